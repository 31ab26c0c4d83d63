#include "geometry/prepared_shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "geometry/predicates.hpp"
#include "taut/error.hpp"
#include "taut/validate.hpp"

namespace taut::internal {

PreparedShape::PreparedShape(const Polygon& polygon, const std::string& name) : polygon_(polygon) {
  validate_polygon(polygon, name);
  facts_ = facts_of(polygon);
  diameter_squared_ = internal::diameter_squared(polygon);
}

std::shared_ptr<const std::vector<Point>> PreparedShape::scaled(int exponent) const {
  const std::lock_guard lock(mutex_);
  return scaled_locked(exponent);
}

std::shared_ptr<const std::vector<Point>> PreparedShape::scaled_locked(int exponent) const {
  if (!scaled_ || exponent_ != exponent) {
    scaled_ = std::make_shared<const std::vector<Point>>(normalised(polygon_, facts_, exponent));
    exponent_ = exponent;
  }
  return scaled_;
}

std::shared_ptr<const ShapeInRole> PreparedShape::make(const ShapeRole& role) const {
  const UnmeteredScope making;
  auto fresh = std::make_shared<ShapeInRole>();
  fresh->role = role;
  fresh->polygon = scaled_locked(role.exponent);
  fresh->displaced = displaced_polygon(*fresh->polygon, role.offset, role.seed);
  return fresh;
}

std::shared_ptr<const ShapeInRole> PreparedShape::in_role(const ShapeRole& role) const {
  const std::lock_guard lock(mutex_);
  for (const auto& known : roles_) {
    if (known->role == role) return known;
  }
  std::shared_ptr<const ShapeInRole> fresh = make(role);
  if (roles_.size() < most_roles) {
    roles_.push_back(fresh);
  } else {
    roles_[next_role_] = fresh;
    next_role_ = (next_role_ + 1) % most_roles;
  }
  return fresh;
}

void refuse_curves(const Body& body) {
  if (body.curves.empty()) return;
  throw InputError(
      body.name, "the body is bounded by curves, which this does not take",
      "`taut flatten SCENE --tolerance X --outer`, or flatten() in the library, makes polygons around such "
      "bodies, and with --inner within them");
}

}  // namespace taut::internal

namespace taut {
using namespace internal;

const Polygon& polygon_of(const Body& body) {
  refuse_curves(body);
  return body.prepared && body.polygon.empty() ? body.prepared->polygon() : body.polygon;
}

}  // namespace taut

namespace taut {
using namespace internal;

std::shared_ptr<const PreparedShape> prepare(const Polygon& polygon, const std::string& name) {
  const UnmeteredScope making;
  return std::make_shared<const PreparedShape>(polygon, name);
}

}  // namespace taut

namespace taut::internal {

ShapeFacts facts_of(const Polygon& polygon) {
  ShapeFacts facts;
  facts.size = static_cast<std::uint32_t>(polygon.size());
  facts.reversed = polygon_orientation(polygon) < 0;
  const auto smallest = std::min_element(polygon.begin(), polygon.end(), [](const Point& a, const Point& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  });
  facts.first = static_cast<std::uint32_t>(smallest - polygon.begin());
  facts.least = INFINITY;
  for (const Point& v : polygon) {
    for (const double c : {std::fabs(v.x), std::fabs(v.y)}) {
      if (c == 0) continue;
      facts.least = std::min(facts.least, c);
      facts.largest = std::max(facts.largest, c);
    }
  }
  facts.bounds = box_around(polygon);
  return facts;
}

std::vector<Point> normalised(const Polygon& polygon, const ShapeFacts& facts, int exponent) {
  std::vector<Point> out(polygon.size());
  // A product with a power of two that is a double is what std::ldexp() returns.
  const bool plain = std::abs(exponent) < 1000;
  const double factor = plain ? std::ldexp(1.0, exponent) : 1;
  const auto scaled = [&](double x) { return plain ? x * factor : std::ldexp(x, exponent); };
  for (std::uint32_t k = 0; k < facts.size; ++k) {
    const Point& v = polygon[facts.vertex(k)];
    out[k] = {scaled(v.x), scaled(v.y)};
  }
  return out;
}

}  // namespace taut::internal
