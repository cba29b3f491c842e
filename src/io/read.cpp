// Loads files, and finds out which format a text is in.
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
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

// A `.poly` text starts with a count, and then has `COUNT out` or `COUNT in`. A text that is just
// `0` is a `.poly` without chains.
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
                  "the text is longer than the limit of " + std::to_string(limit) + " bytes", 0, 0,
                  ExceededLimit{"io::ReadLimits::max_bytes", limit});
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
    // Reading stops one byte beyond the limit, which is enough to see that it is exceeded.
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

Geometry read_by_rules(std::string_view text, const ReadLimits& limits, Rules rules) {
  if (text.size() > limits.max_bytes) fail_too_large(limits.max_bytes);
  if (looks_like_wkb(text)) return read_wkb(text, limits, rules);
  check_encoding(text);
  const std::string_view content = without_mark(text);
  refuse_other_formats(content);
  TextCursor cursor(content);
  cursor.skip_space();
  if (cursor.at_end()) {
    throw ReadError(ErrorCode::kBadInput,
                    text.empty() ? "the file is empty" : "the file is empty but for white space", 1,
                    1);
  }
  switch (detect_format(content)) {
    case Format::kGeoJson:
      return read_geojson(content, limits, rules);
    case Format::kPoly:
      return read_poly(content, limits, rules);
    case Format::kDat:
      return read_dat(content, limits, rules);
    case Format::kWkb:
      return read_hex_wkb(content, limits, rules);
    default:
      return read_wkt(content, limits, rules);
  }
}

}  // namespace

std::string load_text(const std::string& path, const ReadLimits& limits) {
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

Format detect_format(std::string_view text) {
  if (looks_like_wkb(text) || looks_like_hex_wkb(without_mark(text))) return Format::kWkb;
  TextCursor cursor(without_mark(text));
  cursor.skip_space();
  const char first = cursor.peek();
  if (first == '{' || first == '[') return Format::kGeoJson;
  cursor.skip_space_and_comments();
  const char c = cursor.peek();
  if (!is_digit(c) && first != '#') return Format::kWkt;
  return looks_like_poly(cursor) ? Format::kPoly : Format::kDat;
}

std::optional<std::string> feature_properties(std::string_view text, const ReadLimits& limits) {
  if (detect_format(text) != Format::kGeoJson) return {};
  return geojson_properties(without_mark(text), limits);
}

Geometry read_geometry(std::string_view text, const ReadLimits& limits) {
  return read_by_rules(text, limits, Rules::kGeometry);
}

Geometry read_geometry_file(const std::string& path, const ReadLimits& limits) {
  return read_geometry(load_text(path, limits), limits);
}

Region read(std::string_view text, const ReadLimits& limits) {
  return read_by_rules(text, limits, Rules::kRegion).region;
}

Region read_file(const std::string& path, const ReadLimits& limits) {
  return read(load_text(path, limits), limits);
}

}  // namespace minksum::io
