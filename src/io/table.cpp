// Reads tables (CSV, TSV) that have a column of WKT or of WKB in hexadecimal digits.
#include <algorithm>
#include <array>
#include <vector>

#include "io/feature_source.hpp"
#include "io/formats.hpp"
#include "io/json_string.hpp"
#include "io/text_cursor.hpp"

namespace minksum::io {

namespace {

struct Cell {
  std::size_t begin = 0;  ///< position of its text, behind a quote
  std::size_t end = 0;
  bool quoted = false;
};
using Row = std::vector<Cell>;

constexpr const char* kNoNames =
    "this looks like a table, and a table needs a first line that names its columns, such as "
    "id,wkt";

constexpr std::array<std::string_view, 8> kUsualNames = {
    "WKT", "WKB", "GEOM", "GEOMETRY", "THE_GEOM", "WKB_GEOMETRY", "WKT_GEOM", "SHAPE"};

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  for (char& c : capitals) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return capitals;
}

std::string_view first_line(std::string_view text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
}

/// Returns the mark that stands between the names in the first line, or NUL.
char mark_between(std::string_view line) {
  char best = '\0';
  std::ptrdiff_t most = 0;
  for (const char mark : {',', '\t', ';'}) {
    bool quoted = false;
    const auto count = std::count_if(line.begin(), line.end(), [&](char c) {
      if (c == '"') quoted = !quoted;
      return !quoted && c == mark;
    });
    if (count > most) best = mark;
    most = std::max(most, count);
  }
  return best;
}

/// Returns the text from its first line that is not empty. Space in that line stays: a tab there
/// stands behind a name that is empty.
std::string_view from_first_line(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  const std::size_t end = text.substr(0, begin).rfind('\n');
  return end == std::string_view::npos ? text : text.substr(end + 1);
}

/// Tells whether columns of geometries usually have this name, which is in capitals. Databases name
/// a column after the call that made it, such as `ST_AsText(geom)`.
bool is_usual_name(std::string_view name) {
  if (name.size() > 2 && name.front() == '"' && name.back() == '"') {
    name = name.substr(1, name.size() - 2);
  }
  return std::ranges::find(kUsualNames, name) != kUsualNames.end() || name.starts_with("ST_AS");
}

bool has_usual_name(std::string_view line, char mark) {
  for (;;) {
    const std::size_t end = std::min(line.find(mark), line.size());
    if (is_usual_name(line.substr(0, end))) return true;
    if (end == line.size()) return false;
    line.remove_prefix(end + 1);
  }
}

/// Takes letters in capitals from the beginning of a text, and space before and behind them.
std::string_view take_word(std::string_view& text) {
  const auto skip_space = [&text] {
    text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  };
  skip_space();
  std::size_t size = 0;
  while (size < text.size() && text[size] >= 'A' && text[size] <= 'Z') ++size;
  const std::string_view word = text.substr(0, size);
  text.remove_prefix(size);
  skip_space();
  return word;
}

// Names may begin as WKT does: Point Reyes.
bool looks_like_geometry(std::string_view cell) {
  const std::size_t begin = std::min(cell.find_first_not_of(" \t\r\n"), cell.size());
  cell.remove_prefix(begin);
  if (looks_like_hex_wkb(cell)) return true;
  constexpr std::size_t kLongest = 60;
  const std::string start = in_capitals(cell.substr(0, kLongest));
  if (start.starts_with("SRID=")) return true;
  const auto is_dimension = [](std::string_view word) {
    return word == "Z" || word == "M" || word == "ZM";
  };
  std::string_view rest = start;
  const std::string_view word = take_word(rest);
  const bool is_type = std::ranges::any_of(kWktTypes, [&](std::string_view type) {
    return word == type || (word.starts_with(type) && is_dimension(word.substr(type.size())));
  });
  if (!is_type) return false;
  std::string_view next = take_word(rest);
  if (is_dimension(next)) next = take_word(rest);
  return next == "EMPTY" || (next.empty() && rest.starts_with('('));
}

/// Tells whether a line begins as WKT or hexadecimal WKB does, also in quotes.
bool begins_as_geometry(std::string_view line) {
  constexpr std::size_t kEnough = 60;
  line.remove_prefix(std::min(line.find_first_not_of(" \t\"'"), line.size()));
  if (looks_like_hex_wkb(line)) return true;
  const std::string start = in_capitals(line.substr(0, kEnough));
  return start.starts_with("SRID") || std::ranges::any_of(kWktTypes, [&](std::string_view type) {
           return start.starts_with(type);
         });
}

/// Tells whether a cell behind the first one holds a geometry, if this mark stands between cells. A
/// first cell with a bracket may be WKT of an unknown type.
bool has_geometry_behind(std::string_view line, char mark) {
  bool quoted = false;
  bool behind = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (quoted) continue;
    if (line[i] == '(' && !behind) return false;
    if (line[i] != mark) continue;
    behind = true;
    const std::string_view cell = line.substr(i + 1);
    const std::size_t begin = std::min(cell.find_first_not_of(" \"'"), cell.size());
    if (looks_like_geometry(cell.substr(begin))) return true;
  }
  return false;
}

