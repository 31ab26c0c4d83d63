// Index types. Elements live in flat arrays and refer to one another by index, never by pointer.
#pragma once

#include <cstddef>
#include <cstdint>

namespace taut::internal {

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

/// The two roles in a pair of bodies: pair_of() says which of them plays P. In a world a body has a role in each of
/// its pairs, and each of its rings one in each pair of rings. Arrays of two have P's first.
enum class Role : std::uint8_t { p, q };
constexpr Role other(Role role) { return role == Role::p ? Role::q : Role::p; }
constexpr std::size_t index_of(Role role) { return static_cast<std::size_t>(role); }

/// A vertex of the pair: P's vertices counterclockwise, then Q's.
using VertexId = Id<struct VertexTag>;
/// A directed edge; its twin has the last bit flipped.
using HalfedgeId = Id<struct HalfedgeTag>;
/// An active certificate.
using CertificateId = Id<struct CertificateTag>;

}  // namespace taut::internal
