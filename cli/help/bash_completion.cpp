#include "help/help_page.hpp"

namespace minksum::cli {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

bool is_path(const HelpOption& option) { return option.value == "FILE" || option.value == "DIR"; }

// Writes a function that completes one page: NAME WORD PREVIOUS.
void add_page(std::string& text, const HelpPage& page, const std::string& function,
              const std::vector<std::string>& first) {
  std::vector<std::string> names;
  text += function + "() {\n  case $2 in\n";
  for (const HelpSection& section : page.sections) {
    for (const HelpOption& option : section.options) {
      names.insert(names.end(), option.names.begin(), option.names.end());
      if (option.value.empty()) continue;
      std::string pattern;
      for (const std::string& name : option.names) pattern += (pattern.empty() ? "" : "|") + name;
      text += "    " + pattern + ") ";
      if (option.value == "DIR") {
        text += "COMPREPLY=($(compgen -d -- \"$1\"))";
      } else if (is_path(option)) {
        text += "COMPREPLY=($(compgen -f -- \"$1\"))";
      } else {
        text += "COMPREPLY=($(compgen -W '" + joined(option.choices) + "' -- \"$1\"))";
      }
      text += "; return ;;\n";
    }
  }
  text += "  esac\n  case $1 in\n    -*) COMPREPLY=($(compgen -W '" + joined(names) +
          "' -- \"$1\")) ;;\n    *) COMPREPLY=($(compgen ";
  text += first.empty() ? "-f" : "-W '" + joined(first) + "'";
  text += " -- \"$1\")) ;;\n  esac\n}\n\n";
}

}  // namespace

std::string bash_completion(const HelpPage& program) {
  std::string text = "# Completes command lines of minksum in bash.\n\n";
  const std::size_t prefix = program.name.size() + 1;
  std::vector<std::string> commands;
  for (const HelpPage& page : program.commands) commands.push_back(page.name.substr(prefix));
  add_page(text, program, "_minksum_program", commands);
  for (const HelpPage& page : program.commands) {
    const std::string name = page.name.substr(prefix);
    const bool takes_command = !page.operands.empty() && page.operands.front().value == "COMMAND";
    add_page(text, page, "_minksum_" + name, takes_command ? commands : std::vector<std::string>());
  }
  // `--format=w` reaches a completion as three words.
  text += R"(_minksum() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]}
  if [[ $word == = ]]; then
    word=
  elif [[ $previous == = ]]; then
    previous=${COMP_WORDS[COMP_CWORD-2]}
  fi
  local command=${COMP_WORDS[1]}
  if ((COMP_CWORD < 2)) || ! declare -F "_minksum_$command" > /dev/null; then
    command=program
  fi
  "_minksum_$command" "$word" "$previous"
}
)";
  return text + "complete -o filenames -F _minksum minksum\n";
}

}  // namespace minksum::cli
