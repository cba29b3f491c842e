#include "output/picture_file.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <ostream>
#include <sstream>

#include "help/spelling.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

// librsvg draws our SVG well, but its licence (LGPL) is not that of this program. So nothing is
// linked: its own program is called, if it is there.
constexpr const char* kConverter = "rsvg-convert";

// Returns "png" or "pdf", or nothing for SVG.
std::string converted_format(const std::string& file) {
  const std::string ending = in_lower_case(std::filesystem::path(file).extension().string());
  return ending == ".png" || ending == ".pdf" ? ending.substr(1) : "";
}

std::string path_of_converter() {
  const char* const folders = std::getenv("PATH");
  std::istringstream list(folders != nullptr ? folders : "/usr/bin:/bin");
  for (std::string folder; std::getline(list, folder, ':');) {
    std::string path = folder + "/" + kConverter;
    if (::access(path.c_str(), X_OK) == 0) return path;
  }
  return {};
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using TemporaryStream = std::unique_ptr<std::FILE, CloseFile>;

TemporaryStream temporary_stream(const std::string& file) {
  TemporaryStream stream(std::tmpfile());
  if (stream) return stream;
  throw Failure(kBadInput, file + ": cannot be written: " + std::strerror(errno));
}

// The converter gets files without names, so neither program waits for the other's pipe.
std::string converted(const std::string& svg, const std::string& format, const std::string& file) {
  const TemporaryStream input = temporary_stream(file);
  const TemporaryStream output = temporary_stream(file);
  const bool written = std::fwrite(svg.data(), 1, svg.size(), input.get()) == svg.size() &&
                       std::fflush(input.get()) == 0;
  if (!written) throw Failure(kBadInput, file + ": cannot be written: " + std::strerror(errno));
  std::rewind(input.get());
  std::string path = path_of_converter();
  std::string option = "--format=" + format;
  char* const arguments[] = {path.data(), option.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(input.get()), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(output.get()), STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int reason = ::posix_spawn(&child, path.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = reason;
  if (reason == 0) {
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
  }
  std::string result;
  std::rewind(output.get());
  char buffer[1 << 14];
  while (const std::size_t got = std::fread(buffer, 1, sizeof buffer, output.get())) {
    result.append(buffer, got);
  }
  if (status == 0 && !result.empty()) return result;
  throw Failure(kBadInput, file + ": cannot be written: " + kConverter +
                               " could not convert the picture; .svg needs no conversion");
}

}  // namespace

void require_picture(const char* option, const std::string& file) {
  if (file.empty()) return;
  if (file == "-") {
    throw Failure(kWrongUsage, std::string(option) + " needs a file, not standard output");
  }
  const std::string ending = in_lower_case(std::filesystem::path(file).extension().string());
  const bool known = ending.empty() || ending == ".svg" || !converted_format(file).empty();
  if (!known && !is_special(file)) {
    throw Failure(kWrongUsage,
                  file + ": no picture ends in " + ending + "; there are .svg, .png, .pdf");
  }
  if (!converted_format(file).empty() && path_of_converter().empty()) {
    throw Failure(kBadInput, file + ": cannot be written: " + ending + " needs the program " +
                                 kConverter + " (librsvg), which is not there; .svg needs nothing");
  }
}

void write_picture(OutputFiles& files, const std::string& file,
                   const std::function<std::string()>& draw) {
  const std::string format = converted_format(file);
  files.write(file, [&](std::ostream& out) {
    out << (format.empty() ? draw() : converted(draw(), format, file));
  });
}

}  // namespace minksum::cli
