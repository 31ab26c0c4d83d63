// The directions in which one body leaves others.
#pragma once

#include <array>
#include <bitset>
#include <limits>
#include <optional>
#include <vector>

#include "search/vertices_at_pose.hpp"
#include "spacetime/hierarchy.hpp"

namespace taut::internal {

/// A body where it stands, with its tree of boxes.
struct StandingBody {
  VerticesAtPose vertices;
  const spacetime::Hierarchy& tree;
};

/// A direction: from a vertex of the moving body to one of a body that stays; or, of a travel that ends, from a vertex
/// to the place on an edge that is just as far away as the travel is long.
struct VertexDirection {
  enum class Kind : unsigned char {
    vertices,
    to_edge,    ///< of the edge from `to` to the next vertex
    from_edge,  ///< of the moving body's edge from `from` on
  };
  std::uint32_t from = 0;  ///< of the moving body
  int other = 0;           ///< which of the bodies that stay
  std::uint32_t to = 0;
  Kind kind = Kind::vertices;
  bool second = false;  ///< of the two places on the edge, if there are two

  bool operator==(const VertexDirection&) const = default;
};

/// From `from` counterclockwise to `to`.
struct VertexArc {
  VertexDirection from, to;
};

/// The corners of what a disc leaves of a parallelogram: at most four corners, and two places on each side.
class FewDirections {
 public:
  void push_back(const VertexDirection& d) { all_[size_++] = d; }
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  const VertexDirection& operator[](std::size_t i) const { return all_[i]; }

 private:
  std::array<VertexDirection, 12> all_;
  std::size_t size_ = 0;
};

/// The blocked directions are the open arcs of pairs of edges: the cone over all differences of their points. Arcs that
/// are certainly inside the union of others do not matter, and neither do pairs of boxes all of whose directions are:
/// a table of short arcs that are covered tells, in doubles. Of what is left, the ends are sorted by exact signs.
///
/// If the travel has an end, only differences matter that are as short as that: the cone is over what the disc of that
/// radius leaves of the parallelogram of differences, so its ends are corners of the parallelogram within the disc, or
/// places where a side leaves it.
class FreeDirections {
 public:
  FreeDirections(const StandingBody& moving, double travel) : moving_(moving), travel_(travel) {}

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
  VertexDirection second_end(const VertexDirection& side) const;
  template <class Quantity>
  int decided(const Quantity& quantity, const char* what) const;
  bool within_travel(const VertexDirection& d) const;
  bool dips_into_disc(const VertexDirection& side) const;
  void add_places(VertexDirection side, FewDirections& found) const;
  bool has_end() const { return travel_ < std::numeric_limits<double>::infinity(); }
  int cross(const VertexDirection& a, const VertexDirection& b) const;
  int upper(const VertexDirection& d) const;
  bool before(const VertexDirection& a, const VertexDirection& b) const;
  template <class Real>
  std::array<Ball<Real>, 2> exact_difference(const VertexDirection& d) const;
  template <class Real>
  std::array<Ball<Real>, 2> vertex_difference(const VertexDirection& d) const;
  template <class Real>
  std::array<Ball<Real>, 2> place_on_side(const VertexDirection& d) const;
  std::optional<VertexArc> arc_of(std::uint32_t edge, int other, std::uint32_t other_edge) const;
  bool clear(const VertexDirection& d) const;
  void block(std::uint32_t edge, int other, std::uint32_t other_edge);
  void cover(const VertexArc& arc);
  bool covered(double from, double to) const;
  bool covered(const spacetime::BoxNode& own, int other, const spacetime::BoxNode& node) const;
  void descend(int other);
  void sample(int other);

  const StandingBody& moving_;
  double travel_;  ///< infinite if it has no end
  std::vector<const StandingBody*> others_;
  std::vector<VertexArc> arcs_;
  std::bitset<sectors> covered_;
};

}  // namespace taut::internal
