// The lifts at which a vertex of one body lies on an edge of another one, as certified functions of time.
//
// Everything is seen from the follower, which is lifted along u. A point z is written as w = u x z, across the
// direction, and h = u . z, along it. The follower's vertex p lies on the cam's edge a b at the lift
//   s = h_a + (h_b - h_a) (w_p - w_a) / (w_b - w_a) - h_p, while w_a <= w_p <= w_b,
// and the cam's vertex q on the follower's edge c d at s = h_q - (h_c + (h_d - h_c) (w_q - w_c) / (w_d - w_c)), while
// w_d <= w_q <= w_c: outlines have the material to their left, so that other edges do not face the other body.
// Coordinates w and h of the cam are linear in the functions of the frame. All of it is in units of |u|, and lifts are
// in units of |u|^2.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "motion/motion_segment.hpp"
#include "scene/instance.hpp"

namespace taut::internal {

/// An interval of doubles; all numbers if nothing is known.
struct LiftRange {
  double lo = -INFINITY, hi = INFINITY;
};

/// A function over a window: its jet in the middle of the window, and over all of it.
template <class Real>
struct WindowJet {
  Jet<Real> middle, over;

  friend WindowJet operator+(const WindowJet& a, const WindowJet& b) { return {a.middle + b.middle, a.over + b.over}; }
  friend WindowJet operator-(const WindowJet& a, const WindowJet& b) { return {a.middle - b.middle, a.over - b.over}; }
  friend WindowJet operator*(const WindowJet& a, const WindowJet& b) { return {a.middle * b.middle, a.over * b.over}; }
  friend WindowJet operator/(const WindowJet& a, const WindowJet& b) { return {a.middle / b.middle, a.over / b.over}; }
  static WindowJet constant(const Ball<Real>& c) { return {Jet<Real>::constant(c), Jet<Real>::constant(c)}; }

  /// Of the values, and of the slopes, over a window of that radius.
  LiftRange range(double radius) const;
  LiftRange slopes(double radius) const;
  /// Cannot the precision distinguish value, slope and second derivative in the middle from 0? Then a shorter window
  /// would not show more.
  bool vanishes_in_middle() const;
};

/// A cross-section of the follower, and one of another body that it may lie on.
struct LiftCouple {
  LiftCouple(const Instance& instance, int follower, int cam, Offset offset);

  struct Outline {
    SharedRings rings;
    SharedPolygon shape;
    std::uint32_t next(std::uint32_t k) const;
    std::uint32_t previous(std::uint32_t k) const;
    std::uint32_t size() const { return static_cast<std::uint32_t>(shape->points.size()); }
    const DisplacedPoint& point(std::uint32_t k) const { return shape->points[k]; }
  };

  int group;  ///< of the cam: bodies of one group move alike
  Outline follower, cam;
  MotionSegments segments;                       ///< the follower is P
  std::shared_ptr<const MotionSegment> segment;  ///< in use
};

/// A vertex of one body and an edge of the other one, by its first vertex.
struct LiftPair {
  std::uint32_t couple;
  bool of_follower;  ///< the vertex is the follower's
  std::uint32_t vertex, edge;
  friend auto operator<=>(const LiftPair&, const LiftPair&) = default;
};
/// A vertex of the follower and one of the cam.
struct VertexCouple {
  std::uint32_t couple, follower, cam;
  friend auto operator<=>(const VertexCouple&, const VertexCouple&) = default;
};
/// Between what a pair's vertex has to be: the first end is where w is less.
std::array<VertexCouple, 2> ends_of(const std::vector<LiftCouple>& couples, const LiftPair& pair);

/// The functions over one window of time.
template <class Real>
class LiftWindow {
 public:
  LiftWindow(const std::vector<LiftCouple>& couples, const Point& u) : couples_(couples), u_(u) {}
  /// From then on they are those over [lo, hi], in which no body changes its piece.
  void set(double lo, double hi);
  double radius() const { return time_.rad; }

  /// How far the pair's vertex is from that end of its edge (0 or 1) across the direction: at least 0 where it is
  /// there.
  WindowJet<Real> from_end(const LiftPair& pair, int end);
  /// Its lift, in units of |u|^2. Not finite where the edge may be parallel to the direction.
  WindowJet<Real> lift(const LiftPair& pair);
  /// Bounds of that where the vertex is over the edge: also where the edge is parallel to the direction.
  LiftRange lifts(const LiftPair& pair, const WindowJet<Real>& lift);
  /// w of a neighbour of the vertex, less that of the vertex.
  WindowJet<Real> to_neighbour(std::uint32_t couple, bool of_follower, std::uint32_t vertex, bool next);

 private:
  struct Place {
    WindowJet<Real> w, h;
    std::uint64_t stamp = 0;
  };
  const Place& place(std::uint32_t couple, bool of_follower, std::uint32_t vertex);
  Place made(const LiftCouple& couple, std::size_t number, bool of_follower, const DisplacedPoint& point);

  const std::vector<LiftCouple>& couples_;
  Point u_;
  Ball<double> time_;
  std::uint64_t stamp_ = 0;
  std::vector<std::array<WindowJet<Real>, 4>> frames_;          ///< D, c and s of each couple
  std::vector<std::array<std::vector<Place>, 2>> places_ = {};  ///< of the cams' vertices, and the followers'
};

/// What holds at all times of the couples' segments, exactly.
class LiftIdentities {
 public:
  LiftIdentities(const std::vector<LiftCouple>& couples, const Point& u) : couples_(couples), u_(u) {}

  /// Other segments are in use.
  void begin();
  /// Are the two vertices always at the same place across the direction?
  bool level(const VertexCouple& vertices);
  /// The sign of w of that neighbour of a vertex, less that of the vertex, if that is constant.
  std::optional<int> side_of_neighbour(std::uint32_t couple, bool of_follower, std::uint32_t vertex, bool next) const;
  /// Are the two lifts the same wherever both are defined? Certain if so.
  bool same(const LiftPair& a, const LiftPair& b) const;
  /// Is the lift 0 wherever it is defined?
  bool zero(const LiftPair& a) const;

 private:
  /// Coefficients of 1, D, c and s.
  using Linear = std::array<Dyadic, 5>;
  struct Place {
    Linear w, h;
  };
  struct Quotient {
    Linear numerator, denominator;
  };
  Place place(const LiftCouple& couple, bool of_follower, std::uint32_t vertex) const;
  Quotient lift(const LiftPair& pair) const;
  static bool vanishes(const MotionSegment& segment, const Linear& c);
  static bool keeps_orientation(const MotionSegment& segment);
  bool keeps_orientation(const LiftCouple& couple) const {
    return keeps_orientation_[static_cast<std::size_t>(&couple - couples_.data())];
  }
  bool same_line(const LiftPair& a, const LiftPair& b) const;

  const std::vector<LiftCouple>& couples_;
  Point u_;
  std::map<VertexCouple, bool> level_;
  std::vector<bool> keeps_orientation_;  ///< of each couple
};

}  // namespace taut::internal
