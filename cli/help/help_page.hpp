// Describes the command line as data. Help texts, man pages and completions are made of it, so they
// cannot differ.
#pragma once

#include <string>
#include <vector>

namespace minksum::cli {

/// An option, a flag or an operand.
struct HelpOption {
  std::vector<std::string> names;    ///< with their hyphens; an operand has one name without any
  std::string value;                 ///< the name of its value, such as FILE; empty = a flag
  std::string what;                  ///< what it does
  std::vector<std::string> choices;  ///< the values it takes; empty = any
  bool required = false;
  bool repeats = false;
};

/// The options below one heading.
struct HelpSection {
  std::string title;
  std::vector<HelpOption> options;
};

/// The program, or one of its subcommands.
struct HelpPage {
  std::string name;  ///< such as "minksum sum"
  std::string what;
  std::vector<HelpOption> operands;
  std::vector<HelpSection> sections;
  std::string footer;              ///< lines as they are shown
  std::vector<HelpPage> commands;  ///< of the program
};

/// Returns a text such as "minksum draw [OPTIONS] FILE...".
[[nodiscard]] std::string usage_of(const HelpPage& page);

/// Returns the page as a text for terminals, as --help prints it.
[[nodiscard]] std::string help_text(const HelpPage& page);

/// Returns the page as a man page of section 1, in the macros that are named man.
[[nodiscard]] std::string man_page(const HelpPage& page);
/// Returns the name of the page's file, such as "minksum-sum.1".
[[nodiscard]] std::string man_page_name(const HelpPage& page);

/// Each function returns a script for a shell that completes commands, options and values.
[[nodiscard]] std::string bash_completion(const HelpPage& program);
[[nodiscard]] std::string zsh_completion(const HelpPage& program);
[[nodiscard]] std::string fish_completion(const HelpPage& program);

}  // namespace minksum::cli
