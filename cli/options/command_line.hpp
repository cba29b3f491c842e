// The command line: options, subcommands, help. The library behind it takes long to compile, and
// only command_line.cpp knows it.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace minksum::cli {

/// What a value has to be.
struct ValueCheck {
  std::function<std::string(const std::string& text)> fault;  ///< of a value; empty = none
  std::string what;                                           ///< for --help
};

/// An option of a subcommand, which owns it. All functions return the same option.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}

  Option required() const;
  Option type_name(const char* name) const;  ///< of its value, for --help
  Option group(const char* name) const;      ///< for --help
  Option one_of(const std::vector<std::string>& names) const;
  Option in_range(int low, int high) const;
  Option check(const ValueCheck& check) const;
  /// May be given again, with one value each time.
  Option repeats() const;
  /// One text may hold several values.
  Option delimiter(char between) const;
  /// The other one is there already.
  Option excludes(const char* other) const;

 private:
  CLI::Option* option_;
};

/// A subcommand, which the command line owns. Parsing fills the values of its options.
class Command {
 public:
  using Take = std::function<void(const std::string& text)>;

  explicit Command(CLI::App& app) : app_(&app) {}

  /// By names as "-o,--output"; a name without a hyphen is that of a positional.
  Option add_option(const char* names, std::string& value, const std::string& what) const;
  Option add_option(const char* names, std::vector<std::string>& value,
                    const std::string& what) const;
  Option add_option(const char* names, int& value, const std::string& what) const;
  Option add_option(const char* names, std::uint64_t& value, const std::string& what) const;
  Option add_option(const char* names, double& value, const std::string& what) const;
  Option add_option(const char* names, const Take& take, const std::string& what) const;
  /// A name as "!--no-axes" sets the value to false.
  Option add_flag(const char* names, bool& value, const std::string& what = {}) const;
  Option add_flag(const char* name, const std::function<void()>& take,
                  const std::string& what) const;
  void remove_option(const char* name) const;
  void footer(const char* text) const;
  [[nodiscard]] std::string name() const;

 private:
  CLI::App* app_;
};

/// A command line with one subcommand.
class CommandLine {
 public:
  explicit CommandLine(const char* what = "", const char* program = "");
  ~CommandLine();

  Command add_command(const char* name, const char* what);
  void add_version(const char* text);
  /// Ends the help of the program and of each subcommand, after what that has.
  void add_footer(const char* text);
  /// Returns what --help or --version, if it is there, asks for. Throws a Failure for wrong usage,
  /// whose message ends in `hint`.
  std::optional<std::string> parse(const std::vector<std::string>& words, const char* hint = "");
  /// The name of the subcommand that was parsed.
  [[nodiscard]] std::string chosen() const;

 private:
  std::unique_ptr<CLI::App> app_;
};

/// Tells the parser that an option does not take a value.
[[noreturn]] void reject_value(const char* option, const std::string& why);

}  // namespace minksum::cli
