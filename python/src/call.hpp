// Declares what all calls share: their settings, how they are stopped, and how elements of arrays
// are shared by threads.
#pragma once

#include <nanobind/nanobind.h>

#include <functional>
#include <memory>
#include <minksum/minksum.hpp>
#include <optional>
#include <string>
#include <vector>

#include "shape.hpp"

namespace minksum::python {

/// Parameters and arguments of every operation, in one order.
#define MINKSUM_SETTINGS                                                                     \
  const std::string &fill, bool regularize, std::optional<int> threads,                      \
      std::optional<std::uint64_t> max_segments, std::optional<std::uint64_t> max_crossings, \
      std::optional<double> timeout, nanobind::object progress, std::optional<CancelToken> cancel
#define MINKSUM_SETTING_ARGS                                                                      \
  nanobind::arg("fill") = "automatic", nanobind::arg("regularize") = false,                       \
  nanobind::arg("threads") = nanobind::none(), nanobind::arg("max_segments") = nanobind::none(),  \
  nanobind::arg("max_crossings") = nanobind::none(), nanobind::arg("timeout") = nanobind::none(), \
  nanobind::arg("progress") = nanobind::none(), nanobind::arg("cancel") = nanobind::none()
#define MINKSUM_SETTING_VALUES \
  fill, regularize, threads, max_segments, max_crossings, timeout, progress, cancel

/// The argument that says what becomes of an element that fails, of operations on arrays.
#define MINKSUM_ON_ERROR_ARG nanobind::arg("on_error") = "raise"
inline constexpr const char* kOnError = "on_error: str = 'raise', ";

/// Returns a signature for the stubs: NAME(OPERANDS, *, OWN, the settings) -> RESULT. It lives as
/// long as the module.
[[nodiscard]] const char* signature(const std::string& name, const std::string& operands,
                                    const std::string& own = "",
                                    const std::string& result = "Geometry | GeometryArray | None");

/// Settings of one call, and how it is stopped: by Ctrl-C, a token, the progress callback, or time.
class Call {
 public:
  explicit Call(MINKSUM_SETTINGS);
  /// A call with the default settings.
  Call() = default;

  /// Elements that are bad input or pass a limit are left out, instead of ending the call.
  void forgive() { forgives_ = true; }
  [[nodiscard]] bool forgives() const { return forgives_; }

  /// Options for an operation that runs on this thread alone, or on a thread of `for_each`.
  [[nodiscard]] Options& options() { return options_; }
  /// Runs a single operation. The interpreter's lock is released unless `small` is set, which also
  /// keeps it on one thread, and looks for Ctrl-C only if there is something else to look for.
  void run(bool small, const std::function<void()>& operation);
  /// Runs `element` for each index, on as many threads as the caller asked for, with the lock
  /// released. Each thread has options of its own. Throws ElementError for the first that fails.
  void for_each(const std::vector<std::size_t>& shape,
                const std::function<void(std::size_t, const Options&)>& element);

 private:
  struct Watch;
  void start_watch();

  std::shared_ptr<Watch> watch_;
  Options options_;
  std::optional<int> threads_;
  bool forgives_ = false;
};

/// Returns the enumerator that a word names, and throws ValueError, which lists the words.
template <class Enum>
Enum choice(const std::string& word, const char* what,
            std::initializer_list<std::pair<const char*, Enum>> choices) {
  for (const auto& [name, value] : choices) {
    if (word == name) return value;
  }
  std::string message = std::string(what) + " must be one of";
  for (const auto& [name, value] : choices) message += std::string(" \"") + name + '"';
  throw nanobind::value_error(message.c_str());
}
/// Tells what the argument on_error says: whether elements that fail become missing.
[[nodiscard]] bool forgives(const std::string& on_error);
/// Tells whether the exception that is being handled is about an element and not about the call,
/// and no fault of the library.
[[nodiscard]] bool is_bad_element();
[[nodiscard]] FillRule rule_of(const std::string& word);
[[nodiscard]] RoundingSide side_of(const std::string& word);

}  // namespace minksum::python
