// A polygon and everything that has been computed of it alone.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "base/interruption.hpp"
#include "geometry/displacement.hpp"
#include "geometry/ids.hpp"
#include "geometry/shape_facts.hpp"
#include "taut/shape.hpp"

namespace taut {

/// What a body is in one pair: which role it plays, in which units, and how it is displaced.
struct ShapeRole {
  Role role = Role::p;
  bool inwards = true;
  int exponent = 0;  ///< coordinates are the input's times 2^exponent

  friend bool operator==(const ShapeRole& a, const ShapeRole& b) {
    return a.role == b.role && a.inwards == b.inwards && a.exponent == b.exponent;
  }
};

/// The polygon as the engines see it in a role.
struct ShapeInRole {
  ShapeRole role;
  std::shared_ptr<const std::vector<Point>> polygon;  ///< normalised
  SharedPolygon displaced;                            ///< and displaced

  /// What one of the layers above makes of it, once, and keeps here.
  enum Keeper : std::size_t { tiling, hierarchy, keepers };
  template <class T, class Make>
  const T* kept(Keeper keeper, const Make& make) const {
    const std::lock_guard lock(mutex_);
    if (!made_[keeper]) {
      const UncountedWork making;
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
  /// Computed once for each role, and kept as long as the shape.
  const ShapeInRole& in_role(const ShapeRole& role) const;

 private:
  Polygon polygon_;
  ShapeFacts facts_;
  mutable std::mutex mutex_;
  mutable std::vector<std::unique_ptr<const ShapeInRole>> roles_;
};

/// Throws InputError, with what to do, if the body is bounded by curves.
void refuse_curves(const Body& body);

/// A normalised polygon, displaced for a role.
SharedPolygon displaced_for(const std::vector<Point>& polygon, const ShapeRole& role);

}  // namespace taut
