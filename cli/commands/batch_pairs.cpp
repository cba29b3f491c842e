// minksum batch --pairs: takes all ordered pairs of parts at all multiples of an angle.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <system_error>

#include "batch/batch_job.hpp"
#include "batch/batch_run.hpp"
#include "commands/batch.hpp"
#include "commands/commands.hpp"
#include "commands/operations.hpp"
#include "help/spelling.hpp"
#include "minksum/prepared_region.hpp"
#include "options/turns.hpp"
#include "options/unused_options.hpp"
#include "output/json_members.hpp"
#include "output/result_file.hpp"
#include "process/failure.hpp"
#include "process/telling.hpp"

namespace minksum::cli {
namespace {

namespace fs = std::filesystem;

// Smaller tasks would take longer to hand over than to compute.
constexpr std::size_t kPairsPerTask = 64;

// A part that is prepared once for all of its pairs.
struct Part {
  std::string name;
  PreparedRegion fixed;
  /// What is added to a fixed part, for each rotation. For no-fit polygons this is the turned part
  /// times −1, moved so that a sum already lies at the reference point.
  std::vector<PreparedRegion> moving;
  /// The reference point of each of those, as a member of JSON; for sums it is empty.
  std::vector<std::string> references;
};

struct Parts {
  std::vector<Part> parts;
  std::vector<PartialTurn> turns;
  Digest digest;
  io::Coordinates system;  ///< as results are written, with the reference system of all parts

  [[nodiscard]] std::uint64_t pairs() const { return parts.size() * parts.size() * turns.size(); }
};

std::vector<fs::path> files_in(const std::string& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    // Hidden files are no parts: macOS puts one such as ._a.wkt beside each file on foreign disks.
    if (at->path().filename().string().starts_with('.')) continue;
    const std::string ending = in_lower_case(at->path().extension().string());
    const bool readable = ending == ".wkt" || ending == ".geojson" || ending == ".json" ||
                          ending == ".poly" || ending == ".dat";
    if (readable) files.push_back(at->path());
  }
  if (error) throw Failure(kBadInput, folder + ": cannot be read: " + error.message());
  if (files.empty()) {
    throw Failure(kBadInput,
                  folder + ": no parts: files that end in .wkt, .geojson, .json, .poly or .dat");
  }
  std::ranges::sort(files);
  return files;
}

// Adds the second operand of pairs, turned and for no-fit polygons reflected.
void add_moving(Part& part, const BatchArguments& arguments, const Geometry& given,
                const Region& resolved, const PartialTurn& turn) {
  Region turned = transform(resolved, turn.map);
  part.references.emplace_back();
  if (arguments.operation != "sum") {
    const Point reference = turn.map(given.region.point(0));
    turned = transform(
        turned, Affine::translation(reference.x, reference.y).after(Affine::scaling(Rational(-1))));
    const Json json{reference.x.to_string(), reference.y.to_string()};
    part.references.back() = ",\"reference\":" + json.dump();
  }
  part.moving.emplace_back(turned);
}

Part prepare(const BatchArguments& arguments, const fs::path& file, const Geometry& given,
             const std::vector<PartialTurn>& turns) {
  if (const auto reading = reading_of_faults(given.region, arguments.fill)) {
    note(file.string() + ": " + *reading);
  }
  const Geometry resolved = resolve(given, {.fill = arguments.fill, .regularize = true});
  if (resolved.region.empty()) {
    throw Failure(kBadInput, file.string() + ": a part without area cannot be paired");
  }
  Part part{file.filename().string(), PreparedRegion(resolved.region), {}, {}};
  for (const PartialTurn& turn : turns) add_moving(part, arguments, given, resolved.region, turn);
  return part;
}

Parts load(const BatchArguments& arguments) {
  Parts parts;
  parts.digest = digest_of_settings(arguments);
  parts.digest.add(arguments.operation)
      .add(std::to_string(arguments.rotations))
      .add(arguments.tight ? "tight" : "");
  for (int k = 0; k < arguments.rotations; ++k) {
    parts.turns.push_back(turn_by(k, arguments.rotations));
  }
  io::SourceInfo source;  // of the first part that names a reference system
  std::string named_by;
  for (const fs::path& file : files_in(arguments.pairs)) {
    try {
      const std::string text = io::load_text(file.string(), arguments.limits.read);
      parts.digest.add(file.filename().string()).add(text);
      mark_taken_by(io::detect_format(text));
      const io::Document part = io::read_document(text, arguments.limits.read);
      parts.system =
          in_system_of(arguments.coordinates, {source, part.source}, {named_by, file.string()});
      if (named_by.empty() && has_system(parts.system)) {
        source = part.source;
        named_by = file.string();
      }
      parts.parts.push_back(prepare(arguments, file, part.geometry, parts.turns));
    } catch (const Error& error) {
      throw failure_of(error, file.string());
    }
  }
  return parts;
}

std::string degrees(int k, int rotations) {
  // Whole degrees are written as an integer, others as a double.
  if (360 * k % rotations == 0) return std::to_string(360 * k / rotations);
  return Json(360.0 * k / rotations).dump();
}

class PairRunner {
 public:
  PairRunner(const BatchArguments& arguments, const Parts& parts)
      : arguments_(arguments), parts_(parts), digest_(parts.digest.text()) {
    no_fit_.coordinates = arguments.coordinates;
    no_fit_.rounding = arguments.rounding;
    for (const Part& part : parts.parts) names_.push_back(to_json(part.name));
    for (int k = 0; k < arguments.rotations; ++k) {
      std::string text = degrees(k, arguments.rotations);
      const auto& half = parts.turns[static_cast<std::size_t>(k)].half;
      if (half) text += ",\"half_tangent\":\"" + half->to_string() + '"';
      turns_.push_back(std::move(text));
    }
  }
  [[nodiscard]] std::string head(std::uint64_t pair) const {
    return result_head(pair + 1, digest_);
  }
  // Runs the pairs from `first` to before `last`. Pairs are numbered by the fixed part first, then
  // by the moving one, then by the turn.
  Done run(std::uint64_t first, std::uint64_t last, Worker& worker) {
    Done done;
    for (std::uint64_t pair = first; pair < last; ++pair) run(pair, worker, done);
    return done;
  }

