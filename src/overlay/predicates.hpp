// Decides questions of the overlay: by bounded doubles first, then by exact numbers.
#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "exact/bounded.hpp"
#include "machine/cancellation.hpp"
#include "overlay/exact_points.hpp"

namespace minksum::overlay {

/// Coordinates with bounds on their errors.
struct ApproximateLocation {
  Bounded x;
  Bounded y;
};

class Predicates {
 public:
  Predicates() = default;
  /// `work` are the units of work (see Cancellation) of an exact decision.
  Predicates(std::unique_ptr<ExactPoints> exact, std::size_t points, std::uint64_t work,
             Cancellation& cancellation)
      : exact_(std::move(exact)), cancellation_(&cancellation), work_(work) {
    points_.reserve(points);
    for (PointId p = 0; p < points; ++p) {
      cancellation.check(2 + work / 8);
      points_.push_back(approximate(p));
    }
  }

  /// Keeps only these points, and numbers them in this order.
  void pick(std::span<const PointId> points) {
    exact_->pick(points);
    std::vector<ApproximateLocation> picked;
    picked.reserve(points.size());
    for (const PointId p : points) picked.push_back(points_[p]);
    points_ = std::move(picked);
  }

  [[nodiscard]] const ApproximateLocation& point(PointId p) const { return points_[p]; }
  /// Returns the exact points for one decision, and counts its work.
  [[nodiscard]] const ExactPoints& exact() const {
    cancellation_->check(work_);
    return *exact_;
  }
  [[nodiscard]] Cancellation& cancellation() const { return *cancellation_; }

  [[nodiscard]] Sign orientation(const Ends& line, PointId p) const {
    const Bounded area =
        cross(points_[line.low], points_[line.high], points_[line.low], points_[p]);
    return area.certain() ? area.sign() : exact().orientation(line, p);
  }
  [[nodiscard]] Sign orientation(const Ends& line, const ApproximateLocation& at,
                                 const ExactLocation& place) const {
    const Bounded area = cross(points_[line.low], points_[line.high], points_[line.low], at);
    return area.certain() ? area.sign() : exact().orientation(line, place);
  }
  [[nodiscard]] Sign cross(const Ends& s, const Ends& t) const {
    const Bounded area = cross(points_[s.low], points_[s.high], points_[t.low], points_[t.high]);
    return area.certain() ? area.sign() : exact().cross(s, t);
  }
  [[nodiscard]] Sign compare(PointId a, PointId b) const {
    const Sign sign = by_filter(points_[a], points_[b]);
    return sign != kZero ? sign : exact().compare(a, b);
  }
  /// Returns the order by x, then by y.
  [[nodiscard]] Sign compare(const ApproximateLocation& a, const ExactLocation& a_place,
                             const ApproximateLocation& b, const ExactLocation& b_place) const {
    const Sign sign = by_filter(a, b);
    return sign != kZero ? sign : exact().compare(a_place, b_place);
  }
  /// Returns the sign of a ring's signed area.
  [[nodiscard]] Sign area_sign(std::span<const PointId> ring) const {
    Bounded sum;
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      sum = sum + cross(points_[ring[0]], points_[ring[i]], points_[ring[0]], points_[ring[i + 1]]);
    }
    cancellation_->check(ring.size());
    if (sum.certain()) return sum.sign();
    cancellation_->check(work_ * ring.size());
    return exact().area_sign(ring);
  }

  /// Returns where two segments cross: computed in doubles if that is good enough, otherwise
  /// rounded from the exact location.
  [[nodiscard]] ApproximateLocation crossing(const Ends& s, const Ends& t) const {
    const ApproximateLocation& a = points_[s.low];
    const ApproximateLocation& b = points_[s.high];
    const ApproximateLocation& c = points_[t.low];
    const ApproximateLocation& d = points_[t.high];
    const Bounded part = cross(a, c, c, d) / cross(a, b, c, d);
    const Bounded width = b.x - a.x;
    const Bounded height = b.y - a.y;
    constexpr double kGoodEnough = 0x1p-40;
    if (part.error < kGoodEnough) return {a.x + part * width, a.y + part * height};
    const Vec<double> at = exact().approximate(ExactLocation::of_crossing(s, t));
    return {rounded(at.x), rounded(at.y)};
  }

 private:
  /// Returns kZero where doubles cannot tell.
  [[nodiscard]] static Sign by_filter(const ApproximateLocation& a, const ApproximateLocation& b) {
    const Bounded x = a.x - b.x;
    if (x.certain()) return x.sign();
    if (x.error != 0) return kZero;  // otherwise, x is certainly equal
    const Bounded y = a.y - b.y;
    return y.certain() ? y.sign() : kZero;
  }
  /// Returns the cross product of b − a and d − c.
  [[nodiscard]] static Bounded cross(const ApproximateLocation& a, const ApproximateLocation& b,
                                     const ApproximateLocation& c, const ApproximateLocation& d) {
    return (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x);
  }
  [[nodiscard]] static Bounded rounded(double value) {
    return {value, std::fabs(value) * 0x1p-52 + ExactPoints::kAbsoluteError};
  }
  [[nodiscard]] ApproximateLocation approximate(PointId p) const {
    const Vec<double> at = exact_->approximate(ExactLocation::of_point(p));
    const auto bounded = [&](double value) {
      // A value of 2^53 may be 2^53 + 1, rounded.
      const bool exact = exact_->on_grid() && std::fabs(value) < 0x1p53;
      return exact ? Bounded{value, 0} : rounded(value);
    };
    return {bounded(at.x), bounded(at.y)};
  }

  std::unique_ptr<ExactPoints> exact_;
  Cancellation* cancellation_ = nullptr;
  std::uint64_t work_ = 0;
  std::vector<ApproximateLocation> points_;
};

}  // namespace minksum::overlay
