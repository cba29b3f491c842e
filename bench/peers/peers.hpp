// Offers other ways to compute what minksum computes. Each exists only if its library was found
// when the benchmark was configured; otherwise its maker returns null.
#pragma once

#include <cstddef>
#include <memory>
#include <string>

#include "minksum/region.hpp"

namespace minksum::bench {

/// One sum, ready to be computed again and again. Operands are in the peer's own form already.
class Peer {
 public:
  Peer() = default;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  virtual ~Peer() = default;
  /// Computes the sum so many times, and returns the processor seconds of all. Destroying results
  /// is not counted.
  virtual double run(std::size_t times) = 0;
  /// Returns the number of vertices of the last result.
  [[nodiscard]] virtual std::size_t result_vertices() const = 0;
  /// Returns about the area of the last result, for peers whose result is only near the sum.
  [[nodiscard]] virtual double result_area() const { return 0; }
};

/// Makes CGAL's reduced convolution, which gives the exact sum of two single polygons. Operands are
/// made from doubles, CGAL's fast case. Holes into which the other operand cannot fit are left out
/// beforehand, untimed.
[[nodiscard]] std::unique_ptr<Peer> make_cgal_reduced(const Region& p, const Region& q);
/// Makes CGAL's full convolution (Wein), with which the paper compares. It takes simple polygons
/// only.
[[nodiscard]] std::unique_ptr<Peer> make_cgal_full(const Region& p, const Region& q);
/// Makes Clipper 6, which sums the two *boundaries* on integers (coordinates times 10^6, rounded).
/// That is less than the sum of the regions: holes remain where only an operand's interior covers.
[[nodiscard]] std::unique_ptr<Peer> make_clipper(const Region& p, const Region& q);
/// Makes GEOS's buffer by a disc with `quadrant_segments` segments a quarter. The result is not
/// exact, and arcs begin at each edge's own normal. So it is near the sum with a regular polygon,
/// but not equal to it.
[[nodiscard]] std::unique_ptr<Peer> make_geos_buffer(const Region& p, double radius,
                                                     int quadrant_segments);

/// Returns a name such as "CGAL 5.5.1", or an empty text if the library is missing.
[[nodiscard]] std::string cgal_name();
[[nodiscard]] std::string clipper_name();
[[nodiscard]] std::string geos_name();

}  // namespace minksum::bench
