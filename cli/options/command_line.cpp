#include "options/command_line.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <utility>

#include "help/spelling.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

// A check of this name holds the choices of its option, for HelpPage.
constexpr const char* kChoices = "choices: ";

void append(CLI::Option& option, const std::string& note) {
  option.description(option.get_description() + note);
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : " or ";
    text += names[i];
  }
  return text;
}

std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  if (names.empty()) names.push_back(option.get_name(true));
  return names;
}

HelpOption described(CLI::Option& option) {
  HelpOption help{names_of(option), "", option.get_description(), {}, option.get_required(), false};
  const bool flag = option.get_items_expected_max() == 0;
  if (!flag) help.value = option.get_type_name();
  help.repeats = option.get_items_expected_max() > 1;
  try {
    for (int i = 0;; ++i) {
      const std::string name = option.get_validator(i)->get_name();
      if (name.starts_with(kChoices)) {
        help.choices = CLI::detail::split(name.substr(std::string(kChoices).size()), ',');
      }
    }
  } catch (const CLI::OptionNotFound&) {
    // Only this tells that there are no further checks.
  }
  const auto named = [&help](const std::string& name) {
    return help.what.find(name) != std::string::npos;
  };
  if (!std::ranges::all_of(help.choices, named)) help.what += ": " + listed(help.choices);
  return help;
}

HelpPage page_of(CLI::App& app, const std::string& name) {
  HelpPage page{name, app.get_description(), {}, {}, app.get_footer(), {}};
  for (const std::string& group : app.get_groups()) {
    HelpSection section{group, {}};
    for (CLI::Option* const option : app.get_options()) {
      if (option->get_group() != group || group.empty()) continue;
      (option->get_positional() ? page.operands : section.options).push_back(described(*option));
    }
    if (!section.options.empty()) page.sections.push_back(std::move(section));
  }
  for (CLI::App* const command : app.get_subcommands({})) {
    page.commands.push_back(page_of(*command, name + " " + command->get_name()));
  }
  return page;
}

// The parser's own messages are terse.
std::string in_our_words(const std::string& message) {
  constexpr std::pair<std::string_view, const char*> kReplaced[] = {
      {": At Most 1 required but received ", " takes one value, not "},
      {": takes ", " takes "},
      {" is required", " is missing"},
      {" requires ", " has no meaning without "},
      {" excludes ", " cannot be given together with "},
      {": 1 required ", " needs a value: "}};
  std::string text = message;
  for (const auto& [theirs, ours] : kReplaced) {
    if (const std::size_t at = text.find(theirs); at != std::string::npos) {
      text.replace(at, theirs.size(), ours);
      if (theirs.ends_with("required ")) text.resize(text.rfind(" missing"));
      break;
    }
  }
  return text;
}

// The parser's own search for a name ends the process if memory runs out.
CLI::Option& option_named(CLI::App& app, std::string_view name) {
  for (CLI::Option* const option : app.get_options()) {
    const auto is_name = [&](const char* hyphens, const std::string& letters) {
      return name.starts_with(hyphens) && name.substr(std::string_view(hyphens).size()) == letters;
    };
    for (const std::string& letters : option->get_lnames()) {
      if (is_name("--", letters)) return *option;
    }
    for (const std::string& letter : option->get_snames()) {
      if (is_name("-", letter)) return *option;
    }
  }
  throw CLI::OptionNotFound(std::string(name));
}

bool looks_like_option(const std::string& word) { return word.size() > 1 && word[0] == '-'; }

}  // namespace

// A command that nobody asks for has no options, and so nothing is done to them.
Option Option::required() const {
  if (option_ != nullptr) option_->required();
  return *this;
}

