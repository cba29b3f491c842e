// Declares the command line: options, subcommands and help. Only command_line.cpp includes the
// library behind them, because it takes long to compile.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "help/help_page.hpp"

namespace CLI {
class App;
class Option;
class ParseError;
}  // namespace CLI

namespace minksum::cli {

/// A condition on the value of an option.
struct ValueCheck {
  std::function<std::string(const std::string& text)> fault;  ///< why a value is bad; empty = good
  std::string what;                                           ///< the condition in --help
};

/// An option of a subcommand, which owns it. Each function returns the option itself.
class Option {
 public:
  Option(CLI::App* app, CLI::Option* option) : app_(app), option_(option) {}

  Option required() const;
  Option type_name(const char* name) const;  ///< names its value in --help
  Option group(const char* name) const;      ///< names its section of --help
  /// The value is one of these names, which are in lower case. It may be typed in any case.
  Option one_of(const std::vector<std::string>& names) const;
  Option in_range(int low, int high) const;
  Option check(const ValueCheck& check) const;
  /// The option may be given several times, with one value each time.
  Option repeats() const;
  /// One text may hold several values with `between` between them.
  Option delimiter(char between) const;
  /// The two options cannot be given together. The other one must have been added before.
  Option excludes(const char* other) const;
  /// The option has no meaning without the other one, which must have been added before.
  Option needs(const char* other) const;

 private:
  CLI::App* app_;
  CLI::Option* option_;
};

/// A subcommand, which the command line owns. Parsing fills the values of its options.
class Command {
 public:
  using Take = std::function<void(const std::string& text)>;

  /// Unless the command is `asked_for`, options that are added to it are left out.
  Command(CLI::App& app, bool asked_for) : app_(&app), asked_for_(asked_for) {}

  /// Adds an option with names such as "-o,--output". A name without a hyphen makes a positional.
  Option add_option(const char* names, std::string& value, const std::string& what) const;
  Option add_option(const char* names, std::vector<std::string>& value,
                    const std::string& what) const;
  Option add_option(const char* names, int& value, const std::string& what) const;
  Option add_option(const char* names, std::uint64_t& value, const std::string& what) const;
  Option add_option(const char* names, double& value, const std::string& what) const;
  Option add_option(const char* names, const Take& take, const std::string& what) const;
  /// Adds a flag. A name such as "!--no-axes" makes it set the value to false.
  Option add_flag(const char* names, bool& value, const std::string& what = {}) const;
  Option add_flag(const char* name, const std::function<void()>& take,
                  const std::string& what) const;
  void remove_option(const char* name) const;
  [[nodiscard]] bool has_option(const char* name) const;
  void footer(const char* text) const;
  [[nodiscard]] std::string name() const;

 private:
  CLI::App* app_;
  bool asked_for_;
};

/// Parses a command line that has one subcommand.
class CommandLine {
 public:
  /// If `only` names a subcommand, the others get no options: adding those of all takes longer
  /// than a small sum.
  explicit CommandLine(const char* what = "", const char* program = "", std::string only = "");
  ~CommandLine();

  Command add_command(const char* name, const char* what);
  void add_version(const char* text);
  /// Adds `text` at the end of the help of the program and of each subcommand.
  void add_footer(const char* text);
  /// Describes the program with all its subcommands.
  [[nodiscard]] HelpPage help() const;
  /// Parses the words. Returns the text that --help or --version asks for, if one of them is there.
  /// Throws a Failure for wrong usage.
  std::optional<std::string> parse(const std::vector<std::string>& words);
  /// Returns the name of the subcommand that was parsed; empty if there was none.
  [[nodiscard]] std::string chosen() const;
  /// Returns the options of that subcommand that were given, with their values, but for operands
  /// and `but` (names with hyphens).
  [[nodiscard]] std::string given(const std::vector<std::string>& but) const;

 private:
  [[nodiscard]] std::string reason_of(const CLI::ParseError& error) const;

  std::unique_ptr<CLI::App> app_;
  std::string only_;
};

/// Throws what makes the parser refuse the value of an option.
[[noreturn]] void reject_value(const char* option, const std::string& why);

}  // namespace minksum::cli
