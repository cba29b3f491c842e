// Tests sums of real outlines: each shape of some folders ⊕ a 32-gon and ⊕ the next shape.
//
//   outlines_run [--folders gis,fonts,nesting] [--every N] [--max-vertices N] [--first N]
//
// Each sum must be valid and canonical. Points near its edges and at random must agree with an
// independent test (check_sum). Where the second method is fast enough, its sum must be equal. The
// sum is rounded to doubles and to 3 decimals, to all three sides. It must stay valid, also by GEOS
// if that is available, and on its side. Prints a row for each sum. The exit code is 1 if anything
// is wrong, and 2 without shapes.
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

#include "minksum/boolean.hpp"
#include "minksum/check.hpp"
#include "minksum/measure.hpp"
#include "minksum/round.hpp"
#include "real/shape_run.hpp"
#include "support/geos_validity.hpp"
#include "support/rounding_options.hpp"
#include "support/shapes.hpp"

namespace {

using namespace minksum;

struct Arguments {
  test::ShapeRun shapes{{"gis", "fonts", "nesting"}, 1, 0, 1000000};
  std::uint64_t proof_segments = 50000;
};

/// Returns a regular 32-gon that is a fiftieth of the shape wide; its vertices are doubles.
Region disc_for(const Region& shape) {
  const Box box = *bounding_box(shape);
  const double radius = (box.max.x - box.min.x).to_double() / 100;
  Region disc;
  disc.begin_polygon();
  disc.begin_ring();
  for (int k = 0; k < 32; ++k) {
    const double angle = 2 * std::acos(-1.0) * k / 32;
    disc.add_vertex(radius * std::cos(angle), radius * std::sin(angle));
  }
  return disc;
}

class Runner {
 public:
  explicit Runner(const Arguments& arguments) : arguments_(arguments) {}

  void run(const std::string& name, const Region& p, const Region& q) {
    const Geometry first{p, {}, {}};
    const Geometry second{q, {}, {}};
    const auto begin = std::chrono::steady_clock::now();
    const Geometry sum = minkowski_sum(first, second);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    CheckOptions options;
    options.samples = 200;
    options.edges = 300;
    options.proof.max_segments = arguments_.proof_segments;
    const SumCheck check = check_sum(sum, first, second, options);
    expect(name, check.ok(), "check");
    expect(name, !sum.has_thin_parts(), "thin parts");
    proofs_ += check.proof == Proof::kHolds ? 1 : 0;
    for (const auto decimals : {std::optional<int>(), std::optional<int>(3)}) {
      for (const auto side : test::kRoundingSides) {
        check_rounded(name, sum.region, side, decimals);
      }
    }
    std::cout << name << '\t' << p.vertex_count() << '\t' << q.vertex_count() << '\t'
              << sum.region.vertex_count() << '\t' << sum.region.hole_count() << '\t'
              << seconds.count() << '\t' << check.points << '\t'
              << (check.proof == Proof::kHolds ? "proved" : "points") << std::endl;
    ++sums_;
  }

  [[nodiscard]] int finish() const {
    std::cout << sums_ << " sums, " << proofs_ << " proved by the second method, " << roundings_
              << " roundings" << (test::geos_available() ? " (valid by GEOS)" : "") << ", "
              << faults_ << " faults" << std::endl;
    return faults_ == 0 ? 0 : 1;
  }

 private:
  void expect(const std::string& name, bool good, const std::string& what) {
    if (good) return;
    ++faults_;
    std::cout << name << ": WRONG: " << what << std::endl;
  }
  void check_rounded(const std::string& name, const Region& exact, RoundingSide side,
                     std::optional<int> decimals) {
    const std::string what = std::string("rounded, ") + to_string(side);
    RoundOptions options;
    options.side = side;
    options.decimals = decimals;
    const Region rounded = round(exact, options);
    expect(name, validate(rounded, 1).empty(), what + ": not valid");
    if (!decimals) expect(name, test::geos_fault(rounded).empty(), what + ": not valid by GEOS");
    if (side == RoundingSide::kOutside) expect(name, contains(rounded, exact), what);
    if (side == RoundingSide::kInside) expect(name, contains(exact, rounded), what);
    ++roundings_;
  }

  Arguments arguments_;
  std::size_t sums_ = 0;
  std::size_t proofs_ = 0;
  std::size_t roundings_ = 0;
  std::size_t faults_ = 0;
};

int run(int count, char** values) {
  Arguments arguments;
  arguments.shapes.read_options(count, values, {{"--proof-segments", [&](const std::string& value) {
                                   arguments.proof_segments = std::stoul(value);
                                 }}});
  const auto data = test::data_path();
  if (!data) return 2;
  Runner runner(arguments);
  const auto any = [](const test::DataFile&) { return true; };
  arguments.shapes.for_each(*data, any, [&](const std::string& name, const Region& shape,
                                            const std::string& next, const Region& other) {
    runner.run(name + " + 32-gon", shape, disc_for(shape));
    runner.run(name + " + " + next, shape, other);
  });
  return runner.finish();
}

}  // namespace

int main(int count, char** values) {
  try {
    return run(count, values);
  } catch (const std::exception& error) {
    std::cerr << "outlines_run: " << error.what() << '\n';
    return 1;
  }
}
