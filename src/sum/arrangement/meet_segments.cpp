#include "sum/arrangement/meet_segments.hpp"

#include <algorithm>
#include <bit>

#include "machine/exceeded.hpp"
#include "machine/make_room.hpp"

namespace minksum {
namespace {

// Beside the extent. Parts that lie inside the sum are left out down to some slacks. With 2^-34,
// 10,000 triangles around a vertex ⊕ a tiny one have 2.6 times the crossings. With 2^-38, rounded
// positions are too coarse more often: 10,000 slivers take six times as many exact decisions.
constexpr double kSlack = 0x1p-36;

double reach(const KeptSegment& s) { return std::max(std::abs(s.d.x), std::abs(s.d.y)); }
Vec<double> along(const KeptSegment& s, double lambda) {
  return {s.a.x + lambda * s.d.x, s.a.y + lambda * s.d.y};
}

}  // namespace

void limit_crossings(std::size_t crossings, std::uint64_t most) {
  if (crossings <= most) return;
  throw exceeded("Limits::max_crossings", most, "the arrangement has", "crossings");
}

SegmentMeeter::SegmentMeeter(double extent, const SumSettings& options, Predicates& predicates,
                             ArrangementScratch& scratch, const std::vector<KeptSegment>& kept,
                             Meetings& meetings, bool alone)
    : predicates_(predicates),
      scratch_(scratch),
      meetings_(meetings),
      alone_(alone),
      kept_(kept),
      unmoved_(kept),
      bounds_(predicates.bounds()),
      extent_(extent),
      slack_(extent * kSlack),
      exact_(bounds_.product == 0 && bounds_.difference == 0 && bounds_.direction == 0),
      trust_(!std::isinf(bounds_.direction)) {
  most_crossings_ = most_crossings(options.limits);
}

SegmentMeeter::SegmentMeeter(const SegmentMeeter& other, double extent,
                             const std::vector<KeptSegment>& moved, const Vec<double>& origin)
    : predicates_(other.predicates_),
      scratch_(other.scratch_),
      meetings_(other.meetings_),
      alone_(other.alone_),
      kept_(moved),
      unmoved_(other.unmoved_),
      bounds_(other.bounds_.moved_to(extent)),
      most_crossings_(other.most_crossings_),
      extent_(extent),
      slack_(extent * kSlack),
      exact_(other.exact_),
      trust_(other.trust_),
      other_(&other),
      origin_(origin) {}

KeptSegment SegmentMeeter::moved(KeptId origin, KeptId s) const {
  KeptSegment result = kept_[s];
  result.a = predicates_.kernel().between(start(origin), start(s));
  result.b = predicates_.kernel().between(start(origin), end(s));
  return result;
}

void SegmentMeeter::meet(KeptId s, KeptId t) {
  if (kept_[s].line == kept_[t].line) return meet_parallel(s, t);
  if (meet_at_ends(s, t)) return;
  const Sides of_t = sides(s, t);
  if (of_t.apart()) return;
  const Sides of_s = sides(t, s);
  if (of_s.apart()) return;
  if (of_t.start == kZero) return touch(s, of_s, 2 * t);
  if (of_t.end == kZero) return touch(s, of_s, 2 * t + 1);
  if (of_s.start == kZero) return touch(t, of_t, 2 * s);
  if (of_s.end == kZero) return touch(t, of_t, 2 * s + 1);
  cross_at(s, of_s, t, of_t);
}

/// Unites an end that two segments share, if doubles show it at once. That is the common case of
/// neighbours in the convolution. Segments that are not parallel have no other point in common.
bool SegmentMeeter::meet_at_ends(KeptId s, KeptId t) {
  const KeptSegment& ks = kept_[s];
  const KeptSegment& kt = kept_[t];
  // Bits are compared without branches, because it is hard to predict which ends meet.
  const auto apart = [](const Vec<double>& p, const Vec<double>& q) {
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    return (bits(p.x) ^ bits(q.x)) | (bits(p.y) ^ bits(q.y));
  };
  const std::uint32_t common =
      (apart(ks.a, kt.a) == 0 ? 1U : 0U) | (apart(ks.a, kt.b) == 0 ? 2U : 0U) |
      (apart(ks.b, kt.a) == 0 ? 4U : 0U) | (apart(ks.b, kt.b) == 0 ? 8U : 0U);
  if (common == 0) return false;
  const auto first = static_cast<std::uint32_t>(std::countr_zero(common));
  const std::uint32_t of_s = 2 * s + (first >> 1);
  const std::uint32_t of_t = 2 * t + (first & 1);
  if (bounds_.difference != 0 && vertex(of_s) != vertex(of_t)) return false;
  join(scratch_.parent, of_s, of_t);
  return true;
}

/// Tells on which side of s the ends of t lie.
SegmentMeeter::Sides SegmentMeeter::sides(KeptId s, KeptId t) {
  Sides result{0, 0, 0, kZero, kZero};
  if (exact_) {
    const KeptSegment& ks = kept_[s];
    const KeptSegment& kt = kept_[t];
    result.start_value = cross(ks.d, {kt.a.x - ks.a.x, kt.a.y - ks.a.y});
    result.end_value = cross(ks.d, {kt.b.x - ks.a.x, kt.b.y - ks.a.y});
    result.start = sign_of(result.start_value);
    result.end = sign_of(result.end_value);
    predicates_.count_filtered(2);
    return result;
  }
  result.start = side(s, 2 * t, result.start_value, result.bound);
  result.end = side(s, 2 * t + 1, result.end_value, result.bound);
  return result;
}

Sign SegmentMeeter::side(KeptId s, std::uint32_t point, double& value, double& greatest_bound) {
  const KeptSegment& ks = kept_[s];
  const Vec<double>& p = place(point);
  const Vec<double> v{p.x - ks.a.x, p.y - ks.a.y};
  const double left = ks.d.x * v.y;
  const double right = ks.d.y * v.x;
  value = left - right;
  const double bound = bounds_.cross_bound(ks.d, left, right, bounds_.difference);
  greatest_bound = std::max(greatest_bound, bound);
  if (value > bound || value < -bound || bound == 0) {
    predicates_.count_filtered(1);
    return sign_of(value);
  }
  greatest_bound = HUGE_VAL;
  if (coincide(point, 2 * s) || coincide(point, 2 * s + 1)) return kZero;
  predicates_.count_kernel();
  return predicates_.kernel().orientation(ks.segment, vertex(point));
}

/// Whether two ends are certainly equal. That is the common case of neighbours in the convolution.
bool SegmentMeeter::coincide(std::uint32_t a, std::uint32_t b) const {
  const Vec<double>& p = place(a);
  const Vec<double>& q = place(b);
  return p.x == q.x && p.y == q.y && (bounds_.difference == 0 || vertex(a) == vertex(b));
}

/// Adds an end of another segment, which lies on the line of s. It lies on s, because the ends of s
/// are not both strictly on one side of that segment, as `of_s` tells.
void SegmentMeeter::touch(KeptId s, const Sides& of_s, std::uint32_t point) {
  if (of_s.start == kZero) return join(scratch_.parent, point, 2 * s);
  if (of_s.end == kZero) return join(scratch_.parent, point, 2 * s + 1);
  add_vertex_event(s, point);
}

/// Whether doubles show that a segment does not start on the line of a parallel one.
bool SegmentMeeter::clearly_apart(KeptId s, KeptId t) const {
  const KeptSegment& ks = kept_[s];
  const Vec<double> v{kept_[t].a.x - ks.a.x, kept_[t].a.y - ks.a.y};
  const double left = ks.d.x * v.y;
  const double right = ks.d.y * v.x;
  const double bound = bounds_.cross_bound(ks.d, left, right, bounds_.difference);
  return std::abs(left - right) > bound;
}

/// Returns the distance of a segment's line from (0, 0): positive if the line is on the left, as
/// seen along the line to the right, or upwards if it is vertical.
///
/// The distance is a cross product divided by a length. Its roundings and the error of the
/// segment's place make it off by as much wherever the segment is. An error of the direction makes
/// it off by more, the farther the segment is from (0, 0).
SegmentMeeter::LineOffset SegmentMeeter::offset_of(KeptId segment) const {
  const KeptSegment& s = kept_[segment];
  const double length = std::sqrt(s.d.x * s.d.x + s.d.y * s.d.y);
  const bool goes_left = s.d.x != 0 ? s.d.x < 0 : s.d.y < 0;
  // The squares of a shorter vector may have lost digits to underflow. Then its offset says
  // nothing.
  if (length < 0x1p-400) return {0, HUGE_VAL};
  const double error = extent_ * (0x1p-49 + 4 * bounds_.direction);
  return {cross(s.d, s.a) / (goes_left ? -length : length), error + 2 * bounds_.difference};
}

void SegmentMeeter::meet_parallel(KeptId s, KeptId t) {
  if (clearly_apart(s, t)) return;
  const LineOffset of_s = offset_of(s);
  const LineOffset of_t = offset_of(t);
  if (std::abs(of_s.value - of_t.value) > of_s.error + of_t.error) return;
  double value = 0;
  double bound = 0;
  if (side(s, 2 * t, value, bound) != kZero) return;
  join(scratch_.line_parent, s, t);
  meetings_.lines_shared = true;
  for (const std::uint32_t point : {2 * t, 2 * t + 1}) meet_on_line(s, point);
  for (const std::uint32_t point : {2 * s, 2 * s + 1}) meet_on_line(t, point);
}

/// Adds an end of a segment on the same line, if the end lies on s.
void SegmentMeeter::meet_on_line(KeptId s, std::uint32_t point) {
  if (!mine(place(point), bounds_.position)) return;
  const SumVertex v = vertex(point);
  const SumVertex a = start(s);
  const SumVertex b = end(s);
  const bool vertical = predicates_.component(kept_[s].segment.edge, Axis::kX) == kZero;
  const Axis axis = vertical ? Axis::kY : Axis::kX;
  const Sign from_a = predicates_.compare(a, v, axis);
  if (from_a == kZero) return join(scratch_.parent, point, 2 * s);
  const Sign to_b = predicates_.compare(v, b, axis);
  if (to_b == kZero) return join(scratch_.parent, point, 2 * s + 1);
  if (from_a == to_b) add_vertex_event(s, point);
}

/// Computes the position of a crossing along s from the cross products of s's ends with t. These
/// have opposite signs, so their difference does not cancel.
SegmentMeeter::Parameter SegmentMeeter::crossing_parameter(KeptId s, const Sides& of_s, KeptId t) {
  constexpr double kRounding = 0x1p-51;
  const double width = std::abs(of_s.start_value) + std::abs(of_s.end_value);
  const double lambda = std::abs(of_s.start_value) / width;
  const double error = 2 * of_s.bound / width + kRounding;
  if (error * reach(kept_[s]) < slack_ / 4) return {lambda, error};
  const PointOnSegment point{true, kept_[t].segment, {}};
  return from_kernel(s, point);
}

SegmentMeeter::Parameter SegmentMeeter::from_kernel(KeptId s, const PointOnSegment& point) {
  constexpr double kKernelError = 0x1p-47;
  predicates_.count_kernel();
  const KeptSegment& ks = kept_[s];
  const double lambda = predicates_.kernel().parameter(ks.segment, point);
  if (ks.joined == 0) return {lambda, kKernelError};
  // The kernel knows only the first member, which begins where the whole begins.
  const Vec<double> d = unmoved_[scratch_.join.joined[ks.joined - 1].first].d;
  const bool by_x = std::abs(ks.d.x) >= std::abs(ks.d.y);
  return {lambda * (by_x ? d.x / ks.d.x : d.y / ks.d.y), kKernelError};
}

void SegmentMeeter::cross_at(KeptId s, const Sides& of_s, KeptId t, const Sides& of_t) {
  const Parameter on_s = crossing_parameter(s, of_s, t);
  const Vec<double> p = along(kept_[s], on_s.lambda);
  if (!mine(p, on_s.error * reach(kept_[s]) + bounds_.position)) return;
  const Parameter on_t = crossing_parameter(t, of_t, s);
  limit_crossings(meetings_.crossings.size() + 1, most_crossings_);
  const auto point = static_cast<std::uint32_t>(2 * unmoved_.size() + meetings_.crossings.size());
  Cancellation& cancellation = predicates_.cancellation();
  append(meetings_.crossings,
         of_s.start == kPositive ? Crossing{s, t, on_s.lambda, doubted(on_s.error)}
                                 : Crossing{t, s, on_t.lambda, doubted(on_t.error)},
         cancellation);
  append(meetings_.events, {on_s.lambda, doubted(on_s.error), s, point}, cancellation);
  append(meetings_.events, {on_t.lambda, doubted(on_t.error), t, point}, cancellation);
}

void SegmentMeeter::add_vertex_event(KeptId s, std::uint32_t point) {
  const KeptSegment& ks = kept_[s];
  const Vec<double>& p = place(point);
  if (!mine(p, bounds_.position)) return;
  const bool by_x = std::abs(ks.d.x) >= std::abs(ks.d.y);
  const double length = by_x ? ks.d.x : ks.d.y;
  Parameter on_s{(by_x ? p.x - ks.a.x : p.y - ks.a.y) / length, 0};
  on_s.error = bounds_.difference / std::abs(length) + 2 * bounds_.direction + 0x1p-50;
  if (!(on_s.error * reach(ks) < slack_ / 4)) on_s = from_kernel(s, {false, {}, vertex(point)});
  meetings_.events.push_back({on_s.lambda, doubted(on_s.error), s, point});
}

}  // namespace minksum
