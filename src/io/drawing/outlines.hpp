// Declares how outlines with straight and curved pieces become areas and polylines.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/drawing/flatten.hpp"
#include "io/drawing/near_affine.hpp"
#include "io/text_cursor.hpp"

namespace minksum::io {

/// Calls work(), and gives a limit that it exceeds the place in the text.
template <class Work>
void with_place(const TextCursor& cursor, std::size_t position, Work work) {
  try {
    work();
  } catch (const ReadError&) {
    throw;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kLimitExceeded) throw;
    cursor.fail(error.code(), error.what(), position, error.limit());
  }
}

/// Adds each ring of a region as a polygon of its own, backwards if that is asked for.
void append_rings(Region& to, const Region& from, bool backwards, Cancellation& cancellation);

/// A path whose curves are flattened, and the ribbons of these curves (see Flattener).
struct Chain {
  std::vector<Point> path;
  Region ribbons;
};

/// Collects the outlines of a drawing, element by element, and flattens their curves.
///
/// Vertices of straight pieces stay as they are. Where a map is not exact, they are rounded to
/// the grid of the tolerance, and the ribbons of such outlines are wider by the error.
class Outlines {
 public:
  /// `cursor` stands where errors are. It and the options must live as long.
  Outlines(const TextCursor& cursor, const ReadOptions& options);

  /// Errors stand at this position from now on.
  void stand_at(std::size_t position) { position_ = position; }
  /// Later points are moved by `map`.
  void set_map(const NearAffine& map);
  /// Begins a path at a point.
  void move_to(const Point& point);
  void line_to(const Point& point);
  /// Goes along a polynomial Bezier curve; `controls` has its points behind the current one.
  void bezier_to(std::span<const Point> controls);
  /// Goes along an arc, see `elliptical_arc`. `half` and `turned` are not placed yet.
  void arc_to(const Point& point, const Span& half, const Span& turned, const Interval& bulge) {
    arc_to_placed(placed(point), half, turned, bulge);
  }
  /// The same to a point that is placed.
  void arc_to_placed(const Point& point, const Span& half, const Span& turned,
                     const Interval& bulge);
  /// Begins a path at a point that is placed; errors that were added before belong to it.
  void start_at(const Point& point);
  void forget_errors() { error_ = 0; }
  /// Goes along a curve that is placed, from where the path stands.
  void add_curve(const Curve& curve);
  /// Ends the path. It is a ring, or a polyline.
  void end_ring();
  void end_polyline() { add_polyline(end_chain()); }
  /// Ends the path and returns it. Chains can become longer before they are added.
  [[nodiscard]] Chain end_chain();
  void add_ring(Chain chain);
  void add_polyline(const Chain& chain);
  /// Ends the element. The rule says what its rings enclose.
  void end(FillRule rule);

  /// Returns the place of a point, which is on the grid if the map is not exact.
  [[nodiscard]] Point placed(const Point& point);
  /// Returns the point of the grid near the place of a point that is not known exactly.
  [[nodiscard]] Point placed_near(const Span& point);
  /// Returns where the current path stands, placed.
  [[nodiscard]] const Point& here() const { return path_.back(); }
  [[nodiscard]] const Point& start() const { return path_.front(); }
  /// Goes straight back to the start.
  void close() { push(Point(path_.front())); }
  [[nodiscard]] bool is_open() const { return !path_.empty(); }
  /// Says that something in this path is off by so much. Paths begin without errors.
  void add_error(double error) { error_ = std::max(error_, error); }
  /// Returns the flattener. Fails where the options have no tolerance; `why` says what needs one.
  [[nodiscard]] const Flattener& flattener(const std::string& why);
  [[nodiscard]] Cancellation& cancellation() { return cancellation_; }

  [[nodiscard]] Geometry take() { return std::move(result_); }

 private:
  void push(const Point& point);
  void widen_by_error();
  void add_ribbons(Region& region, const Region& ribbons) const;
  void append(const Region& region);

  const TextCursor& cursor_;
  const ReadOptions& limits_;
  Options options_;
  Cancellation cancellation_;
  std::optional<Flattener> flattener_;
  std::size_t position_ = 0;  ///< at which errors stand
  NearAffine map_;
  double error_ = 0;
  std::size_t vertices_ = 0;
  std::vector<Point> path_;
  Region path_ribbons_;
  Region rings_;
  Region ribbons_;       ///< of rings
  Region line_ribbons_;  ///< of polylines
  Geometry result_;
};

}  // namespace minksum::io
