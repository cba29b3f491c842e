// Lists values by key, on several threads if that pays.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "machine/team.hpp"

namespace minksum {

/// Calls visit(i, element) for the elements [begin, end) of several lists, of which `list_of(i)`
/// returns one. Indices of elements count through all lists, one list after the other.
template <class ListOf, class Visit>
void visit_range(std::size_t lists, ListOf list_of, std::size_t begin, std::size_t end,
                 Cancellation& cancellation, Visit visit) {
  std::size_t first = 0;
  for (std::size_t i = 0; i < lists && first < end; ++i) {
    const auto& list = list_of(i);
    const std::size_t from = std::clamp(begin, first, first + list.size()) - first;
    const std::size_t to = std::min(end - first, list.size());
    if (from < to) {
      in_pieces(to - from, cancellation, [&](std::size_t piece_begin, std::size_t piece_end) {
        for (std::size_t k = from + piece_begin; k < from + piece_end; ++k) visit(i, list[k]);
      });
    }
    first += list.size();
  }
}

/// Returns into how many slices a counting sort divides its values: one for each thread, unless
/// there are so many keys that the slices' counts would take more memory than the values.
template <class Value>
[[nodiscard]] std::size_t slices_for(std::size_t values, std::size_t keys,
                                     const Cancellation& cancellation) {
  if (tasks_for(values, cancellation) == 1) return 1;
  const std::size_t most = values * sizeof(Value) / (sizeof(std::uint32_t) * (keys + 1));
  return std::clamp<std::size_t>(most, 1, members_of(cancellation));
}

/// Lists the values of several lists by key, as `list_by_key` does. `keyed(i, element)` returns the
/// key and the value of an element of list i. O(values + keys).
///
/// The values are divided into slices. Each slice counts its values for each key. From all counts
/// follows where each slice puts its values, so slices do not wait for one another.
template <class Value, class ListOf, class Keyed>
void share_by_key(std::size_t keys, std::size_t lists, ListOf list_of, Keyed keyed,
                  Cancellation& cancellation, std::vector<std::uint32_t>& begin,
                  std::vector<Value>& values) {
  std::size_t size = 0;
  for (std::size_t i = 0; i < lists; ++i) size += list_of(i).size();
  const std::size_t slices = slices_for<Value>(size, keys, cancellation);
  // The counts of the last slice come first: they become the ends of the keys' values.
  assign_in_pieces(begin, 1 + slices * keys, 0U, cancellation);
  const auto counts_of = [&](std::size_t slice) {
    return begin.data() + 1 + (slices - 1 - slice) * keys;
  };
  const auto visit_slice = [&](std::size_t slice, Cancellation& own, auto visit) {
    visit_range(lists, list_of, begin_of(slice, slices, size), begin_of(slice + 1, slices, size),
                own, visit);
  };
  share(slices, cancellation, [&](std::size_t slice, std::size_t, Cancellation& own) {
    std::uint32_t* const counts = counts_of(slice);
    visit_slice(slice, own,
                [&](std::size_t i, const auto& element) { ++counts[keyed(i, element).first]; });
  });
  std::uint32_t sum = 0;
  in_pieces(keys, cancellation, [&](std::size_t first, std::size_t last) {
    for (std::size_t key = first; key < last; ++key) {
      for (std::size_t slice = 0; slice < slices; ++slice) {
        sum += std::exchange(counts_of(slice)[key], sum);
      }
    }
  });
  resize_in_pieces(values, size, cancellation);
  share(slices, cancellation, [&](std::size_t slice, std::size_t, Cancellation& own) {
    std::uint32_t* const places = counts_of(slice);
    visit_slice(slice, own, [&](std::size_t i, const auto& element) {
      const auto& [key, value] = keyed(i, element);
      values[places[key]++] = value;
    });
  });
  begin.resize(keys + 1);
}

}  // namespace minksum
