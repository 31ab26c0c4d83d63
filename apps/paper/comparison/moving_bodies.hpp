// Bodies in motion, in doubles: where vertices are, how fast they are, and bounds on what they may do next.
#pragma once

#include <vector>

#include "taut/scene.hpp"

namespace taut::paper {

/// A vertex at an instant.
struct Moving {
  Point position, velocity;
};

/// How fast a body may move within an interval of time.
struct MotionBounds {
  double speed = 0, acceleration = 0;  ///< of the pivot
  double spin = 0, spin_change = 0;    ///< of the angle, in radians
};

/// The bodies of a scene, one polygon each, whose pieces are polynomials with or without an angle, in the world's
/// frame. Vertices are numbered through all bodies, each body's counterclockwise. Doubles throughout, with their
/// rounding: good for a study, no part of a proof.
class MovingBodies {
 public:
  /// Throws InputError of scenes of other forms.
  explicit MovingBodies(const Scene& scene);

  int bodies() const { return static_cast<int>(first_.size()) - 1; }
  int vertices() const { return first_.back(); }
  /// The vertices of a body are first(body) to first(body + 1) - 1.
  int first(int body) const { return first_[static_cast<std::size_t>(body)]; }
  int body_of(int vertex) const { return body_[static_cast<std::size_t>(vertex)]; }
  /// The vertex after this one, and before it, on its body.
  int next(int vertex) const;
  int previous(int vertex) const;
  /// Whether two bodies never move relative to each other: they are the same, or both rest.
  bool rigid(int body, int other) const;

  Moving at(int vertex, double t) const;
  std::vector<Point> positions(double t) const;
  /// Of all instants from t to t + h, which lie in one piece of the motion.
  MotionBounds bounds(int body, double t, double h) const;
  /// The distance of a vertex from the pivot of the piece at t.
  double arm(int vertex, double t) const;
  /// When the piece that holds at t ends: infinite for the last one.
  double piece_end(int body, double t) const;

 private:
  struct Piece {
    double until = 0, origin = 0;
    Coefficients x, y, angle;
    Point pivot;
  };
  const Piece& piece(int body, double t) const;

  std::vector<int> first_, body_;
  std::vector<Point> drawn_;
  std::vector<std::vector<Piece>> pieces_;  ///< none: the body rests as it is drawn
};

/// The scene with vertices moved by random vectors of at most `size`, so that no three are in line.
Scene jittered(Scene scene, double size, std::uint64_t seed);
/// The scene with vertices moved towards the centre of their polygon by a random share between `share` and twice as
/// much. Polygons that are star-shaped about it lie within those given, so that bodies which touch come apart.
Scene shrunk(Scene scene, double share, std::uint64_t seed);

}  // namespace taut::paper
