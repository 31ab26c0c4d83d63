// The bytes of a proof log: little-endian numbers, and a checksum of all of them.
#pragma once

#include <cstdint>
#include <cstring>
#include <istream>
#include <ostream>
#include <sstream>
#include <string>

#include "taut/proof.hpp"

namespace taut::internal::proof {

inline std::uint64_t bits_of(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  return bits;
}

/// 64-bit FNV-1a.
class Checksum {
 public:
  void add(std::uint8_t byte) { value_ = (value_ ^ byte) * 0x100000001b3u; }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325u;
};

/// Writes through a buffer of its own; close() must come last.
class ByteWriter {
 public:
  explicit ByteWriter(std::ostream& out) : out_(out) {}

  void u8(std::uint8_t x) {
    checksum_.add(x);
    buffer_.push_back(static_cast<char>(x));
    if (buffer_.size() >= buffer_size) flush();
  }
  void u32(std::uint32_t x) { little_endian(x, 4); }
  void u64(std::uint64_t x) { little_endian(x, 8); }
  void f64(double x) { u64(bits_of(x)); }
  /// Writes the checksum of everything before it.
  void close() {
    u64(checksum_.value());
    flush();
  }

 private:
  static constexpr std::size_t buffer_size = 1 << 16;

  void little_endian(std::uint64_t x, int bytes) {
    for (int i = 0; i < bytes; ++i) u8(static_cast<std::uint8_t>(x >> (8 * i)));
  }
  void flush() {
    out_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
    buffer_.clear();
  }

  std::ostream& out_;
  std::string buffer_;
  Checksum checksum_;
};

/// Reads; throws ProofError where the log ends too soon. How long it is, is known: what a log says may not take more
/// room or time than it has bytes for. A stream that does not state its length is read first.
class ByteReader {
 public:
  explicit ByteReader(std::istream& in) : in_(*in.rdbuf()) {
    const std::streamoff here = in_.pubseekoff(0, std::ios::cur, std::ios::in);
    std::streamoff end = -1;
    if (here >= 0) end = in_.pubseekoff(0, std::ios::end, std::ios::in);
    if (here >= 0 && end >= here && std::streamoff(in_.pubseekpos(here, std::ios::in)) == here) {
      length_ = static_cast<std::uint64_t>(end - here);
      return;
    }
    std::ostringstream all;
    if (in_.sgetc() != std::char_traits<char>::eof()) all << &in_;
    own_ = std::stringbuf(all.str(), std::ios::in);
    length_ = all.str().size();
    from_own_ = true;
  }
  ByteReader(const ByteReader&) = delete;
  ByteReader& operator=(const ByteReader&) = delete;

  std::uint8_t u8() {
    const int c = source().sbumpc();
    if (c == std::char_traits<char>::eof()) throw ProofError("the log is cut off at byte " + std::to_string(offset_));
    ++offset_;
    checksum_.add(static_cast<std::uint8_t>(c));
    return static_cast<std::uint8_t>(c);
  }
  std::uint32_t u32() { return static_cast<std::uint32_t>(little_endian(4)); }
  std::uint64_t u64() { return little_endian(8); }
  double f64() {
    const std::uint64_t bits = u64();
    double x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
  }
  float f32() {
    const std::uint32_t bits = u32();
    float x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
  }
  /// Reads the checksum, after which nothing may come.
  void close() {
    const std::uint64_t expected = checksum_.value();
    if (u64() != expected) throw ProofError("the checksum is wrong: the log was damaged");
    if (source().sgetc() != std::char_traits<char>::eof())
      throw ProofError("there is something after the end of the log");
  }
  std::uint64_t offset() const { return offset_; }
  std::uint64_t left() const { return length_ > offset_ ? length_ - offset_ : 0; }

 private:
  std::streambuf& source() { return from_own_ ? own_ : in_; }
  std::uint64_t little_endian(int bytes) {
    std::uint64_t x = 0;
    for (int i = 0; i < bytes; ++i) x |= static_cast<std::uint64_t>(u8()) << (8 * i);
    return x;
  }

  std::streambuf& in_;
  std::stringbuf own_;  ///< all of a stream without a length
  bool from_own_ = false;
  std::uint64_t length_ = 0, offset_ = 0;
  Checksum checksum_;
};

}  // namespace taut::internal::proof
