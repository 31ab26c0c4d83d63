// A polygon and everything that has been computed of it alone.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "geometry/axis_box.hpp"
#include "geometry/displacement.hpp"
#include "geometry/ids.hpp"
#include "numeric/budget.hpp"
#include "taut/shape.hpp"

namespace taut::internal {

// What scenes need to know of a polygon that depends on nothing else.

struct ShapeFacts {
  std::uint32_t size = 0;         ///< number of vertices
  std::uint32_t first = 0;        ///< the lexicographically smallest vertex, a strict corner of the hull
  bool reversed = false;          ///< the vertices run clockwise
  double least = 0, largest = 0;  ///< magnitudes of the coordinates that are not zero; infinite and 0 if all are
  AxisBox bounds;

  /// Vertex k of the polygon counterclockwise, from `first` on, as an index of the input.
  std::uint32_t vertex(std::uint32_t k) const { return reversed ? (first + size - k) % size : (first + k) % size; }
};

/// The polygon must be valid. O(n).
ShapeFacts facts_of(const Polygon& polygon);

/// The polygon counterclockwise from its first vertex on, in coordinates multiplied by 2^exponent (exact).
std::vector<Point> normalised(const Polygon& polygon, const ShapeFacts& facts, int exponent);

/// What a body is in one scene: in which units, and how it is displaced.
struct ShapeRole {
  std::uint64_t seed = 0;  ///< of the displacement
  Offset offset = Offset::inward;
  int exponent = 0;  ///< coordinates are the input's times 2^exponent

  friend bool operator==(const ShapeRole&, const ShapeRole&) = default;
};

/// The polygon as the engines see it in a role.
struct ShapeInRole {
  ShapeRole role;
  std::shared_ptr<const std::vector<Point>> polygon;  ///< normalised
  SharedPolygon displaced;                            ///< and displaced

  /// What one of the layers above makes of it, once, and keeps here.
  enum Keeper : std::size_t { tiling_of_p, tiling_of_q, hierarchy, keepers };
  template <class T, class Make>
  const T* kept(Keeper keeper, const Make& make) const {
    const std::lock_guard lock(mutex_);
    if (!made_[keeper]) {
      const UnmeteredScope making;
      kept_[keeper] = make();
      made_[keeper] = true;
    }
    return static_cast<const T*>(kept_[keeper].get());
  }

 private:
  mutable std::mutex mutex_;
  mutable std::array<std::shared_ptr<const void>, keepers> kept_;
  mutable std::array<bool, keepers> made_{};
};

class PreparedShape {
 public:
  PreparedShape(const Polygon& polygon, const std::string& name);
  const Polygon& polygon() const { return polygon_; }
  const ShapeFacts& facts() const { return facts_; }
  double diameter_squared() const { return diameter_squared_; }
  /// The polygon normalised, in coordinates multiplied by 2^exponent: those last asked for are kept.
  std::shared_ptr<const std::vector<Point>> scaled(int exponent) const;
  /// As one of the bodies of a scene, each of which is displaced in a way of its own: the last ones are kept.
  std::shared_ptr<const ShapeInRole> in_role(const ShapeRole& role) const;

 private:
  /// Bodies of a scene, in both touch modes, of which this is the shape: with more of them none would be found.
  static constexpr std::size_t most_roles = 64;

  std::shared_ptr<const std::vector<Point>> scaled_locked(int exponent) const;
  std::shared_ptr<const ShapeInRole> make(const ShapeRole& role) const;

  Polygon polygon_;
  ShapeFacts facts_;
  double diameter_squared_ = 0;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const std::vector<Point>> scaled_;
  mutable int exponent_ = 0;  ///< of these
  mutable std::vector<std::shared_ptr<const ShapeInRole>> roles_;
  mutable std::size_t next_role_ = 0;  ///< which of them gives way to the next one
};

/// Throws InputError, with what to do, if the body is bounded by curves.
void refuse_curves(const Body& body);

}  // namespace taut::internal
