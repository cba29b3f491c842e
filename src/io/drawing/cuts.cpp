#include "io/drawing/cuts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "minksum/error.hpp"

namespace minksum::io {
namespace {

/// Cuts one part after the other, each piece as long as it may be.
class Cutter {
 public:
  static constexpr std::size_t kMostPieces = std::size_t{1} << 20;

  Cutter(const DoubleCurve& curve, const CutSizes& sizes, Cancellation& cancellation)
      : curve_(curve), sizes_(sizes), cancellation_(cancellation) {}

  std::vector<Piece> run(bool box_turns) {
    const std::size_t last = curve_.size() - 1;
    for (std::size_t part = 0; part < last; ++part) cut_evenly(part, 0, 1);
    // The last piece ends with the curve, and so it is found backwards.
    double begin = last == 0 ? longest(0, 0, 1, true).end : 0;
    double end = longest(last, 0, 1, false).begin;
    if (last == 0 && begin >= end) begin = end = (begin + end) / 2;
    if (last == 0) add(0, 0, begin);
    if (begin < end) cut_evenly(last, begin, end);
    add(last, end, 1);
    if (box_turns) box_sharp_turns();
    return std::move(pieces_);
  }

 private:
  [[nodiscard]] Piece piece(std::size_t part, double begin, double end) const {
    cancellation_.check(300);
    Piece result{part, begin, end, false, measure(curve_, part, begin, end)};
    const Extent& extent = result.extent;
    const bool fits = extent.regular && extent.width <= sizes_.width && extent.length > 0;
    result.boxed = extent.diameter <= (fits ? sizes_.least : sizes_.diameter);
    if (!fits && !result.boxed) result.extent.length = -1;
    return result;
  }
  static bool fits(const Piece& piece) { return piece.extent.length >= 0; }

  void add(std::size_t part, double begin, double end) {
    pieces_.push_back(piece(part, begin, end));
  }

  /// Returns the longest piece that fits and begins at `begin`, or that ends at `end`.
  [[nodiscard]] Piece longest(std::size_t part, double begin, double end, bool forwards) const {
    constexpr double kShortest = 0x1p-40;
    const auto of_size = [&](double size) {
      return forwards ? piece(part, begin, begin + size) : piece(part, end - size, end);
    };
    const double whole = end - begin;
    Piece best{};
    double low = 0;
    double high = HUGE_VAL;
    double size = std::min(whole, guess_);
    // Widths, and squares of diameters, grow about as squares of lengths. So few steps find a piece
    // that is nearly the longest.
    for (int step = 0; low < 0.97 * high; ++step) {
      const Piece tried = of_size(size);
      const double diameter = tried.extent.diameter / sizes_.diameter;
      const double share = tried.boxed ? diameter * diameter : tried.extent.width / sizes_.width;
      (fits(tried) ? low : high) = size;
      if (fits(tried)) {
        best = tried;
        if (size == whole || share > 0.95) break;
      }
      if (low == 0 && size < kShortest) {
        throw Error(ErrorCode::kLimitExceeded,
                    "a curve is not smooth enough to be flattened within the tolerance");
      }
      const double grown = size * std::sqrt(0.98 / std::max(share, 1e-3));
      const bool inside = grown > low && grown < high && step % 3 != 2;
      size = inside ? grown : low == 0 ? high / 4 : (low + high) / 2;
      // A piece of nearly all would leave a short one behind it.
      if (high > whole && size > 0.97 * whole) size = whole;
    }
    guess_ = low;
    return best;
  }

  /// Cuts from `begin` to `end` into pieces of about equal widths.
  void cut_evenly(std::size_t part, double begin, double end) {
    std::vector<Piece> pieces;
    for (double at = begin; at < end; at = pieces.back().end) {
      pieces.push_back(longest(part, at, end, true));
      if (pieces.size() > kMostPieces) {
        throw Error(ErrorCode::kLimitExceeded,
                    "a curve would have more than 2^20 vertices by this tolerance");
      }
    }
    // All but the last piece are as long as they may be. As many pieces that are a little shorter
    // leave no short one.
    const auto count = static_cast<double>(pieces.size());
    const double last = std::sqrt(std::min(pieces.back().extent.width / sizes_.width, 1.0));
    const double length = (count - 1 + last) / count;
    std::vector<Piece> even;
    for (std::size_t i = 1; i <= pieces.size(); ++i) {
      double next = end;
      if (i < pieces.size()) {
        const double at = static_cast<double>(i) * length;
        const Piece& there = pieces[static_cast<std::size_t>(at)];
        next = there.begin + (at - std::floor(at)) * (there.end - there.begin);
      }
      even.push_back(piece(part, even.empty() ? begin : even.back().end, next));
      if (!fits(even.back())) {
        even = std::move(pieces);
        break;
      }
    }
    pieces_.insert(pieces_.end(), even.begin(), even.end());
  }

