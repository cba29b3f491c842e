// Implements geometries of the C interface: from arrays, into arrays, from text and to text.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "handles.hpp"

namespace minksum::c {

minksum_status tell(minksum_error* error, minksum_status status, std::string_view message,
                    const Error* cause) noexcept {
  if (error == nullptr) return status;
  const Culprit culprit = cause != nullptr ? cause->culprit() : Culprit{};
  const auto* const read = dynamic_cast<const io::ReadError*>(cause);
  ExceededLimit limit;
  if (cause != nullptr && cause->limit()) limit = *cause->limit();
  // A text that is too long is cut between two characters of UTF-8, not in one.
  std::size_t length = std::min(message.size(), sizeof error->message - 1);
  while (length != 0 && length < message.size() && (message[length] & 0xC0) == 0x80) --length;
  // Texts are not cleared behind their ends, which would take longer than a short call.
  error->status = status;
  error->operand = culprit.operand;
  error->polygon = culprit.polygon;
  error->ring = culprit.ring;
  error->vertex = culprit.vertex;
  error->line = read != nullptr ? read->line() : 0;
  error->column = read != nullptr ? read->column() : 0;
  error->limit[limit.name.copy(error->limit, sizeof error->limit - 1)] = '\0';
  error->limit_value = limit.value;
  error->message[message.copy(error->message, length)] = '\0';
  return status;
}

namespace {

// This takes no memory: there may be none.
minksum_status tell_out_of_memory(minksum_error* error) {
  const Outcome outcome = detail::out_of_memory();
  return tell(error, MINKSUM_LIMIT_EXCEEDED, outcome.error->what(), &*outcome.error);
}

}  // namespace

minksum_status tell_exception(minksum_error* error) noexcept {
  try {
    throw;
  } catch (const Error& cause) {
    constexpr minksum_status kStatus[] = {MINKSUM_BAD_INPUT, MINKSUM_LIMIT_EXCEEDED,
                                          MINKSUM_CANCELLED, MINKSUM_INTERNAL};
    return tell(error, kStatus[static_cast<int>(cause.code())], cause.what(), &cause);
  } catch (const std::length_error&) {  // asked for more elements than a list can have
    return tell_out_of_memory(error);
  } catch (const std::bad_alloc&) {
    return tell_out_of_memory(error);
  } catch (const std::exception& cause) {
    return tell(error, MINKSUM_INTERNAL, cause.what());
  } catch (...) {
    return tell(error, MINKSUM_INTERNAL, "an unknown exception");
  }
}

namespace {

/// Returns the coordinates of n points.
std::span<const double> numbers_of(const double* xy, std::uint64_t n) {
  require(xy != nullptr || n == 0, "there are points, and no array of coordinates");
  require(n <= PTRDIFF_MAX / (2 * sizeof(double)), "more points than an array can have");
  return {xy, 2 * static_cast<std::size_t>(n)};
}

std::vector<Point> points_of(const double* xy, std::size_t n) {
  const std::span<const double> numbers = numbers_of(xy, n);
  std::vector<Point> points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    try {
      points.push_back({numbers[2 * i], numbers[2 * i + 1]});
    } catch (const Error& error) {
      Culprit culprit;
      culprit.vertex = i;
      throw Error(error.code(), error.what(), culprit);
    }
  }
  return points;
}

void copy_points(std::span<const Point> points, double*& xy) {
  for (const Point& point : points) {
    *xy++ = point.x.to_double();
    *xy++ = point.y.to_double();
  }
}

}  // namespace
}  // namespace minksum::c

using namespace minksum;     // NOLINT(google-build-using-namespace)
using namespace minksum::c;  // NOLINT(google-build-using-namespace)

void minksum_options_init(minksum_options* options) {
  if (options != nullptr) *options = {0, 0, MINKSUM_FILL_AUTOMATIC, 0, -1, 1, nullptr, nullptr};
}

const char* minksum_version(void) { return MINKSUM_VERSION; }

