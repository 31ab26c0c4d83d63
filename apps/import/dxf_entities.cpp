#include "import/dxf_entities.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "import/fit_spline.hpp"
#include "taut/error.hpp"

namespace taut::drawing {

namespace {

constexpr double dxf_turn = 2 * 3.14159265358979323846;

Chain closed_ellipse(const DxfItem& item, const Affine& where, Flattener& flattener, const Point& centre,
                     const Point& a, const Point& b) {
  Chain chain{{}, true, item.place()};
  flattener.ellipse(chain.points, where(centre), where.turn(a), where.turn(b));
  return chain;
}

Chain open_ellipse(const DxfItem& item, const Affine& where, Flattener& flattener, const Point& centre, const Point& a,
                   const Point& b, double from, double sweep) {
  const auto at = [&](double t) {
    const double c = std::cos(t), s = std::sin(t);
    return where({centre.x + c * a.x + s * b.x, centre.y + c * a.y + s * b.y});
  };
  Chain chain{{at(from)}, false, item.place()};
  flattener.arc(chain.points, where(centre), where.turn(a), where.turn(b), from, sweep, at(from + sweep));
  return chain;
}

/// From one angle counterclockwise to the other.
double sweep_between(double from, double to) {
  const double sweep = std::fmod(to - from, dxf_turn);
  return sweep <= 0 ? sweep + dxf_turn : sweep;
}

/// Programs write 2 pi, or 360 degrees, with as few as five digits; rounded up, it is a full turn and no sliver of one.
bool is_full_turn(double from, double to) {
  const double beyond = std::fabs(to - from) - dxf_turn;
  return beyond > -1e-9 && beyond < 1e-4;
}

Chain circle_of(const DxfItem& item, const Affine& where, Flattener& flattener) {
  const double r = item.number(40);
  return closed_ellipse(item, where, flattener, item.point(10), {r, 0}, {0, r});
}

Chain arc_of(const DxfItem& item, const Affine& where, Flattener& flattener) {
  constexpr double degree = dxf_turn / 360;
  const double r = item.number(40), from = item.number(50) * degree, to = item.number(51, 360) * degree;
  if (is_full_turn(from, to)) return circle_of(item, where, flattener);
  return open_ellipse(item, where, flattener, item.point(10), {r, 0}, {0, r}, from, sweep_between(from, to));
}

Chain ellipse_of(const DxfItem& item, const Affine& where, Flattener& flattener) {
  const Point a = item.point(11);
  const double ratio = item.number(40, 1) * (item.number(230, 1) < 0 ? -1 : 1);
  const Point b{-a.y * ratio, a.x * ratio};
  const double from = item.number(41, 0), to = item.number(42, dxf_turn);
  if (is_full_turn(from, to)) return closed_ellipse(item, where, flattener, item.point(10), a, b);
  return open_ellipse(item, where, flattener, item.point(10), a, b, from, sweep_between(from, to));
}

/// Of a direction; programs write (0, 0, 0) for none.
std::optional<Point> tangent_of(const DxfItem& item, int code) {
  const Point tangent = item.point(code);
  if (tangent == Point{}) return std::nullopt;
  return tangent;
}

/// A spline without control points. The degree that the entity states does not count: what passes through points is
/// cubic, as ezdxf documents it (fit_points_to_cad_cv).
Chain fitted_spline_of(const DxfItem& item, const Affine& where, Flattener& flattener) {
  const bool closed = (item.integer(70) & 1) != 0;
  const auto curves = fit_spline({item.points(11), tangent_of(item, 12), tangent_of(item, 13), closed});
  if (curves.empty())
    throw InputError(item.place(), "the spline has neither control points nor two points that it passes through",
                     "turn the spline into a polyline");
  Chain chain{{where(curves.front().front())}, false, item.place()};
  for (const auto& curve : curves) {
    std::vector<ControlPoint> control;
    for (const Point& p : curve) control.push_back({where(p).x, where(p).y, 1});
    flattener.bezier(chain.points, control);
  }
  chain.closed = closed && chain.points.front() == chain.points.back();
  return chain;
}

Chain spline_of(const DxfItem& item, const Affine& where, Flattener& flattener) {
  const std::vector<Point> points = item.points(10);
  if (points.empty()) return fitted_spline_of(item, where, flattener);
  const std::vector<double> weights = item.numbers(41);
  if (!weights.empty() && weights.size() != points.size())
    throw InputError(item.place(), "the spline has more or fewer weights than control points",
                     "turn the spline into a polyline");
  std::vector<ControlPoint> control;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double w = weights.empty() ? 1 : weights[i];
    // Far from 1, points that differ are the same in doubles.
    if (!(w > 1e-100 && w < 1e100))
      throw InputError(item.place(), "the spline has a weight that is not positive", "turn it into a polyline");
    const Point p = where(points[i]);
    control.push_back({p.x * w, p.y * w, w});
  }
  const auto spans = bezier_spans(item.integer(71), item.numbers(40), control, item.place());
  Chain chain{{spans.front().front().point()}, false, item.place()};
  for (const auto& span : spans) flattener.bezier(chain.points, span);
  const bool closed = (item.integer(70) & 1) != 0;
  if (closed && chain.points.size() > 2 && chain.points.front() == chain.points.back()) chain.closed = true;
  return chain;
}

}  // namespace

