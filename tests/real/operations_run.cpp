// Tests uses of sums on real shapes: morphology, no-fit polygons, depth and slices of configuration
// spaces. Each shape of some folders meets a small element and the next shape. Results are tested
// by law, by definition and beside a raster.
//
//   operations_run [--folders paper,nesting,fonts,gis,cgal] [--every N] [--first N] [--max-vertices
//   N]
//            [--raster N] [--placements N]
//
// Prints a row for each shape. The exit code is 1 if anything is wrong, and 2 without shapes.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include "minksum/boolean.hpp"
#include "minksum/configuration_space.hpp"
#include "minksum/depth.hpp"
#include "minksum/measure.hpp"
#include "minksum/morphology.hpp"
#include "minksum/no_fit.hpp"
#include "minksum/resolve.hpp"
#include "minksum/transform.hpp"
#include "real/shape_run.hpp"
#include "reference/membership.hpp"
#include "support/random.hpp"
#include "support/shapes.hpp"

namespace {

using namespace minksum;

struct Arguments {
  test::ShapeRun shapes{{"paper", "nesting", "fonts", "gis", "cgal"}, 1, 0, 2000};
  int raster = 64;       ///< points along the longer side
  int placements = 100;  ///< placements tried for each pair
};

Geometry as_geometry(const Region& region) { return {region, {}, {}}; }

/// Returns a double with few digits near this one.
Rational short_number(double value) {
  const int exponent = std::ilogb(value == 0 ? 1 : value) - 8;
  return Rational(std::ldexp(std::nearbyint(std::ldexp(value, -exponent)), exponent));
}

struct Size {
  Point min;
  Rational width;
  Rational height;
  explicit Size(const Region& region) {
    const Box box = *bounding_box(region);
    min = box.min;
    width = box.max.x - box.min.x;
    height = box.max.y - box.min.y;
  }
  [[nodiscard]] Rational longer() const { return std::max(width, height); }
};

/// Returns an element that is a fortieth as wide as the shape, is not convex, and has the origin
/// inside.
Region element_for(const Region& shape) {
  const Rational step = short_number(Size(shape).longer().to_double() / 160);
  return test::scaled(
      test::make_polygon({{-2, -2}, {2, -2}, {2, 2}, {1, 2}, {0, 1}, {-1, 2}, {-2, 2}}), step);
}

class Runner {
 public:
  explicit Runner(const Arguments& arguments) : arguments_(arguments) {}

  void run(const std::string& name, const Region& shape, const Region& next) {
    const auto begin = std::chrono::steady_clock::now();
    name_ = name;
    const Region element = element_for(shape);
    check_laws(shape, element);
    check_duality(shape, element);
    check_raster(shape, element);
    check_placements(shape, next);
    check_depth(shape, next);
    check_slices(shape, next);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    std::cout << name << '\t' << shape.vertex_count() << '\t' << next.vertex_count() << '\t'
              << seconds.count() << std::endl;
    ++shapes_;
  }

  [[nodiscard]] int finish() const {
    std::cout << shapes_ << " shapes; raster: " << pixels_ << " points, " << fitting_
              << " of them fit; placements: " << contacts_[0] << " free, " << contacts_[1]
              << " touching, " << contacts_[2] << " overlapping; depths: " << depths_
              << " overlapping; configurations: " << apart_ << " free, " << colliding_
              << " colliding; " << faults_ << " faults" << std::endl;
    return faults_ == 0 ? 0 : 1;
  }

 private:
  void expect(bool good, const std::string& what) {
    if (good) return;
    ++faults_;
    std::cout << name_ << ": WRONG: " << what << std::endl;
  }

  void check_laws(const Region& shape, const Region& element) {
    const Geometry a = as_geometry(shape);
    const Geometry b = as_geometry(element);
    const Region plain = resolve(a).region;
    const Geometry opened = open(a, b);
    const Geometry closed = close(a, b);
    expect(contains(plain, opened.region), "an opening is within the shape");
    expect(contains(closed.region, plain), "a closing contains the shape");
    expect(open(opened, b) == opened, "opening twice");
    expect(close(closed, b) == closed, "closing twice");
    const Region eroded = erode(a, b).region;
    expect(contains(plain, eroded), "an erosion by what holds the origin is within the shape");
    expect(contains(plain, dilate(as_geometry(eroded), b).region), "(A - B) + B is within A");
  }

