// Lists the settings by which tests compute sums.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "minksum/testing.hpp"

namespace minksum::test {

struct Setting {
  std::string name;
  SumSettings options;
};

/// Returns ways to compute a sum, none of which may change the result.
[[nodiscard]] inline std::vector<Setting> settings() {
  std::vector<Setting> all(1, {"plain", {}});
  const auto add = [&all](std::string name, auto&& change) {
    Setting setting{std::move(name), {}};
    change(setting.options);
    all.push_back(std::move(setting));
  };
  add("cover off", [](SumSettings& o) { o.cover = false; });
  for (const int grid : {1, 2, 3, 4, 8, 16, 64, 256}) {
    add("grid " + std::to_string(grid), [grid](SumSettings& o) { o.grid = grid; });
  }
  add("filter off", [](SumSettings& o) { o.filter = false; });
  add("filter and cover off", [](SumSettings& o) { o.filter = o.cover = false; });
  add("medium", [](SumSettings& o) { o.arithmetic = Arithmetic::kMedium; });
  add("wide", [](SumSettings& o) { o.arithmetic = Arithmetic::kWide; });
  add("wide without filter", [](SumSettings& o) {
    o.arithmetic = Arithmetic::kWide;
    o.filter = false;
  });
  add("arbitrary", [](SumSettings& o) { o.arithmetic = Arithmetic::kArbitrary; });
  add("arbitrary without filter", [](SumSettings& o) {
    o.arithmetic = Arithmetic::kArbitrary;
    o.filter = false;
  });
  add("narrow", [](SumSettings& o) { o.arithmetic = Arithmetic::kNarrow; });
  add("narrow without filter", [](SumSettings& o) {
    o.arithmetic = Arithmetic::kNarrow;
    o.filter = false;
  });
  add("checked", [](SumSettings& o) { o.check = true; });
  add("checked, grid 8", [](SumSettings& o) {
    o.check = true;
    o.grid = 8;
  });
  add("signed", [](SumSettings& o) { o.method = Method::kSigned; });
  add("full", [](SumSettings& o) { o.method = Method::kFull; });
  return all;
}

}  // namespace minksum::test
