// A separating line of two convex polygons in motion, kept by features of the coarsest hulls that it separates.
//
// The idea of Erickson, Guibas, Stolfi and Zhang, Separation-sensitive collision detection for convex objects (1999):
// far apart, coarse hulls are separated for long; close by, finer ones are looked at. Where the certificate fails,
// hierarchies are searched from the coarsest level, instead of walked as in the paper: the certificates are of the same
// kind, and their number is what is counted here.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "comparison/convex_hierarchy.hpp"
#include "comparison/failure_time.hpp"

namespace taut::paper {

class ConvexSeparation {
 public:
  /// Two convex bodies of a scene, disjoint to its end.
  explicit ConvexSeparation(const Scene& scene);

  /// Goes on to the next failure of the line. False if there is none before the end. Throws StructureError where the
  /// bodies touch.
  bool step();
  double time() const { return time_; }
  /// When the line fails next; infinite if never.
  double next_time() const { return next_; }
  std::uint64_t events() const { return events_; }
  /// A vertex beyond the line, and its two neighbours beyond it.
  static constexpr std::uint64_t certificates = 3;
  /// How many sides and vertices were looked at, in searches.
  std::uint64_t looked_at() const { return looked_at_; }
  int levels() const { return levels_; }
  int level() const { return line_.level; }
  /// The side in whose line the bodies are separated: of which body (0 or 1), and where its ends are at t.
  int owner() const { return line_.owner; }
  std::array<Point, 2> line(double t) const;

 private:
  /// The line of a side of one body, and the vertex of the other one's hull that comes nearest to it.
  struct Line {
    int owner = 0, level = 0;
    int from = 0, to = 0, vertex = 0;  ///< as vertices of bodies_
    double gap = 0;
  };

  void search();
  Line best_line(int level, const std::vector<Point>& at) const;
  Line best_line_of(int owner, int level, const std::vector<Point>& at) const;
  void schedule();
  const HierarchyLevel& hull(int body, int level) const;
  int hull_body(int body, int level) const;

  std::array<std::vector<HierarchyLevel>, 2> hulls_;
  MovingBodies bodies_;  ///< all hulls of both bodies, each as a body
  double time_ = 0, end_ = 0, next_ = 0;
  int levels_ = 0;
  Line line_;
  std::uint64_t events_ = 0;
  mutable std::uint64_t looked_at_ = 0;
};

}  // namespace taut::paper