  // In a frame, the erosion by B is what the dilation of the complement by -B leaves.
  void check_duality(const Region& shape, const Region& element) {
    const Size size(shape);
    const Rational far = size.longer();
    const auto frame = [&](const Rational& by) {
      const Point low{size.min.x - by, size.min.y - by};
      const Point high{size.min.x + size.width + by, size.min.y + size.height + by};
      return Region(Polygon{{low, {high.x, low.y}, high, {low.x, high.y}}, {}});
    };
    const Region rest = subtract(frame(far + far), resolve(as_geometry(shape)).region);
    const Region around = minkowski_sum(rest, reflect(element));
    expect(subtract(frame(far), around) == erode(as_geometry(shape), as_geometry(element)).region,
           "duality");
  }

  // By definition, x is in the erosion if x + b is in A for all b in B. This is tested for the
  // vertices of B and its points on a fine grid. All points of the erosion must pass. Points that
  // pass must be in the erosion of A grown by the step of the grid.
  void check_raster(const Region& shape, const Region& element) {
    const Size size(shape);
    const Rational step = Size(element).longer() / Rational(16);
    std::vector<Point> of_element;
    for (std::size_t v = 0; v < element.vertex_count(); ++v) of_element.push_back(element.point(v));
    const PointLocator in_element(as_geometry(element));
    for (int i = -8; i <= 8; ++i) {
      for (int j = -8; j <= 8; ++j) {
        const Point b{step * Rational(i), step * Rational(j)};
        if (in_element.locate(b) != Location::kOutside) of_element.push_back(b);
      }
    }
    const Region square = test::scaled(test::rectangle(-1, -1, 1, 1), step);
    Options tight;
    tight.tight = true;
    const PointLocator in_shape(resolve(as_geometry(shape)));
    const PointLocator eroded(erode(as_geometry(shape), as_geometry(element), tight));
    const PointLocator upper(
        erode(as_geometry(minkowski_sum(resolve(as_geometry(shape)).region, square)),
              as_geometry(element), tight));
    const Rational pixel = size.longer() / Rational(arguments_.raster);
    for (int i = 0; Rational(i) * pixel < size.width; ++i) {
      for (int j = 0; Rational(j) * pixel < size.height; ++j) {
        const Point x{size.min.x + pixel * Rational(2 * i + 1, 2),
                      size.min.y + pixel * Rational(2 * j + 1, 2)};
        const bool fits = std::all_of(of_element.begin(), of_element.end(), [&](const Point& b) {
          return in_shape.locate({x.x + b.x, x.y + b.y}) != Location::kOutside;
        });
        ++pixels_;
        fitting_ += fits ? 1 : 0;
        if (!fits) expect(eroded.locate(x) == Location::kOutside, "an erosion beyond its raster");
        if (fits) expect(upper.locate(x) != Location::kOutside, "a raster beyond the erosion");
      }
    }
  }

  void check_placements(const Region& fixed, const Region& moving) {
    const NoFitPolygon nfp(as_geometry(fixed), as_geometry(moving));
    const Point reference = moving.point(0);
    const Region valid = resolve(as_geometry(fixed)).region;
    const auto check = [&](const Point& t) {
      const Region placed =
          transform(moving, Affine::translation(t.x - reference.x, t.y - reference.y));
      const bool overlap = !intersect(valid, placed).empty();
      const reference::Pt origin{reference::Number(0), reference::Number(0)};
      const bool meet = overlap || reference::contains_sum(valid, reflect(placed), origin);
      const Contact expected = overlap ? Contact::kOverlapping
                               : meet  ? Contact::kTouching
                                       : Contact::kFree;
      expect(nfp.contact(t) == expected, "a placement");
      ++contacts_[static_cast<int>(expected)];
    };
    // Placements lie at random around the shape, and a few at vertices of the polygon, which touch.
    const Size size(nfp.geometry().region);
    for (int k = 0; k < arguments_.placements; ++k) {
      const Region& region = nfp.geometry().region;
      if (k % 8 == 0) {
        check(region.point(random_.next() % region.vertex_count()));
        continue;
      }
      const auto within = [&](const Rational& low, const Rational& length) {
        return low + length * Rational(random_.between(-50, 1050), 1000);
      };
      check({within(size.min.x, size.width), within(size.min.y, size.height)});
    }
  }

