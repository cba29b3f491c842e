#include "list_convolution.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "listed_rings.hpp"
#include "peers/stopwatch.hpp"

namespace minksum::bench {
namespace {

struct Segment {
  Site from;
  Site to;
};

// An edge, named by its first vertex, with its direction as a number that grows with the angle.
struct Direction {
  std::uint64_t angle;
  std::uint32_t edge;
  std::int32_t dx;
  std::int32_t dy;
};
using Directions = std::vector<Direction>;

constexpr int kAngleBits = 33;
constexpr int kDigitBits = 11;

std::int64_t cross(const Direction& a, const Direction& b) {
  return std::int64_t{a.dx} * b.dy - std::int64_t{a.dy} * b.dx;
}

// Compares directions. Rounding makes an angle at most one off, so close angles are compared
// exactly.
bool before(const Direction& a, const Direction& b) {
  if (a.angle + 1 < b.angle) return true;
  return a.angle <= b.angle + 1 && cross(a, b) > 0;
}

// Returns the way along the diamond |x| + |y| = 1 to the direction, where each side counts 2^30.
std::uint64_t angle_of(std::int32_t dx, std::int32_t dy) {
  const double x = dx;
  const double y = dy;
  const double along = y / (std::abs(x) + std::abs(y));
  const bool left = x < 0 || (x == 0 && y > 0);
  const double quarters = left ? 2 - along : y < 0 ? 4 + along : along;
  return static_cast<std::uint64_t>(quarters * 0x1p30);
}

class Sorter {
 public:
  void sort(const ListedRings& rings, Directions& sorted) {
    fill(rings, sorted);
    if (sorted.size() > 64) {
      for (int shift = 0; shift < kAngleBits; shift += kDigitBits) pass(shift, sorted);
    }
    for (std::size_t i = 1; i < sorted.size(); ++i) {
      const Direction moved = sorted[i];
      std::size_t to = i;
      for (; to > 0 && before(moved, sorted[to - 1]); --to) sorted[to] = sorted[to - 1];
      sorted[to] = moved;
    }
  }

 private:
  static void fill(const ListedRings& rings, Directions& sorted) {
    sorted.resize(rings.sites.size());
    for (std::uint32_t i = 0; i < sorted.size(); ++i) {
      const Site a = rings.sites[i];
      const Site b = rings.sites[rings.next[i]];
      sorted[i] = {angle_of(b.x - a.x, b.y - a.y), i, b.x - a.x, b.y - a.y};
    }
  }
  void pass(int shift, Directions& sorted) {
    constexpr std::uint64_t kMask = (1U << kDigitBits) - 1;
    std::array<std::uint32_t, kMask + 2> begin{};
    for (const Direction& d : sorted) ++begin[((d.angle >> shift) & kMask) + 1];
    for (std::size_t i = 1; i < begin.size(); ++i) begin[i] += begin[i - 1];
    other_.resize(sorted.size());
    for (const Direction& d : sorted) other_[begin[(d.angle >> shift) & kMask]++] = d;
    std::swap(sorted, other_);
  }
  Directions other_;
};

class Lister {
 public:
  Lister(const ListedRings& p, const ListedRings& q) : rings_{&p, &q} {}

  std::size_t list() {
    for (const std::size_t i : {0U, 1U}) {
      sorter_.sort(*rings_[i], sorted_[i]);
      gather(*rings_[i], sorted_[i], edges_[i]);
      place_[i].resize(sorted_[i].size());
    }
    merge();
    written_ = 0;
    write_runs(*rings_[0], place_[0], edges_[1]);
    write_runs(*rings_[1], place_[1], edges_[0]);
    return written_;
  }

 private:
  static void gather(const ListedRings& rings, const Directions& sorted,
                     std::vector<Segment>& edges) {
    edges.resize(sorted.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const std::uint32_t edge = sorted[i].edge;
      edges[i] = {rings.sites[edge], rings.sites[rings.next[edge]]};
    }
  }
  // Vertices of P own the directions [in, out), and those of Q own (in, out]. So of parallel edges,
  // P's count as the earlier ones.
  void merge() {
    std::uint32_t i = 0;
    std::uint32_t j = 0;
    while (i < sorted_[0].size() || j < sorted_[1].size()) {
      if (j == sorted_[1].size() ||
          (i < sorted_[0].size() && !before(sorted_[1][j], sorted_[0][i]))) {
        place_[0][sorted_[0][i++].edge] = j;
      } else {
        place_[1][sorted_[1][j++].edge] = i;
      }
    }
  }
  void write_runs(const ListedRings& rings, const std::vector<std::uint32_t>& place,
                  const std::vector<Segment>& edges) {
    const auto end = static_cast<std::uint32_t>(edges.size());
    for (std::uint32_t v = 0; v < rings.sites.size(); ++v) {
      const Site before = rings.sites[rings.previous[v]];
      const Site here = rings.sites[v];
      const Site after = rings.sites[rings.next[v]];
      const std::int64_t in_x = here.x - before.x;
      const std::int64_t in_y = here.y - before.y;
      const std::int64_t out_x = after.x - here.x;
      const std::int64_t out_y = after.y - here.y;
      if (in_x * out_y - in_y * out_x <= 0) continue;
      const std::uint32_t from = place[rings.previous[v]];
      const std::uint32_t to = place[v];
      // A left turn goes past the direction 0 if and only if it leaves the upper half.
      const bool wraps =
          (in_y < 0 || (in_y == 0 && in_x < 0)) && (out_y > 0 || (out_y == 0 && out_x > 0));
      if (wraps) {
        write(edges.data() + from, end - from, here);
        write(edges.data(), to, here);
      } else {
        write(edges.data() + from, to - from, here);
      }
    }
  }
  void write(const Segment* run, std::size_t size, Site by) {
    if (list_.size() < written_ + size) list_.resize(2 * (written_ + size));
    Segment* const out = list_.data() + written_;
    for (std::size_t i = 0; i < size; ++i) {
      out[i] = {{run[i].from.x + by.x, run[i].from.y + by.y},
                {run[i].to.x + by.x, run[i].to.y + by.y}};
    }
    written_ += size;
  }

  const ListedRings* rings_[2];
  Sorter sorter_;
  Directions sorted_[2];
  std::vector<Segment> edges_[2];
  /// The number of the other operand's directions before that of each edge.
  std::vector<std::uint32_t> place_[2];
  std::vector<Segment> list_;
  std::size_t written_ = 0;
};

}  // namespace

Listing list_convolution(const Region& p, const Region& q) {
  const ListedOperands operands = listed_operands(p, q);
  Lister lister(operands.p, operands.q);
  Listing result;
  result.exact = operands.exact;
  result.segments = lister.list();
  std::vector<double> seconds;
  double total = 0;
  while (seconds.size() < 7 || (seconds.size() < 101 && total < 0.05)) {
    const Stopwatch watch;
    (void)lister.list();
    seconds.push_back(watch.seconds());
    total += seconds.back();
  }
  std::sort(seconds.begin(), seconds.end());
  result.seconds = seconds[seconds.size() / 2];
  return result;
}

}  // namespace minksum::bench
