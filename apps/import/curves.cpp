#include "import/curves.hpp"

#include <algorithm>
#include <cmath>

#include "import/open_lines.hpp"
#include "taut/error.hpp"

namespace taut::drawing {

namespace {

constexpr double full_turn = 2 * 3.14159265358979323846;
/// Of halving; the deviation that is left is reported anyhow.
constexpr int deepest = 30;

/// The longer half-axis of the ellipse: the largest singular value of (a b).
double longest_axis_of(const Point& a, const Point& b) {
  const double p = a.x * a.x + a.y * a.y, q = b.x * b.x + b.y * b.y, r = a.x * b.x + a.y * b.y;
  return std::sqrt((p + q + std::hypot(p - q, 2 * r)) / 2);
}

/// What a cosine's rounding leaves of zero is zero: points on the axes of circles are those that were meant.
double cleaned(double x) { return std::fabs(x) < 1e-15 ? 0 : x; }

Point on_ellipse(const Point& centre, const Point& a, const Point& b, double t) {
  const double c = cleaned(std::cos(t)), s = cleaned(std::sin(t));
  return {centre.x + c * a.x + s * b.x, centre.y + c * a.y + s * b.y};
}

/// The ellipse of cos(t) a + sin(t) b as SVG gives it.
struct HalfAxes {
  double longer = 0, shorter = 0, degrees = 0;
  bool mirrored = false;  ///< it runs clockwise
};

HalfAxes half_axes_of(const Point& a, const Point& b) {
  const double p = a.x * a.x + a.y * a.y, q = b.x * b.x + b.y * b.y, r = a.x * b.x + a.y * b.y;
  HalfAxes axes;
  axes.mirrored = a.x * b.y - a.y * b.x < 0;
  if (r == 0) {
    axes.longer = a.y == 0 ? std::fabs(a.x) : a.x == 0 ? std::fabs(a.y) : std::sqrt(p);
    axes.shorter = b.y == 0 ? std::fabs(b.x) : b.x == 0 ? std::fabs(b.y) : std::sqrt(q);
    if (std::fabs(axes.longer - axes.shorter) <= 4e-16 * axes.longer) axes.shorter = axes.longer;
    axes.degrees = axes.longer == axes.shorter ? 0 : std::atan2(a.y, a.x) * 360 / full_turn;
    return axes;
  }
  // The parameter at which cos(t) a + sin(t) b is longest.
  const double t = std::atan2(2 * r, p - q) / 2;
  const Point u = on_ellipse({0, 0}, a, b, t), v = on_ellipse({0, 0}, a, b, t + full_turn / 4);
  axes.longer = std::hypot(u.x, u.y);
  axes.shorter = std::hypot(v.x, v.y);
  const bool round = std::fabs(axes.longer - axes.shorter) <= 1e-15 * axes.longer;
  if (round) axes.shorter = axes.longer;
  axes.degrees = round ? 0 : std::atan2(u.y, u.x) * 360 / full_turn;
  return axes;
}

ControlPoint between(const ControlPoint& a, const ControlPoint& b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.w + t * (b.w - a.w)};
}

/// The polar form of the span [knots[k], knots[k + 1]] at these parameters, by de Boor's scheme.
ControlPoint blossom(std::size_t k, std::size_t degree, const std::vector<double>& knots,
                     const std::vector<ControlPoint>& control, const std::vector<double>& at) {
  std::vector<ControlPoint> d(control.begin() + static_cast<std::ptrdiff_t>(k - degree),
                              control.begin() + static_cast<std::ptrdiff_t>(k + 1));
  for (std::size_t r = 1; r <= degree; ++r) {
    for (std::size_t j = degree; j >= r; --j) {
      const double low = knots[j + k - degree], high = knots[j + 1 + k - r];
      d[j] = between(d[j - 1], d[j], (at[r - 1] - low) / (high - low));
    }
  }
  return d[degree];
}

}  // namespace

void Flattener::fail_size() const {
  throw InputError(file_, "curves would become more than " + std::to_string(settings_.max_points) + " chords",
                   "allow more with --tolerance, or check the drawing's units and --scale");
}

void Flattener::append(std::vector<Point>& out, const Point& p) {
  if (++counts_.chords > settings_.max_points) fail_size();
  out.push_back(p);
}

int Flattener::steps(double longest_axis, double sweep) {
  // 1 - cos h = 2 sin^2(h/2), h half the step: at most a sixth of a turn, so that a circle is at least a triangle.
  const double sine = std::min(0.5, std::sqrt(tolerance_ / (2 * longest_axis)));
  const double count = std::max(1.0, std::ceil(std::fabs(sweep) / (4 * std::asin(sine))));
  if (!(count < static_cast<double>(settings_.max_points))) fail_size();
  const double half = std::sin(std::fabs(sweep) / (4 * count));
  counts_.deviation = std::max(counts_.deviation, longest_axis * 2 * half * half);
  return static_cast<int>(count);
}

