#include "help/help_page.hpp"

namespace minksum::cli {
namespace {

std::string in_quotes(const std::string& text) {
  std::string result = "'";
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return result + "'";
}

void add_fish_option(std::string& text, const HelpOption& option, const std::string& condition) {
  text += "complete -c minksum -n " + in_quotes(condition);
  for (const std::string& name : option.names) {
    text += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (option.value == "FILE") {
    text += " -r -F";
  } else if (option.value == "DIR") {
    text += " -x -a '(__fish_complete_directories)'";
  } else if (!option.value.empty()) {
    text += " -x";
    std::string values;
    for (const std::string& choice : option.choices) {
      values += (values.empty() ? "" : " ") + choice;
    }
    if (!values.empty()) text += " -a " + in_quotes(values);
  }
  text += " -d " + in_quotes(option.what) + "\n";
}

void add_fish_page(std::string& text, const HelpPage& page, const std::string& condition) {
  for (const HelpSection& section : page.sections) {
    for (const HelpOption& option : section.options) add_fish_option(text, option, condition);
  }
}

}  // namespace

std::string fish_completion(const HelpPage& program) {
  const std::size_t prefix = program.name.size() + 1;
  std::string text = "# Completes command lines of minksum in fish.\n\n";
  add_fish_page(text, program, "__fish_use_subcommand");
  for (const HelpPage& page : program.commands) {
    const std::string name = page.name.substr(prefix);
    const std::string condition = "__fish_seen_subcommand_from " + name;
    text += "complete -c minksum -f -n __fish_use_subcommand -a " + name + " -d " +
            in_quotes(page.what) + "\n";
    add_fish_page(text, page, condition);
    for (const HelpOption& operand : page.operands) {
      if (operand.value != "COMMAND") continue;
      text += "complete -c minksum -f -n " + in_quotes(condition) + " -a '";
      for (const HelpPage& other : program.commands) text += other.name.substr(prefix) + " ";
      text += "'\n";
    }
  }
  return text;
}

}  // namespace minksum::cli
