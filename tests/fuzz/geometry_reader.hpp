// Makes geometries of any kind from bytes for fuzz targets, on a grid of 8 by 8 points.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "minksum/minksum.hpp"

namespace minksum::fuzz {

/// Each byte from 64 on is one vertex, and smaller bytes begin something. So bytes can be written
/// as text, in which digits begin something.
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

/// Returns one of the fill rules that take any rings.
inline FillRule fill_rule(int byte) {
  constexpr std::array kRules = {FillRule::kAutomatic, FillRule::kEvenOdd, FillRule::kNonZero,
                                 FillRule::kPositive, FillRule::kNegative};
  return kRules[static_cast<std::size_t>(byte % 5)];
}

}  // namespace minksum::fuzz
