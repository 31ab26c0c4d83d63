// Clean drawings, damaged as drawings are: the import finds the clean areas again, or says that it does not.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "support/drawings.hpp"
#include "support/effort.hpp"

namespace taut {
namespace {

constexpr double pi_here = 3.14159265358979323846;
/// The defaults for drawings in millimetres, of the size of these.
constexpr double usual_tolerance = 0.01, usual_join = 0.02;

/// A straight line, or a circular arc: counterclockwise around `centre` for `sweep` radians.
struct Stroke {
  Point from, to;
  Point centre;
  double radius = 0, start = 0, sweep = 0;
  bool curved() const { return radius > 0; }
};

using Contour = std::vector<Stroke>;

struct Clean {
  std::vector<Contour> contours;
  double area = 0, around = 0;
  std::size_t parts = 0;
  bool shares_cuts = false;
};

class Damage {
 public:
  explicit Damage(std::uint64_t seed) : random_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(uniform(0, static_cast<double>(n))); }
  bool chance(double p) { return uniform(0, 1) < p; }

  Clean draw() {
    Clean clean;
    const std::size_t n = 1 + below(4);
    for (std::size_t k = 0; k < n; ++k)
      add_shape(clean, {120.0 * static_cast<double>(k % 2), 120.0 * static_cast<double>(k / 2)});
    const double angle = chance(0.3) ? 0 : uniform(0, 2 * pi_here);
    for (Contour& contour : clean.contours)
      for (Stroke& stroke : contour) turn(stroke, angle);
    return clean;
  }

  /// Every contour in pieces, in any order.
  std::vector<Stroke> pieces(const Clean& clean) {
    std::vector<Stroke> all;
    for (const Contour& contour : clean.contours)
      for (const Stroke& stroke : contour) split(stroke, all);
    return all;
  }

  void repeat(std::vector<Stroke>& strokes) {
    const std::size_t n = strokes.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (!chance(0.15)) continue;
      Stroke again = strokes[i];
      // Some only in part.
      if (!again.curved() && chance(0.5)) {
        const double a = uniform(0, 0.4), b = uniform(0.6, 1);
        again.from = between(strokes[i], a);
        again.to = between(strokes[i], b);
      }
      strokes.push_back(again);
    }
  }

  /// Both ends of straight lines, in such a way that no two ends that were one are farther apart than the distance.
  void loosen(std::vector<Stroke>& strokes, double distance) {
    for (Stroke& stroke : strokes) {
      if (stroke.curved()) continue;
      for (Point* end : {&stroke.from, &stroke.to}) {
        if (!chance(0.3)) continue;
        const double angle = uniform(0, 2 * pi_here), far = uniform(0, 0.45 * distance);
        end->x += far * std::cos(angle);
        end->y += far * std::sin(angle);
      }
    }
  }

  /// Small loops at ends of lines.
  void add_loops(std::vector<Stroke>& strokes) {
    const std::size_t n = strokes.size();
    for (std::size_t i = 0; i < n; ++i) {
      if (strokes[i].curved() || !chance(0.1)) continue;
      const Point p = strokes[i].to;
      const double angle = uniform(0, 2 * pi_here), size = uniform(0.05, 0.07);
      const Point q{p.x + size * std::cos(angle), p.y + size * std::sin(angle)};
      const Point r{p.x + size * std::cos(angle + 1), p.y + size * std::sin(angle + 1)};
      for (const auto& [from, to] : {std::pair(p, q), {q, r}, {r, p}}) strokes.push_back({from, to, {}, 0, 0, 0});
    }
  }

  std::string dxf(std::vector<Stroke> strokes, std::size_t layers) {
    for (std::size_t i = strokes.size(); i-- > 1;) std::swap(strokes[i], strokes[below(i + 1)]);
    testing::DxfText text;
    constexpr double degrees = 180 / pi_here;
    for (Stroke& s : strokes) {
      const std::string layer = "layer " + std::to_string(below(layers));
      if (s.curved())
        text.arc(s.centre, s.radius, s.start * degrees, (s.start + s.sweep) * degrees, layer);
      else if (chance(0.5))
        text.line(s.from, s.to, layer);
      else
        text.line(s.to, s.from, layer);
    }
    return text.file();
  }

  static Point between(const Stroke& s, double t) {
    return {s.from.x + t * (s.to.x - s.from.x), s.from.y + t * (s.to.y - s.from.y)};
  }

