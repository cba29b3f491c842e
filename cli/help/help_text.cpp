#include <sstream>

#include "help/help_page.hpp"
#include "pictures/text_layout.hpp"

namespace minksum::cli {
namespace {

constexpr std::size_t kWidth = 80;   // as narrow as terminals usually are
constexpr std::size_t kColumn = 26;  // where the text beside names begins

void add_row(std::string& text, const std::string& left, const std::string& right) {
  std::string line = "  " + left;
  if (line.size() + 2 > kColumn) {
    text += line + "\n";
    line.clear();
  }
  for (const std::string& part : wrapped(right, kWidth - kColumn)) {
    line.resize(kColumn, ' ');
    text += line + part + "\n";
    line.clear();
  }
}

std::string label_of(const HelpOption& option) {
  std::string label;
  for (const std::string& name : option.names) label += (label.empty() ? "" : ", ") + name;
  if (!option.value.empty() && option.value != label) label += " " + option.value;
  return label;
}

}  // namespace

std::string usage_of(const HelpPage& page) {
  std::string usage = page.name + (page.commands.empty() ? " [OPTIONS]" : " COMMAND [OPTIONS]");
  for (const HelpOption& operand : page.operands) {
    const std::string name = operand.names.front() + (operand.repeats ? "..." : "");
    usage += operand.required ? " " + name : " [" + name + "]";
  }
  return usage;
}

std::string help_text(const HelpPage& page) {
  std::string text = page.what + "\nUsage: " + usage_of(page) + "\n";
  if (!page.operands.empty()) {
    text += "\nOperands:\n";
    for (const HelpOption& operand : page.operands) add_row(text, label_of(operand), operand.what);
  }
  for (const HelpSection& section : page.sections) {
    text += "\n" + section.title + ":\n";
    for (const HelpOption& option : section.options) add_row(text, label_of(option), option.what);
  }
  if (!page.commands.empty()) text += "\nCommands:\n";
  for (const HelpPage& command : page.commands) {
    add_row(text, command.name.substr(page.name.size() + 1), command.what);
  }
  std::istringstream footer(page.footer);
  for (std::string line; std::getline(footer, line);) {
    for (const std::string& part : wrapped(line, kWidth)) text += part + "\n";
  }
  return text;
}

}  // namespace minksum::cli