void Flattener::arc(std::vector<Point>& out, const Point& centre, const Point& a, const Point& b, double from,
                    double sweep, const Point& end) {
  if (settings_.curves) {
    ++counts_.segments;
    const int parts = static_cast<int>(std::max(1.0, std::ceil(std::fabs(sweep) * 4 / full_turn - 1e-9)));
    for (int i = 0; i < parts; ++i) {
      const double at = from + sweep * i / parts, to = from + sweep * (i + 1) / parts;
      keep_arc(out, centre, a, b, at, to - at, i + 1 == parts ? end : on_ellipse(centre, a, b, to));
    }
    return;
  }
  const int n = steps(longest_axis_of(a, b), sweep);
  ++counts_.segments;
  for (int i = 1; i < n; ++i) {
    const double t = from + sweep * i / n, c = std::cos(t), s = std::sin(t);
    append(out, {centre.x + c * a.x + s * b.x, centre.y + c * a.y + s * b.y});
  }
  append(out, end);
}

void Flattener::keep(const std::vector<Point>& out, std::size_t since, CurveSegment segment) {
  if (out.size() < since + 2) return;
  kept_.push_back({{out.begin() + static_cast<std::ptrdiff_t>(since), out.end() - 1}, std::move(segment)});
}

void Flattener::keep_arc(std::vector<Point>& out, const Point& centre, const Point& a, const Point& b, double from,
                         double sweep, const Point& end) {
  const int n = std::max(2, steps(longest_axis_of(a, b), sweep));
  const std::size_t since = out.size();
  for (int i = 1; i <= n; ++i) append(out, i == n ? end : on_ellipse(centre, a, b, from + sweep * i / n));
  const HalfAxes axes = half_axes_of(a, b);
  keep(out, since, ArcTo{axes.longer, axes.shorter, axes.degrees, false, (sweep > 0) != axes.mirrored, end});
}

void Flattener::ellipse(std::vector<Point>& out, const Point& centre, const Point& a, const Point& b) {
  arc(out, centre, a, b, 0, full_turn, {centre.x + a.x, centre.y + a.y});
}

void Flattener::bezier(std::vector<Point>& out, const std::vector<ControlPoint>& control) {
  ++counts_.segments;
  const auto even = [&](const ControlPoint& c) { return c.w == control[0].w; };
  const bool kept = settings_.curves && (control.size() == 3 || control.size() == 4) &&
                    std::all_of(control.begin(), control.end(), even);
  const std::size_t since = out.size();
  const double others = std::exchange(counts_.deviation, 0);
  halve(out, control, 0, kept ? 1 : 0);
  if (settings_.curves && !kept && control.size() > 2) {
    ++chorded_.segments;
    chorded_.chords += out.size() - since;
    chorded_.deviation = std::max(chorded_.deviation, counts_.deviation);
  }
  counts_.deviation = std::max(counts_.deviation, others);
  if (!kept) return;
  const Point end = control.back().point(), first = control[1].point();
  if (control.size() == 3) return keep(out, since, QuadraticTo{first, end});
  keep(out, since, CubicTo{first, control[2].point(), end});
}

void Flattener::halve(std::vector<Point>& out, std::vector<ControlPoint> control, int depth, int least) {
  const Point first = control.front().point(), last = control.back().point();
  double away = 0;
  for (const ControlPoint& c : control) away = std::max(away, distance_to_segment(c.point(), first, last));
  if (depth >= least && (!(away > tolerance_) || depth == deepest)) {
    counts_.deviation = std::max(counts_.deviation, away);
    return append(out, last);
  }
  // De Casteljau: the first half's control points are found as the others shrink to the second half's.
  std::vector<ControlPoint> left{control.front()};
  for (std::size_t n = control.size(); n > 1; --n) {
    for (std::size_t i = 0; i + 1 < n; ++i) control[i] = between(control[i], control[i + 1], 0.5);
    left.push_back(control[0]);
  }
  halve(out, std::move(left), depth + 1, least);
  halve(out, std::move(control), depth + 1, least);
}

std::vector<std::vector<ControlPoint>> bezier_spans(int degree, const std::vector<double>& knots,
                                                    const std::vector<ControlPoint>& control,
                                                    const std::string& place) {
  const std::string remedy = "save the drawing anew, or turn the spline into a polyline";
  if (degree < 1 || degree > 20) throw InputError(place, "a spline of degree " + std::to_string(degree), remedy);
  const std::size_t p = static_cast<std::size_t>(degree), n = control.size();
  if (n < p + 1 || knots.size() != n + p + 1) {
    throw InputError(place,
                     "a spline of degree " + std::to_string(degree) + " with " + std::to_string(n) +
                         " control points has " + std::to_string(knots.size()) + " knots",
                     remedy);
  }
  if (!std::is_sorted(knots.begin(), knots.end())) throw InputError(place, "the spline's knots decrease", remedy);
  std::vector<std::vector<ControlPoint>> spans;
  for (std::size_t k = p; k < n; ++k) {
    if (knots[k] == knots[k + 1]) continue;
    std::vector<ControlPoint> span;
    for (std::size_t j = 0; j <= p; ++j) {
      std::vector<double> at(p, knots[k]);
      std::fill(at.begin(), at.begin() + static_cast<std::ptrdiff_t>(j), knots[k + 1]);
      span.push_back(blossom(k, p, knots, control, at));
    }
    spans.push_back(std::move(span));
  }
  if (spans.empty()) throw InputError(place, "all knots of the spline are equal", remedy);
  return spans;
}

}  // namespace taut::drawing
