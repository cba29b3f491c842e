// Declares what tells from the nesting of rings which of them are in a wrong place.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "machine/cancellation.hpp"

namespace minksum {

struct OperandRing;

/// What is wrong with a ring's place.
struct Misplacement {
  bool in_other_hole = false;   ///< a hole inside another hole of its polygon
  bool out_of_outer = false;    ///< a hole outside its outer ring
  bool in_other_outer = false;  ///< an outer ring in another polygon, and in no hole of that
};

/// What `find_misplaced_rings` finds, and its memory.
struct RingNesting {
  /// The rings of a polygon that lie around the present ring.
  struct Around {
    bool outer = false;
    std::uint32_t holes = 0;
    [[nodiscard]] bool is_inside() const { return outer && holes == 0; }
  };

  std::vector<Misplacement> misplaced;  ///< by ring

  // -- Memory ------------------------------------------------------------------------------------
  std::vector<Around> polygons;            ///< by polygon
  std::vector<std::uint32_t> first_inner;  ///< by ring, and then the root: where its rings begin
  std::vector<std::uint32_t> inner;
  std::vector<std::uint32_t> next;
};

/// Finds the misplacement of each ring. `parent` has the smallest ring around each, or
/// RingSweep::kNoRing. Takes linear time.
void find_misplaced_rings(std::span<const OperandRing> rings, std::span<const std::uint32_t> parent,
                          Cancellation& cancellation, RingNesting& nesting);

}  // namespace minksum