 private:
  static Contour polygon(const std::vector<Point>& corners) {
    Contour contour;
    for (std::size_t i = 0; i < corners.size(); ++i)
      contour.push_back({corners[i], corners[(i + 1) % corners.size()], {}, 0, 0, 0});
    return contour;
  }
  static Contour box(const Point& p, double w, double h) {
    return polygon({p, {p.x + w, p.y}, {p.x + w, p.y + h}, {p.x, p.y + h}});
  }
  static Contour circle(const Point& c, double r) {
    const Point right{c.x + r, c.y}, left{c.x - r, c.y};
    return {{right, left, c, r, 0, pi_here}, {left, right, c, r, pi_here, pi_here}};
  }
  static double length_of(const Contour& contour) {
    double sum = 0;
    for (const Stroke& s : contour)
      sum += s.curved() ? s.radius * s.sweep : std::hypot(s.to.x - s.from.x, s.to.y - s.from.y);
    return sum;
  }
  static void put(Clean& clean, Contour contour, double area) {
    clean.around += length_of(contour);
    clean.area += area;
    clean.contours.push_back(std::move(contour));
  }

  void add_shape(Clean& clean, const Point& p) {
    const double w = uniform(40, 90), h = uniform(40, 90);
    switch (below(6)) {
      case 0: {  // a plate with holes
        put(clean, box(p, w, h), w * h);
        const double r = uniform(2, 6);
        put(clean, circle({p.x + 10, p.y + 10}, r), -pi_here * r * r);
        put(clean, circle({p.x + w - 10, p.y + h - 10}, r), -pi_here * r * r);
        ++clean.parts;
        break;
      }
      case 1: {  // a frame with an island
        put(clean, box(p, w, h), w * h);
        put(clean, box({p.x + 5, p.y + 5}, w - 10, h - 10), -(w - 10) * (h - 10));
        put(clean, circle({p.x + w / 2, p.y + h / 2}, 8), pi_here * 64);
        clean.parts += 2;
        break;
      }
      case 2: {  // squares in a row that share their cuts
        const std::size_t n = 2 + below(4);
        const double side = 90.0 / static_cast<double>(n);
        for (std::size_t i = 0; i < n; ++i) {
          Contour square = box({p.x + side * static_cast<double>(i), p.y}, side, h);
          if (i > 0) square.erase(square.begin() + 3);
          put(clean, square, side * h);
        }
        clean.parts += n;
        clean.shares_cuts = true;
        break;
      }
      case 3: {  // a slot
        const double r = uniform(5, 15);
        const Point a{p.x + r, p.y + r}, b{p.x + r + w / 2, p.y + r};
        put(clean,
            {{{a.x, a.y - r}, {b.x, b.y - r}, {}, 0, 0, 0},
             {{b.x, b.y - r}, {b.x, b.y + r}, b, r, -pi_here / 2, pi_here},
             {{b.x, b.y + r}, {a.x, a.y + r}, {}, 0, 0, 0},
             {{a.x, a.y + r}, {a.x, a.y - r}, a, r, pi_here / 2, pi_here}},
            pi_here * r * r + w * r);
        ++clean.parts;
        break;
      }
      case 4: {  // a star
        std::vector<Point> corners;
        const std::size_t n = 5 + below(12);
        double area = 0;
        for (std::size_t i = 0; i < n; ++i) {
          const double angle = 2 * pi_here * static_cast<double>(i) / static_cast<double>(n), r = uniform(15, 45);
          corners.push_back({p.x + 45 + r * std::cos(angle), p.y + 45 + r * std::sin(angle)});
        }
        for (std::size_t i = 0; i < n; ++i) {
          const Point &a = corners[i], &b = corners[(i + 1) % n];
          area += (a.x * b.y - a.y * b.x) / 2;
        }
        put(clean, polygon(corners), area);
        ++clean.parts;
        break;
      }
      default:
        put(clean, circle({p.x + 40, p.y + 40}, w / 2), pi_here * w * w / 4);
        ++clean.parts;
    }
  }

  static void turn(Stroke& s, double angle) {
    const double c = std::cos(angle), d = std::sin(angle);
    for (Point* p : {&s.from, &s.to, &s.centre}) *p = {c * p->x - d * p->y, d * p->x + c * p->y};
    s.start += angle;
  }

  void split(const Stroke& stroke, std::vector<Stroke>& out) {
    const std::size_t n = chance(0.3) ? 2 + below(3) : 1;
    for (std::size_t i = 0; i < n; ++i) {
      const double a = static_cast<double>(i) / static_cast<double>(n),
                   b = static_cast<double>(i + 1) / static_cast<double>(n);
      Stroke piece = stroke;
      piece.start = stroke.start + a * stroke.sweep;
      piece.sweep = (b - a) * stroke.sweep;
      if (!stroke.curved()) {
        piece.from = i == 0 ? stroke.from : between(stroke, a);
        piece.to = i + 1 == n ? stroke.to : between(stroke, b);
      }
      out.push_back(piece);
    }
  }

  std::mt19937_64 random_;
};

