#include <algorithm>
#include <sstream>

#include "help/help_page.hpp"
#include "minksum/version.hpp"

namespace minksum::cli {
namespace {

// Returns the text as a man page shows it, whatever marks it holds.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";  // else it would become a hyphen, which nobody can search or paste
    } else {
      result += c;
    }
  }
  // At the beginning of a line these two would be a request.
  const bool request = result.starts_with('.') || result.starts_with('\'');
  return request ? "\\&" + result : result;
}

std::string italic(const std::string& text) { return "\\fI" + escaped(text) + "\\fR"; }
std::string bold(const std::string& text) { return "\\fB" + escaped(text) + "\\fR"; }

std::string upper(std::string text) {
  for (char& c : text) {
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  }
  return text;
}

// Returns "minksum-sum" for "minksum sum".
std::string title_of(const HelpPage& page) {
  std::string title = page.name;
  std::ranges::replace(title, ' ', '-');
  return title;
}

void add_man_option(std::string& text, const HelpOption& option) {
  std::string label;
  for (const std::string& name : option.names) {
    label += (label.empty() ? "" : ", ") + (name.starts_with('-') ? bold(name) : italic(name));
  }
  if (!option.value.empty() && option.value != option.names.front()) {
    label += " " + italic(option.value);
  }
  text += ".TP\n" + label + "\n" + escaped(option.what) + ".\n";
}

// Lines of a footer are filled anew; an empty line begins a paragraph.
void add_footer(std::string& text, const std::string& footer) {
  std::istringstream lines(footer);
  bool first = true;
  bool begins = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) {
      begins = begins || !first;
      continue;
    }
    if (begins) text += ".PP\n";
    begins = false;
    first = false;
    text += escaped(line) + "\n";
  }
}

void add_see_also(std::string& text, const HelpPage& page) {
  text += ".SH SEE ALSO\n";
  const std::size_t space = page.name.find(' ');
  if (space != std::string::npos) text += ".BR " + escaped(page.name.substr(0, space)) + " (1)\n";
  for (const HelpPage& command : page.commands) {
    const bool last = &command == &page.commands.back();
    text += ".BR " + escaped(title_of(command)) + " (1)" + (last ? "" : ",") + "\n";
  }
}

}  // namespace

std::string man_page_name(const HelpPage& page) { return title_of(page) + ".1"; }

std::string man_page(const HelpPage& page) {
  std::string text = ".TH " + escaped(upper(title_of(page))) +
                     " 1 \"\" \"minksum " MINKSUM_VERSION "\" \"User Commands\"\n";
  text += ".SH NAME\n" + escaped(title_of(page)) + " \\- " + escaped(page.what) + "\n";
  text += ".SH SYNOPSIS\n" + escaped(usage_of(page)) + "\n";
  if (!page.operands.empty()) text += ".SH OPERANDS\n";
  for (const HelpOption& operand : page.operands) add_man_option(text, operand);
  text += ".SH OPTIONS\n";
  for (const HelpSection& section : page.sections) {
    if (section.title != "Options") text += ".SS " + escaped(section.title) + "\n";
    for (const HelpOption& option : section.options) add_man_option(text, option);
  }
  if (!page.commands.empty()) text += ".SH COMMANDS\n";
  for (const HelpPage& command : page.commands) {
    text += ".TP\n" + bold(command.name.substr(page.name.size() + 1)) + "\n" +
            escaped(command.what) + ".\n";
  }
  text += ".SH NOTES\n";
  add_footer(text, page.footer);
  add_see_also(text, page);
  return text;
}

}  // namespace minksum::cli
