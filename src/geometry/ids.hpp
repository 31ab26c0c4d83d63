// Index types. Elements live in flat arrays and refer to one another by index, never by pointer.
#pragma once

#include <cstdint>

namespace taut {

/// A 32-bit index into one kind of array; `none` where there is nothing.
template <class Tag>
struct Id {
  std::uint32_t value = 0xffffffffu;

  constexpr Id() = default;
  constexpr explicit Id(std::uint32_t v) : value(v) {}
  constexpr explicit Id(std::size_t v) : value(static_cast<std::uint32_t>(v)) {}
  constexpr explicit Id(int v) : value(static_cast<std::uint32_t>(v)) {}
  constexpr bool valid() const { return value != 0xffffffffu; }
  friend constexpr bool operator==(Id a, Id b) { return a.value == b.value; }
  friend constexpr bool operator!=(Id a, Id b) { return a.value != b.value; }
  friend constexpr bool operator<(Id a, Id b) { return a.value < b.value; }
};

/// A vertex of the pair: P's vertices counterclockwise, then Q's.
using VertexId = Id<struct VertexTag>;
/// A directed edge; its twin has the last bit flipped.
using HalfedgeId = Id<struct HalfedgeTag>;
/// An active certificate.
using CertificateId = Id<struct CertificateTag>;

}  // namespace taut
