#include "sets.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <stdexcept>

#include "minksum/io.hpp"
#include "support/data.hpp"
#include "support/random.hpp"

namespace minksum::bench {
namespace {

using std::filesystem::path;

struct Model {
  const char* name;
  const char* file;
};
// The eleven models of the paper's Fig. 5, with 24 to 1,204 vertices, and that of its Fig. 1. Eight
// of the authors' files were not to be had, and stand-ins with as many vertices take their places.
constexpr Model kPaperModels[] = {
    {"g1", "lookalike_g1"},
    {"g2", "lookalike_g2"},
    {"g3", "lookalike_g3"},
    {"g4", "lookalike_g4"},
    {"airplane", "lookalike_airplane"},
    {"dog", "lookalike_dog"},
    {"hand1", "lookalike_hand1"},
    {"hand2", "lookalike_hand2"},
    {"bird", "bird"},
    {"mammoth", "mammoth"},
    {"monkey", "nazca_monkey"},
    {"neuron", "neuron_original"},
};
// Further real models of the same authors.
constexpr Model kKin[] = {{"heron", "nazca_heron"}, {"taiwan", "taiwan"}, {"texas", "texas"}};

std::string paper_file(const path& data, const Model& model) {
  return data / "paper" / (std::string(model.file) + ".wkt");
}

Case pair_of_files(std::string set, std::string name, std::string p, std::string q) {
  Case one;
  one.set = std::move(set);
  one.name = std::move(name);
  one.load = [p = std::move(p), q = std::move(q)] {
    return Operands{io::read_file(p), io::read_file(q)};
  };
  return one;
}

Case pair_of_models(const std::string& set, const path& data, const Model& p, const Model& q) {
  Case one = pair_of_files(set, std::string(p.name) + " + " + q.name, paper_file(data, p),
                           paper_file(data, q));
  one.about = {{"p_name", p.name}, {"q_name", q.name}};
  one.count_no_cover = true;
  one.clipper = true;
  return one;
}

std::vector<Case> paper_cases(const path& data, bool quick) {
  std::vector<Case> cases;
  for (auto p = std::begin(kPaperModels); p != std::end(kPaperModels); ++p) {
    for (auto q = p; q != std::end(kPaperModels); ++q) {
      const bool in_short = p == q && p - std::begin(kPaperModels) >= 5;
      if (!quick || in_short) cases.push_back(pair_of_models("paper", data, *p, *q));
    }
  }
  return cases;
}

std::vector<Case> kin_cases(const path& data, bool quick) {
  std::vector<Case> cases;
  if (quick) return cases;
  for (const Model& p : kKin) {
    for (const Model& q : kPaperModels) cases.push_back(pair_of_models("kin", data, p, q));
    for (const Model& q : kKin) {
      if (&q >= &p) cases.push_back(pair_of_models("kin", data, p, q));
    }
  }
  return cases;
}

// Returns the pairs of Fig. 6 and 7b, for the full convolution by CGAL and by us. Neuron is left
// out, because CGAL's function takes no holes.
std::vector<Case> figure_cases(const path& data, bool quick) {
  std::vector<Case> cases;
  const auto models = std::end(kPaperModels) - 1;
  for (auto p = std::begin(kPaperModels); p != models; ++p) {
    for (auto q = p; q != models; ++q) {
      if (quick && (p != q || p - std::begin(kPaperModels) > 3)) continue;
      Case one = pair_of_models("figures", data, *p, *q);
      one.cgal = one.clipper = false;
      one.cgal_full = one.count_full = true;
      cases.push_back(std::move(one));
    }
  }
  return cases;
}

// Returns pairs that are known by name.
std::vector<Case> named_cases(const path& data, bool quick) {
  const auto file = [&](const char* name) { return (data / "paper" / name).string() + ".wkt"; };
  std::vector<Case> cases;
  Case fig1;
  fig1.set = "named";
  fig1.name = "neuron + 32-gon";
  fig1.load = [neuron = file("neuron_original")] {
    return Operands{io::read_file(neuron), regular_polygon(32, 0.3)};
  };
  cases.push_back(std::move(fig1));
  cases.push_back(pair_of_files("named", "wierd2 + wierd2_n", file("wierd2"), file("wierd2_n")));
  cases.push_back(
      pair_of_files("named", "monkey + simple7", file("nazca_monkey"), file("simple7")));
  if (quick) return cases;
  Case star5 = pair_of_files("named", "star5 + star5", file("star5"), file("star5"));
  star5.cgal_seconds = 180;  // CGAL takes about 45
  cases.push_back(std::move(star5));
  cases.push_back(
      pair_of_files("named", "star4 + star4_noise", file("star4"), file("star4_noise")));
  Case large = pair_of_files("named", "heron_original_2 + monkey_original_2",
                             file("nazca_heron_original_2"), file("nazca_monkey_original_2"));
  large.cgal = false;  // CGAL does not end within two minutes
  cases.push_back(std::move(large));
  Case star6 = pair_of_files("named", "star6 + star6", file("star6"), file("star6"));
  star6.cgal = false;
  cases.push_back(std::move(star6));
  return cases;
}

std::vector<Case> spiky_cases(const path& data, bool quick) {
  std::vector<Case> cases;
  for (const int n : {50, 100, 200, 400, 800, 1600}) {
    if (quick && n > 100) break;
    const std::string stem = data / "hard" / ("spiky_" + std::to_string(n));
    Case one = pair_of_files("spiky", "spiky " + std::to_string(n), stem + "a.wkt", stem + "b.wkt");
    one.about = {{"n", n}};
    one.cgal = n <= 200;
    // CGAL takes more than a minute and 7 GB for the pair of 200.
    if (n == 200) {
      one.cgal_seconds = 240;
      one.cgal_bytes = std::size_t{16} << 30U;
    }
    one.count_no_cover = n <= 200;
    cases.push_back(std::move(one));
  }
  return cases;
}

std::string stem(const std::string& file) { return path(file).stem().string(); }

// Returns pairs P + -Q of parts of 10 to 100 vertices, whose sums are their no-fit polygons.
std::vector<Case> nesting_cases(const path& data, bool quick) {
  const std::vector<std::string> files = nesting_parts(data, 10, 100);
  if (files.empty()) return {};
  test::Random random(2011);
  const std::size_t count = quick ? 10 : 60;
  std::set<std::pair<std::size_t, std::size_t>> chosen;
  std::vector<Case> cases;
  for (std::size_t tries = 0; cases.size() < count && tries < 10 * count; ++tries) {
    const std::size_t i = random.next() % files.size();
    // Every sixth pair is P + -P.
    const std::size_t j = cases.size() % 6 == 0 ? i : random.next() % files.size();
    if (!chosen.insert({i, j}).second) continue;
    Case one;
    one.set = "nesting";
    one.name = stem(files[i]) + " + -" + stem(files[j]);
    one.load = [p = (data / files[i]).string(), q = (data / files[j]).string()] {
      return Operands{io::read_file(p), negated(io::read_file(q))};
    };
    one.clipper = true;
    cases.push_back(std::move(one));
  }
  return cases;
}

// Returns outlines in degrees; a degree along a meridian is 111.32 km.
std::vector<Case> gis_cases(const path& data, bool quick) {
  constexpr double kDegreesPerKilometre = 1 / 111.32;
  constexpr const char* kOutlines[] = {"gis/canada_10m", "cgal/norway", "gis/indonesia_10m",
                                       "gis/norway_10m", "gis/chile_10m"};
  std::vector<Case> cases;
  for (const char* outline : kOutlines) {
    if (quick && std::string(outline) != "cgal/norway") continue;
    for (const double kilometres : {1.0, 10.0, 100.0}) {
      if (quick && kilometres > 1) break;
      Case one;
      one.set = "gis";
      one.name = stem(outline) + " + 32-gon, " + std::to_string(std::lround(kilometres)) + " km";
      const double radius = kilometres * kDegreesPerKilometre;
      one.load = [file = (data / outline).string() + ".wkt", radius] {
        return Operands{io::read_file(file), regular_polygon(32, radius)};
      };
      one.about = {{"outline", stem(outline)}, {"kilometres", kilometres}};
      one.geos_radius = radius;
      one.cgal = std::string(outline) == "cgal/norway";
      cases.push_back(std::move(one));
    }
  }
  return cases;
}

}  // namespace

std::vector<std::string> nesting_parts(const path& data, std::size_t least, std::size_t most) {
  std::vector<std::string> files;
  for (const auto& file : test::read_manifest(data)) {
    if (file.name.starts_with("nesting/") && file.is_valid && file.parts == 1 && file.holes == 0 &&
        file.vertices >= least && file.vertices <= most) {
      files.push_back(file.name);
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<std::string> set_names() {
  return {"paper", "kin",      "named",   "figures",  "spiky",  "nesting", "tables",
          "gis",   "outlines", "doubles", "families", "regret", "mixed",   "threads"};
}

std::vector<Case> cases_of(const std::string& set, const path& data, bool quick) {
  if (set == "paper") return paper_cases(data, quick);
  if (set == "kin") return kin_cases(data, quick);
  if (set == "figures") return figure_cases(data, quick);
  if (set == "named") return named_cases(data, quick);
  if (set == "spiky") return spiky_cases(data, quick);
  if (set == "nesting") return nesting_cases(data, quick);
  if (set == "gis") return gis_cases(data, quick);
  throw std::runtime_error("no set named " + set);
}

}  // namespace minksum::bench
