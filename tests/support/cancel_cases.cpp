#include "support/cancel_cases.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "minksum/io.hpp"
#include "minksum/minksum.hpp"
#include "minksum/testing.hpp"
#include "support/geometries.hpp"
#include "support/polygon_kinds.hpp"

namespace minksum::test {
namespace {

// -- Inputs ---------------------------------------------------------------------------------------
/// Returns one polygon whose holes are diamonds in a row, each of which touches the next at a
/// vertex.
Region chain_of_holes(int holes) {
  std::vector<Outline> diamonds;
  for (std::int64_t i = 0; i < holes; ++i) {
    diamonds.push_back({{4 * i, 0}, {4 * i + 2, -2}, {4 * i + 4, 0}, {4 * i + 2, 2}});
  }
  return make_polygon({{-4, -4}, {4 * holes + 4, -4}, {4 * holes + 4, 4}, {-4, 4}}, diamonds);
}
/// Returns triangles in rows, apart from each other.
Region triangles(int count) {
  const int side = std::max(1, static_cast<int>(std::sqrt(count)));
  std::vector<std::vector<Outline>> parts;
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t x = 7 * (i % side);
    const std::int64_t y = 7 * (i / side);
    parts.push_back({{{x, y}, {x + 5, y + i % 3}, {x + i % 4, y + 5}}});
  }
  return make_region(parts);
}
/// Returns nested squares: polygon, hole, polygon in the hole, and so on.
Region nested_squares(int rings) {
  std::vector<std::vector<Outline>> parts;
  for (std::int64_t i = 0; i + 1 < rings; i += 2) {
    const auto square = [&](std::int64_t r) { return Outline{{-r, -r}, {r, -r}, {r, r}, {-r, r}}; };
    parts.push_back({square(2 * (rings - i)), square(2 * (rings - i) - 2)});
  }
  return make_region(parts);
}
Region row_of_squares(int count) {
  std::vector<std::vector<Outline>> parts;
  for (std::int64_t x = 0; x < 2 * count; x += 2) {
    parts.push_back({{{x, 0}, {x + 1, 0}, {x + 1, 1}, {x, 1}}});
  }
  return make_region(parts);
}
/// Returns long thin triangles side by side, whose boxes overlap.
Region needles(int count) {
  std::vector<std::vector<Outline>> parts;
  for (std::int64_t i = 0; i < count; ++i) {
    parts.push_back({{{3 * i, 0}, {3 * i + 100'000, 100'001}, {3 * i + 1, 0}}});
  }
  return make_region(parts);
}
Outline random_outline(int vertices, int size, std::uint64_t seed) {
  Random random(seed);
  Outline outline;
  for (int i = 0; i < vertices; ++i) outline.push_back({random.below(size), random.below(size)});
  return outline;
}
Geometry random_path(int vertices, std::uint64_t seed) {
  return make_lines({random_outline(vertices, 100'000, seed)});
}
/// Returns a ring that crosses itself many times.
Geometry tangle(int vertices) {
  return {make_polygon(random_outline(vertices, 10'000, 5)), {}, {}};
}
/// Returns a star whose coordinates all have different long denominators.
Region long_numbers(int spikes, int digits) {
  Random random(11);
  const Region star = spiky_star(random, spikes, 1000);
  std::int64_t next = 1;
  return transformed(star, [&](const Point& p) {
    std::string denominator = "1";
    for (int i = 0; i < digits; ++i) denominator += static_cast<char>('0' + random.below(10));
    denominator += std::to_string(2 * next++ + 1);
    const Rational off = *Rational::parse("1/" + denominator);
    return Point{p.x + off, p.y - off};
  });
}
Geometry geometry_of(Region region) { return {std::move(region), {}, {}}; }

// -- Operations -----------------------------------------------------------------------------------
using Unary = std::pair<const char*, std::function<void(const Geometry&, const Options&)>>;
using Binary =
    std::pair<const char*, std::function<void(const Geometry&, const Geometry&, const Options&)>>;

Options with(const Options& options, FillRule fill) {
  Options copy = options;
  copy.fill = fill;
  return copy;
}
Options on_two_threads(const Options& options) {
  Options copy = options;
  copy.threads = 2;
  return copy;
}

void sum_by(const Geometry& a, const Geometry& b, const Options& options,
            const std::function<void(SumSettings&)>& set) {
  SumSettings settings{options};
  set(settings);
  static_cast<void>(minkowski_sum(a, b, settings));
}

std::vector<Unary> unary_operations() {
  std::vector<Unary> list;
  const auto add = [&](const char* name, auto run) { list.emplace_back(name, run); };
  add("validate",
      [](const Geometry& a, const Options& c) { static_cast<void>(validate(a.region, 100, c)); });
  add("prepare", [](const Geometry& a, const Options& c) {
    if (validate(a.region, 1, c).empty()) static_cast<void>(PreparedRegion(a.region, c));
  });
  for (const FillRule fill : {FillRule::kAutomatic, FillRule::kEvenOdd, FillRule::kPositive}) {
    add(fill == FillRule::kAutomatic ? "resolve" : to_string(fill),
        [fill](const Geometry& a, const Options& c) {
          static_cast<void>(resolve(a, with(c, fill)));
        });
  }
  add("area", [](const Geometry& a, const Options& c) { static_cast<void>(area(a.region, c)); });
  add("measure", [](const Geometry& a, const Options& c) {
    static_cast<void>(approximate_area(a.region, c));
    static_cast<void>(coordinate_bits(a.region, c));
  });
  add("locate",
      [](const Geometry& a, const Options& c) { const PointLocator locator(resolve(a, c), c); });
  add("transform", [](const Geometry& a, const Options& c) {
    static_cast<void>(transform(a, Affine::rotation(Rational(1, 7)), c));
  });
  add("write, read", [](const Geometry& a, const Options& c) {
    std::ostringstream out;
    io::Coordinates exact{io::Coordinates::Style::kExact, 6, c.cancel};
    io::write(out, a, io::Format::kWkt, exact);
    io::ReadOptions limits;
    limits.cancel = c.cancel;
    static_cast<void>(io::read_geometry(out.str(), limits));
  });
  for (const RoundingSide side :
       {RoundingSide::kNearest, RoundingSide::kOutside, RoundingSide::kInside}) {
    add(side == RoundingSide::kNearest ? "round" : to_string(side),
        [side](const Geometry& a, const Options& c) {
          const Geometry third = transform(resolve(a, c), Affine::scaling(Rational(1, 3)), c);
          static_cast<void>(round(third, {.side = side, .decimals = 0}, c));
        });
  }
  add("offset", [](const Geometry& a, const Options& c) {
    for (const Join join : {Join::kRound, Join::kMiter}) {
      static_cast<void>(offset(a, 1, {.join = join}, c));
    }
  });
  add("subtract from a box", [](const Geometry& a, const Options& c) {
    const Region region = resolve(a, c).region;
    static_cast<void>(subtract(rectangle(-1'000'000, -1'000'000, 1'000'000, 1'000'000), region, c));
  });
  return list;
}

std::vector<Binary> binary_operations() {
  std::vector<Binary> list;
  const auto add = [&](const char* name, auto run) { list.emplace_back(name, run); };
  const auto add_sum = [&](const char* name, const std::function<void(SumSettings&)>& set) {
    list.emplace_back(name, [set](const Geometry& a, const Geometry& b, const Options& c) {
      sum_by(a, b, c, set);
    });
  };
  add_sum("sum", [](SumSettings&) {});
  add_sum("sum, signed", [](SumSettings& o) { o.method = Method::kSigned; });
  add_sum("sum, full", [](SumSettings& o) { o.method = Method::kFull; });
  add_sum("sum, arbitrary", [](SumSettings& o) { o.arithmetic = Arithmetic::kArbitrary; });
  add_sum("sum, no filter", [](SumSettings& o) { o.filter = false; });
  add("no-fit polygon", [](const Geometry& a, const Geometry& b, const Options& c) {
    const NoFitPolygon polygon(a, b, Point{}, c);
  });
  add("no-fit table", [](const Geometry& a, const Geometry& b, const Options& c) {
    if (a.region.empty() || b.region.empty()) return;
    const std::array<Geometry, 2> parts{a, b};
    static_cast<void>(NoFitTable(parts, 4, on_two_threads(c)));
  });
  add("depth", [](const Geometry& a, const Geometry& b, const Options& c) {
    static_cast<void>(penetration_depth(a, b, c));
  });
  add("erode, dilate", [](const Geometry& a, const Geometry& b, const Options& c) {
    static_cast<void>(open(a, b, c));
  });
  add("unite, intersect", [](const Geometry& a, const Geometry& b, const Options& c) {
    const std::array<Geometry, 2> both{resolve(a, c), resolve(b, c)};
    const Geometry united = unite(both, c);  // freed later, outside of the library's time
    static_cast<void>(intersect(both[0].region, both[1].region, c));
  });
  add("check", [](const Geometry& a, const Geometry& b, const Options& c) {
    CheckOptions options;
    options.samples = 100;
    options.edges = 100;
    static_cast<void>(check_sum(a, a, b, options, c));
  });
  add("slices", [](const Geometry& a, const Geometry& b, const Options& c) {
    if (b.region.empty()) return;
    const ConfigurationSpace space(b, a, {}, on_two_threads(c));
    static_cast<void>(space.slices(full_turn(9), true));
  });
  return list;
}

struct Input {
  const char* name;
  Geometry a;
  Geometry b;
};

std::vector<Input> inputs(int size) {
  const int few = std::max(4, static_cast<int>(std::sqrt(size)));
  Random random(3);
  std::vector<Input> list;
  const auto add = [&](const char* name, Geometry a, Geometry b) {
    list.push_back({name, std::move(a), std::move(b)});
  };
  add("chain of touching holes", geometry_of(chain_of_holes(size)),
      geometry_of(rectangle(0, 0, 1, 1)));
  add("triangles", geometry_of(triangles(size / 6)), geometry_of(triangles(size / 6)));
  add("squares in each other", geometry_of(nested_squares(size)),
      geometry_of(rectangle(0, 0, 1, 1)));
  add("row of squares", geometry_of(row_of_squares(size)), geometry_of(row_of_squares(few)));
  add("needles", geometry_of(needles(size / 3)), geometry_of(needles(few)));
  add("combs", geometry_of(comb(size / 4, 1, 100'000)),
      geometry_of(turned(comb(size / 4, 1, 100'000))));
  add("spirals", geometry_of(spiral(few)), geometry_of(spiral(few)));
  add("stars", geometry_of(spiky_star(random, size / 4, 100'000)),
      geometry_of(spiky_star(random, size / 4, 100'000)));
  add("polylines", random_path(size / 10, 1), random_path(size / 10, 2));
  add("tangled ring", tangle(size / 4), geometry_of(rectangle(0, 0, 7, 7)));
  add("long numbers", geometry_of(long_numbers(few, 40)),
      geometry_of(long_numbers(few / 4 + 3, 40)));
  add("longest numbers", geometry_of(long_numbers(few / 4 + 3, 4000)),
      geometry_of(rectangle(0, 0, 5, 5)));
  return list;
}

}  // namespace

std::vector<CancelCase> cancel_cases(int size) {
  std::vector<CancelCase> cases;
  for (Input& input : inputs(size)) {
    const auto shapes = std::make_shared<const Input>(std::move(input));
    for (const auto& [name, run] : unary_operations()) {
      cases.push_back({name, shapes->name,
                       [shapes, run = run](const Options& options) { run(shapes->a, options); }});
    }
    for (const auto& [name, run] : binary_operations()) {
      cases.push_back({name, shapes->name, [shapes, run = run](const Options& options) {
                         run(shapes->a, shapes->b, options);
                       }});
    }
  }
  return cases;
}

}  // namespace minksum::test
