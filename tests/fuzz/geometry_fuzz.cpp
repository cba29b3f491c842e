// Sums of anything: bytes become two geometries on a grid of 8 by 8 points, where nearly everything
// coincides, a fill rule and a setting. Resolving, the sum, its tight places, its roundings and its
// check are as by brute force.
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "support/geometry_laws.hpp"
#include "support/messes.hpp"

namespace {

using namespace minksum;

// Operands beyond this take brute force too long.
constexpr std::size_t kMaxWork = 100;

/// A byte from 64 on is one vertex. Those below begin something: so bytes can be written as text,
/// with digits for these.
class GeometryReader {
 public:
  GeometryReader(const std::uint8_t* data, std::size_t size) : data_(data), end_(data + size) {}

  [[nodiscard]] int take() { return data_ == end_ ? 0 : *data_++; }

  [[nodiscard]] Geometry read() {
    geometry_ = {};
    kind_ = Kind::kPolygon;
    geometry_.region.begin_polygon();
    geometry_.region.begin_ring();
    for (int count = 0; count < kMaxBytes && data_ != end_; ++count) {
      const int byte = *data_++;
      if (byte >= kFirstVertex) {
        add(byte);
      } else {
        begin(static_cast<Kind>(byte % kKinds));
        if (kind_ == Kind::kOperand) break;
      }
    }
    for (Polyline& line : geometry_.polylines) {
      if (line.size() == 1) line.push_back(line.front());
    }
    std::erase_if(geometry_.polylines, [](const Polyline& line) { return line.empty(); });
    return std::move(geometry_);
  }

 private:
  enum class Kind { kRing, kPolygon, kPolyline, kPoints, kOperand, kBack };
  static constexpr int kKinds = 6;
  static constexpr int kFirstVertex = 64;
  static constexpr int kMaxBytes = 16;

  void begin(Kind kind) {
    if (kind == Kind::kBack) {
      const int back = before_;
      add(back);
      return;
    }
    kind_ = kind;
    if (kind == Kind::kPolygon) geometry_.region.begin_polygon();
    if (kind == Kind::kPolygon || kind == Kind::kRing) {
      geometry_.region.begin_ring();
      kind_ = Kind::kPolygon;
    }
    if (kind == Kind::kPolyline) geometry_.polylines.emplace_back();
  }

  void add(int byte) {
    before_ = last_;
    last_ = byte;
    const Point point{Rational(byte % 8), Rational(byte / 8 % 8)};
    if (kind_ == Kind::kPoints) {
      geometry_.points.push_back(point);
    } else if (kind_ == Kind::kPolyline) {
      geometry_.polylines.back().push_back(point);
    } else {
      geometry_.region.add_vertex(point.x, point.y);
    }
  }

  const std::uint8_t* data_;
  const std::uint8_t* end_;
  Geometry geometry_;
  Kind kind_ = Kind::kPolygon;
  int last_ = 0;
  int before_ = 0;  ///< the vertex before the last one
};

Options read_setting(int rule, int byte) {
  constexpr std::array kRules = {FillRule::kAutomatic, FillRule::kEvenOdd, FillRule::kNonZero,
                                 FillRule::kPositive, FillRule::kNegative};
  constexpr std::array kArithmetics = {Arithmetic::kAutomatic, Arithmetic::kMedium,
                                       Arithmetic::kWide, Arithmetic::kArbitrary};
  Options setting;
  setting.fill = kRules[static_cast<std::size_t>(rule % 5)];
  setting.regularize = rule / 5 % 4 == 3;
  setting.arithmetic = kArithmetics[static_cast<std::size_t>(byte % 4)];
  setting.cover = byte / 4 % 4 != 0;
  setting.filter = byte / 16 % 4 != 0;
  setting.check = byte / 64 % 2 != 0;
  setting.grid = rule % 3 * (1 + byte % 16);
  return setting;
}

Geometry scaled(const Geometry& geometry, const Rational& factor) {
  return test::transformed(geometry, [&](const Point& p) -> Point {
    return {p.x * factor, p.y * factor};
  });
}

void require(const std::string& fault, const test::SumCase& sum_case) {
  if (fault.empty()) return;
  std::fprintf(stderr, "violated: %s\n%s\n", fault.c_str(), test::note(sum_case).c_str());
  std::abort();
}

void try_laws(const test::SumCase& sum_case, const Rational& scale) {
  const Options& setting = sum_case.setting;
  for (const Geometry* geometry : {&sum_case.p, &sum_case.q}) {
    require(test::broken_resolve(*geometry, setting.fill, setting.regularize), sum_case);
  }
  if (test::brute_force_work(sum_case) > kMaxWork) return;
  require(test::broken_sum(sum_case), sum_case);
  require(test::broken_tight(sum_case), sum_case);
  const Geometry sum = minkowski_sum(sum_case.p, sum_case.q, setting);
  require(test::broken_form(sum), sum_case);
  require(test::broken_rounding(scaled(sum, scale)), sum_case);
  require(test::broken_check(sum_case, sum), sum_case);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  GeometryReader reader(data, size);
  const int rule = reader.take();
  const Options setting = read_setting(rule, reader.take());
  const int scales = reader.take();
  const Geometry p = reader.read();
  const Geometry q = scaled(reader.read(), Rational(1 + scales % 3, 1 + scales / 3 % 2));
  const test::SumCase sum_case{p, q, setting};
  try {
    try_laws(sum_case, Rational(1 + scales / 8, 1 + 37 * (scales % 8)));
  } catch (const std::exception& error) {
    require(std::string("it can be done: ") + error.what(), sum_case);
  }
  return 0;
}
