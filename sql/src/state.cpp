// Reads operands, writes answers, and turns exceptions into what PostgreSQL reports.
#include "state.hpp"

#include <algorithm>
#include <cstring>
#include <minksum/io.hpp>
#include <new>

namespace minksum::sql {

namespace {

template <std::size_t Size>
void copy(char (&target)[Size], std::string_view text) {
  std::size_t length = std::min(text.size(), Size - 1);
  // A character of several bytes is not cut in two.
  while (length < text.size() && length > 0 && (text[length] & 0xC0) == 0x80) --length;
  std::memcpy(target, text.data(), length);
  target[length] = '\0';
}

std::string place_of(const Culprit& culprit) {
  std::string place;
  const auto add = [&](const char* what, std::size_t index) {
    if (index == Culprit::kNone) return;
    place += (place.empty() ? "" : ", ") + std::string(what) + ' ' + std::to_string(index + 1);
  };
  if (culprit.operand >= 0) add("operand", static_cast<std::size_t>(culprit.operand));
  add("polygon", culprit.polygon);
  add("ring", culprit.ring);
  add("vertex", culprit.vertex);
  return place.empty() ? place : "The place is " + place + ", counted from 1.";
}

mink_status status_of(const Error& error) {
  switch (error.code()) {
    case ErrorCode::kBadInput:
      return MINK_BAD_INPUT;
    case ErrorCode::kLimitExceeded:
      return error.limit() && error.limit()->name == "memory" ? MINK_MEMORY : MINK_LIMIT;
    case ErrorCode::kCancelled:
      return MINK_CANCELLED;
    case ErrorCode::kInternal:
      break;
  }
  return MINK_INTERNAL;
}

std::string hint_of(const Error& error) {
  if (!error.limit()) return {};
  if (error.limit()->name == "Limits::max_segments") return "Raise minksum.max_segments.";
  if (error.limit()->name == "Limits::max_crossings") return "Raise minksum.max_crossings.";
  return {};
}

/// Tells whether a text can be read once heights and measures are dropped.
bool readable_flat(std::string_view bytes, io::ReadOptions options) {
  options.drop_z = true;
  return attempt([&] { static_cast<void>(io::read_document(bytes, options)); }).ok();
}

/// Says in PostgreSQL's terms why an operand could not be read.
Refusal unreadable(const io::ReadError& error, std::string_view bytes, bool text, int index,
                   const io::ReadOptions& options) {
  const std::string message = error.what();
  Refusal refusal{status_of(error), message};
  refusal.detail = "The place is operand " + std::to_string(index + 1);
  if (error.line() != 0) {
    refusal.detail += ", line " + std::to_string(error.line()) + ", column " +
                      std::to_string(error.column());
  }
  refusal.detail += ", counted from 1.";
  if (error.code() != ErrorCode::kBadInput) return refusal;
  if (readable_flat(bytes, options)) {
    // What the message says about C++ is of no use here.
    refusal.message = message.substr(0, message.find(" (io::"));
    refusal.hint = "Drop heights and measures with ST_Force2D.";
  } else if (message.find("is not supported") != std::string::npos) {
    refusal.hint = "Make polygons of curves with ST_CurveToLine. Surfaces are not read.";
  } else if (message.find("not a finite number") == std::string::npos) {
    refusal.status = text ? MINK_BAD_TEXT : MINK_BAD_BYTES;
  }
  return refusal;
}

}  // namespace

mink_status describe(mink_error* error) noexcept {
  const auto say = [&](mink_status status, std::string_view message, std::string_view detail = {},
                       std::string_view hint = {}) {
    copy(error->message, message);
    copy(error->detail, detail);
    copy(error->hint, hint);
    return status;
  };
  try {
    throw;
  } catch (const Refusal& refusal) {
    return say(refusal.status, refusal.message, refusal.detail, refusal.hint);
  } catch (const Error& failure) {
    try {
      return say(status_of(failure), failure.what(), place_of(failure.culprit()),
                 hint_of(failure));
    } catch (...) {
      return say(MINK_MEMORY, "out of memory");
    }
  } catch (const std::bad_alloc&) {
    return say(MINK_MEMORY, "out of memory");
  } catch (const std::exception& failure) {
    return say(MINK_INTERNAL, failure.what());
  } catch (...) {
    return say(MINK_INTERNAL, "unknown exception");
  }
}

RoundingSide side_of(mink_bytes word, const char* argument) {
  return choose(word, argument,
                {RoundingSide::kNearest, RoundingSide::kOutside, RoundingSide::kInside});
}

Options options_of(mink_state& state, const mink_request& request) {
  Options options;
  options.limits.max_segments = request.max_segments;
  options.limits.max_crossings = request.max_crossings;
  options.cancel = CancelToken::polling(request.stop);
  options.memory = &state.memory;
  options.fill = choose(request.fill, "fill",
                        {FillRule::kAutomatic, FillRule::kEvenOdd, FillRule::kNonZero,
                         FillRule::kPositive, FillRule::kNegative, FillRule::kStrict});
  return options;
}

std::pair<Geometry, std::optional<std::int32_t>> read(mink_bytes bytes, bool text, int index,
                                                      const Options& options) {
  io::ReadOptions reading;
  reading.cancel = options.cancel;
  const std::string_view given = view(bytes);
  const std::string place =
      "The place is operand " + std::to_string(index + 1) + ", counted from 1.";
  // The library tells formats by their first characters. Here only one is expected.
  constexpr std::size_t kHeader = 5;
  if (!text && (given.size() < kHeader || static_cast<unsigned char>(given[0]) > 1)) {
    throw Refusal{MINK_BAD_BYTES,
                  "expected WKB, which has 5 bytes or more and begins with the byte 0 or 1", place,
                  "Make WKB with ST_AsEWKB, or use the functions of text for WKT."};
  }
  if (!text && io::detect_format(given) != io::Format::kWkb) {
    throw Refusal{MINK_BAD_BYTES, "the code in bytes 2 to 5 names no type of geometry", place,
                  "Make WKB with ST_AsEWKB."};
  }
  if (text && io::detect_format(given) != io::Format::kWkt) {
    throw Refusal{MINK_BAD_TEXT, "expected WKT", place, "Make WKT with ST_AsText."};
  }
  try {
    io::Document document = io::read_document(given, reading);
    return {std::move(document.geometry), document.source.srid};
  } catch (const io::ReadError& error) {
    throw unreadable(error, given, text, index, reading);
  }
}

Operand& operand(mink_state& state, const mink_request& request, int index,
                 const Options& options) {
  Operand& slot = state.operands.at(static_cast<std::size_t>(index));
  const std::string_view given = view(request.operands[index]);
  if (slot.known && slot.bytes == given) {
    slot.again = true;
  } else {
    slot = Operand{};
    auto [geometry, srid] = read(request.operands[index], request.text, index, options);
    slot.bytes = given;
    slot.geometry = std::move(geometry);
    slot.srid = srid;
    slot.known = true;
  }
  join_srid(state.srid, slot.srid);
  return slot;
}

void join_srid(std::optional<std::int32_t>& srid, const std::optional<std::int32_t>& other) {
  if (srid && other && *srid != *other) {
    throw Refusal{MINK_BAD_INPUT, "operands have two reference systems, " +
                  std::to_string(*srid) + " and " + std::to_string(*other), {},
                  "Bring both into one with ST_Transform, or say what they are with ST_SetSRID."};
  }
  if (!srid) srid = other;
}

namespace {

/// Marks little-endian WKB as PostGIS does, so that it names its reference system.
void mark(std::string& wkb, std::int32_t srid) {
  constexpr std::size_t kHeader = 5;
  wkb.at(kHeader - 1) = static_cast<char>(static_cast<unsigned char>(wkb.at(kHeader - 1)) | 0x20U);
  std::array<char, 4> number{};
  for (unsigned i = 0; i < number.size(); ++i) {
    number[i] = static_cast<char>((static_cast<std::uint32_t>(srid) >> (8 * i)) & 0xFFU);
  }
  wkb.insert(kHeader, number.data(), number.size());
}

}  // namespace

mink_bytes write(mink_state& state, const Geometry& geometry, bool text,
                 const RoundOptions& target, const Options& options, std::size_t place,
                 bool fit) {
  std::string& written = state.written.at(place);
  io::Coordinates style;
  style.cancel = options.cancel;
  if (text) {
    style.style = io::Coordinates::Style::kExact;
    written = io::to_wkt(geometry, style);
    if (state.srid) written.insert(0, "SRID=" + std::to_string(*state.srid) + ';');
  } else {
    const bool may_be_tight = fit && geometry.has_thin_parts();
    written = io::to_wkb(may_be_tight ? round_with_tight_places(geometry, target, options)
                                      : round(geometry, target, options),
                         style);
    if (state.srid) mark(written, *state.srid);
  }
  return {written.data(), written.size()};
}

}  // namespace minksum::sql

mink_state* mink_state_new() { return new (std::nothrow) mink_state; }
void mink_state_free(mink_state* state) { delete state; }
