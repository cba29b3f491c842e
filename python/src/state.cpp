#include "state.hpp"

#include <utility>

namespace minksum::python {
namespace {

constexpr std::string_view kMark = "MKS\x01";

void put_count(std::string& out, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) out += static_cast<char>(value | 0x80);
  out += static_cast<char>(value);
}

std::string bytes_of(const std::vector<std::uint64_t>& limbs) {
  std::string bytes;
  for (const std::uint64_t limb : limbs) {
    for (int shift = 0; shift < 64; shift += 8) bytes += static_cast<char>(limb >> shift);
  }
  while (!bytes.empty() && bytes.back() == 0) bytes.pop_back();
  return bytes;
}

void put_number(std::string& out, const Rational& value) {
  const Rational::Limbs limbs = value.limbs();
  const std::string above = bytes_of(limbs.numerator);
  put_count(out, above.size() * 2 + (limbs.negative ? 1 : 0));
  out += above;
  const std::string below = value.is_integer() ? std::string() : bytes_of(limbs.denominator);
  put_count(out, below.size());
  out += below;
}

void put_point(std::string& out, const Point& point) {
  put_number(out, point.x);
  put_number(out, point.y);
}

class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  [[noreturn]] void fail(const char* what) const {
    throw Error(ErrorCode::kBadInput, "byte " + std::to_string(at_ + 1) + ": " + what);
  }
  std::string_view take(std::size_t count) {
    if (count > bytes_.size() - at_) fail("the bytes of a geometry end too early");
    const std::string_view part = bytes_.substr(at_, count);
    at_ += count;
    return part;
  }
  std::uint64_t count() {
    std::uint64_t value = 0;
    for (int shift = 0; shift < 63; shift += 7) {
      const auto byte = static_cast<unsigned char>(take(1)[0]);
      value |= std::uint64_t{byte & 0x7FU} << shift;
      if (byte < 0x80) return value;
    }
    fail("a count is too large");
  }
  /// Reads a count of things that take at least a byte each.
  std::size_t length() {
    const std::uint64_t value = count();
    if (value > bytes_.size() - at_) fail("a count is larger than what is left");
    return value;
  }
  Rational number() {
    const std::uint64_t head = count();
    const std::vector<std::uint64_t> above = limbs(head / 2);
    std::vector<std::uint64_t> below = limbs(count());
    if (below.empty()) below.push_back(1);
    return Rational::from_limbs(head % 2 != 0, above.data(), above.size(), below.data(),
                                below.size());
  }
  Point point() {
    Rational x = number();
    return {std::move(x), number()};
  }
  [[nodiscard]] bool at_end() const { return at_ == bytes_.size(); }

 private:
  std::vector<std::uint64_t> limbs(std::uint64_t bytes) {
    const std::string_view digits = take(bytes);
    std::vector<std::uint64_t> limbs((bytes + 7) / 8);
    for (std::size_t i = 0; i < digits.size(); ++i) {
      limbs[i / 8] |= std::uint64_t{static_cast<unsigned char>(digits[i])} << (i % 8 * 8);
    }
    return limbs;
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
};

}  // namespace

std::string state_of(const Shape& shape) {
  std::string out(kMark);
  put_count(out, static_cast<std::uint32_t>(shape.srid));
  const Geometry& geometry = shape.geometry;
  const Region& region = geometry.region;
  put_count(out, region.polygon_count());
  for (const std::size_t polygon : region.polygons()) {
    const IndexRange rings = region.rings_of(polygon);
    put_count(out, rings.size());
    for (const std::size_t ring : rings) {
      const IndexRange vertices = region.vertices_of(ring);
      put_count(out, vertices.size());
      for (const std::size_t v : vertices) put_point(out, region.point(v));
    }
  }
  put_count(out, geometry.polylines.size());
  for (const Polyline& line : geometry.polylines) {
    put_count(out, line.size());
    for (const Point& point : line) put_point(out, point);
  }
  put_count(out, geometry.points.size());
  for (const Point& point : geometry.points) put_point(out, point);
  return out;
}

Shape shape_from_state(std::string_view bytes) {
  Reader in(bytes);
  if (bytes.substr(0, kMark.size()) != kMark) in.fail("these are not the bytes of a geometry");
  in.take(kMark.size());
  Shape shape;
  shape.srid = static_cast<std::int32_t>(static_cast<std::uint32_t>(in.count()));
  Region& region = shape.geometry.region;
  for (std::size_t polygons = in.length(); polygons > 0; --polygons) {
    region.begin_polygon();
    for (std::size_t rings = in.length(); rings > 0; --rings) {
      region.begin_ring();
      for (std::size_t vertices = in.length(); vertices > 0; --vertices) {
        const Point at = in.point();
        region.add_vertex(at.x, at.y);
      }
    }
  }
  for (std::size_t lines = in.length(); lines > 0; --lines) {
    Polyline& line = shape.geometry.polylines.emplace_back();
    for (std::size_t points = in.length(); points > 0; --points) line.push_back(in.point());
  }
  for (std::size_t points = in.length(); points > 0; --points) {
    shape.geometry.points.push_back(in.point());
  }
  if (!in.at_end()) in.fail("bytes are left behind the geometry");
  return shape;
}

}  // namespace minksum::python
