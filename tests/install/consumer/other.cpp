// A second translation unit shows that headers define nothing that may be defined only once.
#include <minksum/minksum.hpp>

minksum::Region make_square(int side) {
  minksum::Region square;
  square.begin_polygon();
  square.begin_ring();
  square.add_vertex(0, 0);
  square.add_vertex(side, 0);
  square.add_vertex(side, side);
  square.add_vertex(0, side);
  return square;
}
