#include "batch/batch_job.hpp"

#include <algorithm>
#include <filesystem>
#include <new>

#include "minksum/version.hpp"
#include "options/unused_options.hpp"
#include "output/json_members.hpp"
#include "output/result_file.hpp"
#include "process/failure.hpp"

namespace minksum::cli {
namespace {

// Holds what a line asks for; values are JSON as it stands in the line.
struct Job {
  std::string operation;
  std::string_view a;
  std::string_view b;
  std::string_view options;
};

Failure usage(const std::string& what) { return Failure(kWrongUsage, what); }

// Returns the code that results of failed jobs have; docs/batch.md has the table.
const char* name_of(ExitCode code) {
  constexpr const char* kNames[] = {"internal", "bad-job", "bad-input", "limit"};
  return kNames[code <= kLimitExceeded ? code : kFine];
}

Job parse_job(std::string_view text, std::string_view& id) {
  const auto members = json_members(text);
  if (!members) throw usage("a job is a JSON object, which this line is not");
  Job job;
  std::string_view operation;
  const std::pair<const char*, std::string_view*> places[] = {{"id", &id},
                                                              {"operation", &operation},
                                                              {"a", &job.a},
                                                              {"b", &job.b},
                                                              {"options", &job.options}};
  for (const auto& [key, value] : *members) {
    const auto place = std::ranges::find(places, key, [](const auto& p) { return p.first; });
    if (place == std::end(places)) throw usage("a job has no member '" + key + "'");
    if (!place->second->empty()) throw usage("'" + key + "' is there twice");
    *place->second = value;
    if (place->second != &operation) continue;
    auto name = json_string(value);
    if (!name) throw usage("'operation' is a string");
    job.operation = std::move(*name);
  }
  if (operation.empty()) throw usage("the job has no 'operation'");
  if (job.a.empty()) throw usage("the job has no 'a'");
  return job;
}

// Returns a value as it would be typed after the program's name: [1, 2] as 1,2.
std::string typed_value(const std::string& name, std::string_view value) {
  if (auto text = json_string(value)) return "--" + name + "=" + *text;
  if (const auto elements = json_elements(value)) {
    if (elements->size() != 2 && name != "affine") {
      throw usage("--" + name + " takes two numbers, as [1, -2.5]");
    }
    std::string text;
    for (const std::string_view element : *elements) {
      text += (text.empty() ? "" : ",") + json_string(element).value_or(std::string(element));
    }
    return "--" + name + "=" + text;
  }
  if (value.front() == '{' || value == "null") throw usage("--" + name + " takes no such value");
  return "--" + name + "=" + std::string(value);
}

// Returns whether the value is a list of placements. One placement is [x, y], whose numbers may be
// strings.
bool is_list(std::string_view value) {
  const auto elements = json_elements(value);
  if (!elements) return false;
  return std::ranges::any_of(*elements, [](std::string_view element) {
    return element.front() == '[' ||
           json_string(element).value_or("").find(',') != std::string::npos;
  });
}

std::vector<OptionText> parse_options(std::string_view text) {
  std::vector<OptionText> options;
  if (text.empty()) return options;
  const auto members = json_members(text);
  if (!members) throw usage("'options' is an object");
  for (const auto& [name, value] : *members) {
    if (std::ranges::find(options, name, &OptionText::name) != options.end()) {
      throw usage("the option '" + name + "' is there twice");
    }
    OptionText option{name, {}};
    if (value == "false") {
      option.is_off = true;
    } else if (value == "true") {
      option.words.push_back("--" + name);
    } else if (is_list(value)) {
      const auto elements = json_elements(value);
      for (const std::string_view element : *elements) {
        option.words.push_back(typed_value(name, element));
      }
    } else {
      option.words.push_back(typed_value(name, value));
    }
    options.push_back(std::move(option));
  }
  return options;
}

// An operand with its name in messages.
struct NamedOperand {
  Geometry geometry;
  io::SourceInfo source;
  std::string name;
  io::Format format = io::Format::kWkt;
};

NamedOperand read(std::string_view value, const char* name, const std::string& folder,
                  const io::ReadOptions& limits) {
  const auto read_text = [&](auto load, const std::string& shown) -> NamedOperand {
    try {
      const auto& text = load();
      const io::Format format = io::detect_format(text);
      mark_taken_by(format);
      io::Document document = io::read_document(text, limits);
      return {std::move(document.geometry), std::move(document.source), shown, format};
    } catch (const Error& error) {
      if (error.code() == ErrorCode::kCancelled) throw;
      throw failure_of(error, shown);
    }
  };
  if (const auto path = json_string(value)) {
    const bool has_nul = path->find('\0') != std::string::npos;  // which would end the name
    if (path->empty() || *path == "-" || has_nul) {
      throw usage(std::string("'") + name + "' names no file");
    }
    const std::string file = (std::filesystem::path(folder) / *path).string();
    // Reading a special file may never end, and the time limit cannot stop it.
    if (is_special(file)) {
      throw Failure(kBadInput, *path + ": is no file; jobs read no pipes, devices, and folders");
    }
    return read_text([&] { return io::load_text(file, limits); }, *path);
  }
  if (value.front() != '{') {
    throw usage(std::string("'") + name +
                R"(' is the path of a file, {"wkt": "..."}, or a GeoJSON object)");
  }
  const auto members = json_members(value);
  if (members && members->size() == 1 && members->front().key == "wkt") {
    const auto text = json_string(members->front().value);
    if (!text) throw usage(std::string("'wkt' of '") + name + "' is a string");
    return read_text([&] { return std::string_view(*text); }, name);
  }
  return read_text([&] { return value; }, name);
}

const ReadyOperation& ready(const Job& job, const BatchArguments& arguments, Worker& worker) {
  constexpr std::size_t kMost = 64;  // different operations that a thread remembers
  const std::string key = job.operation + ' ' + std::string(job.options);
  if (const auto found = worker.ready.find(key); found != worker.ready.end()) {
    return *found->second;
  }
  auto made = std::make_shared<const ReadyOperation>(ready_operation(
      job.operation, parse_options(job.options), arguments.defaults, arguments.limits));
  if (worker.ready.size() >= kMost) worker.ready.clear();
  return *worker.ready.emplace(key, std::move(made)).first->second;
}

}  // namespace

Digest& Digest::add(std::string_view text) {
  const auto byte = [this](std::uint64_t value) { value_ = (value_ ^ value) * 0x100000001b3; };
  for (const char c : text) byte(static_cast<unsigned char>(c));
  for (int shift = 0; shift < 64; shift += 8) byte((std::uint64_t{text.size()} >> shift) & 0xff);
  return *this;
}

std::string Digest::text() const {
  std::string digits;
  for (int shift = 60; shift >= 0; shift -= 4) digits += "0123456789abcdef"[(value_ >> shift) & 15];
  return digits;
}

Digest digest_of_settings(const BatchArguments& arguments) {
  const ProcessLimits& limits = arguments.limits;
  Digest digest;
  digest.add(MINKSUM_VERSION);
  for (const OptionText& option : arguments.defaults) {
    for (const std::string& word : option.words) digest.add(word);
  }
  for (const std::uint64_t limit :
       {std::uint64_t{limits.read.max_bytes}, std::uint64_t{limits.read.max_vertices},
        limits.sum.max_segments, limits.sum.max_crossings}) {
    digest.add(std::to_string(limit));
  }
  digest.add(std::to_string(limits.seconds));
  const io::DrawingOptions& drawing = limits.read.drawing;
  digest.add(limits.read.drop_z ? "drop-z" : "").add(limits.read.column).add(drawing.layer);
  digest.add(drawing.tolerance ? drawing.tolerance->to_string() : "");
  digest.add(std::to_string(static_cast<int>(drawing.side))).add(drawing.join_ends.to_string());
  return digest;
}

std::string result_head(std::uint64_t job, const std::string& digest) {
  return "{\"job\":" + std::to_string(job) + ",\"digest\":\"" + digest + '"';
}

bool is_result(std::string_view line, const std::string& head, bool& failed) {
  if (!line.starts_with(head)) return false;
  const auto members = json_members(line);
  if (!members) return false;
  failed = members->back().key == "error";
  return true;
}

bool is_any_result(std::string_view line) {
  const auto passes = [&line](std::string_view part) {
    const bool fits = line.starts_with(part) || part.starts_with(line);
    line.remove_prefix(std::min(line.size(), part.size()));
    return fits;
  };
  if (!passes("{\"job\":")) return false;
  const std::size_t digits = std::min(line.find_first_not_of("0123456789"), line.size());
  if (digits == 0 && !line.empty()) return false;
  line.remove_prefix(digits);
  return passes(",\"digest\":\"");
}

bool may_begin(std::string_view line, const std::string& head) {
  return line.starts_with(head) || head.starts_with(line);
}

std::string error_json(double seconds) {
  const auto json = [](const char* code, const std::string& message) {
    return std::string(R"("error":{"code":")") + code + R"(","message":)" + to_json(message) + '}';
  };
  try {
    throw;
  } catch (const Error& error) {
    if (error.code() == ErrorCode::kCancelled) {
      std::string limit = std::to_string(seconds);
      limit.erase(limit.find_last_not_of('0') + 1);
      if (limit.back() == '.') limit.pop_back();
      return json("timeout", "the time limit of " + limit + " seconds is exceeded (--timeout)");
    }
  } catch (...) {
  }
  try {
    const Failure failure = current_failure();
    return json(name_of(failure.code()), failure.what());
  } catch (const std::bad_alloc&) {
    return json("limit", "out of memory (--max-memory)");
  }
}

JobRunner::JobRunner(const BatchArguments& arguments)
    : arguments_(arguments),
      folder_(arguments.jobs == "-" ? ""
                                    : std::filesystem::path(arguments.jobs).parent_path().string()),
      settings_(digest_of_settings(arguments)) {}

std::string JobRunner::head(const JobLine& line) const {
  Digest digest = settings_;
  if (line.dropped > 0) digest.add(std::to_string(line.dropped));
  return result_head(line.number, digest.add(line.text).text());
}

Done JobRunner::run(const JobLine& line, Worker& worker) {
  std::string result;
  std::string notes;
  std::string_view id;
  double seconds = 0;
  bool failed = false;
  try {
    if (line.dropped > 0) {
      throw Failure(kLimitExceeded, "the line is longer than " +
                                        std::to_string(arguments_.limits.read.max_bytes) +
                                        " bytes (--max-bytes)");
    }
    const Job job = parse_job(line.text, id);
    const ReadyOperation& operation = ready(job, arguments_, worker);
    seconds = operation.seconds;
    const Watchdog::Watch watch(watchdog_, seconds);
    io::ReadOptions limits = operation.limits;
    limits.cancel = watch.token();
    const NamedOperand a = read(job.a, "a", folder_, limits);
    if (operation.operands == 2 && job.b.empty()) throw usage("the job has no 'b'");
    if (operation.operands == 1 && !job.b.empty()) throw usage(job.operation + " has no 'b'");
    const NamedOperand b = job.b.empty() ? NamedOperand{} : read(job.b, "b", folder_, limits);
    worker.system = in_system_of({}, {a.source, b.source}, {a.name, b.name});
    const auto add_note = [&notes](const std::string& text) {
      notes += (notes.empty() ? "" : ",") + to_json(text);
    };
    if (!operation.note.empty()) add_note(operation.note);
    const bool has_table = a.format == io::Format::kTable || b.format == io::Format::kTable;
    const std::string& column = operation.limits.column;
    if (!column.empty() && column != arguments_.limits.read.column && !has_table) {
      add_note(kColumnIsUnused);
    }
    for (const NamedOperand* const operand : {&a, &b}) {
      for (const std::string& text : notes_on(operand->source)) {
        add_note(operand->name + ": " + text);
      }
      const auto reading =
          reading_of_faults(operand->geometry.region, operation.fill, watch.token());
      if (reading) add_note(operand->name + ": " + *reading);
    }
    try {
      worker.notes.clear();
      result = operation.run(a.geometry, b.geometry, watch.token(), worker);
      std::ranges::for_each(worker.notes, add_note);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::kCancelled) throw;
      fail_about(error, {a.name, b.name});
    }
  } catch (...) {
    result = error_json(seconds);
    failed = true;
  }
  std::string text = head(line);
  if (!id.empty()) text.append(",\"id\":").append(id);
  if (!notes.empty()) text.append(",\"notes\":[").append(notes).append("]");
  text.append(",").append(result).append("}\n");
  return {std::move(text), 1, failed ? 1u : 0u};
}

}  // namespace minksum::cli
