// Gives the features of a text one by one, or all of them as one set.
#include <algorithm>

#include "io/feature_source.hpp"
#include "io/formats.hpp"

namespace minksum::io {

namespace {

Document read_all_features(std::string_view text, const ReadOptions& options, Rules rules) {
  const auto source = open_source(text, options, rules);
  Document document;
  while (source->next()) {
    if (source->builder().source().features > 1) continue;
    if (std::string properties = source->properties(); !properties.empty()) {
      document.properties = std::move(properties);
    }
  }
  document.geometry = source->builder().take();
  document.source = source->builder().source();
  if (document.source.features != 1) document.properties.reset();
  return document;
}

}  // namespace

bool FeatureSource::next() {
  builder_.begin_feature();
  is_null_ = false;
  if (!read_next()) return false;
  SourceInfo& source = builder_.source();
  ++source.features;
  if (is_null_) {
    ++source.null_geometries;
  } else if (builder_.feature_is_empty()) {
    ++source.empty_geometries;
  }
  return true;
}

struct FeatureReader::State {
  State(std::string content, std::string_view given, const ReadOptions& how)
      : held(std::move(content)), text(without_mark(held.empty() ? given : held)), options(how) {
    source = open_source(text, options, Rules::kGeometry);
  }

  /// Returns the line at which the feature begins. Features come in the order of the text.
  std::size_t line() {
    if (!source->has_lines()) return 0;
    const auto from = text.begin() + static_cast<std::ptrdiff_t>(counted_to);
    const auto to = text.begin() + static_cast<std::ptrdiff_t>(source->start());
    lines += static_cast<std::size_t>(std::count(from, to, '\n'));
    counted_to = source->start();
    return lines;
  }

  std::string held;  ///< the text of a file
  std::string_view text;
  ReadOptions options;
  std::unique_ptr<FeatureSource> source;
  bool at_end = false;
  std::size_t counted_to = 0;
  std::size_t lines = 1;
};

FeatureReader::FeatureReader(std::string_view text, const ReadOptions& options)
    : state_(std::make_unique<State>(std::string(), text, options)) {}

FeatureReader::FeatureReader(std::unique_ptr<State> state) : state_(std::move(state)) {}

FeatureReader FeatureReader::from_file(const std::string& path, const ReadOptions& options) {
  return FeatureReader(std::make_unique<State>(load_text(path, options), "", options));
}

FeatureReader::~FeatureReader() = default;
FeatureReader::FeatureReader(FeatureReader&& other) noexcept = default;
FeatureReader& FeatureReader::operator=(FeatureReader&& other) noexcept = default;

std::optional<Feature> FeatureReader::next() {
  State& state = *state_;
  while (!state.at_end) {
    state.at_end = true;  // and stays so, if an error comes
    if (!state.source->next()) break;
    state.at_end = false;
    GeometryBuilder& builder = state.source->builder();
    if (builder.feature_is_empty()) continue;
    const std::size_t index = builder.source().features - 1;
    return Feature{builder.take(), state.source->properties(), state.source->id(), index,
                   state.line()};
  }
  return {};
}

const SourceInfo& FeatureReader::source() const { return state_->source->builder().source(); }

double FeatureReader::share() const {
  const double size = static_cast<double>(std::max<std::size_t>(state_->text.size(), 1));
  return static_cast<double>(state_->source->start()) / size;
}

Document read_document(std::string_view text, const ReadOptions& options) {
  return read_all_features(text, options, Rules::kGeometry);
}

Document read_document_file(const std::string& path, const ReadOptions& options) {
  return read_document(load_text(path, options), options);
}

Geometry read_geometry(std::string_view text, const ReadOptions& options) {
  return read_document(text, options).geometry;
}

Geometry read_geometry_file(const std::string& path, const ReadOptions& options) {
  return read_document_file(path, options).geometry;
}

Region read(std::string_view text, const ReadOptions& options) {
  return read_all_features(text, options, Rules::kRegion).geometry.region;
}

Region read_file(const std::string& path, const ReadOptions& options) {
  return read(load_text(path, options), options);
}

}  // namespace minksum::io
