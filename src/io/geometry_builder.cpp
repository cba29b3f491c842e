#include "io/geometry_builder.hpp"

#include <utility>

namespace minksum::io {

std::string counted_points(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " point" : " points");
}

void GeometryBuilder::count_vertex() {
  // The work counts all text since the last vertex; a number of many digits takes quadratic time.
  const std::size_t length = cursor_->position() - std::exchange(counted_to_, cursor_->position());
  cancellation_.check(16 + work_of_product(4 * length));
  if (++vertices_ <= max_vertices_) return;
  cursor_->fail(ErrorCode::kLimitExceeded,
                "more vertices than the limit of " + std::to_string(max_vertices_),
                cursor_->position(), ExceededLimit{"io::ReadOptions::max_vertices", max_vertices_});
}

void GeometryBuilder::set_srid(std::int32_t srid, std::size_t position) {
  if (srid == 0) return;
  if (source_.srid && *source_.srid != srid) {
    cursor_->fail(ErrorCode::kBadInput,
                  "the reference system " + std::to_string(srid) +
                      " differs from that of earlier geometries, " + std::to_string(*source_.srid) +
                      "; transform one of them first",
                  position);
  }
  source_.srid = srid;
}

void GeometryBuilder::set_crs(std::string_view crs, std::size_t position) {
  if (source_.crs.empty()) source_.crs = crs;
  if (source_.crs == crs) return;
  const auto number_of = [](std::string_view member) {
    SourceInfo source;
    source.crs = member;
    return srid_of(source);
  };
  const auto number = number_of(crs);
  if (number && number == number_of(source_.crs)) return;  // two spellings of one system
  cursor_->fail(ErrorCode::kBadInput,
                "this \"crs\" differs from an earlier one; transform one of them first", position);
}

void GeometryBuilder::begin_polygon() {
  geometry_.region.begin_polygon();
  ring_ = 0;
}

void GeometryBuilder::add_vertex(const Number& x, const Number& y) {
  count_vertex();
  if (x.is_decimal && y.is_decimal) {
    geometry_.region.add_vertex(x.decimal, y.decimal);
  } else {
    geometry_.region.add_vertex(x.value(), y.value());
  }
}

void GeometryBuilder::begin_closed_ring() {
  begin_ring();
  start_ = cursor_->position();
  points_ = 0;
}

void GeometryBuilder::add_to_closed_ring(Number x, Number y) {
  if (points_ == 0) {
    first_x_ = x;
    first_y_ = y;
  } else {
    add_vertex(last_x_, last_y_);
  }
  last_x_ = std::move(x);
  last_y_ = std::move(y);
  ++points_;
}

void GeometryBuilder::end_closed_ring() {
  if (points_ == 0 || (points_ < 4 && rules_ == Rules::kRegion)) {
    cursor_->fail(
        ErrorCode::kBadInput,
        ring_name() + " has " + counted_points(points_) +
            (rules_ == Rules::kRegion ? ", a ring needs at least 4 with the first repeated"
                                      : ", a ring needs at least 1"),
        start_);
  }
  if (!(first_x_ == last_x_) || !(first_y_ == last_y_)) {
    cursor_->fail(ErrorCode::kBadInput,
                  ring_name() + " is not closed: its last point must repeat the first", start_);
  }
  if (points_ == 1) add_vertex(last_x_, last_y_);
  ++ring_;
}

void GeometryBuilder::begin_line() {
  geometry_.polylines.emplace_back();
  start_ = cursor_->position();
}

void GeometryBuilder::add_to_line(const Number& x, const Number& y) {
  count_vertex();
  geometry_.polylines.back().push_back({x.value(), y.value()});
}

void GeometryBuilder::end_line() {
  const std::size_t points = geometry_.polylines.back().size();
  if (points == 0) return geometry_.polylines.pop_back();
  if (points == 1) {
    cursor_->fail(ErrorCode::kBadInput, "a line has 1 point, it needs at least 2", start_);
  }
}

void GeometryBuilder::add_point(const Number& x, const Number& y) {
  count_vertex();
  geometry_.points.push_back({x.value(), y.value()});
}

std::string GeometryBuilder::ring_name() const {
  // Messages count from 1, as they do for lines and columns.
  return "polygon " + std::to_string(polygon_count()) + ", ring " + std::to_string(ring_ + 1);
}

}  // namespace minksum::io