Option Option::type_name(const char* name) const {
  if (option_ == nullptr) return *this;
  option_->type_name(name);
  const std::string_view kind = name;
  if (kind != "FILE" && kind != "DIR" && kind != "NAME") return *this;
  // The name of an unset variable is no file, and not standard output either. Where a name is
  // missing, the next option is none.
  const bool any = option_->get_positional() || kind == "NAME";
  option_->check(CLI::Validator(
      [any](const std::string& text) -> std::string {
        if (text.empty()) return "needs a name, not an empty text";
        if (any || !looks_like_option(text)) return "";
        return "needs a name; write './" + text + "' if '" + text + "' is one";
      },
      ""));
  return *this;
}

Option Option::group(const char* name) const {
  if (option_ != nullptr) option_->group(name);
  return *this;
}

Option Option::one_of(const std::vector<std::string>& names) const {
  if (option_ == nullptr) return *this;
  const auto accept = [names](std::string& typed) -> std::string {
    const std::string lower = in_lower_case(typed);
    if (std::ranges::find(names, lower) == names.end()) {
      constexpr std::size_t kMostShown = 60;
      return "takes " + listed(names) + ", not '" + typed.substr(0, kMostShown) + "'" +
             did_you_mean(typed, names);
    }
    typed = lower;
    return {};
  };
  std::string all = kChoices;
  for (const std::string& name : names) all += (&name == names.data() ? "" : ",") + name;
  option_->transform(CLI::Validator(accept, "", all));
  return *this;
}

Option Option::in_range(int low, int high) const {
  const std::string range = std::to_string(low) + " to " + std::to_string(high);
  const auto fault = [low, high, range](const std::string& text) -> std::string {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    if (whole && value >= low && value <= high) return {};
    return "takes a whole number from " + range + ", not '" + text + "'";
  };
  return check({fault, range});
}

Option Option::check(const ValueCheck& check) const {
  if (option_ == nullptr) return *this;
  append(*option_, " (" + check.what + ")");
  option_->check(CLI::Validator(check.fault, ""));
  return *this;
}

Option Option::repeats() const {
  if (option_ != nullptr) {
    option_->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  }
  return *this;
}

Option Option::delimiter(char between) const {
  if (option_ != nullptr) option_->delimiter(between);
  return *this;
}

Option Option::excludes(const char* other) const {
  if (option_ != nullptr) option_->excludes(&option_named(*app_, other));
  return *this;
}

Option Option::needs(const char* other) const {
  if (option_ != nullptr) option_->needs(&option_named(*app_, other));
  return *this;
}

Option Command::add_option(const char* names, std::string& value, const std::string& what) const {
  return Option(app_, asked_for_ ? app_->add_option(names, value, what) : nullptr);
}

Option Command::add_option(const char* names, std::vector<std::string>& value,
                           const std::string& what) const {
  return Option(app_, asked_for_ ? app_->add_option(names, value, what) : nullptr);
}

Option Command::add_option(const char* names, int& value, const std::string& what) const {
  return Option(app_, asked_for_ ? app_->add_option(names, value, what) : nullptr);
}

Option Command::add_option(const char* names, std::uint64_t& value, const std::string& what) const {
  return Option(app_, asked_for_ ? app_->add_option(names, value, what) : nullptr);
}

Option Command::add_option(const char* names, double& value, const std::string& what) const {
  return Option(app_, asked_for_ ? app_->add_option(names, value, what) : nullptr);
}

Option Command::add_option(const char* names, const Take& take, const std::string& what) const {
  return Option(app_,
                asked_for_ ? app_->add_option_function<std::string>(names, take, what) : nullptr);
}

Option Command::add_flag(const char* names, bool& value, const std::string& what) const {
  return Option(app_, asked_for_ ? app_->add_flag(names, value, what) : nullptr);
}

Option Command::add_flag(const char* name, const std::function<void()>& take,
                         const std::string& what) const {
  return Option(app_, asked_for_ ? app_->add_flag_callback(name, take, what) : nullptr);
}

void Command::remove_option(const char* name) const {
  if (asked_for_) app_->remove_option(&option_named(*app_, name));
}

