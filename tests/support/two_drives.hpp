// Random mechanisms of which two cranks move the loops together, and where their bodies are, by closed forms in long
// numbers. Shares nothing with src/.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "support/rng.hpp"
#include "taut/scene.hpp"

namespace taut::testing {

/// Five bars; cranks "a" and "d", driven at "A" and "E". Between them two bars with a pin ("B", "C", "D") or with a
/// slide; perhaps two more bars from a point of the first of these to the ground, which are a second loop.
class TwoDrives {
 public:
  enum class Kind : unsigned char { bars, slide, two_loops };
  TwoDrives(Rng& rng, Kind kind);

  /// With the mechanism, without drives. Bodies are convex and counterclockwise.
  const Scene& scene() const { return scene_; }

  /// A body's point p is at `at` + turned by the angle with this cosine and sine, from the drawn origin.
  struct Place {
    long double x, y, c, s;
    std::array<long double, 2> of(const Point& p) const { return {x + c * p.x - s * p.y, y + s * p.x + c * p.y}; }
  };
  /// Of all bodies, where the cranks have turned by these degrees. Along no way without a lock do triangles of pins
  /// change their orientation, so this is the branch of the drawn pose. Nothing beyond a lock.
  std::optional<std::vector<Place>> places(long double a, long double e) const;
  /// How far the mechanism is from a lock there: not above 0 beyond one, else the least sine of an angle between two
  /// bars in a loop; of a slide, also what is left of it, as a share of 20.
  long double margin(long double a, long double e) const;

 private:
  struct Solved {
    std::vector<Place> places;
    long double margin;
  };
  Solved solve(long double a, long double e) const;
  void add_body(Rng& rng, const std::string& name, const Point& p, const Point& q);
  void add_polygon(const std::string& name, Polygon polygon);
  void add_pin(const std::string& name, const std::string& first, const std::string& second, const Point& at);

  Kind kind_;
  Scene scene_;
  Point a_{}, b_{}, c_{}, d_{}, e_{}, p_{}, q_{}, g_{}, along_{};
};

}  // namespace taut::testing
