// CGAL's reduced convolution as a peer to measure against.
#pragma once

#include <memory>

#include "minksum/region.hpp"

namespace minksum::bench {

/// Operands in CGAL's own form, made from doubles: its fast case.
class CgalPeer {
 public:
  /// Two simple polygons without holes.
  CgalPeer(const Region& p, const Region& q);
  ~CgalPeer();
  /// One sum; returns the wall-clock seconds of the call alone, its result's destruction included
  /// (that is where the lazy kernel pays).
  double run();

 private:
  struct Polygons;
  std::unique_ptr<Polygons> polygons_;
};

}  // namespace minksum::bench
