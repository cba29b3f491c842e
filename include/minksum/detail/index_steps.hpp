// Steps of iterators, and ranges of what is made for each index. This is no part of the interface.
#pragma once

#include <compare>
#include <cstddef>
#include <type_traits>

namespace minksum::detail {

/// The steps of an iterator that knows its place by an index, and returns values.
template <class Iterator>
class IndexSteps {
 public:
  using difference_type = std::ptrdiff_t;
  Iterator& operator++() { return *this += 1; }
  Iterator& operator--() { return *this -= 1; }
  Iterator operator++(int) {
    const Iterator before = self();
    ++index_;
    return before;
  }
  Iterator operator--(int) {
    const Iterator before = self();
    --index_;
    return before;
  }
  Iterator& operator+=(difference_type n) {
    index_ += static_cast<std::size_t>(n);
    return static_cast<Iterator&>(*this);
  }
  Iterator& operator-=(difference_type n) {
    index_ -= static_cast<std::size_t>(n);
    return static_cast<Iterator&>(*this);
  }
  auto operator[](difference_type n) const { return *(self() + n); }
  friend Iterator operator+(Iterator at, difference_type n) { return at += n; }
  friend Iterator operator+(difference_type n, Iterator at) { return at += n; }
  friend Iterator operator-(Iterator at, difference_type n) { return at -= n; }
  friend difference_type operator-(const Iterator& a, const Iterator& b) {
    return static_cast<difference_type>(a.index_ - b.index_);
  }
  friend bool operator==(const Iterator& a, const Iterator& b) { return a.index_ == b.index_; }
  friend std::strong_ordering operator<=>(const Iterator& a, const Iterator& b) {
    return a.index_ <=> b.index_;
  }

 protected:
  IndexSteps() = default;
  explicit IndexSteps(std::size_t index) : index_(index) {}
  std::size_t index_ = 0;

 private:
  const Iterator& self() const { return static_cast<const Iterator&>(*this); }
};

/// A range of what `make` returns for each index of a half-open range, to loop over.
template <class Make>
class MadeRange {
 public:
  class Iterator : public IndexSteps<Iterator> {
   public:
    using value_type = std::invoke_result_t<const Make&, std::size_t>;
    Iterator() = default;
    Iterator(const Make& make, std::size_t index) : IndexSteps<Iterator>(index), make_(make) {}
    value_type operator*() const { return make_(this->index_); }

   private:
    Make make_{};
  };
  MadeRange(const Make& make, std::size_t first, std::size_t last)
      : make_(make), first_(first), last_(last) {}
  [[nodiscard]] Iterator begin() const { return {make_, first_}; }
  [[nodiscard]] Iterator end() const { return {make_, last_}; }
  [[nodiscard]] std::size_t size() const { return last_ - first_; }
  [[nodiscard]] bool empty() const { return first_ == last_; }
  /// Returns element `i`, which must be below the size.
  [[nodiscard]] auto operator[](std::size_t i) const { return make_(first_ + i); }
  [[nodiscard]] auto front() const { return make_(first_); }
  [[nodiscard]] auto back() const { return make_(last_ - 1); }

 private:
  Make make_;
  std::size_t first_;
  std::size_t last_;
};

}  // namespace minksum::detail
