// Loads files, and finds out which format a text is in.
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "io/feature_source.hpp"
#include "io/formats.hpp"
#include "io/gdal/gdal.hpp"
#include "io/text_cursor.hpp"

namespace minksum::io {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

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
  if (!take_count() || is_letter(cursor.peek())) return false;  // the letter is an exponent's
  cursor.skip_space_and_comments();
  return is_letter(cursor.peek());
}

[[noreturn]] void fail_too_large(std::size_t limit) {
  throw ReadError(ErrorCode::kLimitExceeded,
                  "the text is longer than the limit of " + std::to_string(limit) + " bytes", 0, 0,
                  ExceededLimit{"io::ReadOptions::max_bytes", limit});
}

[[noreturn]] void fail_unreadable(int reason) {
  throw ReadError(ErrorCode::kBadInput,
                  "cannot be read: " + std::generic_category().message(reason), 0, 0);
}

// Refuses a file of another format, or has GDAL read it, before all of it is loaded. Returns
// nothing if the format is read.
std::optional<std::string> read_other(std::string_view begin, const std::string& path,
                                      const ReadOptions& options) {
  if (looks_like_wkb(begin)) return {};
  const auto format = find_other_format(without_mark(begin));
  if (!format) return {};
  std::error_code unknown;
  const bool is_file = std::filesystem::is_regular_file(path, unknown);
  if (format->by_gdal && is_file) {
    if (auto features = features_by_gdal(path, format->name, options)) return features;
  }
  refuse(*format, is_file);
}

// Some formats are folders of files.
bool is_folder_for_gdal(const std::string& path) {
  std::error_code unknown;
  if (!std::filesystem::is_directory(path, unknown)) return false;
  for (const auto& entry : std::filesystem::directory_iterator(path, unknown)) {
    const auto ending = entry.path().extension();
    if (ending == ".shp" || ending == ".SHP" || ending == ".gdbtable") return true;
  }
  return false;
}

std::string read_all(std::FILE* file, const std::string& path, const ReadOptions& options,
                     std::size_t expected) {
  constexpr std::size_t kChunk = std::size_t{1} << 18;
  std::string text;
  for (;;) {
    const std::size_t before = text.size();
    // Reading stops one byte beyond the limit, which is enough to see that it is exceeded.
    const std::size_t room = options.max_bytes - before;
    const std::size_t want = room < kChunk ? room + 1 : kChunk;
    text.resize(before + want);
    errno = 0;
    const std::size_t got = std::fread(text.data() + before, 1, want, file);
    text.resize(before + got);
    if (std::ferror(file) != 0) fail_unreadable(errno == 0 ? EIO : errno);
    if (text.size() > options.max_bytes) fail_too_large(options.max_bytes);
    if (before == 0) {
      if (auto features = read_other(text, path, options)) return *std::move(features);
      if (expected > 0) text.reserve(expected + kChunk);  // the last chunk shall not move the text
    }
    if (got < want) return text;
  }
}

/// Gives the only feature of a text of another format.
class WholeText : public FeatureSource {
 public:
  using Read = void (*)(std::string_view, const ReadOptions&, GeometryBuilder&);
  WholeText(std::string_view text, const ReadOptions& options, Rules rules, Read read)
      : FeatureSource(options, rules), text_(text), options_(options), read_(read) {}
  [[nodiscard]] bool has_lines() const override { return read_ != read_wkb; }

 private:
  bool read_next() override {
    if (done_) return false;
    done_ = true;
    read_(text_, options_, builder_);
    return true;
  }

  std::string_view text_;
  const ReadOptions& options_;
  Read read_;
  bool done_ = false;
};

}  // namespace

std::string_view without_mark(std::string_view text) {
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return text;
}

std::string load_text(const std::string& path, const ReadOptions& options) {
  if (path == "-") return read_all(stdin, path, options, 0);
  if (is_folder_for_gdal(path)) {
    if (auto features = features_by_gdal(path, "a folder of files", options)) {
      return *std::move(features);
    }
  }
  std::error_code unknown;
  const auto size = std::filesystem::file_size(path, unknown);
  const std::size_t expected = unknown ? 0 : static_cast<std::size_t>(size);
  if (expected > options.max_bytes) fail_too_large(options.max_bytes);
  errno = 0;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) fail_unreadable(errno);
  return read_all(file.get(), path, options, expected + 1);
}

Format detect_format(std::string_view text) {
  if (looks_like_wkb(text)) return Format::kWkb;
  if (looks_like_gdal_features(text)) return Format::kGdal;
  TextCursor cursor(without_mark(text));
  cursor.skip_space();
  const char first = cursor.peek();
  if (first == '<' && looks_like_svg(cursor.rest())) return Format::kSvg;
  if (looks_like_dxf(cursor.rest())) return Format::kDxf;
  if (first == '{' || first == '[' || first == '\x1E') return Format::kGeoJson;
  cursor.skip_space_and_comments();
  if (looks_like_hex_wkb(cursor.rest())) return Format::kWkb;
  const char c = cursor.peek();
  // The first name of a table may be empty, as that of the index is in tables of pandas, and its
  // letters may be of any language.
  const bool may_be_name = is_letter(first) || first == '"' || first == '_' || first == ',' ||
                           first == ';' || static_cast<unsigned char>(first) >= 0x80;
  if (may_be_name && looks_like_table(cursor.rest())) return Format::kTable;
  if (!is_digit(c) && (first != '#' || is_letter(c) || c == '"' || c == '\'')) return Format::kWkt;
  return looks_like_poly(cursor) ? Format::kPoly : Format::kDat;
}

std::unique_ptr<FeatureSource> open_source(std::string_view text, const ReadOptions& options,
                                           Rules rules) {
  require_enumerator(options.drawing.side, RoundingSide::kInside, "side");
  if (text.size() > options.max_bytes) fail_too_large(options.max_bytes);
  const auto whole = [&](std::string_view content, WholeText::Read read) {
    return std::make_unique<WholeText>(content, options, rules, read);
  };
  if (looks_like_wkb(text)) return whole(text, read_wkb);
  if (looks_like_gdal_features(text)) return gdal_source(text, options, rules);
  check_encoding(text);
  const std::string_view content = without_mark(text);
  if (const auto format = find_other_format(content)) refuse(*format, false);
  TextCursor cursor(content);
  cursor.skip_space();
  if (cursor.at_end()) {
    throw ReadError(ErrorCode::kBadInput,
                    text.empty() ? "the file is empty" : "the file is empty but for white space", 1,
                    1);
  }
  if (cursor.peek() == '<' && !looks_like_svg(content)) {  // it ends before it says what it is
    refuse({"XML", "it has no element", false}, false);
  }
  const Format format = detect_format(content);
#if !defined(__wasm__)  // the module for browsers has no room for better errors
  if (format == Format::kWkt || format == Format::kDat) refuse_rows_without_names(content);
#endif
  switch (format) {
    case Format::kGeoJson:
      return geojson_source(content, options, rules);
    case Format::kPoly:
      return whole(content, read_poly);
    case Format::kDat:
      return whole(content, read_dat);
    case Format::kSvg:
      return whole(content, read_svg);
    case Format::kDxf:
      return whole(content, read_dxf);
    case Format::kTable:
      return table_source(content, options, rules);
    default:
      return record_source(content, options, rules);
  }
}

}  // namespace minksum::io