  /// Whether the curve turns by more than 45 degrees between two pieces. What lies beside a cut
  /// there may leave the quadrilateral on the other side.
  static bool turn_sharply(const Piece& a, const Piece& b) {
    const Vector<double>& in = a.extent.chord;
    const Vector<double>& out = b.extent.chord;
    const double ahead = in.x * out.x + in.y * out.y;
    return !a.boxed && !b.boxed && ahead < std::abs(in.x * out.y - in.y * out.x);
  }
  /// Makes boxed pieces of what lies beside a cut between two such pieces.
  void box_sharp_turns() {
    std::vector<Piece> pieces;
    const auto add_boxed = [&](const Piece& of, bool at_begin) {
      double size = of.end - of.begin;
      Piece boxed{};
      do {
        size /= 4;  // a piece may have a sharp turn at either end
        boxed = at_begin ? piece(of.part, of.begin, of.begin + size)
                         : piece(of.part, of.end - size, of.end);
      } while (boxed.extent.diameter > sizes_.diameter);
      boxed.boxed = true;
      pieces.push_back(boxed);
    };
    for (std::size_t i = 0; i < pieces_.size(); ++i) {  // a small piece is boxed as a whole
      const bool turns = (i > 0 && turn_sharply(pieces_[i - 1], pieces_[i])) ||
                         (i + 1 < pieces_.size() && turn_sharply(pieces_[i], pieces_[i + 1]));
      if (turns && pieces_[i].extent.diameter <= sizes_.diameter) pieces_[i].boxed = true;
    }
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      const Piece& whole = pieces_[i];
      double begin = whole.begin;
      if (i > 0 && turn_sharply(pieces_[i - 1], whole)) {
        add_boxed(whole, true);
        begin = pieces.back().end;
      }
      pieces.push_back(whole);
      if (begin != whole.begin) pieces.back() = piece(whole.part, begin, whole.end);
      if (i + 1 < pieces_.size() && turn_sharply(whole, pieces_[i + 1])) {
        const std::size_t rest = pieces.size() - 1;
        add_boxed(whole, false);
        pieces[rest] = piece(whole.part, begin, pieces.back().begin);
      }
    }
    pieces_ = std::move(pieces);
  }

  const DoubleCurve& curve_;
  CutSizes sizes_;
  Cancellation& cancellation_;
  mutable double guess_ = 1;
  std::vector<Piece> pieces_;
};

/// Returns how far apart the directions at both ends of a curve are, as vectors of length 1.
double turn_of(const Bezier<double>& curve) {
  const auto direction = [&](std::size_t from, bool forwards) -> Vector<double> {
    const auto [x, y] = curve.at(from);
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const auto [to_x, to_y] = curve.at(forwards ? i : from - i);
      const double length = std::hypot(to_x - x, to_y - y);
      if (length > 0) return {(to_x - x) / length, (to_y - y) / length};
    }
    return {0, 0};
  };
  const Vector<double> in = direction(0, true);
  const Vector<double> out = direction(curve.size() - 1, false);
  return std::hypot(in.x + out.x, in.y + out.y);
}

}  // namespace

DoubleCurve middle_of(const Curve& curve) {
  DoubleCurve result;
  for (const Bezier<Interval>& part : curve.parts) {
    Bezier<double> near;
    for (std::size_t i = 0; i < part.size(); ++i) {
      near.push_back({part[i].x.middle(), part[i].y.middle(), part[i].w.middle()});
    }
    result.push_back(near);
  }
  return result;
}

Extent measure(const DoubleCurve& curve, std::size_t part, double begin, double end) {
  const Bezier<double> piece = curve[part].between(begin, end);
  const bool at_begin = part == 0 && begin == 0;
  const bool at_end = part + 1 == curve.size() && end == 1;
  const double x = piece.front().x;
  const double y = piece.front().y;
  const Vector<double> last = piece.back();
  Extent extent;
  extent.chord = {last.x - x, last.y - y};
  const double length = extent.length = std::hypot(extent.chord.x, extent.chord.y);
  const double dx = extent.chord.x / length;
  const double dy = extent.chord.y / length;
  double before = 0;
  double low_x = x, high_x = x, low_y = y, high_y = y;
  for_each_control(piece, [&](const Vector<double>& p) {
    low_x = std::min(low_x, p.x);
    high_x = std::max(high_x, p.x);
    low_y = std::min(low_y, p.y);
    high_y = std::max(high_y, p.y);
    const double along = (p.x - x) * dx + (p.y - y) * dy;
    double across = (p.y - y) * dx - (p.x - x) * dy;
    if (!(along >= before * (1 - 1e-9) - 1e-12 * length)) extent.regular = false;
    before = along;
    // Ends of pieces are on the chord up to rounding.
    const double near_end = 1e-9 * length;
    if (along < near_end || along > length - near_end) {
      if (std::abs(across) > near_end) extent.regular = false;
      return;
    }
    double factor = 1;
    if (at_begin) factor = length / along;
    if (at_end) factor = std::max(factor, length / (length - along));
    across *= factor;
    extent.right = std::max(extent.right, -across);
    extent.left = std::max(extent.left, across);
  });
  extent.diameter = std::hypot(high_x - low_x, high_y - low_y);
  // Cuts at right angles to the curve slant against the chord. The piece beside a triangle is about
  // twice as long, so it turns twice as much and slants their cut.
  const double slants = at_begin || at_end ? 2 : 1;
  extent.width = (extent.left + extent.right) * (1 + slants * turn_of(piece));
  // The ribbon of a curve of one piece would have no width anywhere.
  if (at_begin && at_end) extent.regular = false;
  if (!(length > 0)) extent.regular = false;
  return extent;
}

std::vector<Piece> cut(const DoubleCurve& curve, const CutSizes& sizes, bool box_turns,
                       Cancellation& cancellation) {
  return Cutter(curve, sizes, cancellation).run(box_turns);
}

}  // namespace minksum::io
