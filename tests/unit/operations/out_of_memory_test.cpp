// Tests that memory may run out at any request. The failure is reported as such, no memory leaks,
// no result is cut short silently, and later calls work as if nothing had happened.
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <new>
#include <string>

#include "minksum/io.hpp"
#include "minksum/minkowski_sum.hpp"
#include "minksum/resolve.hpp"
#include "minksum/round.hpp"
#include "minksum/testing.hpp"
#include "support/rounding_options.hpp"

namespace {
// Requests that are still granted; below 0, all are.
long granted = -1;
long held = 0;

void* request(std::size_t size) {
  if (granted == 0) throw std::bad_alloc();
  if (granted > 0) --granted;
  void* const memory = std::malloc(size != 0 ? size : 1);
  if (memory == nullptr) throw std::bad_alloc();
  ++held;
  return memory;
}

void release(void* memory) {
  if (memory == nullptr) return;
  --held;
  std::free(memory);
}
}  // namespace

// These are not inlined, because the compiler would warn of malloc and delete together.
[[gnu::noinline]] void* operator new(std::size_t size) { return request(size); }
[[gnu::noinline]] void operator delete(void* memory) noexcept { release(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { release(memory); }

namespace minksum {
namespace {

enum class Ending { kFine, kWrong, kOutOfMemory, kOther };

// Returns how `step` ends if only so many requests are granted. The step returns whether its result
// is right instead of asserting it, because an assertion that fails needs memory.
Ending run_with(long requests, const std::function<bool()>& step) {
  granted = requests;
  Ending ending = Ending::kOther;
  try {
    ending = step() ? Ending::kFine : Ending::kWrong;
  } catch (const std::bad_alloc&) {
    ending = Ending::kOutOfMemory;
  } catch (...) {
  }
  granted = -1;
  return ending;
}

// Lets each request of `step` fail in turn; returns how many requests there are.
long fail_at_each(const std::function<bool()>& step) {
  EXPECT_TRUE(step());  // makes now what is made once and kept
  constexpr long kMost = 100'000;
  for (long requests = 0; requests < kMost; ++requests) {
    const long before = held;
    const Ending ending = run_with(requests, step);
    EXPECT_EQ(held, before) << "after " << requests << " requests";
    if (ending == Ending::kFine) return requests;
    EXPECT_EQ(ending, Ending::kOutOfMemory) << "after " << requests << " requests";
    if (testing::Test::HasFailure()) break;
  }
  ADD_FAILURE() << "no end";
  return 0;
}

const std::string kTexts[] = {
    "SRID=1;GEOMETRYCOLLECTION (MULTIPOLYGON (((0 0, 4 0, 1/3 1e-30, 0 0), (1 1, 2 1, 1 2, 1 1)), "
    "((9 9, 12345678901234567890123 9, 9 10, 9 9))), LINESTRING (0 0, 1 2, 3 4), POINT (5 5))",
    R"({"type":"Feature","properties":{"name":"a name that is long enough to need memory"},)"
    R"("geometry":{"type":"GeometryCollection","geometries":[{"type":"Point","coordinates":[1,2]},)"
    R"({"coordinates":[[[0,0],["1/3",0],[0,1],[0,0]]],"type":"Polygon"}]}})",
    "2\n4 out\n0 0\n9 0\n9 9\n0 9\n1 3 2 4\n3 in\n3 3\n3 6\n6 6\n1 2 3\n",
    "4 0 0 9 0 9 9 0 9\n1\n3 3 3 3 6 6 6\n"};

TEST(OutOfMemory, Reading) {
  for (const std::string& text : kTexts) {
    const Geometry expected = io::read_geometry(text);
    EXPECT_GT(fail_at_each([&] { return io::read_geometry(text) == expected; }), 5) << text;
    const auto properties = io::read_document(text).properties;
    fail_at_each([&] { return io::read_document(text).properties == properties; });
    fail_at_each([&] { return io::FeatureReader(text).next()->geometry == expected; });
  }
}

TEST(OutOfMemory, Faults) {
  for (const char* text : {"POLYGON ((0 0, 1 0, 1 1, 0 1))", "POLYGON ((0 0, 1 nan))", "[1]"}) {
    fail_at_each([&] {
      try {
        static_cast<void>(io::read_geometry(text));
        return false;
      } catch (const io::ReadError&) {
        return true;
      }
    });
  }
}

// A stream that runs out of memory must not yield a shorter text.
TEST(OutOfMemory, Writing) {
  const Geometry geometry = io::read_geometry(kTexts[0]);
  for (const auto style : {io::Coordinates::Style::kDouble, io::Coordinates::Style::kExact,
                           io::Coordinates::Style::kDecimal}) {
    const std::string expected = io::to_wkt(geometry, {style});
    EXPECT_GT(fail_at_each([&] { return io::to_wkt(geometry, {style}) == expected; }), 1);
  }
}

Region triangle_fan() {
  return io::read("POLYGON ((0 0, 9 -1, 4 1, 9 5, 3 2, 5 9, 2 3, -3 8, 1 2, -9 1, 0 0))");
}

TEST(OutOfMemory, Sums) {
  const Region p = triangle_fan();
  for (const Method method : {Method::kReduced, Method::kSigned, Method::kFull}) {
    SumSettings options;
    options.method = method;
    const Region expected = minkowski_sum(p, p, options);
    EXPECT_GT(fail_at_each([&] { return minkowski_sum(p, p, options) == expected; }), 5);
  }
}

TEST(OutOfMemory, Geometries) {
  const Geometry p = io::read_geometry(
      "GEOMETRYCOLLECTION (POLYGON ((0 0, 4 0, 0 4, 4 4, 0 0)), LINESTRING (1 1, 9 1, 9 7), "
      "POINT (12 3))");
  const Geometry q = io::read_geometry(
      "GEOMETRYCOLLECTION (POLYGON ((0 0, 1/3 0, 0 1/3, 0 0)), "
      "LINESTRING (0 0, -1 2))");
  const Geometry resolved = resolve(p);
  EXPECT_GT(fail_at_each([&] { return resolve(p) == resolved; }), 5);
  const Geometry sum = minkowski_sum(p, q);
  EXPECT_GT(fail_at_each([&] { return minkowski_sum(p, q) == sum; }), 5);
  for (const auto side : test::kRoundingSides) {
    const RoundOptions options = test::to_decimals(1, side);
    const Geometry rounded = round(sum, options);
    EXPECT_GT(fail_at_each([&] { return round(sum, options) == rounded; }), 5);
  }
}

TEST(OutOfMemory, TightPlaces) {
  const Region frame = io::read("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 6, 6 6, 6 3, 3 3))");
  const Region square = io::read("POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))");
  fail_at_each(
      [&] { return detailed_sum(frame, square, {.tight = true}).tight.points.size() == 1; });
}

// A workspace keeps its memory and stays usable. The error itself takes no memory.
TEST(OutOfMemory, WorkspacesStayGood) {
  const Region p = triangle_fan();
  const Region expected = minkowski_sum(p, p);
  constexpr long kMost = 100'000;
  Ending ending = Ending::kOutOfMemory;
  for (long requests = 0; requests < kMost && ending != Ending::kFine; ++requests) {
    Workspace workspace;
    Region result;
    bool ok = true;
    ending = run_with(requests, [&] {
      ok = minkowski_sum(p, p, Options{}, workspace, result).ok();
      return true;
    });
    ASSERT_EQ(ending, Ending::kFine);
    ASSERT_EQ(result.empty(), !ok);
    if (!ok) ending = Ending::kOutOfMemory;
    ASSERT_TRUE(minkowski_sum(p, p, Options{}, workspace, result).ok()) << "after " << requests;
    ASSERT_EQ(result, expected) << "after " << requests << " requests";
  }
  EXPECT_EQ(ending, Ending::kFine);
}

}  // namespace
}  // namespace minksum
