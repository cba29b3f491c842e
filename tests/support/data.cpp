#include "support/data.hpp"

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace minksum::test {
namespace {

std::optional<std::filesystem::path> find_data() {
  const char* named = std::getenv("MINKSUM_DATA");
  const std::filesystem::path folder =
      named != nullptr ? named : std::filesystem::path(MINKSUM_SOURCE_DIR) / "../shared/data";
  if (std::filesystem::is_directory(folder)) return folder;
  std::cerr << "no folder of shapes at " << folder << ": tests on real shapes are skipped\n";
  return std::nullopt;
}

class WktReader {
 public:
  explicit WktReader(const std::string& text) : text_(text) {}

  Region read() {
    std::string kind;
    skip_blanks();
    while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) {
      kind += text_[at_++];
    }
    if (kind == "POLYGON") {
      read_polygon();
    } else if (kind == "MULTIPOLYGON") {
      read_list([this] { read_polygon(); });
    } else {
      throw std::runtime_error("neither POLYGON nor MULTIPOLYGON: " + kind);
    }
    return std::move(region_);
  }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  bool accept(char c) {
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  template <class Action>
  void read_list(Action&& action) {
    if (!accept('(')) throw std::runtime_error("'(' expected");
    do {
      action();
    } while (accept(','));
    if (!accept(')')) throw std::runtime_error("')' expected");
  }
  void read_polygon() {
    region_.begin_polygon();
    read_list([this] { read_ring(); });
  }
  void read_ring() {
    std::vector<std::pair<Rational, Rational>> points;
    read_list([&] {
      Rational x = read_number();
      points.emplace_back(std::move(x), read_number());
    });
    if (points.size() > 1 && points.front() == points.back()) points.pop_back();
    region_.begin_ring();
    for (const auto& [x, y] : points) region_.add_vertex(x, y);
  }
  Rational read_number() {
    skip_blanks();
    const std::size_t end = text_.find_first_of(" ,)\n\t\r", at_);
    if (end == std::string::npos) throw std::runtime_error("the text ends too early");
    const auto value = Rational::parse(std::string_view(text_).substr(at_, end - at_));
    if (!value) throw std::runtime_error("a number expected");
    at_ = end;
    return *value;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  Region region_;
};

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream in(line);
  for (std::string field; std::getline(in, field, '\t');) fields.push_back(field);
  return fields;
}

}  // namespace

std::optional<std::filesystem::path> data_path() {
  static const std::optional<std::filesystem::path> folder = find_data();
  return folder;
}

std::vector<std::map<std::string, std::string>> read_table(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> heading = split(line);
  std::vector<std::map<std::string, std::string>> rows;
  while (std::getline(in, line)) {
    const std::vector<std::string> fields = split(line);
    auto& row = rows.emplace_back();
    for (std::size_t i = 0; i < heading.size(); ++i) {
      row[heading[i]] = i < fields.size() ? fields[i] : std::string{};
    }
  }
  return rows;
}

std::vector<DataFile> read_manifest(const std::filesystem::path& folder) {
  std::vector<DataFile> files;
  for (auto& row : read_table(folder / "MANIFEST.tsv")) {
    const auto count = [&row](const char* key) {
      return static_cast<std::size_t>(std::strtoull(row[key].c_str(), nullptr, 10));
    };
    files.push_back(
        {row["file"], count("vertices"), count("holes"), count("parts"), row["is_valid"] == "yes"});
  }
  return files;
}

Region read_wkt(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file.string());
  std::ostringstream text;
  text << in.rdbuf();
  return parse_wkt(text.str());
}

Region parse_wkt(const std::string& text) { return WktReader(text).read(); }

}  // namespace minksum::test
