#include "help/help_page.hpp"

namespace minksum::cli {
namespace {

// Returns the text inside single quotes of a specification of _arguments.
std::string in_specification(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') {
      result += "'\\''";
      continue;
    }
    if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string action_of(const HelpOption& option) {
  if (option.value == "DIR") return "_files -/";
  if (option.value == "FILE") return "_files";
  if (option.choices.empty()) return " ";
  std::string values;
  for (const std::string& choice : option.choices) {
    values += (values.empty() ? "" : " ") + in_specification(choice);
  }
  return "(" + values + ")";
}

void add_zsh_option(std::string& text, const HelpOption& option) {
  // Names of one option exclude each other, unless it may be given again.
  std::string others;
  for (const std::string& name : option.names) others += (others.empty() ? "" : " ") + name;
  for (const std::string& name : option.names) {
    text += "    '" + (option.repeats ? "*" : "(" + others + ")") + name;
    if (!option.value.empty()) text += name.starts_with("--") ? "=" : "+";
    text += "[" + in_specification(option.what) + "]";
    if (!option.value.empty())
      text += ":" + in_specification(option.value) + ":" + action_of(option);
    text += "'\n";
  }
}

void add_operands(std::string& text, const HelpPage& page) {
  for (const HelpOption& operand : page.operands) {
    const bool command = operand.value == "COMMAND";
    text += std::string("    '") + (operand.repeats ? "*" : "") + ":" +
            in_specification(operand.names.front()) + ":" +
            (command ? "_minksum_commands" : "_files") + "'\n";
  }
}

void add_page(std::string& text, const HelpPage& page) {
  for (const HelpSection& section : page.sections) {
    for (const HelpOption& option : section.options) add_zsh_option(text, option);
  }
  add_operands(text, page);
}

}  // namespace

std::string zsh_completion(const HelpPage& program) {
  const std::size_t prefix = program.name.size() + 1;
  std::string text = "#compdef minksum\n# Completes command lines of minksum in zsh.\n\n";
  text += "_minksum_commands() {\n  local -a commands=(\n";
  for (const HelpPage& page : program.commands) {
    text += "    '" + in_specification(page.name.substr(prefix)) + ":" +
            in_specification(page.what) + "'\n";
  }
  text += "  )\n  _describe command commands\n}\n\n_minksum_options() {\n  local -a options\n";
  text += "  case $1 in\n";
  for (const HelpPage& page : program.commands) {
    text += "  " + page.name.substr(prefix) + ") options=(\n";
    add_page(text, page);
    text += "  ) ;;\n";
  }
  text += "  esac\n  _arguments -s $options\n}\n\n_minksum() {\n  local -a options=(\n";
  add_page(text, program);
  text += R"(    '1:command:_minksum_commands'
    '*::operand:->command'
  )
  local state line
  _arguments -C $options
  if [[ $state == command ]]; then
    _minksum_options $line[1]
  fi
}

# The file may be loaded as the function itself, or sourced.
if [[ $funcstack[1] == _minksum ]]; then
  _minksum "$@"
else
  compdef _minksum minksum
fi
)";
  return text;
}

}  // namespace minksum::cli
