// Tests every shape alone and with others: both methods and brute force must agree.
#include <gtest/gtest.h>

#include <exception>
#include <iostream>

#include "degenerate/shapes.hpp"
#include "minksum/resolve.hpp"
#include "reference/brute_force.hpp"
#include "reference/brute_force_overlay.hpp"
#include "support/data.hpp"
#include "support/geometries.hpp"

namespace {

using namespace minksum;
using namespace minksum::test;

constexpr std::size_t kPartners = 10;

/// Returns about how many convex pieces an operand has, which brute force pairs.
std::size_t pieces(const Geometry& geometry) {
  std::size_t count = geometry.points.size();
  for (const Polyline& polyline : geometry.polylines) count += polyline.size() - 1;
  return count + geometry.region.vertex_count() + 2 * geometry.region.hole_count();
}

std::size_t bits(const Geometry& geometry) {
  std::size_t most = 1;
  for (std::size_t v = 0; v < geometry.region.vertex_count(); ++v) {
    most = std::max({most, geometry.region.exact_x(v).bits(), geometry.region.exact_y(v).bits()});
  }
  return most;
}

/// Returns whether brute force would take too long. Its time grows with the square of the pairs of
/// pieces, and with the length of numbers.
bool is_too_much(const Geometry& p, const Geometry& q) {
  constexpr double kMost = 3e7;
  const auto pairs = static_cast<double>(pieces(p) * pieces(q));
  const auto length = static_cast<double>(std::max(bits(p), bits(q)));
  return pairs * pairs * std::max(1.0, length / 30) > kMost;
}

void expect_agreement(const std::string& a, const std::string& b, std::size_t& skipped) {
  const Geometry p = read_shape(a);
  const Geometry q = read_shape(b);
  try {
    const std::string reduced = to_text(reduced_sum(p, q));
    EXPECT_EQ(to_text(signed_sum_of(p, q)), reduced) << a << " and " << b << ", signed";
    const Geometry resolved_p = reference::brute_force_resolve(p, FillRule::kAutomatic);
    const Geometry resolved_q = reference::brute_force_resolve(q, FillRule::kAutomatic);
    if (is_too_much(resolved_p, resolved_q)) {
      std::cout << a << " and " << b << ": too many pieces for brute force\n";
      ++skipped;
      return;
    }
    EXPECT_EQ(to_text(reference::brute_force_sum(resolved_p, resolved_q)), reduced)
        << a << " and " << b << ", brute force";
  } catch (const std::exception& error) {
    ADD_FAILURE() << a << " and " << b << ": " << error.what();
  }
}

TEST(DegenerateShapes, EachAloneResolves) {
  if (!degenerate_path()) GTEST_SKIP() << "no data";
  for (const std::string& name : degenerate_names()) {
    const Geometry shape = read_shape(name);
    const Geometry resolved = resolve(shape);
    EXPECT_EQ(reference::resolved_fault(resolved), "") << name;
    EXPECT_EQ(to_text(reference::brute_force_resolve(shape, FillRule::kAutomatic)),
              to_text(resolved)) << name;
    // The origin is the identity of Minkowski sums.
    const Geometry origin{{}, {}, {Point{}}};
    EXPECT_EQ(to_text(minkowski_sum(shape, origin)), to_text(resolved)) << name;
    EXPECT_EQ(to_text(minkowski_sum(origin, shape)), to_text(resolved)) << name;
  }
}

TEST(DegenerateShapes, ListedPairsAgree) {
  const auto folder = degenerate_path();
  if (!folder) GTEST_SKIP() << "no data";
  std::size_t count = 0;
  std::size_t skipped = 0;
  for (auto& row : read_table(*folder / "pairs.tsv")) {
    const auto name = [&](const char* key) { return row[key].substr(0, row[key].find('.')); };
    expect_agreement(name("A"), name("B"), skipped);
    ++count;
  }
  std::cout << count << " pairs, " << skipped << " of them without brute force\n";
  EXPECT_GT(count, 100U);
}

TEST(DegenerateShapes, EachWithTenOthersAgrees) {
  if (!degenerate_path()) GTEST_SKIP() << "no data";
  const std::vector<std::string> names = degenerate_names();
  std::size_t count = 0;
  std::size_t skipped = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t k = 1; k <= kPartners; ++k) {
      // The steps differ, so that partners are of all kinds and not always the same few.
      const std::size_t j = (i + k * k * 7 + k) % names.size();
      expect_agreement(names[i], names[j], skipped);
      ++count;
    }
  }
  std::cout << count << " pairs, " << skipped << " of them without brute force\n";
}

}  // namespace