std::optional<Affine> own_plane(const DxfItem& item) {
  const double x = item.number(210, 0), y = item.number(220, 0), z = item.number(230, 1);
  if (std::fabs(x) > 1e-9 || std::fabs(y) > 1e-9 || z == 0) return std::nullopt;
  return z > 0 ? Affine{} : scaling(-1, 1);
}

bool is_annotation(const DxfItem& item) {
  static const std::set<std::string> types{"TEXT",
                                           "MTEXT",
                                           "RTEXT",
                                           "ARCALIGNEDTEXT",
                                           "ATTRIB",
                                           "ATTDEF",
                                           "DIMENSION",
                                           "LEADER",
                                           "MULTILEADER",
                                           "MLEADER",
                                           "TOLERANCE",
                                           "ACAD_TABLE",
                                           "POINT",
                                           "XLINE",
                                           "RAY",
                                           "VIEWPORT",
                                           "IMAGE",
                                           "WIPEOUT",
                                           "OLEFRAME",
                                           "OLE2FRAME",
                                           "PDFUNDERLAY",
                                           "DWFUNDERLAY",
                                           "DGNUNDERLAY",
                                           "PDFREFERENCE",
                                           "LIGHT",
                                           "SUN",
                                           "CAMERA",
                                           "SECTION",
                                           "ARC_DIMENSION",
                                           "LARGE_RADIAL_DIMENSION",
                                           "GEOPOSITIONMARKER"};
  return types.count(item.type()) != 0;
}

std::vector<Point> corners_of(const DxfItem& item, const Affine& where) {
  static const std::map<std::string, int> last_code{{"LINE", 11},  {"SPLINE", 11}, {"3DFACE", 13},
                                                    {"MLINE", 11}, {"MESH", 10},   {"VERTEX", 10}};
  const auto last = last_code.find(item.type());
  if (last == last_code.end()) return {};
  std::vector<Point> corners;
  try {
    for (int code = 10; code <= last->second; ++code)
      for (const Point& p : item.points(code)) corners.push_back(where(p));
  } catch (const InputError&) {
    return {};
  }
  return corners;
}

void Heights::include(const DxfItem& item) {
  const auto add = [this](double z) {
    lo = std::min(lo, z);
    hi = std::max(hi, z);
  };
  // Of an ellipse, 31 is a direction.
  const bool ends = item.type() == "LINE", many = item.type() == "SPLINE";
  bool any = false;
  for (const DxfGroup& group : item.groups()) {
    if (group.code != 30 && group.code != 38 && !(group.code == 31 && (ends || many))) continue;
    add(item.number_of(group));
    any = true;
  }
  if (!any) add(0);
}

bool ends_at_its_start(const DxfItem& item) {
  if (item.type() == "ARC") return item.number(50) == item.number(51, 360);
  return item.type() == "ELLIPSE" && item.number(41, 0) == item.number(42, dxf_turn);
}

std::vector<BulgedVertex> vertices_of(const DxfItem& lwpolyline) {
  std::vector<BulgedVertex> vertices;
  for (const DxfGroup& group : lwpolyline.groups()) {
    if (group.code == 10) vertices.push_back({{lwpolyline.number_of(group), 0}, 0});
    if (vertices.empty()) continue;
    if (group.code == 20) vertices.back().at.y = lwpolyline.number_of(group);
    if (group.code == 42) vertices.back().bulge = lwpolyline.number_of(group);
  }
  return vertices;
}

Chain bulged_chain(const std::vector<BulgedVertex>& vertices, bool closed, const std::string& place,
                   const Affine& where, Flattener& flattener) {
  Chain chain{{}, closed, place};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (i == 0) chain.points.push_back(where(vertices[0].at));
    if (i + 1 == vertices.size() && !closed) break;
    const Point p = vertices[i].at, q = vertices[(i + 1) % vertices.size()].at;
    const double bulge = vertices[i].bulge;
    if (bulge == 0 || p == q) {
      chain.points.push_back(where(q));
      continue;
    }
    // The centre is beside the middle of the chord; the angle is four times that of the bulge.
    const double beside = (1 / bulge - bulge) / 4;
    const Point centre{(p.x + q.x) / 2 - beside * (q.y - p.y), (p.y + q.y) / 2 + beside * (q.x - p.x)};
    const Point a{p.x - centre.x, p.y - centre.y}, b{-a.y, a.x};
    flattener.arc(chain.points, where(centre), where.turn(a), where.turn(b), 0, 4 * std::atan(bulge), where(q));
  }
  return chain;
}

std::optional<Chain> chain_of(const DxfItem& item, const Affine& where, Flattener& flattener) {
  const std::string& type = item.type();
  if (type == "LINE") return Chain{{where(item.point(10)), where(item.point(11))}, false, item.place()};
  if (type == "LWPOLYLINE")
    return bulged_chain(vertices_of(item), (item.integer(70) & 1) != 0, item.place(), where, flattener);
  if (type == "ARC") return arc_of(item, where, flattener);
  if (type == "CIRCLE") return circle_of(item, where, flattener);
  if (type == "ELLIPSE") return ellipse_of(item, where, flattener);
  if (type == "SPLINE") return spline_of(item, where, flattener);
  return std::nullopt;
}

}  // namespace taut::drawing
