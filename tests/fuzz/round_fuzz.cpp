// Fuzzes rounding: bytes become a region with rational vertices. Each rounded region must be valid,
// unchanged by rounding again, close to the exact region, and on the right side of it.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "minksum/minksum.hpp"
#include "support/rounding_options.hpp"
#include "support/shapes.hpp"

namespace {

using namespace minksum;

/// Each byte is one vertex, or ends a ring or a polygon. The 16 columns and rows have different
/// widths, so that the steps of rounding differ from those of the shape.
class ShapeReader {
 public:
  ShapeReader(const std::uint8_t* data, std::size_t size) : data_(data), end_(data + size) {}

  [[nodiscard]] int take() { return data_ == end_ ? 0 : *data_++; }

  [[nodiscard]] Region read_region(const Rational& unit) {
    Region region;
    region.begin_polygon();
    region.begin_ring();
    for (int count = 0; count < kMaxBytes && data_ != end_; ++count) {
      const int byte = *data_++;
      if (byte == kEndOfPolygon) region.begin_polygon();
      if (byte == kEndOfPolygon || byte == kEndOfRing) {
        region.begin_ring();
      } else {
        region.add_vertex(unit * (byte % 16), unit * (byte / 16) + Rational(byte % 3, 7));
      }
    }
    return region;
  }

 private:
  static constexpr int kMaxBytes = 96;
  static constexpr int kEndOfRing = ',';
  static constexpr int kEndOfPolygon = '!';
  const std::uint8_t* data_;
  const std::uint8_t* end_;
};

void expect(bool truth, const Region& exact, const RoundOptions& options, const Region& rounded,
            const std::string& what) {
  if (truth) return;
  std::fprintf(stderr, "violated: %s\n%s, %d digits\nexact %s\nrounded %s\n", what.c_str(),
               to_string(options.side), options.decimals.value_or(-1), test::to_text(exact).c_str(),
               test::to_text(rounded).c_str());
  std::abort();
}

bool on_target(const Region& region, const RoundOptions& options) {
  const auto is = [&](const Rational& value) {
    return options.decimals ? (value * Rational(Decimal{1, *options.decimals})).is_integer()
                            : value == Rational(value.to_double());
  };
  for (std::size_t v = 0; v < region.vertex_count(); ++v) {
    if (!is(region.exact_x(v)) || !is(region.exact_y(v))) return false;
  }
  return true;
}

void try_rounding(const Region& exact, const RoundOptions& options) {
  RoundingReport report;
  Region rounded;
  try {
    rounded = test::round(exact, options, report);
  } catch (const Error& error) {
    expect(false, exact, options, rounded, std::string("it can be rounded: ") + error.what());
  }
  const auto require = [&](bool truth, const char* what) {
    expect(truth, exact, options, rounded, what);
  };
  require(on_target(rounded, options), "coordinates are of the target");
  require(validate(rounded, 1).empty(), "it is valid");
  require(report.largest_move <= report.bound, "it keeps its bound");
  RoundingReport again;
  require(test::round(rounded, options, again) == rounded && again.exact,
          "a second time changes nothing");
  if (options.side == RoundingSide::kOutside) require(contains(rounded, exact), "it is outside");
  if (options.side == RoundingSide::kInside) require(contains(exact, rounded), "it is inside");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ShapeReader reader(data, size);
  const int above = reader.take();
  const int below = reader.take();
  const Region exact = reader.read_region(Rational(1 + above % 32, 1 + below % 32));
  if (exact.empty() || !validate(exact, 1).empty()) return 0;
  for (const RoundingSide side : test::kRoundingSides) {
    try_rounding(exact, test::to_doubles(side));
    try_rounding(exact, test::to_decimals(above / 32, side));
  }
  return 0;
}
