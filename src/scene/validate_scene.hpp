// Is this input a scene that can be decided?
#pragma once

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "geometry/prepared_shape.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// Throws InputError unless the bodies' names differ, every ring is valid and lies as it must, parents and ignored
/// bodies exist, chains of parents end, and time and motions are as validate() requires. Refuses curves.
void validate_polygons(const Scene& scene);

/// Which body of a scene has which name.
class BodyNames {
 public:
  /// Throws InputError unless the names differ.
  explicit BodyNames(const Scene& scene);
  explicit BodyNames(const std::vector<std::string>& names);
  /// Throws InputError if another body has that name.
  void add(const std::string& name, BodyId body);
  void remove(const std::string& name) { numbers_.erase(name); }
  std::optional<BodyId> find(const std::string& name) const;

 private:
  std::unordered_map<std::string, BodyId> numbers_;  ///< not of bodies without a name, to which nothing refers
};

/// A body that comes to others at that time, or changes its parent, as validate_polygons() would see it; names and
/// parents apart. `largest` is the greatest magnitude of a coordinate, `extent` the largest of the bodies' diagonals,
/// of which this one's becomes one.
void validate_added(const Body& body, BodyId id, double start, double end, double largest, double& extent);
/// Throws InputError unless a body with so many parents may have a parent that has so many.
void validate_depth(const std::string& name, int depth);
[[noreturn]] void refuse_parent(const Body& body, const std::vector<std::string>& known);
[[noreturn]] void refuse_cycle(const std::string& name);

/// Throws InputError unless the bodies' names differ and ignored bodies exist.
void validate_ignored(const Scene& scene);

/// Is the scene one pair of simple polygons in the world's frame: two bodies without parts, which are tested?
bool is_ring_pair(const Scene& scene);
/// Throws InputError unless it is. `use` says what requires it, as in "a trace".
void require_ring_pair(const Scene& scene, const std::string& use);

/// Throws InputError unless the time interval is one.
void validate_time(const Scene& scene);
/// Exact predicates multiply coordinates of several bodies: throws InputError where their magnitudes are too far apart.
void validate_range(const ShapeFacts& a, const ShapeFacts& b);

}  // namespace taut::internal
