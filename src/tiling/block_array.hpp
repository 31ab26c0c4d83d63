// A long array of which little may be used: its memory is not touched before something is written there.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <memory>
#include <type_traits>
#include <utility>

namespace taut::internal {

/// Elements come into being in blocks of 16, when one of a block is first written. To make an array costs little more
/// than asking for the memory: a byte for each block is cleared.
template <class T>
class BlockArray {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  static_assert(alignof(T) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);

 public:
  static constexpr std::size_t block_size = 16;

  BlockArray() = default;
  /// Room for at least `elements`, none of which is there.
  explicit BlockArray(std::size_t elements) { reset(elements); }
  BlockArray(const BlockArray& other) { assign(other, other.blocks_); }
  BlockArray(BlockArray&& other) noexcept { swap(other); }
  BlockArray& operator=(BlockArray other) noexcept {
    swap(other);
    return *this;
  }
  ~BlockArray() = default;

  void reset(std::size_t elements) {
    blocks_ = (elements + block_size - 1) / block_size;
    memory_.reset(static_cast<std::byte*>(::operator new(bytes())));
    elements_ = reinterpret_cast<T*>(memory_.get());
    flags_ = reinterpret_cast<std::uint8_t*>(memory_.get() + blocks_ * block_size * sizeof(T));
    std::memset(flags_, 0, blocks_);
  }
  std::size_t capacity() const { return blocks_ * block_size; }
  std::size_t bytes() const { return blocks_ * (block_size * sizeof(T) + 1); }
  /// Makes more room; what is there stays.
  void grow(std::size_t elements) {
    if (elements > capacity()) BlockArray().assign_larger(*this, std::max(elements, 2 * capacity()));
  }

  /// Is the element's block there?
  bool has(std::size_t i) const { return flags_[i / block_size] != 0; }
  /// An element of a block that is there.
  const T& operator[](std::size_t i) const { return elements_[i]; }
  /// Any element; T() where nothing has been written.
  T get(std::size_t i) const { return has(i) ? elements_[i] : T(); }
  /// An element to be written. If its block is not there yet, make(first, block) is called: `block` holds 16 elements
  /// T(), of which the first is number `first`.
  template <class Make>
  T& touch(std::size_t i, const Make& make) {
    if (!has(i)) [[unlikely]]
      fill(i / block_size, make);
    return elements_[i];
  }
  T& touch(std::size_t i) {
    return touch(i, [](std::size_t, T*) {});
  }
  /// Calls visit(begin, end) for each block that is there, in order.
  template <class Visit>
  void for_each_block(const Visit& visit) const {
    const std::uint8_t *begin = flags_, *end = begin + blocks_;
    for (const std::uint8_t* f = begin; f != end; ++f) {
      f = static_cast<const std::uint8_t*>(std::memchr(f, 1, static_cast<std::size_t>(end - f)));
      if (!f) return;
      const auto first = static_cast<std::size_t>(f - begin) * block_size;
      visit(first, first + block_size);
    }
  }

 private:
  struct Free {
    void operator()(std::byte* memory) const { ::operator delete(memory); }
  };

  template <class Make>
  [[gnu::noinline]] void fill(std::size_t block, const Make& make) {
    const std::size_t first = block * block_size;
    T* made = elements_ + first;
    std::uninitialized_value_construct_n(made, block_size);
    make(first, made);
    flags_[block] = 1;
  }
  void assign(const BlockArray& other, std::size_t blocks) {
    reset(blocks * block_size);
    for (std::size_t b = 0; b < other.blocks_; ++b) {
      if (other.flags_[b] == 0) continue;
      const std::size_t first = b * block_size;
      std::uninitialized_copy_n(other.elements_ + first, block_size, elements_ + first);
      flags_[b] = 1;
    }
  }
  void assign_larger(BlockArray& other, std::size_t elements) {
    assign(other, (elements + block_size - 1) / block_size);
    swap(other);
  }
  void swap(BlockArray& other) noexcept {
    std::swap(blocks_, other.blocks_);
    std::swap(memory_, other.memory_);
    std::swap(elements_, other.elements_);
    std::swap(flags_, other.flags_);
  }

  std::size_t blocks_ = 0;
  std::unique_ptr<std::byte, Free> memory_;
  T* elements_ = nullptr;
  std::uint8_t* flags_ = nullptr;  ///< one for each block, behind the elements
};

}  // namespace taut::internal
