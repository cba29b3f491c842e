// Other ways to compute what minksum computes. Each is there only if its library
// was found when the benchmark was configured; otherwise its maker returns null.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "minksum/region.hpp"

namespace minksum::bench {

/// One sum, ready to be computed again and again: operands are in the peer's own form already.
class Peer {
 public:
  Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  virtual ~Peer() = default;
  /// Computes the sum once; returns the wall-clock seconds until the result is there. Its
  /// destruction is not counted.
  virtual double run() = 0;
  /// Vertices of the last result.
  [[nodiscard]] virtual std::size_t result_vertices() const = 0;
  /// Area of the last result, about; for peers that compute something near the sum only.
  [[nodiscard]] virtual double result_area() const { return 0; }
};

/// CGAL's reduced convolution: the exact sum of two single polygons, made from doubles, its fast
/// case. Holes that the other operand cannot fit into are left out beforehand, untimed.
[[nodiscard]] std::unique_ptr<Peer> make_cgal_reduced(const Region& p, const Region& q);
/// CGAL's full convolution (Wein), which the paper compares with: simple polygons only.
[[nodiscard]] std::unique_ptr<Peer> make_cgal_full(const Region& p, const Region& q);
/// Clipper 6: the sum of the two *boundaries*, on integers (coordinates times 10^6, rounded). Less
/// than the sum of the regions: where an operand's interior alone covers, there remain holes.
[[nodiscard]] std::unique_ptr<Peer> make_clipper(const Region& p, const Region& q);
/// GEOS: buffer by a disc with `quadrant_segments` segments a quarter. Not exact, and arcs begin at
/// each edge's own normal: near to the sum with a regular polygon, not equal to it.
[[nodiscard]] std::unique_ptr<Peer> make_geos_buffer(const Region& p, double radius,
                                                     int quadrant_segments);

/// "CGAL 5.5.1", or nothing if it is not there.
[[nodiscard]] std::string cgal_name();
[[nodiscard]] std::string clipper_name();
[[nodiscard]] std::string geos_name();

}  // namespace minksum::bench
