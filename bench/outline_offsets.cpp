// Measures offsets of outlines beside GEOS's buffer, from the outline in memory to the result.
#include <array>
#include <string>
#include <vector>

#include "minksum/io.hpp"
#include "minksum/offset.hpp"
#include "minksum/testing.hpp"
#include "peers/peers.hpp"
#include "peers/stopwatch.hpp"
#include "sets.hpp"

namespace minksum::bench {
namespace {

// All outlines of 800 to 70,000 vertices in the folder, by size.
constexpr std::array kOutlines{"greece_50m",       "azerbaijan_10m",     "mongolia_10m",
                               "norway_50m",       "chile_50m",          "indonesia_10m_largest",
                               "south_africa_10m", "mozambique_10m",     "indonesia_50m",
                               "us_alaska",        "france_10m",         "usa_50m",
                               "greece_10m",       "norway_10m_largest", "canada_50m",
                               "norway_10m",       "chile_10m",          "indonesia_10m",
                               "canada_10m"};

struct Distance {
  const char* text;
  double value;
};
// In degrees.
constexpr std::array<Distance, 3> kDistances{{{"0.01", 0.01}, {"0.1", 0.1}, {"1", 1.0}}};

std::size_t size_of(const Geometry& geometry) { return geometry.region.vertex_count(); }

// Counts the decisions of the sum that the offset is.
std::uint64_t decisions(const Geometry& outline, const Region& element) {
  SumSettings settings;
  settings.small = false;
  const Statistics counts = detailed_sum(outline, Geometry{element, {}, {}}, settings).statistics;
  return counts.by_filter + counts.by_fixed_width + counts.by_arbitrary;
}

void measure_one(const std::string& file, const Distance& distance, const Effort& effort,
                 const Report& report) {
  const Geometry outline{io::read_file(file), {}, {}};
  const Rational radius = *Rational::parse(distance.text);
  const Region element = disc(radius, radius / Rational(1000));
  const auto segments = static_cast<int>(element.vertex_count() / 4);
  const std::unique_ptr<Peer> peer = make_geos_buffer(outline.region, distance.value, segments);
  std::vector<double> ours;
  std::vector<double> reusing;  // with memory that is reused
  std::vector<double> theirs;
  double total = 0;
  Workspace workspace;
  Options with_memory;
  with_memory.memory = &workspace;
  const auto run = [&](const Options& options, std::vector<double>& seconds) {
    const Stopwatch watch;
    const Geometry result = offset(outline, radius, {}, options);
    total += seconds.emplace_back(watch.seconds());
    return size_of(result);
  };
  report({{"vertices", size_of(outline)},
          {"disc", element.vertex_count()},
          {"result_vertices", run(with_memory, reusing)},
          {"decisions", decisions(outline, element)}});
  reusing.clear();
  while (ours.size() < 3 || (total < 2 * effort.enough_seconds && ours.size() < 31)) {
    run({}, ours);
    if (peer != nullptr) total += theirs.emplace_back(peer->run(1));
    run(with_memory, reusing);
    if (peer != nullptr) total += theirs.emplace_back(peer->run(1));
  }
  report({{"minksum_alone", summary(ours)}, {"minksum_reusing", summary(reusing)}});
  if (peer == nullptr) return;
  Json members = summary(theirs);
  members["ratio"] = median(theirs) / median(ours);
  members["ratio_reusing"] = median(theirs) / median(reusing);
  members["result_vertices"] = peer->result_vertices();
  report({{"geos", members}});
}

}  // namespace

void measure_outline_offsets(const std::filesystem::path& data, const Effort& effort, bool quick,
                             const std::string& only,
                             const std::function<void(const Json&)>& take) {
  for (const Distance& distance : kDistances) {
    for (const char* outline : kOutlines) {
      if (quick && std::string(outline) != "norway_10m_largest") continue;
      const std::string name = std::string(outline) + ", " + distance.text;
      if (name.find(only) == std::string::npos) continue;
      Json record{{"set", "outlines"}, {"name", name}, {"distance", distance.value}};
      ChildLimits limits;
      limits.seconds_between_reports = 3 * effort.peer_seconds;
      run_part("offset", limits, record, [&](const Report& report) {
        measure_one(data / "gis" / (std::string(outline) + ".wkt"), distance, effort, report);
      });
      take(record);
    }
  }
}

}  // namespace minksum::bench