minksum_status minksum_geometry_empty(minksum_geometry** result, minksum_error* error) {
  return made(result, error, [] { return Geometry(); });
}

minksum_status minksum_geometry_polygon(const double* xy, size_t n, minksum_geometry** result,
                                        minksum_error* error) {
  return made(result, error, [&] {
    const std::span<const double> numbers = numbers_of(xy, n);
    const std::int64_t ring[] = {0, static_cast<std::int64_t>(n)};
    const std::int64_t polygon[] = {0, 1};
    return Geometry(Region::from_flat(numbers, ring, polygon));
  });
}

minksum_status minksum_geometry_polygons(const double* xy, const int64_t* ring_offsets,
                                         size_t rings, const int64_t* polygon_offsets,
                                         size_t polygons, minksum_geometry** result,
                                         minksum_error* error) {
  return made(result, error, [&] {
    require(ring_offsets != nullptr && polygon_offsets != nullptr, "an array of offsets is NULL");
    const std::int64_t points = ring_offsets[rings];
    require(points >= 0, "the last offset of a ring is negative");
    return Geometry(Region::from_flat(numbers_of(xy, static_cast<std::uint64_t>(points)),
                                      {ring_offsets, rings + 1}, {polygon_offsets, polygons + 1}));
  });
}

minksum_status minksum_geometry_add_polyline(minksum_geometry* geometry, const double* xy, size_t n,
                                             minksum_error* error) {
  return guarded(error, [&] {
    require(geometry != nullptr, "an argument is NULL");
    require(n >= 2, "a polyline has two points or more");
    geometry->value.polylines.push_back(points_of(xy, n));
  });
}

minksum_status minksum_geometry_add_points(minksum_geometry* geometry, const double* xy, size_t n,
                                           minksum_error* error) {
  return guarded(error, [&] {
    require(geometry != nullptr, "an argument is NULL");
    const std::vector<Point> points = points_of(xy, n);
    geometry->value.points.insert(geometry->value.points.end(), points.begin(), points.end());
  });
}

minksum_status minksum_geometry_copy(const minksum_geometry* geometry, minksum_geometry** result,
                                     minksum_error* error) {
  return made(result, error, [&] { return value_of(geometry); });
}

void minksum_geometry_free(minksum_geometry* geometry) { delete geometry; }

int minksum_geometry_equal(const minksum_geometry* a, const minksum_geometry* b) {
  if (a == nullptr || b == nullptr) return a == b ? 1 : 0;
  return a->value == b->value ? 1 : 0;
}

minksum_counts minksum_geometry_counts(const minksum_geometry* geometry) {
  if (geometry == nullptr) return {};
  const Geometry& value = geometry->value;
  minksum_counts counts{value.region.polygon_count(),
                        value.region.ring_count(),
                        value.region.vertex_count(),
                        value.polylines.size(),
                        0,
                        value.points.size()};
  for (const Polyline& line : value.polylines) counts.polyline_vertices += line.size();
  return counts;
}

minksum_status minksum_geometry_get_polygons(const minksum_geometry* geometry, double* xy,
                                             int64_t* ring_offsets, int64_t* polygon_offsets,
                                             minksum_error* error) {
  return guarded(error, [&] {
    const Region& region = value_of(geometry).region;
    std::size_t ring_end = 0;
    if (ring_offsets != nullptr) *ring_offsets++ = 0;
    if (polygon_offsets != nullptr) *polygon_offsets++ = 0;
    for (const std::size_t polygon : region.polygons()) {
      for (const std::size_t ring : region.rings_of(polygon)) {
        const IndexRange vertices = region.vertices_of(ring);
        const std::size_t end = vertices.front() + vertices.size();
        if (ring_offsets != nullptr) *ring_offsets++ = static_cast<std::int64_t>(end);
        ring_end = ring + 1;
      }
      if (polygon_offsets != nullptr) *polygon_offsets++ = static_cast<std::int64_t>(ring_end);
    }
    for (std::size_t v = 0; xy != nullptr && v < region.vertex_count(); ++v) {
      *xy++ = region.x(v);
      *xy++ = region.y(v);
    }
  });
}

