// Declares the choice of the places where curves are cut, in doubles.
#pragma once

#include <vector>

#include "io/drawing/curve.hpp"
#include "machine/cancellation.hpp"

namespace minksum::io {

/// How a piece lies beside its chord, as doubles tell.
struct Extent {
  Vector<double> chord;
  double length = 0;    ///< of the chord
  double right = 0;     ///< how far it reaches to the right of the chord; see `measure`
  double left = 0;      ///< how far it reaches to the left
  double width = 0;     ///< of both sides together, more where cuts at the ends slant
  double diameter = 0;  ///< a bound on the diameter
  bool regular = true;  ///< whether it goes along the chord all the way
};

/// A piece of a part of the curve.
struct Piece {
  std::size_t part = 0;
  double begin = 0;
  double end = 1;
  bool boxed = false;  ///< whether a box holds it, because it turns sharply
  Extent extent;
};

/// A curve whose control points are doubles.
using DoubleCurve = std::vector<Bezier<double>>;
[[nodiscard]] DoubleCurve middle_of(const Curve& curve);

/// Measures a piece. Where it begins or ends with the curve, its ribbon has no width. There,
/// `right` and `left` say how wide it must be at the other end so that it holds the piece.
[[nodiscard]] Extent measure(const DoubleCurve& curve, std::size_t part, double begin, double end);

/// How large pieces may be.
struct CutSizes {
  double width;     ///< of the extent of a piece
  double diameter;  ///< of a piece in a box
  double least;     ///< the diameter up to which pieces come into boxes although they are regular
};

/// Cuts the curve into pieces that fit. With `box_turns`, pieces between which the curve turns by
/// more than 45 degrees have boxed ones between them. Throws Error(kLimitExceeded) for more than
/// 2^20 pieces.
[[nodiscard]] std::vector<Piece> cut(const DoubleCurve& curve, const CutSizes& sizes,
                                     bool box_turns, Cancellation& cancellation);

}  // namespace minksum::io
