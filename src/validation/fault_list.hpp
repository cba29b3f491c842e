// Lists each fault of an operand once, with its exact location.
#pragma once

#include <algorithm>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "region/point_arithmetic.hpp"
#include "region/region_access.hpp"
#include "validation/prepared_operand.hpp"

namespace minksum {

/// Adds faults to a list until it is full. A fault may be reported again, because cells have edges
/// in common.
class FaultList {
 public:
  FaultList(const PreparedOperand& operand, std::size_t max_faults, std::vector<Fault>& faults)
      : o_(operand), region_(*operand.region), max_faults_(max_faults), faults_(faults) {
    full_ = faults.size() >= max_faults;
  }

  [[nodiscard]] bool full() const { return full_; }

  void add_vertex(const char* message, SiteId v) {
    if (is_new(message, v)) add(message, vertex(v), {}, point(v));
  }
  void add_two_vertices(const char* message, SiteId v, SiteId w) {
    if (is_new(message, std::min(v, w))) {
      add(message, vertex(std::min(v, w)), vertex(std::max(v, w)), point(v));
    }
  }
  void add_vertex_on_edge(const char* message, SiteId v, SiteId e) {
    if (is_new(message, v)) add(message, vertex(v), edge(e, point(v)), point(v));
  }
  void add_crossing(const char* message, SiteId e, SiteId f) {
    if (is_new(message, std::min(e, f), std::max(e, f))) add_edges(message, e, f, crossing(e, f));
  }
  /// Adds the overlap of two edges on one line.
  void add_overlap(const char* message, SiteId e, SiteId f) {
    if (!is_new(message, std::min(e, f), std::max(e, f))) return;
    add_edges(message, e, f, std::max(smaller_end(e), smaller_end(f), comes_before));
  }

 private:
  [[nodiscard]] bool is_new(const char* message, SiteId a, SiteId b = kNoSite) {
    return !full() && reported_.insert({message, a, b}).second;
  }
  void add_edges(const char* message, SiteId e, SiteId f, const Point& at) {
    add(message, edge(e, at), edge(f, at), at);
  }
  void add(const char* message, const Culprit& place, const Culprit& other, const Point& at) {
    faults_.push_back({message, place, other, at});
    full_ = faults_.size() >= max_faults_;
  }

  [[nodiscard]] Point point(SiteId v) const { return region_.point(o_.vertex_source[v]); }
  [[nodiscard]] Culprit vertex(SiteId v) const {
    return RegionAccess::culprit(region_, o_.vertex_source[v]);
  }
  /// Returns the edge of the region that holds a point of edge `e`. In one line, `e` may stand for
  /// several.
  [[nodiscard]] Culprit edge(SiteId e, const Point& at) const {
    const std::size_t ring = RegionAccess::ring_of(region_, o_.edge_source[e]);
    const std::size_t begin = RegionAccess::ring_first(region_, ring);
    const std::size_t end = RegionAccess::ring_first(region_, ring + 1);
    std::size_t first = o_.edge_source[e];
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t second = first + 1 == end ? begin : first + 1;
      if (is_between(region_.point(first), at, region_.point(second))) break;
      first = second;
    }
    return RegionAccess::culprit(region_, first);
  }
  /// Tells whether `at` lies between a and b, for points on one line.
  static bool is_between(const Point& a, const Point& at, const Point& b) {
    return !comes_before(at, std::min(a, b, comes_before)) &&
           !comes_before(std::max(a, b, comes_before), at);
  }
  [[nodiscard]] Point crossing(SiteId e, SiteId f) const {
    const Point a = point(e);
    const Point c = point(f);
    const Point along = minus(point(o_.sites.next[e]), a);
    const Point other = minus(point(o_.sites.next[f]), c);
    const Rational part = cross(minus(c, a), other) / cross(along, other);
    return {a.x + part * along.x, a.y + part * along.y};
  }
  [[nodiscard]] Point smaller_end(SiteId e) const {
    return std::min(point(e), point(o_.sites.next[e]), comes_before);
  }

  const PreparedOperand& o_;
  const Region& region_;
  std::size_t max_faults_;
  std::vector<Fault>& faults_;
  bool full_ = false;
  std::set<std::tuple<std::string, SiteId, SiteId>> reported_;
};

}  // namespace minksum