void Command::footer(const char* text) const { app_->footer(text); }

std::string Command::name() const { return app_->get_name(); }

bool Command::has_option(const char* name) const {
  return app_->get_option_no_throw(name) != nullptr;
}

CommandLine::CommandLine(const char* what, const char* program, std::string only)
    : app_(std::make_unique<CLI::App>(what, program)), only_(std::move(only)) {
  app_->require_subcommand(1);
  app_->set_help_flag("-h,--help", "Print this help");
}

CommandLine::~CommandLine() = default;

Command CommandLine::add_command(const char* name, const char* what) {
  return Command(*app_->add_subcommand(name, what), only_.empty() || only_ == name);
}

void CommandLine::add_version(const char* text) {
  app_->set_version_flag("--version", text, "Print the version");
}

void CommandLine::add_footer(const char* text) {
  for (CLI::App* const command : app_->get_subcommands({})) {
    command->footer(command->get_footer() + text);
  }
  app_->footer(app_->get_footer() + text);
}

HelpPage CommandLine::help() const { return page_of(*app_, app_->get_name()); }

std::optional<std::string> CommandLine::parse(const std::vector<std::string>& words) {
  try {
    app_->parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForHelp&) {
    const auto chosen = app_->get_subcommands();
    if (chosen.empty()) return help_text(help());
    CLI::App& command = *chosen.back();
    return help_text(page_of(command, app_->get_name() + " " + command.get_name()));
  } catch (const CLI::CallForVersion& version) {
    return std::string(version.what()) + "\n";
  } catch (const CLI::ParseError& error) {
    throw Failure(kWrongUsage, reason_of(error));
  }
  return {};
}

// The parser reports a misspelt option as a missing operand, or with the words after it.
std::string CommandLine::reason_of(const CLI::ParseError& error) const {
  const auto chosen = app_->get_subcommands();
  const CLI::App& app = chosen.empty() ? *app_ : *chosen.back();
  const std::vector<std::string> unknown = app_->remaining(true);
  const bool about_words = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                           dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
  if (!about_words) return in_our_words(error.what());
  if (const auto word = std::ranges::find_if(unknown, looks_like_option); word != unknown.end()) {
    const std::string typed = word->substr(0, word->find('='));
    std::vector<std::string> names;
    for (const CLI::Option* const option : app.get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back(name);
    }
    const std::size_t letters = std::min(typed.find_first_not_of('-'), typed.size());
    return "there is no option '" + typed + "'" + did_you_mean(typed.substr(letters), names, "--");
  }
  if (chosen.empty() && !unknown.empty()) {
    std::vector<std::string> names;
    for (const CLI::App* const command : app_->get_subcommands({})) {
      names.push_back(command->get_name());
    }
    return "there is no command '" + unknown.front() + "'" + did_you_mean(unknown.front(), names);
  }
  if (chosen.empty()) return "a command is missing";
  if (!unknown.empty()) return "'" + unknown.front() + "' is one operand too many";
  return in_our_words(error.what());
}

std::string CommandLine::chosen() const {
  const auto commands = app_->get_subcommands();
  return commands.empty() ? "" : commands.front()->get_name();
}

std::string CommandLine::given(const std::vector<std::string>& but) const {
  std::string text;
  const auto commands = app_->get_subcommands();
  if (commands.empty()) return text;
  for (CLI::Option* const option : commands.front()->get_options()) {
    const std::vector<std::string> names = names_of(*option);
    const bool is_left_out = std::ranges::any_of(
        names, [&](const std::string& name) { return std::ranges::find(but, name) != but.end(); });
    if (option->count() == 0 || option->get_positional() || is_left_out) continue;
    text += names.front();
    for (const std::string& value : option->results()) text += '=' + value;
    text += '\n';
  }
  return text;
}

void reject_value(const char* option, const std::string& why) {
  throw CLI::ValidationError(option, why);
}

}  // namespace minksum::cli
