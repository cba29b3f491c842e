// Checks the stage's result, and prepares one operand.
#include "sum/operands/operands.hpp"

namespace minksum {

void prepare_operand(const Region& region, const SumSettings& options, std::size_t max_faults,
                     Cancellation& cancellation, OperandScratch& scratch, PreparedOperand& operand,
                     std::vector<Fault>& faults) {
  load_and_validate(region, options, max_faults, cancellation, scratch, operand, faults);
  if (faults.empty()) sort_directions(cancellation, scratch, operand);
}

namespace {

/// Checks that places go round once, counter-clockwise. Each step from a direction or reverse to
/// the next must turn left by less than half a circle. Directions must be in order of rank.
std::optional<std::string> check_places(const Operands& o) {
  struct Ray {
    SiteId edge;
    Sign sense;
  };
  std::vector<Ray> at(o.place_count, {kNoSite, kZero});
  for (const SiteId e : o.by_direction) {
    const std::uint32_t place = o.place[o.rank[e]];
    const std::uint32_t reverse = o.reverse_place[o.rank[e]];
    if (place >= at.size() || reverse >= at.size()) return "a place is out of range";
    if (o.rank[e] > 0 && o.place[o.rank[e] - 1] >= place) return "places are not sorted";
    at[place] = {e, kPositive};
    if (at[reverse].edge == kNoSite) at[reverse] = {e, kNegative};
  }
  for (std::size_t i = 0; i < at.size(); ++i) {
    const Ray& a = at[i];
    const Ray& b = at[(i + 1) % at.size()];
    if (a.edge == kNoSite) return "a place is empty";
    if (o.kernel->cross(a.edge, b.edge) * a.sense * b.sense != kPositive) {
      return "places do not go round";
    }
  }
  for (const SiteId e : o.by_direction) {
    const Ray& ray = at[o.reverse_place[o.rank[e]]];
    if (o.kernel->cross(e, ray.edge) != kZero ||
        o.kernel->dot(e, ray.edge) * ray.sense != kNegative) {
      return "a reverse is out of place";
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> check(const Operands& o) {
  const SiteId n = o.size();
  if (o.split > n) return "the first operand has more sites than there are";
  if (o.rank.size() != n || o.convex.size() != n || o.by_direction.size() != n) {
    return "an array has the wrong size";
  }
  SiteId expected = 0;
  for (std::size_t r = 0; r < o.rings.size(); ++r) {
    const OperandRing& ring = o.rings[r];
    const SiteId fewest = o.thin[r < o.first_rings ? 0 : 1] ? 2 : 3;
    if (ring.begin != expected || ring.end < ring.begin + fewest) {
      return "rings do not tile the sites";
    }
    if (r + 1 == o.first_rings && ring.end != o.split) {
      return "the operands are not split at a ring";
    }
    expected = ring.end;
  }
  if (expected != n) return "rings do not tile the sites";
  for (SiteId v = 0; v < n; ++v) {
    if (o.previous[o.sites.next[v]] != v) return "next and previous disagree";
    const Sign turn = o.kernel->cross(o.previous[v], v);
    const bool walk = o.thin[static_cast<std::size_t>(o.operand_of(v))];
    if (turn == kZero && (!walk || o.kernel->dot(o.previous[v], v) != kNegative)) {
      return "a vertex lies on a straight line";
    }
    if ((turn != kNegative) != (o.convex[v] != 0)) return "a convexity flag is wrong";
  }
  for (SiteId i = 1; i < n; ++i) {
    const SiteId a = o.by_direction[i - 1];
    const SiteId b = o.by_direction[i];
    const bool parallel = o.kernel->cross(a, b) == kZero && o.kernel->dot(a, b) == kPositive;
    if (o.rank[b] != o.rank[a] + (parallel ? 0 : 1)) return "directions are not sorted";
  }
  // Two opposite directions are half a circle apart, and so cannot pass `check_places`.
  return o.all_parallel() ? std::nullopt : check_places(o);
}

}  // namespace minksum
