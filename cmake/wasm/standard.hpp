// Completes the C++20 library of emscripten 3.1.6 by what minksum uses and that library lacks. The
// toolchain file cmake/wasm.cmake includes this header in every file, and no other build sees it.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <functional>
#include <memory>
#include <ranges>

#if !defined(_LIBCPP_VERSION) || _LIBCPP_VERSION >= 14000
#error "remove from cmake/wasm/standard.hpp what this C++ library has by itself"
#endif

namespace std {

/// Looks at a variable that threads share, as the compiler's own functions do.
template <class T>
class atomic_ref {
 public:
  explicit atomic_ref(T& shared) : shared_(&shared) {}
  T load(memory_order order) const { return __atomic_load_n(shared_, static_cast<int>(order)); }
  void store(T value, memory_order order) const {
    __atomic_store_n(shared_, value, static_cast<int>(order));
  }
  bool compare_exchange_strong(T& expected, T value, memory_order order) const {
    return __atomic_compare_exchange_n(shared_, &expected, value, false, static_cast<int>(order),
                                       static_cast<int>(order));
  }

 private:
  T* shared_;
};

template <class To, class From>
[[nodiscard]] constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}

template <class T>
[[nodiscard]] unique_ptr<T> make_unique_for_overwrite() {
  return unique_ptr<T>(new T);
}

namespace ranges {

template <class Test, class Project>
constexpr auto projected_test(Test& test, Project& project) {
  return [&](auto&& a) -> bool { return invoke(test, invoke(project, a)); };
}
template <class Relation, class Project>
constexpr auto projected_relation(Relation& relation, Project& project) {
  return [&](auto&& a, auto&& b) -> bool {
    return invoke(relation, invoke(project, a), invoke(project, b));
  };
}

// Algorithms that test each element of a whole range.
#define MINKSUM_COMPLETE(name)                                            \
  template <class Range, class Test, class Project = std::identity>            \
  constexpr auto name(Range&& range, Test test, Project project = {}) {   \
    return std::name(ranges::begin(range), ranges::end(range),            \
                     ranges::projected_test(test, project));              \
  }
MINKSUM_COMPLETE(all_of)
MINKSUM_COMPLETE(any_of)
MINKSUM_COMPLETE(none_of)
MINKSUM_COMPLETE(count_if)
MINKSUM_COMPLETE(find_if)
#undef MINKSUM_COMPLETE

// Algorithms that order or relate the elements of a whole range.
#define MINKSUM_COMPLETE(name, Relation)                                      \
  template <class Range, class Given = std::Relation<>, class Project = std::identity> \
  constexpr auto name(Range&& range, Given given = {}, Project project = {}) { \
    return std::name(ranges::begin(range), ranges::end(range),                \
                     ranges::projected_relation(given, project));             \
  }
MINKSUM_COMPLETE(sort, less)
MINKSUM_COMPLETE(is_sorted, less)
MINKSUM_COMPLETE(adjacent_find, equal_to)
#undef MINKSUM_COMPLETE

// Algorithms that look for a value in a whole range that is sorted.
template <class Range, class Value, class Less = std::less<>, class Project = std::identity>
constexpr auto lower_bound(Range&& range, const Value& value, Less order = {},
                           Project project = {}) {
  return std::lower_bound(
      ranges::begin(range), ranges::end(range), value,
      [&](auto&& a, const Value& v) -> bool { return invoke(order, invoke(project, a), v); });
}
template <class Range, class Value, class Less = std::less<>, class Project = std::identity>
constexpr auto upper_bound(Range&& range, const Value& value, Less order = {},
                           Project project = {}) {
  return std::upper_bound(
      ranges::begin(range), ranges::end(range), value,
      [&](const Value& v, auto&& a) -> bool { return invoke(order, v, invoke(project, a)); });
}
template <class Range, class Value>
constexpr bool binary_search(Range&& range, const Value& value) {
  return std::binary_search(ranges::begin(range), ranges::end(range), value);
}

template <class Range, class Value>
constexpr auto find(Range&& range, const Value& value) {
  return std::find(ranges::begin(range), ranges::end(range), value);
}
template <class Range>
constexpr void reverse(Range&& range) {
  std::reverse(ranges::begin(range), ranges::end(range));
}
template <class Range, class Output>
constexpr void copy(Range&& range, Output output) {
  std::copy(ranges::begin(range), ranges::end(range), output);
}

// Algorithms of two whole ranges.
template <class First, class Second>
constexpr bool equal(First&& a, Second&& b) {
  return std::equal(ranges::begin(a), ranges::end(a), ranges::begin(b), ranges::end(b));
}
template <class First, class Second>
constexpr bool includes(First&& a, Second&& b) {
  return std::includes(ranges::begin(a), ranges::end(a), ranges::begin(b), ranges::end(b));
}
template <class First, class Second, class Output>
constexpr void set_union(First&& a, Second&& b, Output output) {
  std::set_union(ranges::begin(a), ranges::end(a), ranges::begin(b), ranges::end(b), output);
}
template <class First, class Second, class Output>
constexpr void set_difference(First&& a, Second&& b, Output output) {
  std::set_difference(ranges::begin(a), ranges::end(a), ranges::begin(b), ranges::end(b), output);
}

}  // namespace ranges
}  // namespace std
