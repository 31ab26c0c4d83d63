#include "proof/barrier.hpp"

#include <cmath>

namespace taut::internal::proof {
namespace {

/// A coordinate is the sum of no more doubles.
constexpr std::size_t most_summands = 32;

std::optional<std::vector<double>> summands(Dyadic x) {
  std::vector<double> found;
  while (!x.is_zero()) {
    const double next = nearest_double(x);
    if (next == 0 || !std::isfinite(next) || found.size() == most_summands) return std::nullopt;
    found.push_back(next);
    x = x - Dyadic::exact(next);
  }
  return found;
}

bool write_number(ByteWriter& out, const Dyadic& x) {
  const auto parts = summands(x);
  if (!parts) return false;
  out.u8(static_cast<std::uint8_t>(parts->size()));
  for (const double part : *parts) out.f64(part);
  return true;
}

Dyadic read_number(ByteReader& in) {
  const std::uint8_t count = in.u8();
  if (count > most_summands) throw ProofError("a coordinate of the polygon has too many digits");
  Dyadic sum;
  for (std::uint8_t i = 0; i < count; ++i) {
    const double part = in.f64();
    if (!std::isfinite(part)) throw ProofError("a coordinate of the polygon is not a number");
    sum = sum + Dyadic::exact(part);
  }
  return sum;
}

bool write_place(ByteWriter& out, const ExactPlace& p) { return write_number(out, p.x) && write_number(out, p.y); }

ExactPlace read_place(ByteReader& in) {
  const Dyadic x = read_number(in);
  return {x, read_number(in)};
}

bool write_edge(ByteWriter& out, const BarrierEdge& edge) {
  if (!write_place(out, edge.from)) return false;
  out.u8(static_cast<std::uint8_t>(edge.kind));
  if (edge.kind == BarrierEdge::Kind::outside) {
    out.u8(edge.side);
    return true;
  }
  out.u32(edge.body);
  out.u32(edge.other);
  return write_place(out, edge.common[0]) && write_place(out, edge.common[1]);
}

BarrierEdge read_edge(ByteReader& in) {
  BarrierEdge edge;
  edge.from = read_place(in);
  const std::uint8_t kind = in.u8();
  if (kind > static_cast<std::uint8_t>(BarrierEdge::Kind::outside)) throw ProofError("unknown edge of the polygon");
  edge.kind = static_cast<BarrierEdge::Kind>(kind);
  if (edge.kind == BarrierEdge::Kind::outside) {
    edge.side = in.u8();
    return edge;
  }
  edge.body = in.u32();
  edge.other = in.u32();
  for (ExactPlace& at : edge.common) at = read_place(in);
  return edge;
}

}  // namespace

bool write(ByteWriter& out, const Barrier& barrier, bool goal_outside) {
  out.u8(barrier.touching ? 1 : 0);
  if (goal_outside) {
    for (const std::uint32_t body : barrier.boxes) out.u32(body);
  }
  out.u32(static_cast<std::uint32_t>(barrier.edges.size()));
  for (const BarrierEdge& edge : barrier.edges) {
    if (!write_edge(out, edge)) return false;
  }
  return true;
}

Barrier read_barrier(ByteReader& in, bool goal_outside) {
  Barrier barrier;
  const std::uint8_t touching = in.u8();
  if (touching > 1) throw ProofError("the log's header makes no sense");
  barrier.touching = touching == 1;
  if (goal_outside) {
    for (std::uint32_t& body : barrier.boxes) body = in.u32();
  }
  for (std::uint32_t left = in.u32(); left > 0; --left) barrier.edges.push_back(read_edge(in));
  return barrier;
}

}  // namespace taut::internal::proof
