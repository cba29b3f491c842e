// A long list is sorted as std::sort sorts it, and a token stops the sort.
#include "machine/make_room.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace minksum {
namespace {

constexpr std::size_t kMany = 200'000;  // several parts

std::vector<std::uint32_t> make(const std::string& kind) {
  std::vector<std::uint32_t> list(kMany);
  std::mt19937 random(7);
  for (std::size_t i = 0; i < kMany; ++i) list[i] = static_cast<std::uint32_t>(i);
  if (kind == "backwards") std::reverse(list.begin(), list.end());
  if (kind == "shuffled") std::shuffle(list.begin(), list.end(), random);
  if (kind == "up and down") std::reverse(list.begin() + kMany / 2, list.end());
  if (kind == "few values") {
    for (std::uint32_t& value : list) value = static_cast<std::uint32_t>(random() % 3);
  }
  if (kind == "equal") std::fill(list.begin(), list.end(), 1);
  return list;
}

TEST(SortInPieces, SortsAsTheStandardLibraryDoes) {
  for (const char* kind :
       {"sorted", "backwards", "shuffled", "up and down", "few values", "equal"}) {
    std::vector<std::uint32_t> list = make(kind);
    std::vector<std::uint32_t> expected = list;
    Cancellation cancellation;
    sort_in_pieces(list.begin(), list.end(), cancellation, std::less<>());
    std::sort(expected.begin(), expected.end());
    EXPECT_EQ(list, expected) << kind;
  }
}

TEST(SortInPieces, LooksAtTheToken) {
  for (const char* kind : {"sorted", "shuffled", "equal"}) {
    std::vector<std::uint32_t> list = make(kind);
    int asked = 0;  // the first time is before sorting begins
    const Options options{.cancel = CancelToken::polling([&] { return ++asked > 1; })};
    Cancellation cancellation(options);
    EXPECT_THROW(sort_in_pieces(list.begin(), list.end(), cancellation, std::less<>()), Error)
        << kind;
  }
}

}  // namespace
}  // namespace minksum
