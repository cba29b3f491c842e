// Long lists that grow without keeping a cancel token waiting.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "machine/cancellation.hpp"

namespace minksum {

/// Makes room for so many more elements. What a long list holds is moved piece by piece, with looks
/// at the token in between: a vector by itself moves a gigabyte in one step of 0.3 s.
template <class T>
void make_room(std::vector<T>& list, std::size_t more, Cancellation& cancellation) {
  if (list.capacity() - list.size() >= more) return;
  constexpr std::size_t kPiece = (std::size_t{1} << 20) / sizeof(T);  // a megabyte: 0.3 ms
  std::vector<T> larger;
  larger.reserve(std::max(2 * list.size(), list.size() + more));
  for (std::size_t begin = 0; begin < list.size(); begin += kPiece) {
    const std::size_t end = std::min(begin + kPiece, list.size());
    larger.insert(larger.end(), list.begin() + static_cast<std::ptrdiff_t>(begin),
                  list.begin() + static_cast<std::ptrdiff_t>(end));
    cancellation.check(end - begin);
  }
  list.swap(larger);
}

}  // namespace minksum
