// Holds the memory of regions. This is no part of the interface.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <new>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

namespace minksum::detail {

/// Growing arrays of plain values in one block of memory. Copies share the block until one of them
/// is changed. Different threads may use different copies.
template <class... Values>
class SharedArrays {
 public:
  static constexpr std::size_t kArrays = sizeof...(Values);
  /// One number for each array.
  using Counts = std::array<std::size_t, kArrays>;
  template <std::size_t kArray>
  using Value = std::tuple_element_t<kArray, std::tuple<Values...>>;

  SharedArrays() = default;
  ~SharedArrays() { release(); }
  SharedArrays(const SharedArrays& from) noexcept : block_(from.block_) {
    if (block_ != nullptr) block_->owners.fetch_add(1, std::memory_order_relaxed);
  }
  SharedArrays(SharedArrays&& from) noexcept : block_(std::exchange(from.block_, nullptr)) {}
  SharedArrays& operator=(const SharedArrays& from) noexcept {
    SharedArrays copy(from);
    std::swap(block_, copy.block_);
    return *this;
  }
  /// Leaves `from` empty, even if it is moved to itself.
  SharedArrays& operator=(SharedArrays&& from) noexcept {
    SharedArrays taken(std::move(from));
    if (&from != this) std::swap(block_, taken.block_);
    return *this;
  }

  template <std::size_t kArray>
  [[nodiscard]] std::size_t size() const {
    return block_ == nullptr ? 0 : block_->sizes[kArray];
  }
  template <std::size_t kArray>
  [[nodiscard]] std::span<const Value<kArray>> get() const {
    return {data<kArray>(), size<kArray>()};
  }
  /// `index` must be below the array's size.
  template <std::size_t kArray>
  [[nodiscard]] const Value<kArray>& at(std::size_t index) const {
    return data<kArray>()[index];
  }

  /// Returns a value to be changed, of which no copy may share the block.
  template <std::size_t kArray>
  [[nodiscard]] Value<kArray>& unshared(std::size_t index) {
    return data<kArray>()[index];
  }
  /// Returns values to be changed, and first copies the block if it is shared. The span is valid
  /// until the next call that changes a size.
  template <std::size_t kArray>
  [[nodiscard]] std::span<Value<kArray>> change() {
    if (block_ != nullptr && !is_only_owner()) reallocate(block_->sizes);
    return {data<kArray>(), size<kArray>()};
  }
  template <std::size_t kArray>
  void push_back(Value<kArray> value) {
    const std::size_t count = size<kArray>();
    make_room<kArray>(count + 1);
    data<kArray>()[count] = value;
    block_->sizes[kArray] = count + 1;
  }
  /// `values` must lie elsewhere.
  template <std::size_t kArray>
  void append(std::span<const Value<kArray>> values) {
    if (values.empty()) return;
    const std::size_t count = size<kArray>();
    make_room<kArray>(count + values.size());
    std::copy(values.begin(), values.end(), data<kArray>() + count);
    block_->sizes[kArray] = count + values.size();
  }
  /// Changes a size. The caller sets new values.
  template <std::size_t kArray>
  void resize(std::size_t count) {
    if (count == size<kArray>()) return;
    make_room<kArray>(count);
    block_->sizes[kArray] = count;
  }
  /// Makes room for exactly so many values, or for those that are there if they are more.
  void reserve(const Counts& counts) {
    Counts room = counts;
    bool enough = block_ != nullptr && is_only_owner();
    for (std::size_t k = 0; k < kArrays; ++k) {
      if (block_ != nullptr) room[k] = std::max(room[k], block_->sizes[k]);
      enough = enough && room[k] <= block_->capacities[k];
    }
    if (!enough) reallocate(room);
  }
  /// Removes all values. The memory is kept unless it is shared.
  void clear() {
    if (block_ == nullptr) return;
    if (is_only_owner()) {
      block_->sizes.fill(0);
    } else {
      release();
      block_ = nullptr;
    }
  }

 private:
  /// Sizes of 32 bits are aligned less than the values.
  struct alignas(std::max({alignof(std::size_t), alignof(Values)...})) Block {
    std::atomic<std::size_t> owners;
    Counts sizes;
    Counts capacities;
  };
  static_assert((std::is_trivially_copyable_v<Values> && ...));
  static constexpr Counts kBytes{sizeof(Values)...};
  static_assert(alignof(Block) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);

  /// Returns where an array begins: the arrays follow each other.
  [[nodiscard]] static constexpr std::size_t bytes_before(std::size_t array, const Counts& room) {
    constexpr std::size_t kAligned = alignof(Block);
    std::size_t bytes = sizeof(Block);
    for (std::size_t k = 0; k < array; ++k) {
      bytes += (room[k] * kBytes[k] + kAligned - 1) / kAligned * kAligned;
    }
    return bytes;
  }
  template <std::size_t kArray>
  [[nodiscard]] Value<kArray>* data() const {
    if (block_ == nullptr) return nullptr;
    void* const begin =
        reinterpret_cast<std::byte*>(block_) + bytes_before(kArray, block_->capacities);
    return static_cast<Value<kArray>*>(begin);
  }
  [[nodiscard]] bool is_only_owner() const {
    return block_->owners.load(std::memory_order_acquire) == 1;
  }
  void release() {
    if (block_ == nullptr) return;
    if (is_only_owner() || block_->owners.fetch_sub(1, std::memory_order_acq_rel) == 1) {
      ::operator delete(block_);
    }
  }

  template <std::size_t kArray>
  void make_room(std::size_t count) {
    const bool changeable = block_ != nullptr && is_only_owner();
    if (changeable && count <= block_->capacities[kArray]) return;
    grow(kArray, count, changeable);
  }
  [[gnu::noinline]] void grow(std::size_t array, std::size_t count, bool changeable) {
    Counts room{};
    if (block_ != nullptr) room = changeable ? block_->capacities : block_->sizes;
    if (count > room[array]) {
      // Every array grows in proportion to the whole block, which has to be copied. Otherwise a
      // short array beside a long one might grow by one value at a time.
      constexpr std::size_t kLeast = 4;
      const std::size_t share = bytes_before(kArrays, room) / 8 / kBytes[array];
      room[array] = std::max({count, 2 * room[array], share, kLeast});
    }
    reallocate(room);
  }
  /// Returns how many bytes the arrays take. For more than sizes of 32 bits can tell, returns what
  /// `operator new` refuses: a `throw` here would not compile where exceptions are off.
  static std::size_t bytes_of(const Counts& room) {
    if constexpr (sizeof(std::size_t) < sizeof(std::uint64_t)) {
      std::uint64_t bytes = 0;
      for (std::size_t k = 0; k < kArrays; ++k) bytes += std::uint64_t{room[k]} * kBytes[k];
      if (bytes > PTRDIFF_MAX - sizeof(Block) - kArrays * alignof(Block)) return SIZE_MAX;
    }
    return bytes_before(kArrays, room);
  }
  void reallocate(const Counts& room) {
    void* const memory = ::operator new(bytes_of(room));
    auto* const block = new (memory) Block{1, {}, room};
    if (block_ != nullptr) {
      block->sizes = block_->sizes;
      for (std::size_t k = 0; k < kArrays; ++k) {
        std::memcpy(
            static_cast<std::byte*>(memory) + bytes_before(k, room),
            reinterpret_cast<const std::byte*>(block_) + bytes_before(k, block_->capacities),
            block_->sizes[k] * kBytes[k]);
      }
      release();
    }
    block_ = block;
  }

  Block* block_ = nullptr;
};

}  // namespace minksum::detail
