#include "batch/batch_run.hpp"

#include <chrono>
#include <ostream>
#include <utility>

#include "batch/batch_job.hpp"
#include "commands/commands.hpp"
#include "minksum/version.hpp"
#include "pictures/sum_picture.hpp"
#include "process/failure.hpp"
#include "process/progress.hpp"
#include "process/telling.hpp"

namespace minksum::cli {

RunSettings settings_of(const BatchArguments& arguments) {
  return {arguments.output,
          arguments.stats,
          arguments.threads,
          arguments.restart,
          arguments.no_output,
          "job",
          {}};
}

void expect_files(const RunSettings& settings, OutputFiles& files) {
  if (!settings.no_output) {
    files.expect("-o", settings.output);
    if (!settings.output.empty() && !is_special(settings.output)) {
      files.reserve("FILE.partial of -o", LineOutput::unfinished_place(settings.output));
    }
  }
  files.expect_if_any("--stats", settings.stats);
}

void expect_files(const BatchArguments& arguments, OutputFiles& files) {
  if (!arguments.jobs.empty() && arguments.jobs != "-") files.reserve("JOBS", arguments.jobs);
  expect_files(settings_of(arguments), files);
}

BatchRun::BatchRun(RunSettings settings) : settings_(std::move(settings)) {
  if (!settings_.no_output && !settings_.sink) output_.emplace(settings_.output);
}

void BatchRun::go_on(const Jobs& jobs) {
  if (!output_) return;
  if (settings_.restart) {
    check_earlier();
  } else {
    take_earlier(jobs);
  }
  output_->begin(!settings_.restart);
}

void BatchRun::take_earlier(const Jobs& jobs) {
  while (const std::optional<std::string> line = output_->earlier_line()) {
    const std::optional<std::string> head = jobs.head();
    bool failed = false;
    if (!head || !is_result(*line, *head, failed)) refuse(jobs_ + 1, *line + '\n');
    jobs.pass();
    ++jobs_;
    if (failed) ++failed_;
  }
  earlier_ = jobs_;
  if (output_->torn().empty()) return;
  const std::optional<std::string> head = jobs.head();
  if (!head || !may_begin(output_->torn(), *head)) refuse(jobs_ + 1, output_->torn());
}

void BatchRun::check_earlier() {
  std::uint64_t count = 0;
  while (const std::optional<std::string> line = output_->earlier_line()) {
    ++count;
    if (!is_any_result(*line + '\n')) refuse(count, *line + '\n');
  }
  if (!is_any_result(output_->torn())) refuse(count + 1, output_->torn());
}

void BatchRun::refuse(std::uint64_t line, std::string_view text) const {
  const std::string why =
      is_any_result(text)
          ? "not the result of this job with these settings; --restart starts afresh"
          : "not a line that a run has left; move the file away, or name another with -o";
  throw Failure(kBadInput, output_->unfinished() + ":" + std::to_string(line) + ": " + why);
}

void BatchRun::run(Work work, const std::function<std::optional<double>()>& share) {
  const auto start = std::chrono::steady_clock::now();
  BatchProgress progress(settings_.unit, !settings_.no_output && settings_.output.empty());
  work.consume = [&](const Done& done) {
    if (settings_.sink) settings_.sink(done.lines);
    if (output_) output_->write(done.lines);
    jobs_ += done.jobs;
    failed_ += done.failed;
    progress.show(jobs_, failed_, share());
  };
  run_in_order(settings_.threads, work);
  seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

int BatchRun::finish(const Json& more, OutputFiles& files,
                     const std::function<void(LineOutput& lines)>& deliver) {
  if (!settings_.stats.empty()) {
    Json json{{settings_.unit + std::string("s"), jobs_},
              {"failed", failed_},
              {"earlier", earlier_},
              {"threads", settings_.threads},
              {"seconds", seconds_},
              {"version", MINKSUM_VERSION}};
    json.update(more);
    files.write(settings_.stats, [&](std::ostream& out) { out << json.dump(2) << '\n'; });
  }
  if (output_ && deliver) deliver(*output_);
  if (output_ && !deliver) output_->finish();
  files.finish();
  if (output_ && deliver) output_->discard();
  if (failed_ == 0) return kFine;
  note(grouped(failed_) + " of " + grouped(jobs_) + " " + settings_.unit + (jobs_ == 1 ? "" : "s") +
       " failed");
  return kBadInput;
}

}  // namespace minksum::cli
