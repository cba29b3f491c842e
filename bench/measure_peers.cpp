// Measures minksum and a peer in turn, in one process, on the same operands.
#include "measure.hpp"
#include "peers/peers.hpp"
#ifdef MINKSUM_BENCH_CGAL
#include "oracle/cgal_oracle.hpp"
#endif

namespace minksum::bench {
namespace {

// Returns whether CGAL's sum of the very same operands, with exact numbers, is the same region.
bool equals_cgal([[maybe_unused]] const Region& p, [[maybe_unused]] const Region& q,
                 [[maybe_unused]] const Region& sum) {
#ifdef MINKSUM_BENCH_CGAL
  return oracle::cgal_sum(p, q).sum == sum;
#else
  return false;
#endif
}

// Runs again and again for so many seconds, and at least so often.
template <class Run>
double run_block(double seconds, int runs, const Run& run) {
  double total = 0;
  for (int i = 0; i < runs || total < seconds; ++i) total += run();
  return total;
}

using MakePeer = std::function<std::unique_ptr<Peer>(const Region& p, const Region& q)>;

struct PeerOfCase {
  const char* name;
  double seconds;  ///< for one sum
  std::size_t least_runs;
  MakePeer make;
};

// Alternates blocks of the peer's runs and of minksum's. Blocks are equally long if runs are short
// enough, so that both find memory and processor equally warm. Reports after each pair of blocks.
void run_in_turn(Peer& peer, const PeerOfCase& about, const Region& p, const Region& q,
                 const Effort& effort, const Report& report) {
  MinksumRuns minksum;
  minksum.run(p, q);
  minksum.forget();
  std::vector<double> seconds;
  double total = 0;
  while (total < effort.enough_seconds ||
         (seconds.size() < about.least_runs && total < effort.most_seconds)) {
    total += run_block(effort.block_seconds, 1, [&] {
      seconds.push_back(peer.run(1));
      return seconds.back();
    });
    run_block(effort.block_seconds, 5, [&] { return minksum.run(p, q); });
    Json members = summary(seconds);
    members["minksum"] = minksum.json();
    members["ratio"] =
        static_cast<double>(members["median"]) / static_cast<double>(members["minksum"]["median"]);
    members["result_vertices"] = peer.result_vertices();
    if (peer.result_area() != 0) members["result_area"] = peer.result_area();
    report({{about.name, members}});
  }
}

std::vector<PeerOfCase> peers_of(const Case& one, const Effort& effort, const Json& record) {
  const double cgal_seconds = one.cgal_seconds > 0 ? one.cgal_seconds : effort.peer_seconds;
  const bool single = record["p"]["parts"] == 1 && record["q"]["parts"] == 1;
  const auto quadrangles = static_cast<std::size_t>(record["p"]["vertices"]) *
                           static_cast<std::size_t>(record["q"]["vertices"]);
  std::vector<PeerOfCase> peers;
  // CGAL is timed only if its result was found equal first.
  if (one.cgal && record.contains("equal_to_cgal")) {
    peers.push_back({"cgal", cgal_seconds, 3, make_cgal_reduced});
  }
  if (one.cgal_full && record.contains("equal_to_cgal")) {
    peers.push_back({"cgal_full", effort.full_seconds, 1, make_cgal_full});
  }
  if (one.clipper && single && quadrangles <= effort.most_quadrangles) {
    peers.push_back({"clipper", effort.peer_seconds, 1, make_clipper});
  }
  if (one.geos_radius > 0) {
    peers.push_back({"geos", effort.peer_seconds, 3, [&one](const Region& p, const Region&) {
                       return make_geos_buffer(p, one.geos_radius, 8);
                     }});
  }
  return peers;
}

}  // namespace

void compare_with_cgal(const Case& one, const Effort& effort, Json& record) {
  if ((!one.cgal && !one.cgal_full) || cgal_name().empty()) return;
  if (record["p"]["parts"] != 1 || record["q"]["parts"] != 1) {
    record["failures"]["cgal"] = "takes single polygons only";
    return;
  }
  ChildLimits limits;
  // CGAL's operands are the decimals themselves here, which is slower than doubles.
  limits.seconds_between_reports =
      2 * (one.cgal_seconds > 0 ? one.cgal_seconds : effort.peer_seconds);
  limits.address_space_bytes = one.cgal_bytes;
  run_part("comparison", limits, record, [&](const Report& report) {
    const auto [p, q] = one.load();
    MinksumRuns minksum;
    minksum.run(p, q);
    report({{"equal_to_cgal", equals_cgal(p, q, minksum.sum())}});
  });
}

void add_peers(const Case& one, const Effort& effort, Json& record) {
  for (const PeerOfCase& each : peers_of(one, effort, record)) {
    ChildLimits limits;
    limits.seconds_between_reports = each.seconds;
    limits.address_space_bytes = one.cgal_bytes;
    run_part(each.name, limits, record, [&](const Report& report) {
      const auto [p, q] = one.load();
      const std::unique_ptr<Peer> peer = each.make(p, q);
      if (peer != nullptr) run_in_turn(*peer, each, p, q, effort, report);
    });
  }
}

}  // namespace minksum::bench
