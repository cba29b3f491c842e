// minksum and a peer in turn, in one process, on the same operands.
#include <algorithm>
#include <cmath>

#include "measure.hpp"
#include "peers/peers.hpp"
#ifdef MINKSUM_BENCH_CGAL
#include "oracle/cgal_oracle.hpp"
#endif

namespace minksum::bench {
namespace {

// CGAL's sum of the very same operands, all numbers exact, must be the same region.
bool equals_cgal([[maybe_unused]] const Region& p, [[maybe_unused]] const Region& q,
                 [[maybe_unused]] const Region& sum) {
#ifdef MINKSUM_BENCH_CGAL
  return oracle::cgal_sum(p, q).sum == sum;
#else
  return false;
#endif
}

// A peer's run, then a few of minksum, and again. Reports after each round.
void run_in_turn(Peer& peer, const char* name, const Region& p, const Region& q,
                 const Effort& effort, const Report& report) {
  MinksumRuns minksum;
  const double first = minksum.run(p, q);
  minksum.forget();
  const int each = std::clamp(static_cast<int>(std::lround(0.02 / first)), 3, 50);
  std::vector<double> seconds;
  double total = 0;
  while (seconds.size() < 200 && total < effort.least_peer_seconds &&
         !(seconds.size() >= static_cast<std::size_t>(effort.least_peer_runs) &&
           total >= effort.least_seconds)) {
    seconds.push_back(peer.run());
    total += seconds.back();
    for (int i = 0; i < each; ++i) minksum.run(p, q);
    Json members = summary(seconds);
    members["minksum"] = minksum.json();
    members["ratio"] = static_cast<double>(members["median"]) /
                       static_cast<double>(members["minksum"]["median"]);
    members["result_vertices"] = peer.result_vertices();
    if (peer.result_area() != 0) members["result_area"] = peer.result_area();
    report({{name, members}});
  }
}

void measure_cgal(const Case& one, const Effort& effort, const Report& report) {
  const auto [p, q] = one.load();
  const std::unique_ptr<Peer> peer = make_cgal_reduced(p, q);
  if (peer == nullptr) return;
  MinksumRuns minksum;
  minksum.run(p, q);
  const bool equal = equals_cgal(p, q, minksum.sum());
  report({{"equal_to_cgal", equal}});
  if (equal) run_in_turn(*peer, "cgal", p, q, effort, report);
}

void measure_peer(const Case& one, const char* name, const Effort& effort, const Report& report) {
  const auto [p, q] = one.load();
  const std::string which = name;
  const std::unique_ptr<Peer> peer =
      which == "cgal_full" ? make_cgal_full(p, q)
      : which == "clipper" ? make_clipper(p, q)
                           : make_geos_buffer(p, one.geos_radius, 8);
  if (peer != nullptr) run_in_turn(*peer, name, p, q, effort, report);
}

}  // namespace

void add_peers(const Case& one, const Effort& effort, Json& record) {
  const auto add = [&](const char* name, double seconds, const Effort& how, auto work) {
    ChildLimits limits;
    limits.seconds_between_reports = seconds;
    limits.address_space_bytes = one.cgal_bytes;
    ChildEnd end = run_in_child(
        limits, [&](const Report& report) { work(one, name, how, report); });
    record.update(end.members);
    if (end.status != "ok") record["failures"][name] = end.status;
  };
  const bool single = record["p"]["parts"] == 1 && record["q"]["parts"] == 1;
  if (one.cgal && !single) record["failures"]["cgal"] = "takes single polygons only";
  if (one.cgal && single && !cgal_name().empty()) {
    add("cgal", one.cgal_seconds > 0 ? one.cgal_seconds : effort.peer_seconds, effort,
        [](const Case& c, const char*, const Effort& e, const Report& r) {
          measure_cgal(c, e, r);
        });
  }
  // What is slower than CGAL's reduced convolution by far needs no repeats to tell.
  Effort once = effort;
  once.least_peer_runs = 1;
  once.least_peer_seconds = 0.3;
  if (one.cgal_full && single) add("cgal_full", effort.peer_seconds, once, measure_peer);
  const auto quadrangles = static_cast<std::size_t>(record["p"]["vertices"]) *
                           static_cast<std::size_t>(record["q"]["vertices"]);
  if (one.clipper && single && quadrangles <= effort.most_quadrangles) {
    add("clipper", effort.peer_seconds, once, measure_peer);
  }
  if (one.geos_radius > 0) add("geos", effort.peer_seconds, effort, measure_peer);
}

}  // namespace minksum::bench
