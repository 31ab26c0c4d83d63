// The directions in which one body can leave others.
#pragma once

#include <array>
#include <bitset>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

#include "geometry/vector.hpp"
#include "scene/instance.hpp"
#include "spacetime/hierarchy.hpp"

namespace taut::internal {

// The vertices of displaced bodies at one instant, in the world.

/// The vertices of one body. Positions are rounded, with a bound of the error, and recomputed with more bits on demand.
/// The pose is computed once for each precision, so an object must be used by one thread only.
class VerticesAtPose {
 public:
  VerticesAtPose(const InstanceBody& body, double t, Offset offset);

  const DisplacedPolygon& polygon() const { return *polygon_; }
  /// Rounded; each coordinate has an error of at most error().
  Vector at(std::uint32_t k) const { return positions_[k]; }
  double error() const { return error_; }
  /// The position of a point of the body, also rounded.
  Vector place(Vector v) const;
  template <class Real>
  std::array<Ball<Real>, 2> enclosed(std::uint32_t k) const;

 private:
  SharedPolygon polygon_;
  PieceChain chain_;  ///< the pieces valid at that instant
  double t_;
  Vector origin_, axis_{1, 0};
  std::vector<Vector> positions_;
  double error_ = 0;
  bool turned_ = true;  ///< its axes may not be the world's
  template <class Real>
  using Known = std::optional<Pose<Real>>;
  mutable OfEachPrecision<Known, double> poses_;
};

/// A body at its position, with its tree of boxes.
struct StandingBody {
  VerticesAtPose vertices;
  const spacetime::Hierarchy& tree;
};

/// A direction from a vertex of the moving body to one of a stationary body. If the travel is finite, it may also be
/// the direction from a vertex to the place on an edge at a distance equal to the travel.
struct VertexDirection {
  enum class Kind : unsigned char {
    vertices,
    to_edge,    ///< on the edge from `to` to the next vertex
    from_edge,  ///< on the moving body's edge that starts at `from`
  };
  std::uint32_t from = 0;  ///< a vertex of the moving body
  int other = 0;           ///< the number of the call of add() that named both bodies
  std::uint32_t to = 0;
  Kind kind = Kind::vertices;
  bool second = false;  ///< the second of the two places on the edge

  bool operator==(const VertexDirection&) const = default;
};

/// The arc from `from` counterclockwise to `to`.
struct VertexArc {
  VertexDirection from, to;
};

/// The corners of the intersection of a disc with a parallelogram: at most four corners, and two places on each side.
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
/// are certainly inside the union of others do not matter, and neither do pairs of boxes whose directions all are. A
/// table of covered short arcs decides this in doubles. The ends of the remaining arcs are sorted by exact signs.
///
/// If the travel is finite, only differences up to that length matter. The cone is then over the intersection of the
/// parallelogram of differences with the disc of that radius. So its ends are corners of the parallelogram within the
/// disc, or places where a side leaves the disc.
class FreeDirections {
 public:
  explicit FreeDirections(double travel) : travel_(travel) {}

  /// Adds another stationary body, for the moving one or for one of its cross-sections.
  void add(const StandingBody& moving, const StandingBody& other);
  /// The free arcs, in order from the x axis; empty if all directions are blocked. Throws Undecidable.
  std::vector<VertexArc> free();
  /// Is the arc a single direction, as far as doubles show?
  bool is_point(const VertexArc& arc) const;
  /// Are no directions blocked?
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
  bool covered(const spacetime::BoxNode& box, int other, const spacetime::BoxNode& node) const;
  void descend(int other);
  void sample(int other);

  struct StandingPair {
    const StandingBody *moving, *other;
  };
  const StandingBody& own(int pair) const { return *pairs_[static_cast<std::size_t>(pair)].moving; }
  const StandingBody& theirs(int pair) const { return *pairs_[static_cast<std::size_t>(pair)].other; }

  double travel_;  ///< infinite if it is unlimited
  std::vector<StandingPair> pairs_;
  std::vector<VertexArc> arcs_;
  std::bitset<sectors> covered_;
};

}  // namespace taut::internal