void expect_clean(const drawing::Import& import, const Clean& clean, double width, std::uint64_t seed) {
  const testing::Totals totals = testing::totals_of(import);
  ASSERT_TRUE(import.faults.empty()) << seed << ": " << import.faults.front().what();
  ASSERT_EQ(totals.parts, clean.parts) << seed << "\n" << drawing::report_text(import, {});
  ASSERT_NEAR(totals.area, clean.area, clean.around * width) << seed << "\n" << drawing::report_text(import, {});
}

TEST(ImportDamage, FindsTheCleanAreasAgain) {
  for (std::uint64_t seed = 0; seed < testing::effort(8000); ++seed) {
    Damage damage(seed);
    const Clean clean = damage.draw();
    std::vector<Stroke> strokes = damage.pieces(clean);
    if (damage.chance(0.7)) damage.repeat(strokes);
    if (damage.chance(0.7))
      damage.loosen(strokes, usual_join);
    else
      damage.add_loops(strokes);
    const std::string text = damage.dxf(strokes, damage.chance(0.3) ? 3 : 1);
    expect_clean(testing::examine(text, "d.dxf"), clean, usual_tolerance + usual_join, seed);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

/// A contour with a gap wider than the distance: that is an error, and with --open close the area is found again.
TEST(ImportDamage, NeverDropsAnOutlineSilently) {
  for (std::uint64_t seed = 0; seed < testing::effort(2000); ++seed) {
    Damage damage(seed + 1000000);
    const Clean clean = damage.draw();
    std::vector<Stroke> strokes = damage.pieces(clean);
    std::vector<std::size_t> straight;
    for (std::size_t i = 0; i < strokes.size(); ++i)
      if (!strokes[i].curved() &&
          std::hypot(strokes[i].to.x - strokes[i].from.x, strokes[i].to.y - strokes[i].from.y) > 4)
        straight.push_back(i);
    if (straight.empty()) continue;
    Stroke& broken = strokes[straight[damage.below(straight.size())]];
    const double length = std::hypot(broken.to.x - broken.from.x, broken.to.y - broken.from.y);
    broken.to = Damage::between(broken, 1 - damage.uniform(3 * usual_join, 3) / length);
    const std::string text = damage.dxf(strokes, 1);
    const drawing::Import import = testing::examine(text, "d.dxf");
    // A cut that two parts share may be missing: their outline is closed, and the rest of the cut is named.
    const std::size_t parts = testing::totals_of(import).parts;
    ASSERT_TRUE(!import.faults.empty() || parts + 1 == clean.parts) << seed << "\n" << drawing::report_text(import, {});
    ASSERT_FALSE(import.files[0].open.empty()) << seed;
    if (import.faults.empty()) continue;
    drawing::ImportSettings settings;
    settings.open = drawing::OpenRings::close;
    expect_clean(testing::examine(text, "d.dxf", settings), clean, usual_tolerance + usual_join, seed);
    if (::testing::Test::HasFatalFailure()) return;
  }
}

/// A gap with a line across it, as centre lines are: that line is no part of the contour, and the gap remains one.
TEST(ImportDamage, LosesNoPlateWhoseGapIsCrossed) {
  for (std::uint64_t seed = 0; seed < testing::effort(2000); ++seed) {
    Damage damage(seed + 2000000);
    const Clean clean = damage.draw();
    // One of several parts that share cuts may stay open, as above.
    if (clean.shares_cuts) continue;
    std::vector<Stroke> strokes = damage.pieces(clean);
    std::vector<std::size_t> straight;
    for (std::size_t i = 0; i < strokes.size(); ++i)
      if (!strokes[i].curved() &&
          std::hypot(strokes[i].to.x - strokes[i].from.x, strokes[i].to.y - strokes[i].from.y) > 8)
        straight.push_back(i);
    if (straight.empty()) continue;
    const std::size_t chosen = straight[damage.below(straight.size())];
    const Stroke broken = strokes[chosen];
    const double length = std::hypot(broken.to.x - broken.from.x, broken.to.y - broken.from.y);
    const double gap = damage.uniform(3 * usual_join, 1.5);
    const Point along{(broken.to.x - broken.from.x) / length, (broken.to.y - broken.from.y) / length};
    const Point begin = Damage::between(broken, 0.5 - gap / 2 / length);
    const Point end = Damage::between(broken, 0.5 + gap / 2 / length);
    strokes[chosen].to = begin;
    strokes.push_back({end, broken.to, {}, 0, 0, 0});
    const Point middle{(begin.x + end.x) / 2, (begin.y + end.y) / 2};
    const double reach = gap * damage.uniform(0.3, 1);
    strokes.push_back({{middle.x - reach * along.y, middle.y + reach * along.x},
                       {middle.x + reach * along.y, middle.y - reach * along.x},
                       {},
                       0,
                       0,
                       0});
    const drawing::Import import = testing::examine(damage.dxf(strokes, 1), "d.dxf");
    ASSERT_FALSE(import.faults.empty()) << seed << "\n" << drawing::report_text(import, {});
  }
}

}  // namespace
}  // namespace taut
