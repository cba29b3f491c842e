// Makes a table of no-fit polygons of the geometries in a file, one of WKT on each line, and all of
// its entries, and prints the seconds: the counterpart of promises.py.
#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <minksum/io.hpp>
#include <minksum/minksum.hpp>
#include <string>
#include <vector>

int main(int count, char** arguments) {
  if (count != 2) return 2;
  std::vector<minksum::Geometry> parts;
  std::ifstream file(arguments[1]);
  for (std::string line; std::getline(file, line);) {
    parts.push_back(minksum::io::read_geometry(line));
  }
  double best = 1e300;
  for (int run = 0; run < 3; ++run) {
    const auto begin = std::chrono::steady_clock::now();
    const minksum::NoFitTable table(parts, 4);
    std::vector<minksum::Geometry> entries;
    entries.reserve(parts.size() * parts.size() * 16);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      for (int r = 0; r < 4; ++r) {
        for (std::size_t j = 0; j < parts.size(); ++j) {
          for (int s = 0; s < 4; ++s) entries.push_back(table.at({i, r}, {j, s}));
        }
      }
    }
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - begin;
    best = std::min(best, spent.count());
  }
  std::cout << best << '\n';
}
