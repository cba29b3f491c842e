#include "failure.hpp"

#include <cstdio>
#include <exception>
#include <new>

namespace minksum::cli {
namespace {

ExitCode exit_code_of(ErrorCode code) {
  switch (code) {
    case ErrorCode::kBadInput:
      return kBadInput;
    case ErrorCode::kLimitExceeded:
      return kLimitExceeded;
    case ErrorCode::kCancelled:
    case ErrorCode::kInternal:
      break;
  }
  return kInternal;
}

std::string shown_name(const std::string& file) { return file == "-" ? "standard input" : file; }

// Input can put anything into a message; one line stays one line, and a terminal stays sane.
std::string one_line(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f) {
      char escaped[8];
      std::snprintf(escaped, sizeof escaped, "\\x%02x", static_cast<unsigned>(byte));
      line += escaped;
    } else {
      line += c;
    }
  }
  return line;
}

int tell(ExitCode code, const std::string& message) noexcept {
  try {
    std::fprintf(stderr, "minksum: %s\n", one_line(message).c_str());
  } catch (...) {
    std::fputs("minksum: out of memory\n", stderr);
  }
  return code;
}

}  // namespace

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
  append(error.what());
  return Failure(exit_code_of(error.code()), line);
}

Region read_operand(const std::string& file) {
  try {
    return io::read_file(file);
  } catch (const Error& error) {
    throw failure_of(error, file);
  }
}

int report_failure() noexcept {
  try {
    throw;
  } catch (const Failure& failure) {
    return tell(failure.code(), failure.what());
  } catch (const Error& error) {
    try {
      const Failure failure = failure_of(error, "");
      return tell(failure.code(), failure.what());
    } catch (...) {
      return tell(kInternal, "internal error");
    }
  } catch (const std::bad_alloc&) {
    return tell(kLimitExceeded, "out of memory");
  } catch (const std::length_error&) {
    return tell(kLimitExceeded, "out of memory");
  } catch (const std::exception& error) {
    try {
      return tell(kInternal, std::string("internal error: ") + error.what());
    } catch (...) {
      return tell(kInternal, "internal error");
    }
  } catch (...) {
    return tell(kInternal, "internal error");
  }
}

}  // namespace minksum::cli
