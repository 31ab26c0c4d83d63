// Random linkages of dyads, and where their points are by closed forms in 2,000 bits: circles and lines intersected one
// after the other. Shares nothing with src/.
#pragma once

#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "support/rng.hpp"
#include "taut/scene.hpp"

namespace taut::testing {

using Long =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<2000, boost::multiprecision::digit_base_2>,
                                  boost::multiprecision::et_off>;

struct LongPoint {
  Long x, y;
};

/// A crank on the ground, and dyads: two links, or a link and a block that slides along another link.
class ClosedLinkage {
 public:
  ClosedLinkage(Rng& rng, int dyads);

  /// With the mechanism, not assembled. Each body is a small triangle.
  const Scene& scene() const { return scene_; }
  /// A joint's place in the drawn pose, and the body that carries it.
  struct Marker {
    int body;
    Point at;
  };
  const std::vector<Marker>& markers() const { return markers_; }
  /// Where the markers are at a time. The result is how far the linkage is from a dead point: the least discriminant of
  /// its dyads, relative to their sizes. Where it is not positive, the linkage is beyond one, and nothing is placed.
  Long place(double t, std::vector<LongPoint>& points) const;

 private:
  struct Dyad {
    int p, q;  ///< markers that it hangs on; of a block, q's body is what it slides along
    int r;     ///< the marker of its inner joint
    bool slides;
    Point direction;
  };
  /// A body's place: where two of its points are.
  struct Frame {
    LongPoint at, axis;  ///< of the drawn origin, and the unit vector of the drawn x axis
  };
  int add_body(const std::string& name, const Point& at);
  int pick_marker(Rng& rng) const;
  void add_dyad(Rng& rng, int number);

  Scene scene_;
  std::vector<Marker> markers_;
  std::vector<Dyad> dyads_;
  double speed_;  ///< of the crank, in degrees for each unit of time
};

}  // namespace taut::testing