  void check_depth(const Region& shape, const Region& next) {
    const Size size(shape);
    const Size other(next);
    const Region moved = transform(
        next, Affine::translation(size.min.x - other.min.x + size.width * Rational(1, 2),
                                  size.min.y - other.min.y + size.height * Rational(1, 3)));
    const auto depth = penetration_depth(as_geometry(shape), as_geometry(moved));
    const Region valid = resolve(as_geometry(shape)).region;
    const auto overlap_at = [&](const Rational& part) {
      const Affine way = Affine::translation(depth->vector.x * part, depth->vector.y * part);
      return !intersect(valid, transform(moved, way)).empty();
    };
    expect(depth->overlapping == overlap_at(Rational(0)), "whether shapes overlap");
    expect(!overlap_at(Rational(1)), "the depth's vector separates");
    if (depth->overlapping) {
      expect(overlap_at(Rational(999999, 1000000)), "a hair less does not");
      ++depths_;
    }
  }

  // The next shape, about a tenth as large, is a robot among this one. A placed robot must collide
  // if and only if its configuration is inside the obstacles of the slice.
  void check_slices(const Region& shape, const Region& next) {
    const double ratio = Size(shape).longer().to_double() / Size(next).longer().to_double();
    const Region robot = test::scaled(next, short_number(ratio / 10));
    const Region valid = resolve(as_geometry(shape)).region;
    const ConfigurationSpace space(as_geometry(robot), as_geometry(shape));
    std::vector<Turn> turns;
    for (const int degrees : {0, 37, 90, 121, 160, 200, 270, 333}) {
      turns.push_back(nearest_turn(degrees));
    }
    for (const Slice& slice : space.slices(turns)) {
      const PointLocator obstacles(slice.obstacles);
      const Size size(slice.obstacles.region);
      const Region turned = transform(robot, slice.turn.map());
      for (int k = 0; k < arguments_.placements / 8; ++k) {
        const Point at{size.min.x + size.width * Rational(random_.between(-20, 1020), 1000),
                       size.min.y + size.height * Rational(random_.between(-20, 1020), 1000)};
        const Region placed = transform(turned, Affine::translation(at.x, at.y));
        const bool collides = !intersect(valid, placed).empty();
        expect((obstacles.locate(at) == Location::kInside) == collides, "a configuration");
        ++(collides ? colliding_ : apart_);
      }
    }
  }

  Arguments arguments_;
  std::string name_;
  test::Random random_{2011};
  std::size_t shapes_ = 0;
  std::size_t pixels_ = 0;
  std::size_t fitting_ = 0;
  std::size_t contacts_[3] = {0, 0, 0};
  std::size_t depths_ = 0;
  std::size_t apart_ = 0;
  std::size_t colliding_ = 0;
  std::size_t faults_ = 0;
};

int run(int count, char** values) {
  Arguments arguments;
  const auto number = [](int& target) {
    return [&target](const std::string& value) { target = std::stoi(value); };
  };
  arguments.shapes.read_options(
      count, values,
      {{"--raster", number(arguments.raster)}, {"--placements", number(arguments.placements)}});
  const auto data = test::data_path();
  if (!data) return 2;
  Runner runner(arguments);
  const auto valid = [](const test::DataFile& file) { return file.is_valid; };
  arguments.shapes.for_each(*data, valid,
                            [&](const std::string& name, const Region& shape, const std::string&,
                                const Region& next) { runner.run(name, shape, next); });
  return runner.finish();
}

}  // namespace

int main(int count, char** values) {
  try {
    return run(count, values);
  } catch (const std::exception& error) {
    std::cerr << "operations_run: " << error.what() << '\n';
    return 1;
  }
}
