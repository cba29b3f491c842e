#include "reference/scaled.hpp"

#include <algorithm>

#include "reference/canonical.hpp"

namespace minksum::reference {

Scaled scale_up(const Region& p, const Region& q, Loops thin_p, Loops thin_q) {
  Scaled result{directed_and_noded(to_loops(p)),
                directed_and_noded(to_loops(q)),
                std::move(thin_p),
                std::move(thin_q),
                1,
                0};
  const auto for_each_coordinate = [&](auto&& action) {
    for (Loops* loops : {&result.p, &result.q, &result.thin_p, &result.thin_q}) {
      for (Loop& loop : *loops) {
        for (Pt& point : loop) {
          action(point.x);
          action(point.y);
        }
      }
    }
  };
  for_each_coordinate([&](const Number& c) { result.scale = lcm(result.scale, denominator(c)); });
  for_each_coordinate([&](Number& c) {
    c *= result.scale;
    if (c != 0) {
      result.bits = std::max<std::size_t>(result.bits, msb(Integer(abs(numerator(c)))) + 1);
    }
  });
  return result;
}

}  // namespace minksum::reference