/// Tells whether a cell is as databases write one that holds nothing.
bool is_null(std::string_view text, bool quoted) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return true;
  if (quoted || text.size() - begin > sizeof "NULL") return false;
  text = text.substr(begin, text.find_last_not_of(" \t\r\n") + 1 - begin);
  return text == "\\N" || in_capitals(text) == "NULL";
}

class TableSource : public FeatureSource {
 public:
  TableSource(std::string_view text, const ReadOptions& options, Rules rules)
      : FeatureSource(options, rules),
        cursor_(text),
        options_(options),
        mark_(mark_between(first_line(from_first_line(text)))) {
    builder_.follow(cursor_);
    const std::size_t at_header = text.size() - from_first_line(text).size();
    cursor_.move_to(at_header);
    Row header;
    take_row(header);
    for (const Cell& cell : header) names_.push_back(text_of(cell));
    if (names_.size() > 1 && names_.back().empty()) names_.pop_back();  // as GDAL writes one column
    if (std::ranges::any_of(names_, looks_like_hex_wkb)) {
      cursor_.fail(ErrorCode::kBadInput, kNoNames, at_header);
    }
    column_ = options.column.empty() ? find_column() : named_column();
  }

  [[nodiscard]] std::string properties() const override {
    std::string json = "{";
    for (std::size_t i = 0; i < row_.size(); ++i) {
      if (i == column_) continue;
      json += (json.size() > 1 ? ", " : "") + json_string(names_[i]) + ": " +
              json_string(text_of(row_[i]));
    }
    return json + '}';
  }

 private:
  bool read_next() override {
    if (!next_row()) return false;
    const Cell& cell = row_[column_];
    start_ = row_.front().begin;
    const std::string_view text = cursor_.text().substr(cell.begin, cell.end - cell.begin);
    is_null_ = is_null(text, cell.quoted);
    if (is_null_) return true;
    const std::size_t after = cursor_.position();
    cursor_.move_to(cell.begin);
    read_wkt_or_hex_wkb(cursor_, options_, builder_);
    while (cursor_.position() < cell.end && is_space(cursor_.peek())) cursor_.advance();
    if (cursor_.position() != cell.end) {
      cursor_.fail("expected the end of the cell after a geometry, found " + cursor_.found());
    }
    cursor_.move_to(after);
    return true;
  }

  // Takes the next row that is not empty, into `row_`.
  bool next_row() {
    for (;;) {
      if (cursor_.at_end()) return false;
      const std::size_t begin = cursor_.position();
      cursor_.name_record("row", rows_ + 1);
      take_row(row_);
      if (row_.size() == 1 && row_[0].begin == row_[0].end) continue;
      ++rows_;
      while (row_.size() > names_.size() && row_.back().begin == row_.back().end) row_.pop_back();
      if (row_.size() == names_.size()) return true;
      cursor_.fail(ErrorCode::kBadInput,
                   "there are " + std::to_string(row_.size()) + " cells, where the table has " +
                       std::to_string(names_.size()) + " columns",
                   begin);
    }
  }

  void take_row(Row& row) {
    row.clear();
    for (;;) {
      row.push_back(take_cell());
      if (!cursor_.accept(mark_)) break;
    }
    cursor_.accept('\r');
    cursor_.accept('\n');
  }

  Cell take_cell() {
    const bool quoted = cursor_.accept('"');
    Cell cell{cursor_.position(), 0, quoted};
    if (quoted) {
      skip_quoted(cell);
    } else {
      const char mark = mark_ == '\0' ? '\n' : mark_;
      const std::string_view rest = cursor_.rest();
      const auto end =
          std::ranges::find_if(rest, [mark](char c) { return c == mark || c == '\n'; });
      cursor_.advance(static_cast<std::size_t>(end - rest.begin()));
      cell.end = cursor_.position();
      if (cell.end > cell.begin && cursor_.text()[cell.end - 1] == '\r') --cell.end;
    }
    if (!is_utf8(cursor_.text().substr(cell.begin, cell.end - cell.begin))) {
      cursor_.fail(ErrorCode::kBadInput, std::string("a cell is not UTF-8") + kToUtf8, cell.begin);
    }
    return cell;
  }

