// Reads lists of geometries, each of them WKT or WKB in hexadecimal digits: one a line, or with
// semicolons between them.
#include "io/feature_source.hpp"
#include "io/formats.hpp"
#include "io/text_cursor.hpp"

namespace minksum::io {

namespace {

class RecordSource : public FeatureSource {
 public:
  RecordSource(std::string_view text, const ReadOptions& options, Rules rules)
      : FeatureSource(options, rules), cursor_(text), options_(options) {
    builder_.follow(cursor_);
  }

 private:
  bool read_next() override {
    if (count_ > 0) separator();
    cursor_.skip_space_and_comments();
    if (cursor_.at_end() && count_ > 0) return false;
    start_ = cursor_.position();
    if (++count_ > 1) cursor_.name_record("geometry", count_);
    const char quote = cursor_.peek() == '"' || cursor_.peek() == '\'' ? cursor_.peek() : '\0';
    if (quote != '\0') cursor_.advance();
    read_wkt_or_hex_wkb(cursor_, options_, builder_);
    if (quote != '\0' && !cursor_.accept(quote)) {
      cursor_.fail_expected(std::string("the closing quote ") + quote);
    }
    return true;
  }

  // Two geometries on one line without a semicolon are more likely a mistake than a list.
  void separator() {
    while (is_space(cursor_.peek()) && cursor_.peek() != '\n') cursor_.advance();
    const char c = cursor_.peek();
    if (cursor_.at_end() || c == '\n' || c == '#' || cursor_.accept(';')) return;
    cursor_.fail("expected the end of the line or ';' after a geometry, found " + cursor_.found() +
                 (c == ',' ? "; a table needs a first line that names its columns" : ""));
  }

  TextCursor cursor_;
  const ReadOptions& options_;
  std::size_t count_ = 0;
};

}  // namespace

void read_wkt_or_hex_wkb(TextCursor& cursor, const ReadOptions& options, GeometryBuilder& builder) {
  if (looks_like_hex_wkb(cursor.rest())) {
    read_hex_wkb(cursor, options, builder);
  } else {
    read_wkt(cursor, options, builder);
  }
}

std::unique_ptr<FeatureSource> record_source(std::string_view text, const ReadOptions& options,
                                             Rules rules) {
  return std::make_unique<RecordSource>(text, options, rules);
}

}  // namespace minksum::io
