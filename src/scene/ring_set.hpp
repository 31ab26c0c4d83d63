// A body of several rings as the engines see it.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/container.hpp"
#include "geometry/displacement.hpp"
#include "geometry/ids.hpp"
#include "geometry/predicates.hpp"
#include "geometry/prepared_shape.hpp"
#include "numeric/budget.hpp"
#include "taut/feature.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// One ring of a body: how its internal vertices are numbered in the input.
struct RingMap {
  int part = 0, ring = 0;
  std::uint32_t offset = 0;  ///< of its first vertex among those of the body
  std::uint32_t size = 0;
  std::uint32_t first = 0;  ///< index of the input that became its first vertex
  bool reversed = false;    ///< the input runs against the internal order

  int vertex(std::uint32_t k) const {
    return static_cast<int>(reversed ? (first + size - k) % size : (first + k) % size);
  }
  int edge(std::uint32_t k) const {
    return static_cast<int>(reversed ? (first + 2 * size - k - 1) % size : (first + k) % size);
  }
};

/// One displaced ring of a body as a simple polygon: an outline as it is, a hole as the material around it.
struct SingleRing {
  SharedPolygon polygon;
  std::optional<Container> container;
  std::uint32_t offset = 0;  ///< of the ring's first vertex among those of the body

  /// The body's vertex, and edge by its first vertex, that a vertex of the polygon and the edge from it are. Nothing
  /// for what is there around a hole only.
  std::optional<std::uint32_t> vertex(VertexId v) const {
    return of_body(container ? container->vertex(v.value) : v.value);
  }
  std::optional<std::uint32_t> edge(VertexId v) const {
    return of_body(container ? container->edge(v.value) : v.value);
  }

 private:
  std::optional<std::uint32_t> of_body(std::optional<std::uint32_t> k) const {
    if (k) *k += offset;
    return k;
  }
};

/// All rings of a body, one after the other: of each part the outline counterclockwise, then its holes clockwise, so
/// that the material is to the left. Displaced for both readings of touching when first asked for; safe to share
/// between threads.
class RingSet {
 public:
  /// The body must be valid. Coordinates are the input's times 2^exponent; `index` is its position in the scene. Of a
  /// body of parts, only those in `section`, unless it is empty.
  RingSet(const Body& body, int index, int exponent, const std::vector<std::size_t>& section = {});

  /// The k-th vertex, and the edge from it to the next one along its ring, in the input's terms.
  VertexRef vertex(std::uint32_t k) const;
  EdgeRef edge(std::uint32_t k) const;
  /// Scaled.
  const AxisBox& bounds() const { return bounds_; }
  /// In the input's units.
  AxisBox input_bounds() const;
  /// Of the bounds.
  double diagonal() const { return diagonal_; }
  std::size_t size() const { return size_; }
  bool has_part(int part) const {
    return std::any_of(maps_.begin(), maps_.end(), [&](const RingMap& ring) { return ring.part == part; });
  }
  /// In the order of their vertices: the holes of a part follow its outline.
  const std::vector<RingMap>& rings() const { return maps_; }
  /// Of a ring, counterclockwise also if it is a hole; scaled.
  const std::vector<Point>& points(std::size_t ring) const { return *rings_[ring]; }
  /// Of a ring, scaled.
  double diameter_squared(std::size_t ring) const {
    return rings_.size() == 1 ? diameter_squared() : internal::diameter_squared(points(ring));
  }
  /// Of the body, scaled; computed when first asked for.
  double diameter_squared() const;
  int exponent() const { return exponent_; }
  int body() const { return index_; }
  const std::string& name() const { return name_; }

  /// Displaced towards the material, or away from it. Throws InputError where a feature is finer than the displacement.
  const SharedPolygon& displaced(Offset offset) const;
  /// One of them alone; made when first asked for. Throws Undecidable where a hole's corners are all too sharp for it.
  const SingleRing& single_ring(std::size_t ring, Offset offset) const;
  /// What the spacetime engine makes of the displaced rings, once: they are displaced by then. It is kept here, or with
  /// the shape if that was prepared.
  template <class T, class Make>
  const T& kept(Offset offset, const Make& make) const {
    const std::lock_guard lock(mutex_);
    const std::size_t side = index_of(offset);
    if (in_role_[side]) return *in_role_[side]->kept<T>(ShapeInRole::hierarchy, make);
    std::shared_ptr<const void>& place = kept_[side];
    if (!place) {
      const UnmeteredScope making;
      place = make();
    }
    return *static_cast<const T*>(place.get());
  }
  /// Is the only ring that of a prepared shape, with which everything is kept that is made of it?
  bool is_prepared() const { return prepared_ != nullptr; }
  /// What the kinetic engine makes of one displaced ring in a role, once; null if that is what was made of it.
  template <class T, class Make>
  const T* kept_of(std::size_t ring, Offset offset, Role role, const Make& make) const {
    const std::lock_guard lock(mutex_);
    if (const auto& shape = in_role_[index_of(offset)])
      return shape->kept<T>(role == Role::p ? ShapeInRole::tiling_of_p : ShapeInRole::tiling_of_q, make);
    auto& kept = kept_of_[index_of(offset)];
    const std::pair key(ring, role);
    auto place = kept.find(key);
    if (place == kept.end()) {
      const UnmeteredScope making;
      place = kept.emplace(key, std::shared_ptr<const T>(make())).first;
    }
    return static_cast<const T*>(place->second.get());
  }

 private:
  using Points = std::shared_ptr<const std::vector<Point>>;

  void add_ring(const Polygon& ring, int part, int number);
  void add(const Points& points, const ShapeFacts& facts, int part, int number);
  const RingMap& ring_of(std::uint32_t k) const;
  SharedPolygon displace_rings(Offset offset) const;
  SharedPolygon displaced_ring(std::size_t ring, Offset offset) const;
  [[noreturn]] void refuse(const RingMap& ring, const DisplacementFault& fault) const;

  int index_, exponent_;
  std::string name_;
  std::shared_ptr<const PreparedShape> prepared_;  ///< if the only ring is
  std::vector<RingMap> maps_;
  std::vector<Points> rings_;  ///< scaled, each counterclockwise
  AxisBox bounds_;
  double diagonal_ = 0;
  std::size_t size_ = 0;
  mutable std::mutex mutex_;
  mutable std::optional<double> diameter_squared_;
  mutable std::array<SharedPolygon, 2> displaced_;
  mutable std::array<std::shared_ptr<const ShapeInRole>, 2> in_role_;  ///< of a prepared shape
  mutable std::array<std::shared_ptr<const void>, 2> kept_;
  mutable std::array<std::map<std::size_t, SingleRing>, 2> single_rings_;
  mutable std::array<std::map<std::pair<std::size_t, Role>, std::shared_ptr<const void>>, 2> kept_of_;
};

/// The parts of a body, of which a polygon is one.
std::vector<Part> parts_of(const Body& body);
/// The name of a ring in messages: the body's, with part and hole where there are several.
std::string ring_name(const Body& body, std::size_t part, std::size_t ring);
std::string ring_name(std::string body, bool several_parts, int part, int ring);

}  // namespace taut::internal
