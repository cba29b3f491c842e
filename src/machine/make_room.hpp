// Grows, fills and visits long lists without keeping a cancel token waiting.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <vector>

#include "machine/cancellation.hpp"

namespace minksum {

/// Elements that are handled at once, in some ten microseconds.
inline constexpr std::size_t kPiece = std::size_t{1} << 12;

/// Calls work(begin, end) for the indices below `size`, piece by piece, and looks at the token in
/// between. Use this where the work of one element is too little to count.
template <class Work>
void in_pieces(std::size_t size, Cancellation& cancellation, Work work) {
  for (std::size_t begin = 0; begin < size; begin += kPiece) {
    const std::size_t end = std::min(begin + kPiece, size);
    cancellation.check(end - begin);
    work(begin, end);
  }
}
/// Calls visit(element) for all elements of a long list.
template <class List, class Visit>
void visit_in_pieces(List&& list, Cancellation& cancellation, Visit visit) {
  in_pieces(list.size(), cancellation, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) visit(list[i]);
  });
}

/// Moves a list to where it has room for `more` elements, piece by piece. A vector by itself would
/// move a gigabyte in one step of 0.3 s.
template <class T>
[[gnu::noinline]] void move_to_larger(std::vector<T>& list, std::size_t more,
                                      Cancellation& cancellation) {
  std::vector<T> larger;
  larger.reserve(std::max(2 * list.size(), list.size() + more));
  in_pieces(list.size(), cancellation, [&](std::size_t begin, std::size_t end) {
    const auto at = [&](std::size_t i) { return list.begin() + static_cast<std::ptrdiff_t>(i); };
    larger.insert(larger.end(), std::move_iterator(at(begin)), std::move_iterator(at(end)));
  });
  list.swap(larger);
}
/// Makes room for `more` elements.
template <class T>
void make_room(std::vector<T>& list, std::size_t more, Cancellation& cancellation) {
  if (list.capacity() - list.size() < more) move_to_larger(list, more, cancellation);
}
/// Does what `push_back` does. Where there is room it asks nothing that `push_back` does not ask.
template <class T>
[[gnu::always_inline]] inline void append(std::vector<T>& list, const T& value,
                                          Cancellation& cancellation) {
  if (list.size() == list.capacity()) [[unlikely]] {
    move_to_larger(list, 1, cancellation);
  }
  list.push_back(value);
}
/// Resizes piece by piece. Stays out of line, because short lists are resized more often.
template <class T, class... Value>
[[gnu::noinline]] void resize_long(std::vector<T>& list, std::size_t size,
                                   Cancellation& cancellation, const Value&... value) {
  if (size > list.size()) make_room(list, size - list.size(), cancellation);
  while (list.size() + kPiece < size) {
    cancellation.check(kPiece);
    list.resize(list.size() + kPiece, value...);
  }
  list.resize(size, value...);
}
// Lists of these are in most files. So they are compiled once.
extern template void move_to_larger(std::vector<std::uint8_t>&, std::size_t, Cancellation&);
extern template void move_to_larger(std::vector<std::uint32_t>&, std::size_t, Cancellation&);
extern template void resize_long(std::vector<std::uint8_t>&, std::size_t, Cancellation&,
                                 const std::uint8_t&);
extern template void resize_long(std::vector<std::uint32_t>&, std::size_t, Cancellation&);
extern template void resize_long(std::vector<std::uint32_t>&, std::size_t, Cancellation&,
                                 const std::uint32_t&);
/// Does what `resize` does. New elements get the given value, if there is one.
template <class T, class... Value>
void resize_in_pieces(std::vector<T>& list, std::size_t size, Cancellation& cancellation,
                      const Value&... value) {
  if (size <= std::max(kPiece, list.capacity()) && size <= list.size() + kPiece) {
    list.resize(size, value...);
  } else {
    resize_long(list, size, cancellation, value...);
  }
}
/// Does what `assign` does.
template <class T>
void assign_in_pieces(std::vector<T>& list, std::size_t size, const T& value,
                      Cancellation& cancellation) {
  if (size <= kPiece) return list.assign(size, value);
  list.clear();
  resize_in_pieces(list, size, cancellation, value);
}

/// Sorts a list, and leaves one of equal elements.
template <class T>
void sort_unique(std::vector<T>& list, Cancellation& cancellation) {
  std::sort(list.begin(), list.end(), cancellation.counting(std::less<>()));
  const auto same = cancellation.counting(std::equal_to<>());
  list.erase(std::unique(list.begin(), list.end(), same), list.end());
}

/// Lists values by key. for_each(visit) calls visit(key, value) for each of them, counts its work,
/// and is called twice. The values of a key, in their order, begin at begin[key] and end where
/// those of the next key begin.
template <class Value, class ForEach>
void list_by_key(std::size_t keys, Cancellation& cancellation, std::vector<std::uint32_t>& begin,
                 std::vector<Value>& values, ForEach for_each) {
  assign_in_pieces(begin, keys + 2, 0U, cancellation);
  for_each([&](std::size_t key, const Value&) { ++begin[key + 2]; });
  std::uint32_t sum = 0;
  visit_in_pieces(begin, cancellation, [&](std::uint32_t& count) { count = sum += count; });
  resize_in_pieces(values, sum, cancellation);
  for_each([&](std::size_t key, const Value& value) { values[begin[key + 1]++] = value; });
  begin.pop_back();
}

/// Does what `clear` does, for elements that hold memory. A vector by itself would free that of a
/// million points in one step of 0.1 s.
template <class T>
void clear_in_pieces(std::vector<T>& list, Cancellation& cancellation) {
  const auto count = [&](std::size_t size) { cancellation.check(4 * size + 1); };
  for (; list.size() > kPiece; list.resize(list.size() - kPiece)) count(kPiece);
  count(list.size());
  list.clear();
}

/// Sorts a list. The order must tell any two different elements apart, so that every way of sorting
/// gives the same result. A comparison must be cheap: a unit of work or two.
template <class Iterator, class Less>
void sort_in_pieces(Iterator first, Iterator last, Cancellation& cancellation, Less less) {
  constexpr std::ptrdiff_t kAtOnce = 1 << 15;  // std::sort takes some five milliseconds for these
  const auto log = [](std::ptrdiff_t n) {
    return static_cast<int>(std::bit_width(static_cast<std::size_t>(n)));
  };
  // If so many partitions leave a long part, they are bad, and std::sort copes better.
  for (int parts = 2 * log(last - first); last - first > kAtOnce; --parts) {
    if (parts == 0) return std::sort(first, last, cancellation.counting(less));
    const auto at = [&](std::ptrdiff_t i) { return first[i]; };
    const auto a = at(0);
    const auto b = at((last - first) / 2);
    const auto c = at(last - first - 1);
    const auto pivot =
        std::max(std::min(a, b, less), std::min(std::max(a, b, less), c, less), less);
    const Iterator middle = std::partition(first, last, [&](const auto& element) {
      cancellation.check();
      return less(element, pivot);
    });
    if (middle - first < last - middle) {
      sort_in_pieces(first, middle, cancellation, less);
      first = middle;
    } else {
      sort_in_pieces(middle, last, cancellation, less);
      last = middle;
    }
  }
  cancellation.check(static_cast<std::uint64_t>(last - first) *
                     static_cast<std::uint64_t>(log(last - first)));
  std::sort(first, last, less);
}

}  // namespace minksum
