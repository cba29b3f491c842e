// Goes through the shapes of some folders, for all programs over real shapes.
//
//   [--folders gis,fonts,...] [--every N] [--first N] [--max-vertices N], and the program's own
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/data.hpp"

namespace minksum::test {

struct ShapeRun {
  std::vector<std::string> folders;
  std::size_t every = 1;
  std::size_t first = 0;
  std::size_t max_vertices = 0;

  /// Reads the options. `more` has further options with functions that take their values. Throws
  /// std::runtime_error.
  void read_options(int count, char** values,
                    std::map<std::string, std::function<void(const std::string&)>> more) {
    const auto number = [](std::size_t& target) {
      return [&target](const std::string& value) { target = std::stoul(value); };
    };
    more["--every"] = number(every);
    more["--first"] = number(first);
    more["--max-vertices"] = number(max_vertices);
    more["--folders"] = [this](const std::string& value) {
      folders.clear();
      std::stringstream list(value);
      for (std::string folder; std::getline(list, folder, ',');) folders.push_back(folder);
    };
    for (int i = 1; i < count; i += 2) {
      const auto option = more.find(values[i]);
      if (option == more.end()) {
        throw std::runtime_error(std::string("unknown option ") + values[i]);
      }
      if (i + 1 == count) throw std::runtime_error(std::string(values[i]) + " needs a value");
      option->second(values[i + 1]);
    }
  }

  /// Calls visit(name, shape, name of the next one in its folder, that shape). `wanted` chooses the
  /// files.
  template <class Wanted, class Visit>
  void for_each(const std::filesystem::path& data, Wanted wanted, Visit visit) const {
    for (const std::string& folder : folders) {
      std::vector<std::string> names;
      for (const DataFile& file : read_manifest(data)) {
        const bool ours = file.name.starts_with(folder + "/") && wanted(file);
        if (ours && file.vertices <= max_vertices) names.push_back(file.name);
      }
      for (std::size_t i = first; i < names.size(); i += every) {
        const std::string& next = names[(i + 1) % names.size()];
        visit(names[i], read_wkt(data / names[i]), next, read_wkt(data / next));
      }
    }
  }
};

}  // namespace minksum::test
