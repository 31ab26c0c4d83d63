#include "pair/fitted_scene.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <string>

#include "geometry/displacement_check.hpp"
#include "geometry/hull.hpp"
#include "pair/ring_set.hpp"
#include "pair/validate_world.hpp"
#include "taut/error.hpp"
#include "taut/shape.hpp"

namespace taut {
namespace {

/// The least fit, as a share of the largest coordinate: what rounding adds to a way of 1.05 to 1.95 times the fit must
/// stay well below 0.05 times that.
constexpr double least_share = 0x1p-40;

/// As short as tells it from other doubles, or nearly.
std::string number_of(double x) {
  for (int digits = 6;; ++digits) {
    std::ostringstream s;
    s.precision(digits);
    s << x;
    if (digits == 17 || std::stod(s.str()) == x) return s.str();
  }
}

double largest_in(const Scene& scene) {
  double largest = 0;
  for (const Body& body : scene.bodies) {
    for (const Part& part : parts_of(body)) {
      for (const Point& p : part.outline) largest = std::max({largest, std::fabs(p.x), std::fabs(p.y)});
    }
  }
  return largest;
}

class Fitter {
 public:
  Fitter(double fit, int exponent) : fit_(fit), exponent_(exponent) {}

  Part part(const Body& body, const Part& given, std::size_t index) {
    Part shrunk{ring(given.outline, true, ring_name(body, index, 0)), {}};
    for (std::size_t i = 0; i < given.holes.size(); ++i)
      shrunk.holes.push_back(ring(given.holes[i], false, ring_name(body, index, i + 1)));
    return shrunk;
  }

 private:
  /// Counterclockwise, displaced, and back in the order given.
  Polygon ring(const Polygon& given, bool inwards, const std::string& name) {
    const bool reversed = polygon_orientation(given) < 0;
    std::vector<Point> points;
    for (const Point& p : given) points.push_back({std::ldexp(p.x, -exponent_), std::ldexp(p.y, -exponent_)});
    if (reversed) std::reverse(points.begin(), points.end());
    Displacement moved = displace(points, inwards, std::ldexp(fit_, -exponent_), ++seed_);
    if (moved.too_sharp) refuse(name, {DisplacementFault::Kind::sharp_corner, *moved.too_sharp, 0}, given, reversed);
    Polygon shrunk;
    for (DisplacedPoint& p : moved.points) {
      // To doubles: what it is displaced by is then what it has been displaced by.
      const Point to{p.x + p.dx, p.y + p.dy};
      p.dx = to.x - p.x;
      p.dy = to.y - p.y;
      shrunk.push_back({std::ldexp(to.x, exponent_), std::ldexp(to.y, exponent_)});
    }
    const double farthest = moved.farthest * (1 + 0x1p-20);
    if (!has_room(points, farthest)) {
      const auto fault = find_displacement_fault(moved.points, inwards, farthest);
      if (fault) refuse(name, *fault, given, reversed);
    }
    if (reversed) std::reverse(shrunk.begin(), shrunk.end());
    return shrunk;
  }

  [[noreturn]] void refuse(const std::string& name, const DisplacementFault& fault, const Polygon& given,
                           bool reversed) const {
    const auto n = given.size();
    const auto vertex = [&](std::size_t k) { return reversed ? n - 1 - k : k; };
    const auto edge = [&](std::size_t k) { return reversed ? (2 * n - 2 - k) % n : k; };
    const bool corner = fault.kind == DisplacementFault::Kind::sharp_corner;
    const std::string where = corner ? "the corner at vertex " + std::to_string(vertex(fault.first)) + " is too sharp"
                                     : "edges " + std::to_string(edge(fault.first)) + " and " +
                                           std::to_string(edge(fault.second)) + " come too close";
    throw InputError(name, where + " for a fit of " + number_of(fit_),
                     "bodies are shrunk by up to twice the fit on each side: choose a smaller one, or a coarser shape");
  }

  double fit_;
  int exponent_;
  std::uint64_t seed_ = 0;
};

}  // namespace

Scene fitted(const Scene& scene, double fit) {
  const double largest = largest_in(scene);
  if (!(fit > 0 && std::isfinite(fit))) throw InputError("fit", "it is not a positive number", "leave it out");
  if (fit < least_share * largest)
    throw InputError("fit", "it is less than 2^-40 of the largest coordinate, " + number_of(largest),
                     "doubles round by nearly as much: choose a larger one");
  int exponent = 0;
  std::frexp(largest, &exponent);
  Fitter fitter(fit, exponent);
  Scene shrunk = scene;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    const std::vector<Part> parts = parts_of(body);
    Body& small = shrunk.bodies[i];
    small.prepared = nullptr;
    small.parts.clear();
    for (std::size_t k = 0; k < parts.size(); ++k) small.parts.push_back(fitter.part(body, parts[k], k));
    small.polygon.clear();
    if (body.parts.empty()) {
      small.polygon = small.parts[0].outline;
      small.parts.clear();
    }
  }
  try {
    validate_world(shrunk);
  } catch (const InputError& error) {
    throw InputError(error.place(), "shrunk by a fit of " + number_of(fit) + ", " + error.problem(),
                     "the walls there are thinner than the fit allows: choose a smaller one");
  }
  return shrunk;
}

}  // namespace taut
