#include "batch/each_feature.hpp"

#include <memory>
#include <optional>
#include <ostream>

#include "batch/batch_job.hpp"
#include "batch/batch_run.hpp"
#include "batch/feature_text.hpp"
#include "minksum/version.hpp"
#include "options/typed_operand.hpp"
#include "options/unused_options.hpp"
#include "output/json_members.hpp"
#include "output/line_output.hpp"
#include "output/output_file.hpp"
#include "output/result_file.hpp"
#include "process/failure.hpp"
#include "process/telling.hpp"

namespace minksum::cli {
namespace {

std::string text_of(const std::string& operand, const io::ReadOptions& limits) {
  if (const auto shape = named_shape(operand, limits.drawing)) {
    return io::to_wkt(*shape, {io::Coordinates::Style::kExact});
  }
  return is_typed_wkt(operand) ? operand : io::load_text(operand, limits);
}

// Calls `read`, whose failures are about the file.
template <class Read>
auto reading(const std::string& file, Read read) {
  try {
    return read();
  } catch (const Error& error) {
    throw failure_of(error, file);
  }
}

// A feature that was read, with what its text had said by then.
struct Item {
  io::Feature feature;
  io::Coordinates coordinates;
};

class EachRun {
 public:
  explicit EachRun(const EachSettings& settings)
      : settings_(settings), name_(shown_name(settings.operands[0])) {
    if (!settings.operands[1].empty()) {
      second_ = read_operand(settings.operands[1], settings.limits, settings.options.fill);
    }
    text_ = reading(settings.operands[0],
                    [&] { return text_of(settings.operands[0], settings.limits); });
    mark_taken_by(io::detect_format(text_));
    reader_.emplace(
        reading(settings.operands[0], [&] { return io::FeatureReader(text_, settings_.limits); }));
    choose_format();
    digest_ = digest();
  }

  int run();

 private:
  // GeoJSON alone keeps properties, so GeoJSON and tables become that if nothing else is asked for.
  void choose_format() {
    ResultArguments& result = settings_.result;
    const bool is_asked_for = !result.typed_format.empty() || !result.output.empty();
    using enum io::Format;
    const io::Format given = io::detect_format(text_);
    if (!is_asked_for && (given == kGeoJson || given == kTable || given == kGdal)) {
      result.format = kGeoJson;
    }
    if (result.format == kWkt || result.format == kGeoJson || result.format == kHexWkb) return;
    throw Failure(kWrongUsage,
                  "--each writes lists: --format takes wkt, geojson, geojsonl or wkbhex");
  }

  [[nodiscard]] std::string digest() const {
    const ResultArguments& result = settings_.result;
    Digest digest;
    digest.add(MINKSUM_VERSION).add(settings_.each.settings).add(text_);
    digest.add(std::to_string(static_cast<int>(result.format)) + (result.lines ? "l" : ""));
    digest.add(io::to_wkt(second_.geometry, {io::Coordinates::Style::kExact}));
    return digest.text();
  }

  // Returns the reference system as far as the operands have named it.
  [[nodiscard]] io::Coordinates system() const {
    return in_system_of(settings_.result.coordinates, {reader_->source(), second_.source},
                        settings_.operands);
  }

  // Returns the next feature without taking it.
  const Item* peek() {
    if (ahead_) return &*ahead_;
    auto feature = reading(settings_.operands[0], [&] { return reader_->next(); });
    const io::Coordinates coordinates = system();
    if (!first_) first_ = coordinates;
    if (coordinates.srid != first_->srid || coordinates.crs != first_->crs) {
      system_came_late_ = true;
    }
    if (!feature) return nullptr;
    ahead_ = Item{std::move(*feature), coordinates};
    return &*ahead_;
  }
  Item take() {
    Item item = std::move(*ahead_);
    ahead_.reset();
    const std::string& properties = item.feature.properties;
    has_properties_ = has_properties_ || !(properties.empty() || properties == "null");
    return item;
  }

  [[nodiscard]] std::string head(const Item& item) const {
    return result_head(item.feature.index + 1, digest_);
  }

