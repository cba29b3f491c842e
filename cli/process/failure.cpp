#include "process/failure.hpp"

#include <cstdio>
#include <exception>
#include <new>
#include <string_view>
#include <utility>

#include "options/typed_operand.hpp"
#include "options/unused_options.hpp"
#include "output/faults.hpp"
#include "pictures/sum_picture.hpp"
#include "pictures/text_layout.hpp"
#include "process/progress.hpp"
#include "process/telling.hpp"

namespace minksum::cli {
namespace {

ExitCode exit_code_of(ErrorCode code) {
  if (code == ErrorCode::kBadInput) return kBadInput;
  return code == ErrorCode::kLimitExceeded ? kLimitExceeded : kInternal;
}

// Input can put any bytes into a message. Escaping keeps it one line, and harmless for terminals.
std::string one_line(const std::string& text) {
  return printable(text, [](std::string_view part) {
    std::string escaped;
    for (const char c : part) {
      const unsigned byte = static_cast<unsigned char>(c);
      char hexadecimal[8];
      std::snprintf(hexadecimal, sizeof hexadecimal, "\\x%02x", byte);
      escaped += hexadecimal;
    }
    return escaped;
  });
}

int tell_out_of_memory(std::optional<std::uint64_t> limit) noexcept {
  StatusLine::remove();
  if (!limit) {
    std::fputs("minksum: out of memory\n", stderr);
    return kLimitExceeded;
  }
  static constexpr const char* kUnits[] = {"", "K", "M", "G", "T"};
  std::uint64_t size = *limit;
  std::size_t unit = 0;
  for (; unit < 4 && size >= 1024 && size % 1024 == 0; size /= 1024) ++unit;
  std::fprintf(stderr, "minksum: out of memory: the limit is %llu%s bytes (--max-memory)\n",
               static_cast<unsigned long long>(size), kUnits[unit]);
  return kLimitExceeded;
}

bool is_about(const Error& error, std::string_view limit) {
  return error.limit() && error.limit()->name == limit;
}

// Names the option that sets or avoids the limit, instead of the library's member. Other limits are
// fixed and have no option.
std::string with_option(const Error& error) {
  constexpr std::pair<std::string_view, const char*> kOptions[] = {
      {"Limits::max_segments", "--max-segments"},
      {"Limits::max_crossings", "--max-crossings"},
      {"io::ReadOptions::max_vertices", "--max-vertices"},
      {"io::ReadOptions::max_bytes", "--max-bytes"},
      {"doubles", "--coords exact, or decimal:N"}};
  std::string message = error.what();
  for (const auto& [limit, option] : kOptions) {
    if (!is_about(error, limit)) continue;
    const std::string member = " (" + std::string(limit) + ")";
    if (message.ends_with(member)) message.resize(message.size() - member.size());
    message += " (";
    message += option;
    message += ')';
  }
  return message;
}

// Names the program's option instead of the library's.
std::string with_reading_option(std::string message) {
  constexpr std::pair<std::string_view, std::string_view> kOptions[] = {
      {"io::ReadOptions::drop_z", "--drop-z"},
      {"io::ReadOptions::column", "--column"},
      {"io::DrawingOptions::tolerance", "--tolerance"},
      {"io::DrawingOptions::side", "--side"},
      {"io::DrawingOptions::layer", "--layer"},
      {"io::DrawingOptions::join_ends", "--join-ends"}};
  for (const auto& [member, option] : kOptions) {
    const std::size_t at = message.find(member);
    if (at != std::string::npos) message.replace(at, member.size(), option);
  }
  return message;
}

}  // namespace

std::string shown_name(const std::string& file) {
  if (file == "-") return "standard input";
  constexpr std::size_t kMostLetters = 40;
  if (!is_typed_wkt(file)) return file;
  return "'" + (file.size() > kMostLetters ? file.substr(0, kMostLetters) + "..." : file) + "'";
}

void tell(const std::string& message) {
  StatusLine::remove();
  std::fprintf(stderr, "minksum: %s\n", one_line(message).c_str());
}

std::string describe(const Culprit& place) {
  std::string text;
  const auto add = [&text](const char* what, std::size_t index) {
    if (index == Culprit::kNone) return;
    if (!text.empty()) text += ", ";
    text += what + std::to_string(index + 1);
  };
  add("polygon ", place.polygon);
  add("ring ", place.ring);
  add("vertex ", place.vertex);
  return text;
}

Failure failure_of(const Error& error, const std::string& file) {
  if (error.code() == ErrorCode::kInternal) {
    const std::string stage = error.stage().empty() ? "" : " in stage " + error.stage();
    return Failure(kInternal, "internal error" + stage + ": " + error.what());
  }
  std::string line = file.empty() ? "" : shown_name(file) + ":";
  if (const auto* fault = dynamic_cast<const io::ReadError*>(&error); fault && fault->line() > 0) {
    line += std::to_string(fault->line()) + ":";
    if (fault->column() > 0) line += std::to_string(fault->column()) + ":";
  }
  const auto append = [&line](const std::string& part) {
    if (!line.empty()) line += ' ';
    line += part;
  };
  if (const std::string place = describe(error.culprit()); !place.empty()) append(place + ":");
  append(error.code() == ErrorCode::kLimitExceeded ? with_option(error)
                                                   : with_reading_option(error.what()));
  return Failure(exit_code_of(error.code()), line);
}

void fail_about_output(const Error& error, const std::string& output) {
  if (!is_about(error, "doubles") && !is_about(error, "pictures")) throw;
  throw failure_of(error, output.empty() || output == "-" ? "standard output" : output);
}

void fail_about(const Error& error, const std::string (&operands)[2], const std::string& other) {
  // Where the library throws nothing, it reports lack of memory as an error of this name.
  if (is_about(error, "memory")) throw std::bad_alloc();
  const int operand = error.culprit().operand;
  throw failure_of(error, operand == 0 || operand == 1 ? operands[operand] : other);
}

io::Document read_operand(const std::string& file, const io::ReadOptions& limits) {
  try {
    io::Document document;
    if (std::optional<Geometry> shape = named_shape(file, limits.drawing)) {
      document.geometry = std::move(*shape);
    } else if (is_typed_wkt(file)) {
      document = io::read_document(file, limits);
    } else {
      const std::string text = io::load_text(file, limits);
      mark_taken_by(io::detect_format(text));
      document = io::read_document(text, limits);
    }
    for (const std::string& text : notes_on(document.source)) note(shown_name(file) + ": " + text);
    tell_detail(shown_name(file) + ": " + summary(document.geometry));
    return document;
  } catch (const Error& error) {
    throw failure_of(error, file);
  }
}

std::vector<std::string> notes_on(const io::SourceInfo& source) {
  std::vector<std::string> notes;
  std::string about = source.unit.empty() ? "" : "a drawing, whose unit is " + source.unit;
  if (!source.remarks.empty()) about += (about.empty() ? "" : "; ") + source.remarks;
  if (!about.empty()) notes.push_back(std::move(about));
  const std::size_t without = source.null_geometries;
  const std::size_t empty = source.features > 1 ? source.empty_geometries : 0;
  if (without + empty == 0) return notes;
  const auto counted = [](std::size_t count, const char* what) {
    return std::to_string(count) + (count == 1 ? " has " : " have ") + what;
  };
  std::string skipped = std::to_string(without + empty) + " of " + std::to_string(source.features) +
                        " features skipped: ";
  if (without > 0) skipped += counted(without, "no geometry");
  if (empty > 0) skipped += (without > 0 ? ", " : "") + counted(empty, "an empty one");
  notes.push_back(std::move(skipped));
  return notes;
}

io::Document read_operand(const std::string& file, const io::ReadOptions& limits, FillRule fill) {
  io::Document operand = read_operand(file, limits);
  // Shapes of a drawing, which has a unit, may overlap: it shows their union.
  const bool drawing = !operand.source.unit.empty() && fill == FillRule::kAutomatic;
  if (const auto reading =
          drawing ? std::nullopt : reading_of_faults(operand.geometry.region, fill)) {
    note(shown_name(file) + ": " + *reading);
  }
  return operand;
}

std::optional<std::string> reading_of_faults(const Region& region, FillRule fill,
                                             const std::optional<CancelToken>& cancel) {
  if (fill == FillRule::kStrict) return std::nullopt;
  const std::vector<Fault> faults = validate(region, 1, {.cancel = cancel});
  if (faults.empty()) return std::nullopt;
  const char* const meaning =
      fill == FillRule::kAutomatic
          ? "each polygon is what its outer ring encloses less what its holes enclose"
          : "what rings enclose is told by their winding numbers";
  return described(faults.front()) + "; the polygons are not valid, and are read by --fill " +
         to_string(fill) + ": " + meaning + " (--strict refuses them)";
}

Failure current_failure() {
  try {
    throw;
  } catch (const Failure& failure) {
    return failure;
  } catch (const Error& error) {
    return failure_of(error, "");
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::length_error&) {  // asked for more elements than a vector can have
    throw std::bad_alloc();
  } catch (const std::exception& error) {
    return Failure(kInternal, std::string("internal error: ") + error.what());
  }
}

int report_failure(std::optional<std::uint64_t> memory_limit) noexcept {
  try {
    const Failure failure = current_failure();
    tell(failure.what());
    return failure.code();
  } catch (const std::bad_alloc&) {
    return tell_out_of_memory(memory_limit);
  } catch (...) {
    std::fputs("minksum: internal error\n", stderr);
    return kInternal;
  }
}

}  // namespace minksum::cli
