// Fuzzes whole sums: bytes become two operands on a small grid. Every setting must give the region
// that the signed convolution gives.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "minksum/minksum.hpp"
#include "minksum/testing.hpp"
#include "support/shapes.hpp"

namespace {

using namespace minksum;

/// Each byte is one vertex, or ends a ring, a polygon or an operand. Small changes to the bytes are
/// then small changes to the shapes, and bytes can be written as text.
class ShapeReader {
 public:
  ShapeReader(const std::uint8_t* data, std::size_t size) : data_(data), end_(data + size) {}

  [[nodiscard]] int take() { return data_ == end_ ? kEndOfShape : *data_++; }

  /// Reads a region with vertices on a grid of 16 columns and rows, `scale` apart. Bytes that are
  /// text use 6 rows only.
  [[nodiscard]] Region read_region(int scale) {
    Region region;
    region.begin_polygon();
    region.begin_ring();
    for (int count = 0; count < kMaxBytes; ++count) {
      const int byte = take();
      if (byte == kEndOfShape) break;
      if (byte == kEndOfPolygon) region.begin_polygon();
      if (byte == kEndOfPolygon || byte == kEndOfRing) {
        region.begin_ring();
      } else {
        region.add_vertex(byte % 16 * scale, byte / 16 * scale);
      }
    }
    return region;
  }

 private:
  static constexpr int kMaxBytes = 48;
  static constexpr int kEndOfRing = ',';
  static constexpr int kEndOfPolygon = '!';
  static constexpr int kEndOfShape = '|';
  const std::uint8_t* data_;
  const std::uint8_t* end_;
};

[[noreturn]] void fail(const Region& p, const Region& q, const std::string& what) {
  std::fprintf(stderr, "violated: %s\nP %s\nQ %s\n", what.c_str(), test::to_text(p).c_str(),
               test::to_text(q).c_str());
  std::abort();
}

void expect_sum(const Region& p, const Region& q, const char* setting, const SumSettings& options,
                const Region& expected) {
  try {
    if (!(minkowski_sum(p, q, options) == expected)) {
      fail(p, q, std::string("the sum is the signed one, ") + setting);
    }
  } catch (const Error& error) {
    fail(p, q, std::string("valid operands have a sum, ") + setting + ": " + error.what());
  }
}

void try_settings(const Region& p, const Region& q, const Region& expected, int grid) {
  const auto expect = [&](const char* setting, const SumSettings& options) {
    expect_sum(p, q, setting, options, expected);
  };
  SumSettings options;
  expect("plain", options);
  options.check = true;
  options.grid = grid;
  expect("checked, on a grid", options);
  options.filter = false;
  options.arithmetic = Arithmetic::kArbitrary;
  expect("checked, on a grid, arbitrary, filter off", options);
  options = {};
  options.cover = false;
  options.check = true;
  options.arithmetic = Arithmetic::kMedium;
  expect("checked, cover off, medium", options);
  options = {};
  options.grid = 2 * grid + 5;
  options.filter = false;
  options.arithmetic = Arithmetic::kWide;
  expect("on a finer grid, wide, filter off", options);
  options = {};
  options.method = Method::kFull;
  expect("full", options);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ShapeReader reader(data, size);
  const int grid = 1 + reader.take() % 64;
  const int scales = reader.take();
  const Region p = reader.read_region(1 + scales % 8);
  const Region q = reader.read_region(1 + scales / 8 % 8);
  for (const Region* region : {&p, &q}) {
    if (region->empty() || !validate(*region, 1).empty()) return 0;
  }
  SumSettings options;
  options.method = Method::kSigned;
  Region expected;
  try {
    expected = minkowski_sum(p, q, options);
  } catch (const Error& error) {
    fail(p, q, std::string("valid operands have a signed sum: ") + error.what());
  }
  try_settings(p, q, expected, grid);
  Workspace workspace;
  Region mirror;
  if (!minkowski_sum(q, p, Options{}, workspace, mirror).ok() || !(mirror == expected)) {
    fail(p, q, "the sum of q and p is the same");
  }
  return 0;
}
