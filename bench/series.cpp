// Measures families of growing size, and doubles against decimals.
#include <algorithm>
#include <cmath>

#include "minksum/io.hpp"
#include "sets.hpp"

namespace minksum::bench {
namespace {

constexpr std::size_t kLargestMember = std::size_t{1} << 18U;

Case member(const Family& family, std::size_t n) {
  Case one;
  one.set = "families";
  one.name = family.name + " " + std::to_string(n);
  one.about = {{"family", family.name}, {"description", family.description}, {"n", n}};
  one.load = [make = family.make, n] { return make(n); };
  return one;
}

double seconds_of(const Json& record, const char* who) {
  return record.contains(who) ? static_cast<double>(record[who]["median"]) : INFINITY;
}

// Returns the region turned by one radian, scaled so that the largest coordinate is `largest`, and
// rounded to integers if `round` is true.
Region turned(const Region& region, double largest, bool round) {
  double extent = 0;
  for (std::size_t v = 0; v < region.vertex_count(); ++v) {
    extent = std::max({extent, std::abs(region.x(v)), std::abs(region.y(v))});
  }
  const double c = std::cos(1.0) * largest / extent;
  const double s = std::sin(1.0) * largest / extent;
  Region result;
  for (const std::size_t polygon : region.polygons()) {
    result.begin_polygon();
    for (const std::size_t ring : region.rings_of(polygon)) {
      result.begin_ring();
      for (const std::size_t v : region.vertices_of(ring)) {
        const double x = c * region.x(v) - s * region.y(v);
        const double y = s * region.x(v) + c * region.y(v);
        if (round) {
          result.add_vertex(Decimal{std::llround(x), -3}, Decimal{std::llround(y), -3});
        } else {
          result.add_vertex(x / 1000, y / 1000);
        }
      }
    }
  }
  return result;
}

Json in_turn(const Operands& decimals, const Operands& doubles, const Effort& effort) {
  MinksumRuns a;
  MinksumRuns b;
  double total = 0;
  for (int i = 0; i < effort.most_runs && (i < 5 || total < 2 * effort.least_seconds); ++i) {
    total += a.run(decimals.first, decimals.second);
    total += b.run(doubles.first, doubles.second);
  }
  Json json;
  json["decimals"] = a.json();
  json["doubles"] = b.json();
  json["decimals"]["bits"] = a.statistics().coordinate_bits;
  json["doubles"]["bits"] = b.statistics().coordinate_bits;
  json["convolution_segments"] = a.statistics().convolution_segments;
  json["ratio"] = static_cast<double>(json["doubles"]["median"]) /
                  static_cast<double>(json["decimals"]["median"]);
  return json;
}

}  // namespace

void measure_families(const Effort& effort, double longest_seconds, const std::string& only,
                      const std::function<void(const Json&)>& take) {
  for (const Family& family : families()) {
    if (family.name.find(only) == std::string::npos) continue;
    double cgal_seconds = 0;
    for (std::size_t n = family.first_size; n <= kLargestMember; n *= 2) {
      Case one = member(family, n);
      // The next size takes CGAL at least four times as long, up to twenty times on thin shapes.
      // The comparison before it takes twice that.
      one.cgal = cgal_seconds < effort.peer_seconds / 100;
      const Json record = measure(one, effort);
      if (record.contains("p") && record["p"]["vertices"] == 0) break;  // no member of this size
      take(record);
      if (one.cgal) cgal_seconds = seconds_of(record, "cgal");
      // A record without seconds failed, and larger sizes would fail as well.
      if (seconds_of(record, "minksum_alone") > longest_seconds) break;
    }
  }
}

void measure_doubles(const std::filesystem::path& data, const Effort& effort, bool quick,
                     const std::function<void(const Json&)>& take) {
  std::vector<std::string> names{"bird", "mammoth", "taiwan", "texas", "lookalike_dog"};
  if (!quick) names.insert(names.end(), {"nazca_monkey", "nazca_heron", "neuron_original"});
  for (std::size_t i = 0; i < names.size(); ++i) {
    for (std::size_t j = i; j < names.size(); ++j) {
      Json record{{"set", "doubles"}, {"name", names[i] + " + " + names[j]}};
      const auto file = [&](std::size_t k) {
        return (data / "paper" / (names[k] + ".wkt")).string();
      };
      run_part("minksum", {}, record, [&](const Report& report) {
        const Region p = io::read_file(file(i));
        const Region q = io::read_file(file(j));
        report(in_turn({turned(p, 999999, true), turned(q, 700000, true)},
                       {turned(p, 999999, false), turned(q, 700000, false)}, effort));
      });
      take(record);
    }
  }
}

}  // namespace minksum::bench
