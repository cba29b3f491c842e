// Tests reading and writing of well-known binary, against bytes that are put together here.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "minksum/io.hpp"

namespace minksum::io {
namespace {

/// Bytes in one order. PostGIS sets bits in a code where ISO adds thousands.
class Bytes {
 public:
  explicit Bytes(bool little) : little_(little) {}
  Bytes& code(std::uint32_t code) {
    text_ += little_ ? '\1' : '\0';
    return number(code);
  }
  Bytes& number(std::uint32_t value) { return put(value, 4); }
  Bytes& point(double x, double y) {
    put(std::bit_cast<std::uint64_t>(x), 8);
    return put(std::bit_cast<std::uint64_t>(y), 8);
  }
  Bytes& add(const std::string& bytes) {
    text_ += bytes;
    return *this;
  }
  Bytes& square(double x) {
    return number(5).point(x, 0).point(x + 1, 0).point(x + 1, 1).point(x, 1).point(x, 0);
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  Bytes& put(std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i) {
      text_ += static_cast<char>(value >> (8 * (little_ ? i : size - 1 - i)));
    }
    return *this;
  }

  bool little_;
  std::string text_;
};

std::string hex(const std::string& bytes) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string text;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    text += kDigits[byte / 16];
    text += kDigits[byte % 16];
  }
  return text;
}

const double kNan = std::numeric_limits<double>::quiet_NaN();
const double kInfinity = std::numeric_limits<double>::infinity();

TEST(Wkb, IsReadInBothOrdersAsBytesAndDigits) {
  const std::string wkt = "POLYGON ((0.1 0, 1.1 0, 1.1 1, 0.1 1, 0.1 0))";
  for (const bool little : {false, true}) {
    const std::string bytes = Bytes(little).code(3).number(1).square(0.1).text();
    const Region region = read(bytes);
    EXPECT_EQ(region.exact_x(0), Rational(0.1));  // the double, not 1/10
    EXPECT_EQ(to_wkt(region), wkt);
    EXPECT_EQ(detect_format(bytes), Format::kWkb);
    for (const char* before : {"", " \n", "\\x", "0x"}) {
      EXPECT_EQ(read(before + hex(bytes) + "\n"), region) << before;
    }
  }
}

TEST(Wkb, CollectionsMixOrders) {
  const std::string line = Bytes(false).code(2).number(2).point(0, 0).point(0.5, 1).text();
  const std::string polygon = Bytes(true).code(3).number(1).square(4).text();
  const std::string empty_point = Bytes(true).code(1).point(kNan, kNan).text();
  const std::string point = Bytes(true).code(1).point(-7, 8).text();
  const Bytes all = Bytes(false)
                        .code(7)
                        .number(4)
                        .add(line)
                        .add(Bytes(true).code(6).number(2).add(polygon).add(polygon).text())
                        .add(Bytes(false).code(4).number(2).add(empty_point).add(point).text())
                        .add(Bytes(true).code(5).number(1).add(line).text());
  EXPECT_EQ(to_wkt(read_geometry(all.text())),
            "GEOMETRYCOLLECTION (MULTIPOLYGON (((4 0, 5 0, 5 1, 4 1, 4 0)), ((4 0, 5 0, 5 1, 4 1, "
            "4 0))), MULTILINESTRING ((0 0, 0.5 1), (0 0, 0.5 1)), POINT (-7 8))");
}

TEST(Wkb, EmptyShapesAreNothing) {
  for (const std::uint32_t code : {2U, 3U, 4U, 5U, 6U, 7U}) {
    EXPECT_EQ(read_geometry(Bytes(true).code(code).number(0).text()), Geometry()) << code;
  }
  EXPECT_EQ(read_geometry(Bytes(true).code(1).point(kNan, kNan).text()), Geometry());
}

