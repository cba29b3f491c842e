// Defines rational Bezier curves over doubles, which choose, and over intervals, which prove.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "io/drawing/interval.hpp"

namespace minksum::io {

/// A control point in homogeneous form: its coordinates are x/w and y/w. Weights are positive.
template <class N>
struct Control {
  N x, y, w;
};

template <class N>
struct Vector {
  N x, y;
};

/// A rational Bezier curve. It lies in the convex hull of its control points.
template <class N>
class Bezier {
 public:
  static constexpr std::size_t kMostControls = 12;

  Bezier() = default;
  // Only control points that are there are copied, because most curves have three or four of
  // twelve.
  Bezier(const Bezier& other) : size_(other.size_) {
    std::copy_n(other.controls_.begin(), size_, controls_.begin());
  }
  Bezier& operator=(const Bezier& other) {
    size_ = other.size_;
    std::copy_n(other.controls_.begin(), size_, controls_.begin());
    return *this;
  }
  ~Bezier() = default;

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const Control<N>& operator[](std::size_t i) const { return controls_[i]; }
  [[nodiscard]] Control<N>& operator[](std::size_t i) { return controls_[i]; }
  void push_back(const Control<N>& control) { controls_[size_++] = control; }
  [[nodiscard]] Vector<N> at(std::size_t i) const {
    const Control<N>& c = controls_[i];
    return {c.x / c.w, c.y / c.w};
  }
  [[nodiscard]] Vector<N> front() const { return at(0); }
  [[nodiscard]] Vector<N> back() const { return at(size_ - 1); }

  /// Returns the curves before and behind parameter t, by de Casteljau's algorithm.
  [[nodiscard]] std::pair<Bezier, Bezier> split(const N& t) const {
    const N rest = N(1.0) - t;
    return split_by([&](const N& a, const N& b) { return a * rest + b * t; });
  }
  /// Returns the curves before and behind 1/2.
  [[nodiscard]] std::pair<Bezier, Bezier> halves() const {
    return split_by([](const N& a, const N& b) { return half_of(a + b); });
  }
  /// Returns the curve from parameter t to parameter u, 0 ≤ t < u ≤ 1.
  [[nodiscard]] Bezier between(double t, double u) const {
    const Bezier before = u == 1 ? *this : split(N(u)).first;
    return t == 0 ? before : before.split(N(t) / N(u)).second;
  }
  [[nodiscard]] Bezier reversed() const {
    Bezier result;
    for (std::size_t i = size_; i-- > 0;) result.push_back(controls_[i]);
    return result;
  }

 private:
  /// `between` returns the number between two others at the parameter.
  template <class Between>
  [[nodiscard]] std::pair<Bezier, Bezier> split_by(Between between) const {
    std::pair<Bezier, Bezier> parts;
    auto& [before, behind] = parts;
    behind = *this;
    before.size_ = size_;
    for (std::size_t k = 0; k < size_; ++k) {
      before.controls_[k] = behind.controls_[0];
      for (std::size_t i = 0; i + k + 1 < size_; ++i) {
        const Control<N>& a = behind.controls_[i];
        const Control<N>& b = behind.controls_[i + 1];
        behind.controls_[i] = {between(a.x, b.x), between(a.y, b.y), between(a.w, b.w)};
      }
    }
    return parts;
  }

  std::array<Control<N>, kMostControls> controls_;
  std::size_t size_ = 0;
};

/// Calls visit(point) for the control points of the quarters of a curve, whose hulls are closer to
/// the curve than its own hull is. Points where quarters meet come once.
template <class N, class Visit>
void for_each_control(const Bezier<N>& curve, Visit visit) {
  const auto [first, second] = curve.halves();
  const auto [a, b] = first.halves();
  const auto [c, d] = second.halves();
  bool begun = false;
  for (const Bezier<N>* const quarter : {&a, &b, &c, &d}) {
    for (std::size_t i = begun ? 1 : 0; i < quarter->size(); ++i) visit(quarter->at(i));
    begun = true;
  }
}

}  // namespace minksum::io
