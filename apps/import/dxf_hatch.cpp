#include "import/dxf_hatch.hpp"

#include <algorithm>
#include <cmath>

#include "import/dxf_entities.hpp"
#include "import/faces.hpp"
#include "taut/error.hpp"

namespace taut::drawing {

namespace {

constexpr double hatch_turn = 2 * 3.14159265358979323846;
constexpr int most_values = 1000000;

/// Reads groups in their order: what they mean depends on those before.
class HatchReader {
 public:
  HatchReader(const DxfItem& item, const Affine& where, Flattener& flattener)
      : item_(item), where_(where), flattener_(flattener) {}

  std::vector<Chain> read() {
    std::vector<Chain> chains;
    seek(91);
    const int paths = count(91);
    for (int k = 0; k < paths; ++k) {
      seek(92);
      const int kind = count(92);
      chain_ = {{}, true, item_.place()};
      constexpr int text_box = 8;
      // MPOLYGON has polylines only, whose kind says so, too.
      if ((kind & 2) != 0 || item_.type() == "MPOLYGON")
        polyline();
      else
        edges();
      if (chain_.points.size() > 1 && chain_.points.front() == chain_.points.back()) chain_.points.pop_back();
      // The room for a text in a filling is no hole in the material.
      if (chain_.points.size() > 1 && (kind & text_box) == 0) chains.push_back(std::move(chain_));
    }
    return chains;
  }

 private:
  const std::vector<DxfGroup>& groups() const { return item_.groups(); }

  [[noreturn]] void fail() const {
    throw InputError(item_.place(), "the boundary of the " + item_.type() + " cannot be read",
                     "draw the boundary as a closed polyline");
  }

  void seek(int code) {
    while (next_ < groups().size() && groups()[next_].code != code) ++next_;
    if (next_ == groups().size()) fail();
  }
  bool is(int code) const { return next_ < groups().size() && groups()[next_].code == code; }
  double number(int code) {
    if (!is(code)) fail();
    return item_.number_of(groups()[next_++]);
  }
  double number_or(int code, double otherwise) { return is(code) ? number(code) : otherwise; }
  int count(int code) {
    const double n = number(code);
    if (!(n >= 0 && n <= most_values)) fail();
    return static_cast<int>(n);
  }
  Point point(int code) {
    const double x = number(code), y = number(code + 10);
    return {x, y};
  }

  void polyline() {
    std::vector<BulgedVertex> vertices;
    // HATCH says first whether there are bulges, MPOLYGON whether it is closed, which it is.
    number_or(73, 1);
    const bool bulges = number_or(72, 0) != 0;
    number_or(73, 1);
    const int n = count(93);
    for (int i = 0; i < n; ++i) {
      const Point p = point(10);
      vertices.push_back({p, bulges ? number_or(42, 0) : 0});
    }
    chain_ = bulged_chain(vertices, true, item_.place(), where_, flattener_);
  }

  void edges() {
    const int n = count(93);
    for (int i = 0; i < n; ++i) {
      // Points that a spline passes through may stand in between.
      seek(72);
      switch (count(72)) {
        case 1:
          begin(point(10));
          chain_.points.push_back(where_(point(11)));
          break;
        case 2:
          arc(false);
          break;
        case 3:
          arc(true);
          break;
        case 4:
          spline();
          break;
        default:
          fail();
      }
    }
  }

  /// The start of an edge is the end of the one before, but for rounding.
  void begin(const Point& p) {
    if (chain_.points.empty()) chain_.points.push_back(where_(p));
  }

  void arc(bool ellipse) {
    const Point centre = point(10);
    Point a;
    Point b;
    if (ellipse) {
      a = point(11);
      const double ratio = number(40);
      b = {-a.y * ratio, a.x * ratio};
    } else {
      const double r = number(40);
      a = {r, 0};
      b = {0, r};
    }
    const double from = number(50), to = number(51);
    // Clockwise arcs have their angles measured clockwise, too.
    const double sign = number_or(73, 1) != 0 ? 1 : -1;
    constexpr double degree = hatch_turn / 360;
    double sweep = (to - from) * degree;
    if (std::fabs(sweep) > hatch_turn) sweep = std::copysign(hatch_turn, sweep);
    const double start = sign * from * degree, end = start + sign * sweep;
    const auto at = [&](double t) {
      return Point{centre.x + std::cos(t) * a.x + std::sin(t) * b.x, centre.y + std::cos(t) * a.y + std::sin(t) * b.y};
    };
    begin(at(start));
    flattener_.arc(chain_.points, where_(centre), where_.turn(a), where_.turn(b), start, end - start, where_(at(end)));
  }

  void spline() {
    const int degree = count(94);
    const bool rational = number(73) != 0;
    number_or(74, 0);
    const int knot_count = count(95), control_count = count(96);
    std::vector<double> knots;
    for (int i = 0; i < knot_count; ++i) knots.push_back(number(40));
    std::vector<ControlPoint> control;
    for (int i = 0; i < control_count; ++i) {
      const Point p = where_(point(10));
      const double w = rational ? number_or(42, 1) : 1;
      if (!(w > 1e-100 && w < 1e100)) fail();
      control.push_back({p.x * w, p.y * w, w});
    }
    const auto spans = bezier_spans(degree, knots, control, item_.place());
    if (chain_.points.empty()) chain_.points.push_back(spans.front().front().point());
    for (const auto& span : spans) flattener_.bezier(chain_.points, span);
  }

  const DxfItem& item_;
  const Affine& where_;
  Flattener& flattener_;
  std::size_t next_ = 0;
  Chain chain_;
};

}  // namespace

Chain solid_boundary(const DxfItem& item, const Affine& where) {
  std::vector<Point> corners{item.point(10), item.point(11)};
  // The third corner lies opposite of the second one; a triangle repeats it, or leaves the fourth one out.
  if (item.has(13)) corners.push_back(item.point(13));
  corners.push_back(item.point(12));
  Chain chain{{}, true, item.place()};
  for (const Point& p : corners)
    if (chain.points.empty() || !(where(p) == chain.points.back())) chain.points.push_back(where(p));
  return chain;
}

Fill fill_of_hatch(const DxfItem& item) {
  const int style = item.type() == "HATCH" ? item.integer(75) : 0;
  return style == 1 ? Fill::once : style == 2 ? Fill::nonzero : Fill::even_odd;
}

std::vector<Chain> hatch_boundaries(const DxfItem& item, const Affine& where, Flattener& flattener) {
  std::vector<Chain> chains = HatchReader(item, where, flattener).read();
  // With all of them counterclockwise, a point is wound around as often as boundaries go around it.
  for (Chain& chain : chains)
    if (doubled_area(chain.points) < 0) std::reverse(chain.points.begin(), chain.points.end());
  return chains;
}

}  // namespace taut::drawing
