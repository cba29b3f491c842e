// minksum_work computes one sum whose work is counted. It runs alone for what the library counts
// itself, and under callgrind, which counts the instructions inside `counted_sum`.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <functional>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "families.hpp"
#include "minksum/minkowski_sum.hpp"
#include "support/data.hpp"
#if __has_include("minksum/prepared_region.hpp")  // earlier revisions lack this header
#include "minksum/prepared_region.hpp"
#define MINKSUM_WORK_PREPARED 1
#endif
#if __has_include("minksum/testing.hpp")  // earlier revisions fill statistics through a pointer
#include "minksum/testing.hpp"
#define MINKSUM_WORK_DETAILED 1
#endif

namespace {

std::uint64_t allocations = 0;

}  // namespace

void* operator new(std::size_t size) {
  ++allocations;
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

// Callgrind counts inside functions of these names, so they must never be inlined.
extern "C" __attribute__((noinline)) bool counted_sum(const minksum::Region& p,
                                                      const minksum::Region& q,
                                                      const minksum::Options& options,
                                                      minksum::Workspace& workspace,
                                                      minksum::Region& sum) {
  return minkowski_sum(p, q, options, workspace, sum).ok();
}

#ifdef MINKSUM_WORK_PREPARED
extern "C" __attribute__((noinline)) bool counted_sum_prepared(const minksum::PreparedRegion& p,
                                                               const minksum::PreparedRegion& q,
                                                               const minksum::Options& options,
                                                               minksum::Workspace& workspace,
                                                               minksum::Region& sum) {
  return minkowski_sum(p, q, options, workspace, sum).ok();
}
#endif

namespace {

using namespace minksum;
using bench::Operands;

struct Member {
  const char* family;
  std::size_t size;
};
constexpr Member kMembers[] = {
    {"spiky stars", 64},
    {"combs", 128},
    {"spirals", 256},
    {"random simple polygons", 16},
    {"random simple polygons", 256},
    {"orthogonal outlines", 128},
    {"many holes", 320},
    {"dense circles", 128},
    {"convex + convex", 1024},
    {"region + small convex", 1024},
    {"P + -P", 128},
};

// Files of the folder of shapes. Without a second file, Q is a 32-gon of that radius.
struct Files {
  const char* p;
  const char* q;
  double radius;
};
constexpr Files kFiles[] = {
    {"paper/lookalike_g1", "paper/lookalike_g1", 0},
    {"paper/bird", "paper/bird", 0},
    {"paper/bird", "paper/mammoth", 0},
    {"paper/nazca_monkey", "paper/nazca_monkey", 0},
    {"paper/neuron_original", nullptr, 0.3},
    {"paper/neuron_original", "paper/neuron_original", 0},
    {"paper/wierd2", "paper/wierd2_n", 0},
    {"paper/star5", "paper/star5", 0},
    {"paper/nazca_heron_original_2", "paper/nazca_monkey_original_2", 0},
    {"hard/spiky_100a", "hard/spiky_100b", 0},
    {"nesting/albano_0", "nesting/albano_4", 0},
    {"nesting/swim_0", "nesting/swim_6", 0},
    {"cgal/norway", nullptr, 0.01},
};

struct Work {
  std::string name;
  std::function<Operands()> load;
  bool prepared = false;
};

// Returns a region with its coordinates divided by three, which gives doubles with all their bits.
Region with_all_bits(const Region& region) {
  Region result;
  for (const std::size_t polygon : region.polygons()) {
    result.begin_polygon();
    for (const std::size_t ring : region.rings_of(polygon)) {
      result.begin_ring();
      for (const std::size_t v : region.vertices_of(ring)) {
        result.add_vertex(region.x(v) / 3, region.y(v) / 3);
      }
    }
  }
  return result;
}

std::vector<Work> all_work() {
  std::vector<Work> all;
  for (const Member& member : kMembers) {
    for (const bench::Family& family : bench::families()) {
      if (family.name != member.family) continue;
      all.push_back({family.name + " " + std::to_string(member.size),
                     [make = family.make, n = member.size] { return make(n); }});
    }
  }
  all.push_back({"doubles: " + all[4].name, [load = all[4].load] {
                   const Operands operands = load();
                   return Operands{with_all_bits(operands.first), with_all_bits(operands.second)};
                 }});
#ifdef MINKSUM_WORK_PREPARED
  for (const std::size_t i : {3U, 4U}) {
    all.push_back({"prepared: " + all[i].name, all[i].load, true});
  }
#endif
  const auto data = test::data_path();
  if (!data) return all;
  for (const Files& files : kFiles) {
    const auto p = *data / (std::string(files.p) + ".wkt");
    const std::string other = files.q == nullptr ? "32-gon" : files.q;
    const auto q = *data / (other + ".wkt");
    if (!exists(p) || (files.q != nullptr && !exists(q))) continue;
    const auto load = [p, q, files] {
      Region second =
          files.q == nullptr ? bench::regular_polygon(32, files.radius) : test::read_wkt(q);
      return Operands{test::read_wkt(p), std::move(second)};
    };
    all.push_back({p.stem().string() + " + " + q.stem().string(), load});
  }
  return all;
}

// Returns FNV-1a of the exact result, on which two revisions must agree.
std::uint64_t fingerprint(const Region& sum) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  const auto add = [&](const std::string& text) {
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3U;
  };
  for (std::size_t ring = 0; ring < sum.ring_count(); ++ring) {
    add("/");
    for (const std::size_t v : sum.vertices_of(ring)) {
      add(sum.exact_x(v).to_string() + " " + sum.exact_y(v).to_string() + ",");
    }
  }
  return hash;
}

// Sums twice, because the first sum fills the memory that later ones reuse. Returns the allocations
// of the second sum.
std::uint64_t sum_twice(const Work& work, const Options& options, Region& sum) {
  const auto [p, q] = work.load();
  Workspace workspace;
  bool ok = false;
  std::uint64_t before = 0;
  if (!work.prepared) {
    ok = minkowski_sum(p, q, options, workspace, sum).ok();
    before = allocations;
    ok = ok && counted_sum(p, q, options, workspace, sum);
  } else {
#ifdef MINKSUM_WORK_PREPARED
    const PreparedRegion prepared_p(p);
    const PreparedRegion prepared_q(q);
    ok = minkowski_sum(prepared_p, prepared_q, options, workspace, sum).ok();
    before = allocations;
    ok = ok && counted_sum_prepared(prepared_p, prepared_q, options, workspace, sum);
#endif
  }
  if (!ok) throw std::runtime_error("no sum");
  return allocations - before;
}

// The counts are those of the stages, also where operands are small.
Statistics statistics_of(const Work& work) {
  const auto [p, q] = work.load();
#ifdef MINKSUM_WORK_DETAILED
  SumSettings by_stages;
  by_stages.small = false;
  return detailed_sum(p, q, by_stages).statistics;
#else
  Statistics statistics;
  Options options;
  options.statistics = &statistics;
  static_cast<void>(minkowski_sum(p, q, options));
  return statistics;
#endif
}

void work_on(const Work& work, bool tell) {
  Region sum;
  const std::uint64_t allocated = sum_twice(work, {}, sum);
  if (!tell) return;
  const Statistics statistics = statistics_of(work);
  const auto print = [](const char* name, std::uint64_t value) {
    std::printf("%s %llu\n", name, static_cast<unsigned long long>(value));
  };
  print("by_filter", statistics.by_filter);
  print("exactly", statistics.by_fixed_width + statistics.by_arbitrary);
  print("crossings", statistics.crossings);
  print("allocations", allocated);
  print("fingerprint", fingerprint(sum));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const std::string wanted = words.empty() ? "" : words[0];
    for (const Work& work : all_work()) {
      if (words.empty()) std::printf("%s\n", work.name.c_str());
      if (work.name == wanted) work_on(work, words.size() == 1);
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "minksum_work: %s\n", error.what());
    return 1;
  }
}
