// Lets the members of a team mark cells of one bitmap.
#pragma once

#include <utility>
#include <vector>

#include "machine/team.hpp"
#include "sum/cover/bitmap.hpp"

namespace minksum {

/// A helper's bitmap.
struct HelperBitmap {
  Bitmap bitmap;
  bool used = false;               ///< whether it was cleared since the last `MemberBitmaps`
  std::vector<std::uint64_t> row;  ///< a row of cells, for the work itself
};

/// The calling thread marks cells of the whole bitmap, and each helper those of its own.
class MemberBitmaps {
 public:
  MemberBitmaps(const Cancellation& cancellation, std::vector<HelperBitmap>& helpers, Bitmap& whole)
      : helpers_(helpers), whole_(whole) {
    helpers.resize(std::max(helpers.size(), members_of(cancellation) - 1));
    for (HelperBitmap& helper : helpers) helper.used = false;
  }
  /// Returns the bitmap that this member marks.
  [[nodiscard]] Bitmap& of(std::size_t member) const {
    if (member == 0) return whole_;
    HelperBitmap& helper = helpers_[member - 1];
    if (!std::exchange(helper.used, true)) {
      helper.bitmap.reset(whole_.columns(), whole_.rows(), whole_.words_per_row());
    }
    return helper.bitmap;
  }
  /// Marks in the whole what all members have marked.
  void unite() {
    for (const HelperBitmap& helper : helpers_) {
      if (!helper.used) continue;
      for (std::size_t w = 0; w < whole_.words().size(); ++w) {
        whole_.words()[w] |= helper.bitmap.words()[w];
      }
    }
  }

 private:
  std::vector<HelperBitmap>& helpers_;
  Bitmap& whole_;
};

}  // namespace minksum
