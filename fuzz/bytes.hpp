// The fuzzer's bytes as a source of small decisions; zeros once they are used up.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace taut::fuzz {

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  bool empty() const { return at_ >= size_; }
  std::uint8_t u8() { return empty() ? std::uint8_t{0} : data_[at_++]; }
  std::uint16_t u16() {
    const unsigned low = u8();
    return static_cast<std::uint16_t>(low | static_cast<unsigned>(u8()) << 8);
  }
  std::uint64_t u64() {
    std::uint64_t x = 0;
    for (int i = 0; i < 64; i += 8) x |= std::uint64_t{u8()} << i;
    return x;
  }
  /// Any 64 bits as a double: NaN and infinities, too.
  double f64() {
    const std::uint64_t bits = u64();
    double x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
  }
  /// 0 <= result < n <= 256.
  int below(int n) { return u8() % n; }
  std::string rest() {
    const std::string s(reinterpret_cast<const char*>(data_) + at_, size_ - at_);
    at_ = size_;
    return s;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
  std::size_t at_ = 0;
};

}  // namespace taut::fuzz
