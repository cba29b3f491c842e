// Decides what is told on standard error beside failures: notes, details, and how far a run is.
#pragma once

#include <functional>
#include <string>

#include "minksum/options.hpp"

namespace minksum::cli {

/// What the user wants to be told.
struct Telling {
  bool quiet = false;     ///< no notes and no progress
  bool verbose = false;   ///< what is read, and what the run took
  bool progress = false;  ///< progress at once, and even if standard error is not a terminal
};

/// Sets what is told from now on. Like standard error, this belongs to the process.
void set_telling(const Telling& telling);

/// Tells what is not a failure but may surprise, unless the user wants quiet.
void note(const std::string& message);
/// Tells this if the user wants details.
void tell_detail(const std::string& message);
/// Tells time and memory of the whole run if the user wants details.
void tell_cost();

/// Returns a function for Options::progress, which keeps a line on standard error up to date once
/// an operation takes over a second. Returns an empty function if nobody would see that.
[[nodiscard]] std::function<bool(const minksum::Progress&)> live_progress();

}  // namespace minksum::cli
