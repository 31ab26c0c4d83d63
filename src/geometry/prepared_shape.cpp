#include "geometry/prepared_shape.hpp"

#include "taut/error.hpp"
#include "taut/validate.hpp"

namespace taut {

SharedPolygon displaced_for(const std::vector<Point>& polygon, const ShapeRole& role) {
  return displaced_polygon(polygon, role.inwards, role.role == Role::p ? 1 : 0x1234567);
}

PreparedShape::PreparedShape(const Polygon& polygon, const std::string& name) : polygon_(polygon) {
  validate_polygon(polygon, name);
  facts_ = facts_of(polygon);
}

const ShapeInRole& PreparedShape::in_role(const ShapeRole& role) const {
  const std::lock_guard lock(mutex_);
  for (const auto& known : roles_) {
    if (known->role == role) return *known;
  }
  const UncountedWork making;
  auto fresh = std::make_unique<ShapeInRole>();
  fresh->role = role;
  fresh->polygon = std::make_shared<const std::vector<Point>>(normalised(polygon_, facts_, role.exponent));
  fresh->displaced = displaced_for(*fresh->polygon, role);
  roles_.push_back(std::move(fresh));
  return *roles_.back();
}

void refuse_curves(const Body& body) {
  if (body.curves.empty()) return;
  throw InputError(
      body.name, "the body is bounded by curves, which this does not take",
      "`taut flatten SCENE --tolerance X --outer`, or flatten() in the library, makes polygons around such "
      "bodies, and with --inner within them");
}

const Polygon& polygon_of(const Body& body) {
  refuse_curves(body);
  return body.prepared && body.polygon.empty() ? body.prepared->polygon() : body.polygon;
}

std::shared_ptr<const PreparedShape> prepare(const Polygon& polygon, const std::string& name) {
  const UncountedWork making;
  return std::make_shared<const PreparedShape>(polygon, name);
}

}  // namespace taut