 private:
  void run(std::uint64_t pair, Worker& worker, Done& done) {
    const std::uint64_t turns = parts_.turns.size();
    const std::uint64_t turn = pair % turns;
    const std::uint64_t moving = pair / turns % parts_.parts.size();
    const std::uint64_t fixed = pair / turns / parts_.parts.size();
    ++done.jobs;
    const double seconds = arguments_.limits.seconds;
    if (arguments_.no_output) {
      try {
        const Watchdog::Watch watch(watchdog_, seconds);
        sum(fixed, moving, turn, watch.token(), worker);
      } catch (const Error&) {
        ++done.failed;
      }
      return;
    }
    std::string& text = done.lines;
    text.append(head(pair)).append(",\"fixed\":").append(names_[fixed]);
    text.append(",\"moving\":").append(names_[moving]).append(",\"turn\":").append(turns_[turn]);
    text += parts_.parts[moving].references[turn];
    text += ',';
    try {
      const Watchdog::Watch watch(watchdog_, seconds);
      text += result(fixed, moving, turn, watch.token(), worker);
    } catch (...) {
      text += error_json(seconds);
      ++done.failed;
    }
    text += "}\n";
  }

  // The worker's geometry becomes the sum, and its thin parts tight places if they are wanted.
  void sum(std::uint64_t fixed, std::uint64_t moving, std::uint64_t turn,
           const std::optional<CancelToken>& cancel, Worker& worker) {
    Options options;
    options.limits = arguments_.limits.sum;
    options.cancel = cancel;
    const PreparedRegion& p = parts_.parts[fixed].fixed;
    const PreparedRegion& q = parts_.parts[moving].moving[turn];
    if (!arguments_.tight) {
      const Outcome outcome = minkowski_sum(p, q, options, worker.memory, worker.geometry.region);
      if (!outcome.ok()) throw *outcome.error;
      return;
    }
    options.tight = true;
    options.memory = &worker.memory;
    DetailedSum found = detailed_sum(p, q, options);
    worker.geometry = std::move(found.tight);
    worker.geometry.region = std::move(found.sum.region);
  }
  std::string result(std::uint64_t fixed, std::uint64_t moving, std::uint64_t turn,
                     const std::optional<CancelToken>& cancel, Worker& worker) {
    sum(fixed, moving, turn, cancel, worker);
    NoFitArguments no_fit = no_fit_;
    no_fit.cancel = cancel;
    worker.notes.clear();
    const Geometry shown = rounded(worker.geometry, no_fit, worker.notes);
    const std::string notes =
        worker.notes.empty() ? "" : "\"notes\":[" + to_json(worker.notes.front()) + "],";
    return notes + "\"result\":" + geometry_json(shown, arguments_.format, parts_.system);
  }

  const BatchArguments& arguments_;
  const Parts& parts_;
  std::string digest_;
  NoFitArguments no_fit_;
  std::vector<std::string> names_;  // as JSON strings
  std::vector<std::string> turns_;
  Watchdog watchdog_;
};

}  // namespace

int run_pairs(const BatchArguments& arguments) {
  OutputFiles files;
  expect_files(arguments, files);
  const auto start = std::chrono::steady_clock::now();
  const Parts parts = load(arguments);
  const double preparing =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  PairRunner runner(arguments, parts);
  const std::uint64_t count = parts.pairs();
  std::uint64_t at = 0;
  BatchRun run(settings_of(arguments));
  run.go_on({[&]() -> std::optional<std::string> {
               return at < count ? std::optional(runner.head(at)) : std::nullopt;
             },
             [&] { ++at; }});
  Work work;
  work.next = [&]() -> std::optional<Task> {
    if (at == count) return {};
    const std::uint64_t first = at;
    at = std::min<std::uint64_t>(count, at + kPairsPerTask);
    return Task{
        [&runner, first, last = at](Worker& worker) { return runner.run(first, last, worker); }};
  };
  run.run(std::move(work),
          [&] { return static_cast<double>(run.jobs()) / static_cast<double>(count); });
  return run.finish({{"parts", parts.parts.size()}, {"preparing_seconds", preparing}}, files);
}

}  // namespace minksum::cli
