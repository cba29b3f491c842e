#include "support/geometry_laws.hpp"

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "minksum/boolean.hpp"
#include "minksum/check.hpp"
#include "minksum/testing.hpp"
#include "minksum/validity.hpp"
#include "reference/brute_force.hpp"
#include "reference/brute_force_overlay.hpp"
#include "reference/tight_places.hpp"
#include "support/geometries.hpp"
#include "support/messes.hpp"
#include "support/rounding_options.hpp"

namespace minksum::test {
namespace {

// Beyond this many vertices, the reference takes too long to judge a result.
constexpr std::size_t kMaxJudged = 24;

std::size_t size_of(const Geometry& geometry) {
  std::size_t size = geometry.region.vertex_count() + geometry.points.size();
  for (const Polyline& line : geometry.polylines) size += line.size();
  return size;
}

std::string differ(const char* what, const Geometry& found, const Geometry& expected) {
  return std::string(what) + "\nfound    " + to_text(found) + "\nexpected " + to_text(expected);
}

Geometry resolved(const Geometry& geometry, const SumSettings& setting) {
  return resolve(geometry, {.fill = setting.fill, .regularize = setting.regularize});
}

Geometry without_area(const Geometry& geometry) {
  return {{}, geometry.polylines, geometry.points};
}
Geometry without_thin_parts(const Geometry& geometry) { return {geometry.region, {}, {}}; }

/// Returns the tight places of both areas that no area swept by a thin part covers.
Geometry true_tight_places(const Geometry& p, const Geometry& q) {
  Geometry tight = reference::brute_force_tight_places(p.region, q.region);
  if (!tight.has_thin_parts() || (!p.has_thin_parts() && !q.has_thin_parts())) return tight;
  std::vector<Geometry> swept;
  for (const auto& [a, b] : {std::pair{without_area(p), without_thin_parts(q)},
                             {without_thin_parts(p), without_area(q)},
                             {without_area(p), without_area(q)}}) {
    swept.push_back(without_thin_parts(reference::brute_force_sum(a, b)));
  }
  const Geometry area = without_thin_parts(reference::brute_force_unite(swept));
  const Geometry left = reference::brute_force_unite(std::array{area, tight});
  return without_area(left);
}

bool on_target(const Geometry& geometry, const RoundOptions& options) {
  const auto is = [&](const Rational& value) {
    return options.decimals ? (value * Rational(Decimal{1, *options.decimals})).is_integer()
                            : value == Rational(value.to_double());
  };
  const auto all = [&](const std::vector<Point>& points) {
    for (const Point& p : points) {
      if (!is(p.x) || !is(p.y)) return false;
    }
    return true;
  };
  for (std::size_t v = 0; v < geometry.region.vertex_count(); ++v) {
    if (!all({geometry.region.point(v)})) return false;
  }
  for (const Polyline& line : geometry.polylines) {
    if (!all(line)) return false;
  }
  return all(geometry.points);
}

/// Returns the geometry without its last part.
Geometry less_one_part(const Geometry& geometry) {
  Geometry less = geometry;
  if (!less.points.empty()) {
    less.points.pop_back();
  } else if (!less.polylines.empty()) {
    less.polylines.pop_back();
  } else {
    std::vector<Polygon> polygons;
    for (std::size_t i = 0; i + 1 < geometry.region.polygon_count(); ++i) {
      polygons.push_back(geometry.region.polygon(i));
    }
    less.region = Region(polygons);
  }
  return less;
}

}  // namespace

std::string note(const SumCase& sum_case) {
  const SumSettings& o = sum_case.setting;
  return std::string(to_string(o.fill)) + (o.regularize ? ", regularized" : "") +
         (o.cover ? "" : ", cover off") + (o.filter ? "" : ", filter off") +
         (o.check ? ", checked" : "") + ", grid " + std::to_string(o.grid) + ", arithmetic " +
         std::to_string(static_cast<int>(o.arithmetic)) + "\nP " + to_text(sum_case.p) + "\nQ " +
         to_text(sum_case.q);
}

std::size_t brute_force_work(const SumCase& sum_case) {
  return size_of(resolved(sum_case.p, sum_case.setting)) *
         size_of(resolved(sum_case.q, sum_case.setting));
}

std::string broken_resolve(const Geometry& geometry, FillRule fill, bool regularize) {
  const Geometry expected = reference::brute_force_resolve(geometry, fill, regularize);
  const Geometry found = resolve(geometry, {.fill = fill, .regularize = regularize});
  if (!(found == expected)) return differ("resolving is as by brute force", found, expected);
  const Geometry again = resolve(found, {.fill = FillRule::kStrict});
  if (!(again == found)) return differ("what is resolved stays so", again, found);
  return {};
}

std::string broken_sum(const SumCase& sum_case) {
  const auto& [p, q, setting] = sum_case;
  const Geometry expected = reference::brute_force_sum(resolved(p, setting), resolved(q, setting));
  const Geometry reduced = minkowski_sum(p, q, setting);
  if (!(reduced == expected)) return differ("the sum is as by brute force", reduced, expected);
  const Geometry exchanged = minkowski_sum(q, p, setting);
  if (!(exchanged == expected)) return differ("q and p have the same sum", exchanged, expected);
  SumSettings by_winding;
  by_winding.method = Method::kSigned;
  by_winding.fill = setting.fill;
  by_winding.regularize = setting.regularize;
  const Geometry by_signs = minkowski_sum(p, q, by_winding);
  if (!(by_signs == expected)) return differ("so is the signed sum", by_signs, expected);
  return {};
}

std::string broken_scaling(const SumCase& sum_case, const std::function<Point(const Point&)>& map) {
  const Point origin = map({Rational(0), Rational(0)});
  const auto map_of_sum = [&](const Point& at) -> Point {
    const Point mapped = map(at);
    return {mapped.x + origin.x, mapped.y + origin.y};
  };
  const auto sum_of = [&](const Geometry& p, const Geometry& q, Geometry& tight) {
    SumSettings setting = sum_case.setting;
    setting.arithmetic = Arithmetic::kAutomatic;
    setting.tight = true;
    DetailedSum found = detailed_sum(p, q, setting);
    tight = std::move(found.tight);
    return std::move(found.sum);
  };
  const auto& [p, q, as_given] = sum_case;
  Geometry tight;
  Geometry tight_of_mapped;
  const Geometry expected = transformed(sum_of(p, q, tight), map_of_sum);
  const Geometry found = sum_of(transformed(p, map), transformed(q, map), tight_of_mapped);
  if (!(found == expected)) return differ("sums are scaled with operands", found, expected);
  tight = transformed(tight, map_of_sum);
  if (tight_of_mapped == tight) return {};
  return differ("tight places are scaled with operands", tight_of_mapped, tight);
}

std::string broken_form(const Geometry& result) {
  if (size_of(result) > kMaxJudged) return {};
  const std::string fault = reference::resolved_fault(result);
  return fault.empty() ? fault : "results are resolved: " + fault + '\n' + to_text(result);
}

std::string broken_tight(const SumCase& sum_case) {
  SumSettings setting = sum_case.setting;
  setting.tight = true;
  const auto [sum, tight, statistics, trace] = detailed_sum(sum_case.p, sum_case.q, setting);
  const Geometry plain = minkowski_sum(sum_case.p, sum_case.q, sum_case.setting);
  if (!(sum == plain)) return differ("asking for tight places changes nothing", sum, plain);
  const Geometry expected =
      true_tight_places(resolved(sum_case.p, setting), resolved(sum_case.q, setting));
  if (!(tight == expected)) return differ("tight places are as by brute force", tight, expected);
  return {};
}

std::string broken_rounding(const Geometry& exact, const RoundOptions& options,
                            const RoundingReport& report, const Geometry& rounded) {
  const auto fault = [&](const std::string& what) {
    return differ((what + ", " + to_string(options.side) + ", digits " +
                   std::to_string(options.decimals.value_or(-1)))
                      .c_str(),
                  rounded, exact);
  };
  if (!on_target(rounded, options)) return fault("coordinates are of the target");
  if (!validate(rounded.region, 1).empty()) return fault("what is rounded is valid");
  if (!(resolve(rounded) == rounded)) return fault("what is rounded is resolved");
  if (report.largest_move > report.bound) return fault("rounding keeps its bound");
  if (report.exact && !(rounded == exact)) return fault("what is exact is as it was");
  RoundingReport again;
  if (!(round(rounded, options, again) == rounded) || !again.exact) {
    return fault("a second time changes nothing");
  }
  if (options.side == RoundingSide::kOutside && !contains(rounded, exact)) {
    return fault("it is outside");
  }
  if (options.side == RoundingSide::kInside && !contains(exact, rounded)) {
    return fault("it is inside");
  }
  return {};
}

std::string broken_rounding(const Geometry& exact) {
  for (const RoundingSide side : kRoundingSides) {
    for (const std::optional<int> decimals :
         {std::optional<int>{}, std::optional<int>{3}, std::optional<int>{0}}) {
      const RoundOptions options = rounding(decimals, side);
      RoundingReport report;
      const Geometry rounded = round(exact, options, report);
      std::string fault = broken_rounding(exact, options, report, rounded);
      if (!fault.empty()) return fault;
    }
  }
  return {};
}

std::string broken_check(const SumCase& sum_case, const Geometry& sum) {
  CheckOptions how;
  how.samples = 8;
  Options options;
  options.fill = sum_case.setting.fill;
  options.regularize = sum_case.setting.regularize;
  const SumCheck right = check_sum(sum, sum_case.p, sum_case.q, how, options);
  if (!right.ok() || right.proof != Proof::kHolds) {
    return differ("the check agrees with the sum", sum, {});
  }
  if (sum.empty()) return {};
  const Geometry less = less_one_part(sum);
  const SumCheck wrong = check_sum(less, sum_case.p, sum_case.q, how, options);
  if (wrong.ok()) return differ("the check misses what is missing", less, sum);
  return {};
}

}  // namespace minksum::test
