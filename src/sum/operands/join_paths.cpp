// Joins the polylines of a resolved geometry into paths, of which a sum has less to do.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

#include "region/point_predicates.hpp"
#include "sum/operands/operands.hpp"

namespace minksum {
namespace {

/// An end of a polyline. That of polyline i has the number 2 i at its start, and 2 i + 1 at its
/// other end.
struct PathEnd {
  RoundedPoint at;
  RoundedPoint inner;  ///< the vertex before it
  double line = 0;     ///< grows with the angle of the line to that vertex, from -1 to 1

  PathEnd(const Point& vertex, const Point& before) : at(vertex), inner(before) {
    const double x = inner.x - at.x;
    const double y = inner.y - at.y;
    const double length = std::abs(x) + std::abs(y);
    if (length > 0) line = x < 0 ? -y / length : y / length;
  }
};

/// Joins what ends at one point.
class PathJoiner {
 public:
  PathJoiner(const std::vector<Polyline>& polylines, Cancellation& cancellation)
      : polylines_(polylines),
        cancellation_(cancellation),
        joint_(2 * polylines.size()),
        done_(polylines.size()) {}

  std::vector<Polyline> run() {
    list_ends();
    for (std::size_t i = 0, j = 0; i < order_.size(); i = j) {
      while (j < order_.size() && compare(order_[i], order_[j]) == 0) ++j;
      join(std::span(order_).subspan(i, j - i));
    }
    for (std::uint32_t end = 0; end < joint_.size(); ++end) {
      if (!is_joined(end)) follow(end);
    }
    // Only closed paths are left.
    for (std::uint32_t end = 0; end < joint_.size(); end += 2) follow(end);
    return std::move(paths_);
  }

 private:
  static constexpr std::uint32_t kNone = ~0U;
  struct Joint {
    std::uint32_t to = kNone;
    bool straight = false;
  };

  [[nodiscard]] int compare(std::uint32_t a, std::uint32_t b) const {
    const RoundedPoint& p = ends_[a].at;
    const RoundedPoint& q = ends_[b].at;
    cancellation_.check(work_of(p.exact));
    const int by_x = compare_x(p, q);
    return by_x != 0 ? by_x : compare_y(p, q);
  }
  /// Lists all ends. Those at one point are sorted by the angles of their lines.
  void list_ends() {
    ends_.reserve(joint_.size());
    for (const Polyline& line : polylines_) {
      cancellation_.check(2 * work_of(line[0]));
      ends_.emplace_back(line[0], line[1]);
      ends_.emplace_back(line.back(), line[line.size() - 2]);
      while (order_.size() < ends_.size()) {
        order_.push_back(static_cast<std::uint32_t>(order_.size()));
      }
    }
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
      const int sign = compare(a, b);
      return sign != 0 ? sign < 0 : ends_[a].line < ends_[b].line;
    });
  }
  [[nodiscard]] bool is_straight(std::uint32_t a, std::uint32_t b) const {
    return turn(ends_[a].inner, ends_[b].at, ends_[b].inner) == 0;
  }
  void join(std::uint32_t a, std::uint32_t b, bool straight) {
    joint_[a] = {b, straight};
    joint_[b] = {a, straight};
  }
  [[nodiscard]] bool is_joined(std::uint32_t end) const { return joint_[end].to != kNone; }

  /// Joins ends at one point: first those that go straight on. These are side by side in order,
  /// unless doubles do not tell lines apart. Then more paths end there, or another two are joined.
  void join(std::span<const std::uint32_t> ends) {
    std::uint32_t before = ends.back();  // a line may have the least and the greatest angle
    for (const std::uint32_t end : ends) {
      cancellation_.check(4 * work_of(ends_[end].at.exact));
      if (before != end && !is_joined(before) && !is_joined(end) && is_straight(before, end)) {
        join(before, end, true);
      }
      before = end;
    }
    before = kNone;
    for (const std::uint32_t end : ends) {
      if (is_joined(end)) continue;
      if (before != kNone) join(before, end, is_straight(before, end));
      before = before == kNone ? end : kNone;
    }
  }

  /// Adds the path that starts at an end of a polyline, if it is not there yet.
  void follow(std::uint32_t start) {
    if (done_[start / 2] != 0) return;
    Polyline& path = paths_.emplace_back();
    for (std::uint32_t end = start;;) {
      const Polyline& line = polylines_[end / 2];
      done_[end / 2] = 1;
      cancellation_.check(line.size());
      for (std::size_t i = path.empty() ? 0 : 1; i < line.size(); ++i) {
        path.push_back(line[end % 2 == 0 ? i : line.size() - 1 - i]);
      }
      const Joint joint = joint_[end ^ 1U];
      if (joint.to == kNone) return;
      if (done_[joint.to / 2] != 0) {  // back at the start
        if (joint.straight) {
          path.pop_back();
          path.front() = path.back();
        }
        return;
      }
      if (joint.straight) path.pop_back();
      end = joint.to;
    }
  }

  const std::vector<Polyline>& polylines_;
  Cancellation& cancellation_;
  std::vector<PathEnd> ends_;
  std::vector<std::uint32_t> order_;  // of ends
  std::vector<Joint> joint_;          // by end
  std::vector<std::uint8_t> done_;    // by polyline
  std::vector<Polyline> paths_;
};

}  // namespace

std::vector<Polyline> join_paths(const std::vector<Polyline>& polylines,
                                 Cancellation& cancellation) {
  return PathJoiner(polylines, cancellation).run();
}

}  // namespace minksum
