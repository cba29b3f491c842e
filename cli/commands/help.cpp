// minksum help: prints help, man pages and completions, or writes them all for an installation.
#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <ostream>
#include <utility>
#include <vector>

#include "commands/commands.hpp"
#include "commands/subcommands.hpp"
#include "help/help_page.hpp"
#include "help/spelling.hpp"
#include "options/result_options.hpp"
#include "output/output_file.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

/// `minksum help [COMMAND]`
struct HelpArguments {
  std::string command;
  bool man = false;
  std::string shell;   ///< whose completion is asked for; empty = none
  std::string folder;  ///< where all files are written; empty = none
};

constexpr const char* kHelpFooter = R"(
`minksum help COMMAND` prints the same as `minksum COMMAND --help`.
)";

struct Completion {
  std::string (*script)(const HelpPage& program);
  const char* file;  ///< below the folder `share` of an installation
};

const std::map<std::string, Completion>& completions() {
  static const std::map<std::string, Completion> kCompletions = {
      {"bash", {bash_completion, "bash-completion/completions/minksum"}},
      {"zsh", {zsh_completion, "zsh/site-functions/_minksum"}},
      {"fish", {fish_completion, "fish/vendor_completions.d/minksum.fish"}}};
  return kCompletions;
}

const HelpPage& page_of(const HelpPage& program, const std::string& command) {
  if (command.empty()) return program;
  std::vector<std::string> names;
  for (const HelpPage& page : program.commands) {
    names.push_back(page.name.substr(program.name.size() + 1));
    if (names.back() == in_lower_case(command)) return page;
  }
  throw Failure(kWrongUsage,
                "there is no command '" + command + "'" + did_you_mean(command, names));
}

void write_all(const HelpPage& program, const std::string& folder) {
  std::vector<std::pair<std::string, std::string>> texts;
  const auto add = [&](const std::string& name, std::string text) {
    texts.emplace_back(folder + "/" + name, std::move(text));
  };
  add("man/man1/" + man_page_name(program), man_page(program));
  for (const HelpPage& page : program.commands) {
    add("man/man1/" + man_page_name(page), man_page(page));
  }
  for (const auto& [name, completion] : completions())
    add(completion.file, completion.script(program));
  OutputFiles files;
  for (const auto& [path, text] : texts) {
    make_folder(path.substr(0, path.rfind('/')));
    files.expect_own("--install", path);
  }
  for (const auto& [path, text] : texts) {
    files.write(path, [&text = text](std::ostream& out) { out << text; });
  }
  files.finish();
}

std::string text_for(const HelpPage& program, const HelpArguments& arguments) {
  if (!arguments.shell.empty()) return completions().at(arguments.shell).script(program);
  const HelpPage& page = page_of(program, arguments.command);
  return arguments.man ? man_page(page) : help_text(page);
}

int run_help(const HelpPage& program, const HelpArguments& arguments) {
  if (!arguments.folder.empty()) {
    write_all(program, arguments.folder);
    return kFine;
  }
  const std::string text = text_for(program, arguments);
  write_standard_output([&](std::ostream& out) { out << text; });
  return kFine;
}

}  // namespace

void add_help(Program& program) {
  const auto arguments = std::make_shared<HelpArguments>();
  const Command command =
      program.line.add_command("help", "Help on a command, as a text or a man page; completions");
  command.footer(kHelpFooter);
  command.add_option("COMMAND", arguments->command, "The command; without it, the program")
      .type_name("COMMAND");
  command.add_flag("--man", arguments->man, "As a man page, for man -l -");
  command
      .add_option("--completion", arguments->shell,
                  "The script by which a shell completes command lines")
      .one_of(names_of(completions()))
      .type_name("SHELL")
      .excludes("--man");
  command
      .add_option("--install", arguments->folder,
                  "Write all man pages and completions into this folder, as share of a prefix")
      .type_name("DIR")
      .excludes("--man")
      .excludes("--completion");
  program.add(command, [&program, arguments] { return run_help(program.line.help(), *arguments); });
}

}  // namespace minksum::cli
