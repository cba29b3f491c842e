// Which format a text is in, and how a file becomes a text.
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <sstream>
#include <system_error>

#include "io/formats.hpp"
#include "io/text_cursor.hpp"

namespace minksum::io {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::string_view without_mark(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return text;
}

void check_encoding(std::string_view text) {
  const bool marked = text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF");
  const bool wide = text.size() >= 4 && ((text[0] == '\0' && text[1] != '\0' && text[2] == '\0') ||
                                         (text[1] == '\0' && text[0] != '\0' && text[3] == '\0'));
  if (marked || wide) {
    throw ReadError(ErrorCode::kBadInput, "the text is in UTF-16; UTF-8 is needed", 1, 1);
  }
}

// A single count and then `COUNT out` or `COUNT in`; `0` alone is a `.poly` without chains.
bool looks_like_poly(TextCursor cursor) {
  const auto take_count = [&cursor] {
    cursor.skip_space_and_comments();
    const std::size_t start = cursor.position();
    while (is_digit(cursor.peek())) cursor.advance();
    return cursor.position() > start;
  };
  const bool zero = cursor.peek() == '0';
  const std::size_t start = cursor.position();
  if (!take_count()) return false;
  const bool lone_zero = zero && cursor.position() == start + 1;
  cursor.skip_space_and_comments();
  if (cursor.at_end()) return lone_zero;
  if (!take_count()) return false;
  cursor.skip_space_and_comments();
  return is_letter(cursor.peek());
}

[[noreturn]] void fail_too_large(std::size_t limit) {
  throw ReadError(ErrorCode::kLimitExceeded,
                  "the text is longer than the limit of " + std::to_string(limit) + " bytes", 0, 0);
}

[[noreturn]] void fail_unreadable(int reason) {
  throw ReadError(ErrorCode::kBadInput,
                  "cannot be read: " + std::generic_category().message(reason), 0, 0);
}

std::string read_all(std::FILE* file, const ReadLimits& limits, std::size_t expected) {
  constexpr std::size_t kChunk = std::size_t{1} << 18;
  std::string text;
  text.reserve(expected);
  for (;;) {
    const std::size_t before = text.size();
    // One byte beyond the limit is enough to see that it is exceeded.
    const std::size_t room = limits.max_bytes - before;
    const std::size_t want = room < kChunk ? room + 1 : kChunk;
    text.resize(before + want);
    errno = 0;
    const std::size_t got = std::fread(text.data() + before, 1, want, file);
    text.resize(before + got);
    if (std::ferror(file) != 0) fail_unreadable(errno == 0 ? EIO : errno);
    if (text.size() > limits.max_bytes) fail_too_large(limits.max_bytes);
    if (got < want) return text;
  }
}

std::string load(const std::string& path, const ReadLimits& limits) {
  if (path == "-") return read_all(stdin, limits, 0);
  std::error_code unknown;
  const auto size = std::filesystem::file_size(path, unknown);
  const std::size_t expected = unknown ? 0 : static_cast<std::size_t>(size);
  if (expected > limits.max_bytes) fail_too_large(limits.max_bytes);
  errno = 0;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) fail_unreadable(errno);
  return read_all(file.get(), limits, expected + 1);
}

}  // namespace

Format detect_format(std::string_view text) {
  TextCursor cursor(without_mark(text));
  cursor.skip_space();
  const char first = cursor.peek();
  if (first == '{' || first == '[') return Format::kGeoJson;
  cursor.skip_space_and_comments();
  const char c = cursor.peek();
  if (!is_digit(c) && first != '#') return Format::kWkt;
  return looks_like_poly(cursor) ? Format::kPoly : Format::kDat;
}

Region read(std::string_view text, const ReadLimits& limits) {
  if (text.size() > limits.max_bytes) fail_too_large(limits.max_bytes);
  check_encoding(text);
  const std::string_view content = without_mark(text);
  TextCursor cursor(content);
  cursor.skip_space();
  if (cursor.at_end()) {
    throw ReadError(ErrorCode::kBadInput,
                    text.empty() ? "the file is empty" : "the file is empty but for white space", 1,
                    1);
  }
  switch (detect_format(content)) {
    case Format::kGeoJson:
      return read_geojson(content, limits);
    case Format::kPoly:
      return read_poly(content);
    case Format::kDat:
      return read_dat(content);
    default:
      return read_wkt(content, limits);
  }
}

Region read_file(const std::string& path, const ReadLimits& limits) {
  return read(load(path, limits), limits);
}

void write(std::ostream& out, const Region& region, Format format, const Coordinates& style) {
  switch (format) {
    case Format::kWkt:
      return write_wkt(out, region, style);
    case Format::kGeoJson:
      return write_geojson(out, region, style);
    case Format::kPoly:
      return write_poly(out, region, style);
    case Format::kSvg:
      return write_svg(out, region);
    case Format::kDat:
      break;
  }
  throw Error(ErrorCode::kBadInput, "regions are not written as .dat");
}

std::string to_wkt(const Region& region, const Coordinates& style) {
  std::ostringstream out;
  write_wkt(out, region, style);
  return std::move(out).str();
}

}  // namespace minksum::io
