#include "io/drawing/chains.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "minksum/error.hpp"

namespace minksum::io {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

bool comes_before(const Point& a, const Point& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

bool path_before(const Chain& a, const Chain& b) {
  return std::lexicographical_compare(a.path.begin(), a.path.end(), b.path.begin(), b.path.end(),
                                      comes_before);
}

/// Makes paths of equal rings equal: each begins at its least vertex, and goes on to the lesser one
/// of that one's neighbours.
void make_canonical(Chain& ring) {
  std::vector<Point>& path = ring.path;
  if (path.size() > 1 && path.front() == path.back()) path.pop_back();
  std::rotate(path.begin(), std::min_element(path.begin(), path.end(), comes_before), path.end());
  if (path.size() > 2 && comes_before(path.back(), path[1])) {
    std::reverse(path.begin() + 1, path.end());
  }
}

/// Drops chains that occur before, and returns how many.
std::size_t drop_repeated(std::vector<Chain>& chains, Cancellation& cancellation) {
  std::stable_sort(chains.begin(), chains.end(), cancellation.counting(path_before));
  const auto end = std::unique(chains.begin(), chains.end(),
                               [](const Chain& a, const Chain& b) { return a.path == b.path; });
  const auto count = static_cast<std::size_t>(chains.end() - end);
  chains.erase(end, chains.end());
  return count;
}

/// Ends of chains have numbers: 2i is the first end of chain i, and 2i + 1 the last one.
class Joiner {
 public:
  Joiner(std::vector<Chain>& chains, Outlines& outlines)
      : chains_(chains), outlines_(outlines), partner_(2 * chains.size(), kNone) {}

  [[nodiscard]] const Point& point(std::size_t end) const {
    const std::vector<Point>& path = chains_[end / 2].path;
    return end % 2 == 0 ? path.front() : path.back();
  }

  void join_equal() {
    std::vector<std::size_t> ends(partner_.size());
    for (std::size_t i = 0; i < ends.size(); ++i) ends[i] = i;
    sort_by_points(ends);
    for (std::size_t i = 0; i < ends.size();) {
      std::size_t k = i + 1;
      while (k < ends.size() && point(ends[k]) == point(ends[i])) ++k;
      if ((k - i) % 2 == 0) {
        for (std::size_t j = i; j < k; j += 2) join(ends[j], ends[j + 1]);
      }
      i = k;
    }
  }

  void join_near(const Rational& distance) {
    if (distance.sign() == 0) return;
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < partner_.size(); ++i) {
      if (partner_[i] == kNone) ends.push_back(i);
    }
    sort_by_points(ends);
    struct Pair {
      Rational square;
      std::size_t a, b;
    };
    std::vector<Pair> pairs;
    const Rational most = distance * distance;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      std::size_t near = 0;
      for (std::size_t k = i + 1; k < ends.size(); ++k) {
        outlines_.cancellation().check(100);
        const Rational x = point(ends[k]).x - point(ends[i]).x;
        if (x > distance) break;
        const Rational y = point(ends[k]).y - point(ends[i]).y;
        const Rational square = x * x + y * y;
        if (square > most) continue;
        pairs.push_back({square, ends[i], ends[k]});
        if (++near > 8) {
          throw Error(ErrorCode::kLimitExceeded,
                      "more than eight ends of lines are nearer than the distance at which ends "
                      "are joined (io::DrawingOptions::join_ends)");
        }
      }
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.square < b.square; });
    for (const Pair& pair : pairs) {
      if (partner_[pair.a] == kNone && partner_[pair.b] == kNone) join(pair.a, pair.b);
    }
  }

  /// Adds joined chains that are open, and returns how many these are. The others go to `rings`.
  std::size_t add(std::vector<Chain>& rings) {
    std::size_t open = 0;
    used_.assign(chains_.size(), false);
    for (std::size_t end = 0; end < partner_.size(); ++end) {
      if (partner_[end] != kNone || used_[end / 2]) continue;
      outlines_.add_polyline(follow(end));
      ++open;
    }
    for (std::size_t i = 0; i < chains_.size(); ++i) {
      if (!used_[i]) rings.push_back(follow(2 * i));
    }
    return open;
  }

 private:
  void sort_by_points(std::vector<std::size_t>& ends) const {
    std::sort(ends.begin(), ends.end(),
              outlines_.cancellation().counting([this](std::size_t a, std::size_t b) {
                return comes_before(point(a), point(b)) || (point(a) == point(b) && a < b);
              }));
  }

  void join(std::size_t a, std::size_t b) {
    partner_[a] = b;
    partner_[b] = a;
  }

  /// Returns the chain that begins at an end, up to where it ends or comes back.
  Chain follow(std::size_t end) {
    Chain result;
    while (end != kNone && !used_[end / 2]) {
      used_[end / 2] = true;
      Chain& chain = chains_[end / 2];
      if (end % 2 == 1) std::reverse(chain.path.begin(), chain.path.end());
      for (const Point& p : chain.path) {
        outlines_.cancellation().check(16);
        if (result.path.empty() || !(result.path.back() == p)) result.path.push_back(p);
      }
      append_rings(result.ribbons, chain.ribbons, false, outlines_.cancellation());
      end = partner_[end ^ 1U];
    }
    return result;
  }

  std::vector<Chain>& chains_;
  Outlines& outlines_;
  std::vector<std::size_t> partner_;  ///< the end to which an end is joined
  std::vector<bool> used_;
};

}  // namespace

Joined add_joined(std::vector<Chain> open, std::vector<Chain> closed, const Rational& distance,
                  Outlines& outlines) {
  Joined result;
  for (Chain& chain : open) {
    if (chain.path.front() == chain.path.back()) {
      closed.push_back(std::move(chain));
      chain.path.clear();
    } else if (comes_before(chain.path.back(), chain.path.front())) {
      std::reverse(chain.path.begin(), chain.path.end());
    }
  }
  std::erase_if(open, [](const Chain& chain) { return chain.path.empty(); });
  result.repeated = drop_repeated(open, outlines.cancellation());
  Joiner joiner(open, outlines);
  joiner.join_equal();
  joiner.join_near(distance);
  result.open = joiner.add(closed);
  for (Chain& ring : closed) make_canonical(ring);
  result.repeated += drop_repeated(closed, outlines.cancellation());
  for (Chain& ring : closed) outlines.add_ring(std::move(ring));
  return result;
}

}  // namespace minksum::io