minksum_status minksum_geometry_get_polylines(const minksum_geometry* geometry, double* xy,
                                              int64_t* offsets, minksum_error* error) {
  return guarded(error, [&] {
    std::int64_t end = 0;
    if (offsets != nullptr) *offsets++ = 0;
    for (const Polyline& line : value_of(geometry).polylines) {
      if (xy != nullptr) copy_points(line, xy);
      end += static_cast<std::int64_t>(line.size());
      if (offsets != nullptr) *offsets++ = end;
    }
  });
}

minksum_status minksum_geometry_get_points(const minksum_geometry* geometry, double* xy,
                                           minksum_error* error) {
  return guarded(error, [&] {
    require(xy != nullptr || value_of(geometry).points.empty(), "the result has nowhere to go");
    copy_points(value_of(geometry).points, xy);
  });
}

minksum_status minksum_geometry_get_origins(const minksum_geometry* geometry,
                                            minksum_origin* origins, int* found,
                                            minksum_error* error) {
  return guarded(error, [&] {
    int& is_there = result_at(found);
    const Region& region = value_of(geometry).region;
    is_there = region.has_origins() ? 1 : 0;
    for (std::size_t v = 0; is_there != 0 && origins != nullptr && v < region.vertex_count(); ++v) {
      const EdgeOrigin& origin = region.origin(v);
      origins[v] = {static_cast<std::uint32_t>(origin.edge_operand), origin.edge, origin.vertex};
    }
  });
}

void minksum_read_options_init(minksum_read_options* read_options) {
  if (read_options != nullptr) *read_options = {0, 0, MINKSUM_NEAREST, 0, nullptr, nullptr};
}
minksum_status minksum_read_as(const char* text, size_t length,
                               const minksum_read_options* read_options, minksum_geometry** result,
                               minksum_error* error) {
  return made(result, error, [&] {
    require(text != nullptr, "an argument is NULL");
    io::ReadOptions how;
    if (read_options != nullptr) {
      require(read_options->tolerance >= 0, "the tolerance must not be negative");
      require(read_options->join_ends >= 0, "the distance of ends must not be negative");
      if (read_options->tolerance > 0) how.drawing.tolerance = read_options->tolerance;
      how.drawing.join_ends = read_options->join_ends;
      how.drawing.side = as<RoundingSide>(read_options->side);
      how.drop_z = read_options->drop_z != 0;
      if (read_options->column != nullptr) how.column = read_options->column;
      if (read_options->layer != nullptr) how.drawing.layer = read_options->layer;
    }
    return io::read_geometry(std::string_view(text, length), how);
  });
}

minksum_status minksum_read(const char* text, size_t length, minksum_geometry** result,
                            minksum_error* error) {
  return made(result, error, [&] {
    require(text != nullptr, "an argument is NULL");
    return io::read_geometry(std::string_view(text, length));
  });
}

minksum_status minksum_write(const minksum_geometry* geometry, minksum_format format,
                             minksum_style style, int digits, char** text, size_t* length,
                             minksum_error* error) {
  return guarded(error, [&] {
    if (length != nullptr) *length = 0;
    char*& result = result_at(text);
    // In the order of minksum_format.
    constexpr io::Format kFormats[] = {io::Format::kWkt, io::Format::kGeoJson, io::Format::kPoly,
                                       io::Format::kSvg, io::Format::kWkb,     io::Format::kHexWkb};
    const auto index = as<unsigned>(format);
    require(index < std::size(kFormats), "there is no such format");
    const auto kind = as<io::Coordinates::Style>(style);
    const std::string written =
        io::to_text(value_of(geometry), kFormats[index], io::Coordinates{kind, digits, {}});
    result = static_cast<char*>(std::malloc(written.size() + 1));
    if (result == nullptr) throw std::bad_alloc();
    std::memcpy(result, written.c_str(), written.size() + 1);
    if (length != nullptr) *length = written.size();
  });
}

void minksum_text_free(char* text) { std::free(text); }
