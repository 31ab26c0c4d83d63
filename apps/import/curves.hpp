// Curves as chords, with a bound of how far they are away.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "import/drawing.hpp"

namespace taut::drawing {

/// A control point of a rational curve: (x, y) / w.
struct ControlPoint {
  double x = 0, y = 0, w = 1;
  Point point() const { return {x / w, y / w}; }
};

/// Appends chords to chains of points, and keeps account. All points are where they are in the scene: the bound is that
/// of the scene's units.
class Flattener {
 public:
  /// `file` is for messages.
  Flattener(const ImportSettings& settings, double tolerance, std::string file)
      : settings_(settings), tolerance_(tolerance), file_(std::move(file)) {}

  /// The ellipse centre + cos(t) a + sin(t) b, t from `from` over `sweep`, after its first point; the last one is
  /// `end`. The curve is nowhere farther from its chord than the longest half-axis times 1 - cos(half the step).
  void arc(std::vector<Point>& out, const Point& centre, const Point& a, const Point& b, double from, double sweep,
           const Point& end);
  /// A whole ellipse, without its first point again.
  void ellipse(std::vector<Point>& out, const Point& centre, const Point& a, const Point& b);
  /// A Bezier curve of any degree after its first point; weights must be positive. It lies within the hull of its
  /// control points, and is halved until these are near enough to the chord.
  void bezier(std::vector<Point>& out, const std::vector<ControlPoint>& control);

  /// With ImportSettings::curves: those that scenes can have. Rational ones, and those of a higher degree, are chords.
  std::vector<KeptCurve> take_kept() { return std::move(kept_); }
  const CurveCounts& counts() const { return counts_; }
  /// With ImportSettings::curves, since the last call: curves that are chords all the same.
  CurveCounts take_chorded() { return std::exchange(chorded_, {}); }

 private:
  /// How many chords.
  int steps(double longest_axis, double sweep);
  void append(std::vector<Point>& out, const Point& p);
  void halve(std::vector<Point>& out, std::vector<ControlPoint> control, int depth, int least);
  [[noreturn]] void fail_size() const;

  /// A quarter of an ellipse or less, kept.
  void keep_arc(std::vector<Point>& out, const Point& centre, const Point& a, const Point& b, double from, double sweep,
                const Point& end);
  /// What has been appended since, less the last point, stands for this.
  void keep(const std::vector<Point>& out, std::size_t since, CurveSegment segment);

  ImportSettings settings_;
  double tolerance_;
  std::vector<KeptCurve> kept_;
  std::string file_;
  CurveCounts counts_, chorded_;
};

/// The B-spline's control points as those of Bezier curves, one for each span of its knots. Throws InputError with
/// `place` if the numbers do not fit each other.
std::vector<std::vector<ControlPoint>> bezier_spans(int degree, const std::vector<double>& knots,
                                                    const std::vector<ControlPoint>& control, const std::string& place);

}  // namespace taut::drawing