  [[nodiscard]] Done work_on(const Item& item, Worker& worker) const;
  [[nodiscard]] Work work();
  void tell_end() const;

  EachSettings settings_;
  std::string name_;
  io::Document second_;
  std::string text_;
  std::optional<io::FeatureReader> reader_;
  std::string digest_;
  std::optional<Item> ahead_;
  std::optional<io::Coordinates> first_;  ///< those that were known at the first feature
  bool system_came_late_ = false;
  bool has_properties_ = false;
};

Done EachRun::work_on(const Item& item, Worker& worker) const {
  const io::Feature& feature = item.feature;
  const std::string names[2] = {name_ + ": feature " + std::to_string(feature.index + 1),
                                settings_.operands[1]};
  std::string note;
  std::string member;
  bool failed = false;
  try {
    if (const auto how = reading_of_faults(feature.geometry.region, settings_.options.fill)) {
      note = ",\"note\":" + to_json(names[0] + ": " + *how);
    }
    try {
      worker.notes.clear();
      const FeatureAnswer answer = settings_.answer(feature.geometry, second_.geometry, worker);
      member = answer_member(settings_, feature, answer, item.coordinates);
      for (const std::string& lost : worker.notes) {
        note += ",\"lost\":" + to_json(names[0] + ": " + lost);
      }
    } catch (const Error& error) {
      fail_about(error, names, names[0]);
    }
  } catch (...) {
    member = error_json(0);
    failed = true;
  }
  return {head(item) + note + "," + member + "}\n", 1, failed ? 1U : 0U};
}

Work EachRun::work() {
  Work work;
  work.next = [this]() -> std::optional<Task> {
    if (peek() == nullptr) return {};
    const auto item = std::make_shared<const Item>(take());
    constexpr std::size_t kBytesOfVertex = 32;
    return Task{[this, item](Worker& worker) { return work_on(*item, worker); },
                item->feature.geometry.region.vertex_count() * kBytesOfVertex};
  };
  return work;
}

void EachRun::tell_end() const {
  for (const std::string& text : notes_on(reader_->source())) note(name_ + ": " + text);
  if (settings_.json || settings_.result.format == io::Format::kGeoJson) return;
  if (has_properties_) {
    note("properties have no place in this format; --format geojson keeps them");
  }
  note_lost_system(system(), settings_.result.format);
  if (system_came_late_) {
    note(name_ + ": the reference system stands behind features, whose results do not name it");
  }
}

int EachRun::run() {
  const std::string& output = settings_.result.output;
  RunSettings how{output,
                  settings_.stats,
                  threads_or_all(settings_.options.threads),
                  settings_.each.restart,
                  false,
                  "feature",
                  {}};
  OutputFiles files;
  expect_files(how, files);
  FeatureText text(settings_);
  std::optional<LineOutput> stream;  // what cannot be continued is written at once
  if (output.empty() || is_special(output)) {
    stream.emplace(output);
    how.sink = [&](std::string_view line) { stream->write(text.add(line)); };
  }
  BatchRun run(how);
  run.go_on({[this]() -> std::optional<std::string> {
               const Item* const item = peek();
               return item != nullptr ? std::optional(head(*item)) : std::nullopt;
             },
             [this] { static_cast<void>(take()); }});
  static_cast<void>(peek());
  if (stream) stream->write(text.begin(*first_));
  try {
    run.run(work(), [this] { return std::optional(reader_->share()); });
  } catch (const Failure&) {  // as where a feature cannot be read
    if (stream) stream->write(text.end(*first_));
    throw;
  }
  if (stream) stream->write(text.end(system()));
  tell_end();
  const int code = run.finish(Json::object(), files, [&](LineOutput& lines) {
    files.write(output, [&](std::ostream& out) {
      out << text.begin(*first_);
      lines.rewind();
      while (const auto line = lines.earlier_line()) out << text.add(*line);
      out << text.end(system());
    });
  });
  text.tell_notes();
  return code;
}

}  // namespace

int run_each(const EachSettings& settings) { return EachRun(settings).run(); }

}  // namespace minksum::cli
