// Stands in for peers whose libraries were not found.
#include "peers/peers.hpp"

namespace minksum::bench {

#ifndef MINKSUM_BENCH_CGAL
std::unique_ptr<Peer> make_cgal_reduced(const Region&, const Region&) { return nullptr; }
std::unique_ptr<Peer> make_cgal_full(const Region&, const Region&) { return nullptr; }
std::string cgal_name() { return {}; }
#endif

#ifndef MINKSUM_BENCH_CLIPPER
std::unique_ptr<Peer> make_clipper(const Region&, const Region&) { return nullptr; }
std::string clipper_name() { return {}; }
#endif

#ifndef MINKSUM_BENCH_GEOS
std::unique_ptr<Peer> make_geos_buffer(const Region&, double, int) { return nullptr; }
std::string geos_name() { return {}; }
#endif

}  // namespace minksum::bench