TEST(Wkb, PostgisFormHasAReferenceSystem) {
  // A big-endian code with this bit could be taken for UTF-16.
  const std::string bytes = Bytes(false).code(0x2000'0003).number(4326).number(1).square(2).text();
  EXPECT_EQ(to_wkt(read(bytes)), "POLYGON ((2 0, 3 0, 3 1, 2 1, 2 0))");
}

TEST(Wkb, ComesBackAsWritten) {
  for (const char* wkt : {"POLYGON EMPTY", "POINT (0.1 -2)", "MULTIPOINT ((1 2), (3 1e+300))",
                          "LINESTRING (0 0, 1 3)", "MULTILINESTRING ((0 0, 1 3), (5 5, 6 6, 5 5))",
                          "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (3 3, 3 6, 6 6, 3 3))",
                          "MULTIPOLYGON (((0 0, 1 0, 0 1, 0 0)), ((5 5, 6 5, 5 6, 5 5)))",
                          "GEOMETRYCOLLECTION (POLYGON ((0 0, 1 0, 0 1, 0 0)), LINESTRING (0 0, 1 "
                          "3), POINT (1 2))"}) {
    EXPECT_EQ(to_wkt(read_geometry(to_wkb(read_geometry(wkt)))), wkt);
  }
  EXPECT_EQ(to_wkb(read("POLYGON ((7 0, 8 0, 8 1, 7 1, 7 0))")),
            Bytes(true).code(3).number(1).square(7).text());
}

TEST(Wkb, IsWrittenAsDoublesAlone) {
  const Region third = read("POLYGON ((1/3 0, 1 0, 0 1, 1/3 0))");
  EXPECT_EQ(read(to_wkb(third)).exact_x(0), Rational(1.0 / 3));
  const auto code_of = [](const Region& region, const Coordinates& style) {
    try {
      static_cast<void>(to_wkb(region, style));
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kInternal;
  };
  EXPECT_EQ(code_of(third, {Coordinates::Style::kExact}), ErrorCode::kBadInput);
  EXPECT_EQ(code_of(read("POLYGON ((1e400 0, 1 0, 0 1, 1e400 0))"), {}), ErrorCode::kLimitExceeded);
}

struct Refusal {
  std::string bytes;
  std::string message;
  ErrorCode code = ErrorCode::kBadInput;
};

TEST(Wkb, RefusalsNameTheByte) {
  const std::string polygon = Bytes(true).code(3).number(1).square(0).text();
  std::string nested = polygon;
  for (int i = 0; i < 33; ++i) nested = Bytes(true).code(7).number(1).add(nested).text();
  const std::vector<Refusal> refusals = {
      {Bytes(true).code(1003).number(0).text(),
       "byte 2: POLYGON Z has more than two coordinates (io::ReadOptions::drop_z keeps x and y)"},
      {Bytes(true).code(0xC000'0001).text(),
       "byte 2: POINT ZM has more than two coordinates (io::ReadOptions::drop_z keeps x and y)"},
      {Bytes(false).code(2001).text(),
       "byte 2: POINT M has more than two coordinates (io::ReadOptions::drop_z keeps x and y)"},
      {Bytes(true).code(8).number(0).text(), "byte 2: CIRCULARSTRING is not supported"},
      {Bytes(true).code(6).number(1).add(Bytes(true).code(2).number(0).text()).text(),
       "byte 11: expected a POLYGON, found a LINESTRING"},
      {Bytes(true).code(7).number(1).add(Bytes(true).code(99).number(0).text()).text(),
       "byte 11: code 99 names no geometry"},
      {Bytes(true).code(7).number(1).add("\2\1\1\1\1").text(),
       "byte 10: expected the byte order, 0 or 1, found 2"},
      {Bytes(true).code(3).number(4'000'000'000).text(),
       "byte 6: 4000000000 rings do not fit into the 0 bytes that are left"},
      {polygon + "ab", "byte 94: expected the end, found 2 more bytes"},
      {Bytes(true).code(1).point(1, kInfinity).text(),
       "byte 14: a coordinate is not a finite number"},
      {Bytes(true).code(2).number(1).point(1, 1).text(),
       "byte 6: a line has 1 point, it needs at least 2"},
      {Bytes(true).code(3).number(1).number(2).point(1, 1).point(1, 2).text(),
       "byte 10: polygon 1, ring 1 is not closed: its last point must repeat the first"},
      {nested, "byte 294: collections are nested deeper than the limit of 32",
       ErrorCode::kLimitExceeded},
  };
  const auto expect_refused = [](const Refusal& refusal, const std::string& text,
                                 std::size_t line) {
    try {
      static_cast<void>(read_geometry(text));
      ADD_FAILURE() << "no error: " << refusal.message;
    } catch (const ReadError& error) {
      EXPECT_EQ(std::string(error.what()), refusal.message);
      EXPECT_EQ(error.code(), refusal.code) << refusal.message;
      EXPECT_EQ(error.line(), line);
    }
  };
  for (const Refusal& refusal : refusals) {
    expect_refused(refusal, refusal.bytes, 0);
    if (refusal.bytes.size() >= 9) expect_refused(refusal, "\n" + hex(refusal.bytes), 2);
  }
}

TEST(Wkb, DigitsAreRefusedInTheirPlace) {
  const std::string digits = hex(Bytes(true).code(7).number(0).text());
  const auto refusal = [](const std::string& text) {
    try {
      static_cast<void>(read_geometry(text));
    } catch (const ReadError& error) {
      return std::to_string(error.line()) + ':' + std::to_string(error.column()) + ": " +
             error.what();
    }
    return std::string("no error");
  };
  EXPECT_EQ(refusal(digits + "0"),
            "1:20: expected a second hexadecimal digit of the byte, found the end of the text");
  EXPECT_EQ(refusal("\n" + digits + " g"),
            "2:20: expected the end of the line or ';' after a geometry, found 'g'");
  EXPECT_EQ(refusal(digits + "g"),
            "1:19: expected a hexadecimal digit, or the end of the line, found 'g'");
}

TEST(Wkb, RegionsHavePolygonsAlone) {
  const std::string point = Bytes(true).code(1).point(1, 2).text();
  EXPECT_EQ(read_geometry(point).points.size(), 1U);
  EXPECT_THROW(static_cast<void>(read(point)), ReadError);
}

TEST(Wkb, EveryPrefixIsRefused) {
  const std::string whole =
      Bytes(true).code(6).number(1).add(Bytes(false).code(3).number(1).square(1).text()).text();
  ASSERT_FALSE(read(whole).empty());
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_THROW(static_cast<void>(read(whole.substr(0, size))), ReadError) << size;
  }
}

TEST(Wkb, NumbersOfOtherFormatsAreNotTakenForIt) {
  EXPECT_EQ(detect_format("0 0 1 0 0 1"), Format::kDat);
  EXPECT_EQ(detect_format("0103000000 0 1 0"), Format::kDat);
  EXPECT_EQ(detect_format("0"), Format::kPoly);
  EXPECT_EQ(detect_format("010300000099999999"), Format::kWkb);
}

}  // namespace
}  // namespace minksum::io
