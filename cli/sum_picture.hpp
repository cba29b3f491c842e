// The picture of a sum: operands on the left, the sum on the right, all to one scale.
#pragma once

#include <string>

#include "minksum/region.hpp"

namespace minksum::cli {

/// Draws P, Q and P ⊕ Q. Throws Error(kLimitExceeded) if doubles cannot hold the picture.
[[nodiscard]] std::string sum_picture(const Region& p, const Region& q, const Region& sum);

/// The operands alone.
[[nodiscard]] std::string operands_picture(const Region& p, const Region& q);

/// "1,815 vertices, 18 holes", "3 parts, ...".
[[nodiscard]] std::string summary(const Region& region);

/// 1234567 as "1,234,567".
[[nodiscard]] std::string grouped(std::uint64_t number);

}  // namespace minksum::cli
