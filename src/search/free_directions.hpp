// The directions in which one body leaves others.
#pragma once

#include <bitset>
#include <vector>

#include "search/posed_vertices.hpp"
#include "spacetime/hierarchy.hpp"

namespace taut {

/// A body where it stands, with its tree of boxes.
struct StandingBody {
  PosedVertices vertices;
  const spacetime::Hierarchy& tree;
};

/// A direction: from a vertex of the moving body to one of a body that stays.
struct VertexDirection {
  std::uint32_t from = 0;  ///< of the moving body
  int other = 0;           ///< which of the bodies that stay
  std::uint32_t to = 0;

  bool operator==(const VertexDirection& o) const { return from == o.from && other == o.other && to == o.to; }
};

/// From `from` counterclockwise to `to`.
struct VertexArc {
  VertexDirection from, to;
};

/// The blocked directions are the open arcs of pairs of edges: the cone over all differences of their points. Arcs that
/// are certainly inside the union of others do not matter, and neither do pairs of boxes all of whose directions are:
/// a table of short arcs that are covered tells, in doubles. Of what is left, the ends are sorted by exact signs.
class FreeDirections {
 public:
  explicit FreeDirections(const StandingBody& moving) : moving_(moving) {}

  /// Another body that stays.
  void add(const StandingBody& other);
  /// What is left free, in order from the x axis; nothing if all is blocked. Throws Undecidable.
  std::vector<VertexArc> free();
  /// Is the arc no more than a direction, as far as doubles tell?
  bool is_point(const VertexArc& arc) const;
  /// No direction is blocked.
  bool all_free() const { return arcs_.empty(); }
  /// The direction in degrees, in [0, 360), certainly enclosed.
  std::pair<double, double> degrees(const VertexDirection& d) const;

 private:
  static constexpr std::size_t sectors = 4096;

  Vector difference(const VertexDirection& d) const;
  double difference_error(const VertexDirection& d) const;
  int cross(const VertexDirection& a, const VertexDirection& b) const;
  int upper(const VertexDirection& d) const;
  bool before(const VertexDirection& a, const VertexDirection& b) const;
  template <class Real>
  std::array<Ball<Real>, 2> exact_difference(const VertexDirection& d) const;
  VertexArc arc_of(std::uint32_t edge, int other, std::uint32_t other_edge) const;
  bool clear(const VertexDirection& d) const;
  void block(std::uint32_t edge, int other, std::uint32_t other_edge);
  void cover(const VertexArc& arc);
  bool covered(double from, double to) const;
  bool covered(const spacetime::BoxNode& own, int other, const spacetime::BoxNode& node) const;
  void descend(int other);
  void sample(int other);

  const StandingBody& moving_;
  std::vector<const StandingBody*> others_;
  std::vector<VertexArc> arcs_;
  std::bitset<sectors> covered_;
};

}  // namespace taut
