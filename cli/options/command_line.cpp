#include "options/command_line.hpp"

#include <CLI/CLI.hpp>
#include <sstream>
#include <utility>

#include "process/failure.hpp"

namespace minksum::cli {

Option Option::required() const { return Option(*option_->required()); }

Option Option::type_name(const char* name) const { return Option(*option_->type_name(name)); }

Option Option::group(const char* name) const { return Option(*option_->group(name)); }

Option Option::one_of(const std::vector<std::string>& names) const {
  return Option(*option_->check(CLI::IsMember(names)));
}

Option Option::in_range(int low, int high) const {
  return Option(*option_->check(CLI::Range(low, high)));
}

Option Option::check(const ValueCheck& check) const {
  return Option(*option_->check(CLI::Validator(check.fault, check.what)));
}

Option Option::repeats() const {
  return Option(*option_->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll));
}

Option Option::delimiter(char between) const { return Option(*option_->delimiter(between)); }

Option Option::excludes(const char* other) const { return Option(*option_->excludes(other)); }

Option Command::add_option(const char* names, std::string& value, const std::string& what) const {
  return Option(*app_->add_option(names, value, what));
}

Option Command::add_option(const char* names, std::vector<std::string>& value,
                           const std::string& what) const {
  return Option(*app_->add_option(names, value, what));
}

Option Command::add_option(const char* names, int& value, const std::string& what) const {
  return Option(*app_->add_option(names, value, what));
}

Option Command::add_option(const char* names, std::uint64_t& value, const std::string& what) const {
  return Option(*app_->add_option(names, value, what));
}

Option Command::add_option(const char* names, double& value, const std::string& what) const {
  return Option(*app_->add_option(names, value, what));
}

Option Command::add_option(const char* names, const Take& take, const std::string& what) const {
  return Option(*app_->add_option_function<std::string>(names, take, what));
}

Option Command::add_flag(const char* names, bool& value, const std::string& what) const {
  return Option(*app_->add_flag(names, value, what));
}

Option Command::add_flag(const char* name, const std::function<void()>& take,
                         const std::string& what) const {
  return Option(*app_->add_flag_callback(name, take, what));
}

void Command::remove_option(const char* name) const { app_->remove_option(app_->get_option(name)); }

void Command::footer(const char* text) const { app_->footer(text); }

std::string Command::name() const { return app_->get_name(); }

CommandLine::CommandLine(const char* what, const char* program)
    : app_(std::make_unique<CLI::App>(what, program)) {
  app_->require_subcommand(1);
}

CommandLine::~CommandLine() = default;

Command CommandLine::add_command(const char* name, const char* what) {
  return Command(*app_->add_subcommand(name, what));
}

void CommandLine::add_version(const char* text) { app_->set_version_flag("--version", text); }

void CommandLine::add_footer(const char* text) {
  for (CLI::App* const command : app_->get_subcommands({})) {
    command->footer(command->get_footer() + text);
  }
  app_->footer(text);
}

std::optional<std::string> CommandLine::parse(const std::vector<std::string>& words,
                                              const char* hint) {
  try {
    app_->parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::Success& asked) {
    std::ostringstream text;
    app_->exit(asked, text, text);
    return std::move(text).str();
  } catch (const CLI::ParseError& error) {
    throw Failure(kWrongUsage, std::string(error.what()) + hint);
  }
  return {};
}

std::string CommandLine::chosen() const { return app_->get_subcommands().front()->get_name(); }

void reject_value(const char* option, const std::string& why) {
  throw CLI::ValidationError(option, why);
}

}  // namespace minksum::cli
