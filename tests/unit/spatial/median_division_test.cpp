// Tests that a division in two steps handles the same parts, in the same order, as one at once.
#include "spatial/median_division.hpp"

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace {

using namespace minksum;
using minksum::test::Random;

struct Line {
  Vec<double> a, b;
};

/// Lists the segments of each part that it handles: first whether they are a crowd.
class Recorder {
 public:
  Recorder(const std::vector<Line>& lines, const std::vector<BoxedSegment>& items)
      : lines_(lines), items_(items) {}
  std::vector<std::vector<std::uint32_t>> handled;

  bool enter(std::size_t, std::size_t, std::size_t, const BoxOf<double>&, const BoxOf<double>&) {
    return true;
  }
  template <Axis axis>
  [[nodiscard]] bool cut(std::uint32_t line, double at, LineCut& result) const {
    return cut_segment<axis>(lines_[line].a, lines_[line].b, at, 0x1p-30, 0x1p-40, result);
  }
  void meet_few(std::size_t begin, std::size_t end) { record(0, begin, end); }
  void meet_crowd(std::size_t begin, std::size_t end, const BoxOf<double>&) {
    record(1, begin, end);
  }
  [[nodiscard]] bool is_sorted_soon(std::size_t, std::size_t, const BoxOf<double>&) const {
    return false;
  }
  [[nodiscard]] std::optional<DividingLine> line_among_crossings(std::size_t, std::size_t,
                                                                 const BoxOf<double>&) const {
    return std::nullopt;
  }

 private:
  void record(std::uint32_t kind, std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t>& part = handled.emplace_back(1, kind);
    for (std::size_t i = begin; i < end; ++i) part.push_back(items_[i].segment);
  }
  const std::vector<Line>& lines_;
  const std::vector<BoxedSegment>& items_;
};

std::vector<BoxedSegment> boxes(const std::vector<Line>& lines) {
  std::vector<BoxedSegment> items;
  for (const auto& [a, b] : lines) {
    items.push_back(
        {{std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)},
         static_cast<std::uint32_t>(items.size())});
  }
  return items;
}

/// Most lines are short. `long_ones` of a hundred pass far.
std::vector<Line> random_lines(Random& random, int count, int long_ones) {
  const auto unit = [&] { return static_cast<double>(random.below(1 << 20)) * 0x1p-20; };
  std::vector<Line> lines;
  for (int i = 0; i < count; ++i) {
    const double reach = static_cast<int>(random.below(100)) < long_ones ? 1 : 0.02;
    const Vec<double> a{unit(), unit()};
    lines.push_back({a, {a.x + reach * (unit() - 0.5), a.y + reach * (unit() - 0.5)}});
  }
  return lines;
}

TEST(MedianDivision, HandlesTheSameInTwoSteps) {
  Random random(5);
  Cancellation never;
  constexpr double kSlack = 0x1p-34;
  const BoxOf<double> plane{-HUGE_VAL, -HUGE_VAL, HUGE_VAL, HUGE_VAL};
  std::size_t parts = 0;
  std::size_t crowds = 0;
  for (const int count : {2, 17, 200, 3000}) {
    for (const int long_ones : {0, 10, 60, 100}) {
      const std::vector<Line> lines = random_lines(random, count, long_ones);
      std::vector<BoxedSegment> items = boxes(lines);
      Recorder at_once(lines, items);
      MedianDivision(at_once, items, kSlack, never).divide(plane);
      for (const std::size_t most : {0U, 50U, 500U, 5000U}) {
        items = boxes(lines);
        Recorder first(lines, items);
        std::vector<UndividedPart> undivided;
        MedianDivision(first, items, kSlack, never).split(plane, most, undivided);
        EXPECT_TRUE(first.handled.empty());
        std::vector<BoxedSegment> own;
        Recorder second(lines, own);
        for (UndividedPart& part : undivided) {
          MedianDivision(second, own, kSlack, never).divide(part);
          EXPECT_TRUE(own.empty());
        }
        EXPECT_EQ(second.handled, at_once.handled) << count << ' ' << long_ones << ' ' << most;
        parts = std::max(parts, undivided.size());
      }
      for (const auto& part : at_once.handled) crowds += part[0];
    }
  }
  EXPECT_GT(parts, 30U);
  EXPECT_GT(crowds, 5U);
}

}  // namespace