  // A quote within quotes is doubled.
  void skip_quoted(Cell& cell) {
    for (;;) {
      const std::string_view rest = cursor_.rest();
      const std::size_t quote = rest.find('"');
      if (quote == std::string_view::npos) {
        cursor_.fail(ErrorCode::kBadInput, "a quote is not closed", cell.begin - 1);
      }
      cursor_.advance(quote + 1);
      if (cursor_.accept('"')) continue;
      cell.end = cursor_.position() - 1;
      const char c = cursor_.peek();
      if (cursor_.at_end() || c == mark_ || c == '\n' || c == '\r') return;
      cursor_.fail_expected("the end of the cell behind its closing quote");
    }
  }

  [[nodiscard]] std::string text_of(const Cell& cell) const {
    std::string text(cursor_.text().substr(cell.begin, cell.end - cell.begin));
    if (!cell.quoted) return text;
    for (std::size_t at = text.find("\"\""); at != std::string::npos;
         at = text.find("\"\"", at + 1)) {
      text.erase(at, 1);
    }
    return text;
  }

  // Looks into the first rows, until one has a geometry. If no row has one, the name decides.
  std::size_t find_column() {
    const std::size_t begin = cursor_.position();
    std::vector<std::size_t> found;
    while (found.empty() && next_row()) {
      for (std::size_t i = 0; i < row_.size(); ++i) {
        if (looks_like_geometry(text_of(row_[i]))) found.push_back(i);
      }
    }
    rows_ = 0;
    cursor_.name_record({}, 0);
    cursor_.move_to(begin);
    if (found.empty()) {
      for (std::size_t i = 0; i < names_.size(); ++i) {
        if (is_usual_name(in_capitals(names_[i]))) found.push_back(i);
      }
      if (found.size() > 1) found.clear();
    }
    if (found.size() == 1) return found.front();
    if (found.empty()) {
      cursor_.fail(
          ErrorCode::kBadInput,
          "no column of this table holds WKT, or WKB in hexadecimal digits; there are " + listed(),
          0);
    }
    cursor_.fail(ErrorCode::kBadInput,
                 "several columns hold geometries: '" + names_[found[0]] + "' and '" +
                     names_[found[1]] + "'; io::ReadOptions::column names the one to read",
                 0);
  }

  std::size_t named_column() {
    const auto found = std::ranges::find(names_, options_.column);
    if (found != names_.end()) return static_cast<std::size_t>(found - names_.begin());
    cursor_.fail(ErrorCode::kBadInput,
                 "there is no column '" + options_.column +
                     "' (io::ReadOptions::column); there are " + listed(),
                 0);
  }

  [[nodiscard]] std::string listed() const {
    constexpr std::size_t kMost = 20;
    std::string text;
    for (std::size_t i = 0; i < std::min(names_.size(), kMost); ++i) {
      text += (i > 0 ? ", '" : "'") + names_[i].substr(0, 2 * kMost) + "'";
    }
    return text + (names_.size() > kMost ? " and more" : "");
  }

  TextCursor cursor_;
  const ReadOptions& options_;
  char mark_;
  std::vector<std::string> names_;
  std::size_t column_ = 0;
  Row row_;
  std::size_t rows_ = 0;
};

}  // namespace

bool looks_like_table(std::string_view text) {
  const std::string line = in_capitals(first_line(text));
  const char mark = mark_between(line);
  if (!line.empty() && static_cast<unsigned char>(line[0]) >= 0x80 && !is_utf8(line)) {
    return has_usual_name(line, mark);  // any other text may be binary
  }
  const bool may_be_wkt =
      line.find_first_of("({[<=") != std::string::npos || line.find(" EMPTY") != std::string::npos;
  return may_be_wkt ? has_usual_name(line, mark) : mark != '\0' || is_usual_name(line);
}

void refuse_rows_without_names(std::string_view text) {
  constexpr std::size_t kEnough = 10'000;  // all of a text may be one line
  const std::string_view table = from_first_line(text);
  const std::string_view line = first_line(table).substr(0, kEnough);
  if (line.starts_with('#') || begins_as_geometry(line)) return;
  for (const char mark : {',', '\t', ';'}) {
    if (!has_geometry_behind(line, mark)) continue;
    TextCursor(text).fail(ErrorCode::kBadInput, kNoNames, text.size() - table.size());
  }
}

std::unique_ptr<FeatureSource> table_source(std::string_view text, const ReadOptions& options,
                                            Rules rules) {
  return std::make_unique<TableSource>(text, options, rules);
}

}  // namespace minksum::io
