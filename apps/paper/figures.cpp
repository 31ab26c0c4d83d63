// The paper's figures, from runs of the scenes in examples/paper/.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "kinetic/session.hpp"
#include "motion/placement.hpp"
#include "sheet.hpp"
#include "study.hpp"
#include "taut/io.hpp"
#include "taut/separator.hpp"
#include "taut/simulation.hpp"
#include "tree_picture.hpp"

namespace taut::paper {
namespace {

constexpr int panel_width = 440;

DrawOptions panel_options() {
  DrawOptions o;
  o.width = panel_width;
  o.legend = false;
  o.title.assign(1, ' ');
  return o;
}

Simulation at(const Scene& scene, double t) {
  Simulation simulation(scene);
  simulation.advance_to(t);
  return simulation;
}

const Point& position(const Tiling& tiling, int v) { return tiling.vertices[static_cast<std::size_t>(v)].position; }

/// The vertex of a body with this index of the input.
int find_vertex(const Tiling& tiling, int body, int index) {
  for (std::size_t i = 0; i < tiling.vertices.size(); ++i) {
    if (tiling.vertices[i].body == body && tiling.vertices[i].index == index) return static_cast<int>(i);
  }
  throw std::logic_error("no such vertex");
}

Point outwards(const Scene& scene, const Tiling& tiling, int v, double distance) {
  // Away from the body's middle, which is good enough for letters.
  const TilingVertex& vertex = tiling.vertices[static_cast<std::size_t>(v)];
  const std::size_t n = scene.bodies[static_cast<std::size_t>(vertex.body)].polygon.size();
  const Point a = position(
      tiling, find_vertex(tiling, vertex.body, static_cast<int>((static_cast<std::size_t>(vertex.index) + n - 1) % n)));
  const Point b = position(
      tiling, find_vertex(tiling, vertex.body, static_cast<int>((static_cast<std::size_t>(vertex.index) + 1) % n)));
  const Point& p = vertex.position;
  double dx = 2 * p.x - a.x - b.x, dy = 2 * p.y - a.y - b.y;
  const double turn = (p.x - a.x) * (b.y - p.y) - (p.y - a.y) * (b.x - p.x), length = std::hypot(dx, dy);
  const double side = turn > 0 ? 1 : -1;
  return {p.x + side * distance * dx / length, p.y + side * distance * dy / length};
}

// ----- Fig. 1 -----

/// The geodesic of the second half of P's boundary.
DrawnPath half_geodesic(const Simulation& simulation, const Tiling& tiling) {
  const GeodesicCycle cycle = simulation.geodesic_cycle(0, 1);
  DrawnPath path;
  path.kind = DrawnPath::Kind::come;
  for (std::size_t i = static_cast<std::size_t>(cycle.pinned[1]); i < cycle.vertices.size(); ++i)
    path.points.push_back(position(tiling, cycle.vertices[i]));
  path.points.push_back(position(tiling, cycle.vertices[0]));
  path.stars = {path.points.front(), path.points.back()};
  return path;
}

std::string figure_1(const Scene& scene) {
  Sheet sheet(2);
  for (const double t : {0.0, 1.0}) {
    const Simulation simulation = at(scene, t);
    const Tiling tiling = simulation.tiling();
    DrawOptions o = panel_options();
    o.faces = o.edges = o.certificates = false;
    o.paths = {half_geodesic(simulation, tiling)};
    const Point a = o.paths[0].points.front(), b = o.paths[0].points.back();
    o.labels = {{{a.x + 0.45, a.y - 0.1}, "a"}, {{b.x - 0.45, b.y + 0.2}, "b"}};
    sheet.add(draw_svg(scene, tiling, o), t == 0 ? "Q outside" : "Q in the cavity");
  }
  return sheet.draw();
}

// ----- Fig. 2 -----

/// The lasso, for hulls apart: from the pin clockwise along P's hull to the outer tangent, around Q, back by the inner
/// tangent, along the root pseudo-triangle's side of P's hull, and to the pin the way it came.
DrawnPath lasso(const Tiling& tiling, int pin) {
  const auto of_p = [&tiling](int v) { return tiling.vertices[static_cast<std::size_t>(v)].body == 0; };
  // Either face's boundary, begun where it comes back to P.
  const auto from_p = [&](FaceKind kind) {
    for (const TilingFace& face : tiling.faces) {
      if (face.kind != kind) continue;
      std::vector<int> b = face.boundary;
      std::size_t k = 0;
      while (!of_p(b[k]) || of_p(b[(k + b.size() - 1) % b.size()])) ++k;
      std::rotate(b.begin(), b.begin() + static_cast<std::ptrdiff_t>(k), b.end());
      return b;
    }
    throw std::logic_error("no such face");
  };
  const std::vector<int> outer = from_p(FaceKind::infinite);  // z ... y, q ... x
  std::vector<int> inner = from_p(FaceKind::root);            // y ... z, x ... q
  while (!of_p(inner.back())) inner.pop_back();
  const auto at_pin = std::find(outer.begin(), outer.end(), pin);
  if (at_pin == outer.end()) throw std::logic_error("the pin is not on the outer side of the hull");
  std::vector<int> loop(at_pin, outer.end());
  loop.insert(loop.end(), inner.rbegin(), inner.rend());
  for (auto i = std::find(at_pin, outer.end(), inner.front()); i != at_pin;) loop.push_back(*--i);
  DrawnPath path;
  path.kind = DrawnPath::Kind::come;
  for (const int v : loop) path.points.push_back(position(tiling, v));
  path.stars = {position(tiling, pin)};
  return path;
}

/// Of P's two diametral vertices, the one beyond which no point of Q lies (section 2.1).
std::array<int, 2> diametral_pair(const Tiling& tiling, int body) {
  std::array<int, 2> best{};
  double longest = 0;
  for (std::size_t i = 0; i < tiling.vertices.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const TilingVertex &a = tiling.vertices[i], &b = tiling.vertices[j];
      if (a.body != body || b.body != body) continue;
      const double d = std::hypot(a.position.x - b.position.x, a.position.y - b.position.y);
      if (d > longest) longest = d, best = {static_cast<int>(j), static_cast<int>(i)};
    }
  }
  return best;
}

bool beyond(const Tiling& tiling, int pin, int other, int body) {
  const Point a = position(tiling, pin), b = position(tiling, other);
  return std::any_of(tiling.vertices.begin(), tiling.vertices.end(), [&](const TilingVertex& v) {
    return v.body != body && (v.position.x - a.x) * (b.x - a.x) + (v.position.y - a.y) * (b.y - a.y) < 0;
  });
}

std::string figure_2(const Scene& scene) {
  Sheet sheet(2);
  int pin = -1;
  for (const double t : {0.0, 0.35, 0.7, 1.0}) {
    const Simulation simulation = at(scene, t);
    const Tiling tiling = simulation.tiling();
    const std::array<int, 2> pair = diametral_pair(tiling, 0);
    if (pin < 0) pin = beyond(tiling, pair[0], pair[1], 0) ? pair[1] : pair[0];
    const int other = pin == pair[0] ? pair[1] : pair[0];
    const bool moves = beyond(tiling, pin, other, 0);
    if (moves) pin = other;
    DrawOptions o = panel_options();
    o.faces = o.certificates = false;
    o.paths = {lasso(tiling, pin)};
    for (const int k : {0, 1}) {
      const Point p = position(tiling, pair[static_cast<std::size_t>(k)]);
      o.labels.push_back({{p.x + (p.x < 6 ? -0.9 : 0.9), p.y}, k == 0 ? "p1" : "p2"});
    }
    for (const Point& corner : {Point{-4, -2.4}, Point{16, 5.6}}) o.window.push_back(corner);
    sheet.add(draw_svg(scene, tiling, o),
              fmt::format("t = {}: pinned to {}{}", t, pin == pair[0] ? "p1" : "p2", moves ? ", just moved" : ""));
  }
  return sheet.draw();
}

// ----- Fig. 3 -----

std::string figure_3(const Scene& scene) {
  Sheet sheet(3);
  const Simulation simulation(scene);
  const Tiling tiling = simulation.tiling();
  DrawOptions o = panel_options();
  sheet.add(draw_svg(scene, tiling, o), "The tiling; PQ edges bold");
  for (int level = 0; level < 4; ++level) {
    DrawOptions dream = panel_options();
    dream.faces = dream.edges = dream.certificates = false;
    dream.paths = {drawn_cycle(tiling, simulation.geodesic_cycle(1, level))};
    sheet.add(draw_svg(scene, tiling, dream),
              level == 0 ? "Level 0: the relative convex hull of Q"
                         : fmt::format("Level {}: {} pinned vertices", level, dream.paths[0].stars.size()));
  }
  DrawOptions all = panel_options();
  all.faces = all.edges = all.certificates = false;
  all.paths = {drawn_cycle(tiling, simulation.geodesic_cycle(0, 0)),
               drawn_cycle(tiling, simulation.geodesic_cycle(1, 0))};
  for (DrawnPath& path : all.paths) path.stars.clear();
  sheet.add(draw_svg(scene, tiling, all), "RCH(P) and RCH(Q), and where they meet");
  return sheet.draw();
}

// ----- Fig. 4 -----

std::string figure_4(const Scene& scene) {
  Sheet sheet(2);
  const Simulation simulation(scene);
  const Tiling tiling = simulation.tiling();
  DrawOptions o = panel_options();
  o.width = 560;
  o.certificates = false;
  const SubtreePicture tree(scene, tiling, 0, 1, 1);
  for (const auto& [vertex, letter] : tree.letters())
    o.labels.push_back({outwards(scene, tiling, vertex, -0.3), letter});
  for (const auto& [where, number] : tree.face_labels()) o.labels.push_back({where, number});
  sheet.add(draw_svg(scene, tiling, o),
            fmt::format("The chain a ... {} of P and the faces of its nodes", tree.letters().back().second));
  sheet.add(tree.draw(560), "The nodes: ends of the chain, number of the face (- if there is none)");
  return sheet.draw();
}

// ----- Fig. 5 -----

RootState root_state(const Scene& scene, double t) {
  Session session(scene, Touch::open, nullptr);
  while (session.step(t)) {
  }
  const Placement placement(session.engine().geometry(), session.engine().leg(), session.engine().parameter());
  return build_tiling(placement).root;
}

std::string figure_5(const Scene& scene) {
  Sheet sheet(2);
  // Of each state the middle of its longest stretch.
  constexpr int samples = 400;
  const auto time = [&scene](double k) { return scene.start + (scene.end - scene.start) * k / samples; };
  std::map<RootState, std::pair<int, int>> longest;
  for (int k = 0, begin = 0; k <= samples; ++k) {
    const RootState state = root_state(scene, time(k));
    if (k > 0 && state != root_state(scene, time(k - 1))) begin = k;
    auto& [from, to] = longest[state];
    if (k - begin >= to - from) from = begin, to = k;
  }
  if (longest.size() < 4)
    throw std::logic_error("Fig. 5's scene passes only " + std::to_string(longest.size()) +
                           " of the four states of the root");
  for (const auto& [state, stretch] : longest) {
    const double later = time((stretch.first + stretch.second) / 2.0);
    const Simulation simulation = at(scene, later);
    const Tiling tiling = simulation.tiling();
    DrawOptions o = panel_options();
    o.certificates = false;
    DrawnPath outer;
    outer.kind = DrawnPath::Kind::come;
    outer.closed = true;
    Point middle{0, 0};
    double count = 0;
    for (const TilingFace& face : tiling.faces) {
      if (face.kind == FaceKind::infinite) {
        for (const int v : face.boundary) outer.points.push_back(position(tiling, v));
      }
      if (face.kind != FaceKind::root) continue;
      for (const int v : face.boundary)
        middle = {middle.x + position(tiling, v).x, middle.y + position(tiling, v).y}, ++count;
    }
    o.paths = {outer};
    sheet.add(draw_svg(scene, tiling, o), fmt::format("{} (t = {:.3g})", to_string(state), later));
  }
  return sheet.draw();
}

// ----- Fig. 7 and 8: events -----

class EventList : public Tracer {
 public:
  void on_event(const TraceEvent& e) override { events.push_back(e); }
  std::vector<TraceEvent> events;
};

std::vector<TraceEvent> run(const Scene& scene) {
  EventList list;
  Simulation simulation(scene, Touch::open, &list);
  simulation.advance_to(scene.end);
  return list.events;
}

using Segment = std::pair<int, int>;
std::set<Segment> segments(const Tiling& tiling) {
  std::set<Segment> out;
  for (const TilingEdge& e : tiling.edges) out.insert(std::minmax(e.from, e.to));
  return out;
}

/// The time before and after an event, well between its neighbours but near it.
struct Around {
  double before, after;
};
Around around(const Scene& scene, const std::vector<TraceEvent>& events, std::size_t i, double reach) {
  const double t = events[i].lo, last = i == 0 ? scene.start : events[i - 1].hi;
  const double next = i + 1 == events.size() ? scene.end : events[i + 1].lo;
  return {std::max(t - reach, t - 0.7 * (t - last)),
          std::min(events[i].hi + reach, events[i].hi + 0.7 * (next - events[i].hi))};
}

void add_event(Sheet& sheet, const Scene& scene, const std::vector<TraceEvent>& events, std::size_t i, double reach,
               const std::string& caption, double zoom) {
  const TraceEvent& e = events[i];
  const Around times = around(scene, events, i, reach);
  const Tiling before = at(scene, times.before).tiling(), after = at(scene, times.after).tiling();
  const std::set<Segment> old_edges = segments(before), new_edges = segments(after);
  const int corner[] = {find_vertex(before, e.u.body, e.u.index), find_vertex(before, e.v.body, e.v.index),
                        find_vertex(before, e.w.body, e.w.index)};
  for (const Tiling* tiling : {&before, &after}) {
    DrawOptions o = panel_options();
    const std::set<Segment>&mine = tiling == &before ? old_edges : new_edges,
          &other = tiling == &before ? new_edges : old_edges;
    for (const Segment& s : mine) {
      if (other.count(s)) continue;
      o.paths.push_back({{position(*tiling, s.first), position(*tiling, s.second)},
                         tiling == &before ? DrawnPath::Kind::gone : DrawnPath::Kind::come,
                         false,
                         {}});
    }
    Point low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
    for (const int v : corner) {
      const Point p = position(*tiling, v);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const Point middle{(low.x + high.x) / 2, (low.y + high.y) / 2};
    const double size = zoom * std::max(high.x - low.x, high.y - low.y);
    o.window = {{middle.x - size, middle.y - 0.7 * size}, {middle.x + size, middle.y + 0.7 * size}};
    for (int k = 0; k < 3; ++k) o.labels.push_back({position(*tiling, corner[k]), std::string(1, "uvw"[k])});
    for (DrawnLabel& label : o.labels) label.at.y += 0.06 * size;
    sheet.add(draw_svg(scene, *tiling, o),
              fmt::format("{}, {} t = {:.6g}", caption, tiling == &before ? "before" : "after", e.lo));
  }
}

/// How clear a picture an event makes: long edges, far from its neighbours in time.
double clarity(const Scene& scene, const std::vector<TraceEvent>& events, std::size_t i) {
  const Tiling tiling = at(scene, events[i].lo).tiling();
  const auto& e = events[i];
  const Point u = position(tiling, find_vertex(tiling, e.u.body, e.u.index)),
              v = position(tiling, find_vertex(tiling, e.v.body, e.v.index)),
              w = position(tiling, find_vertex(tiling, e.w.body, e.w.index));
  const double gap = std::min(e.lo - (i == 0 ? scene.start : events[i - 1].hi),
                              (i + 1 == events.size() ? scene.end : events[i + 1].lo) - e.hi);
  return std::min(std::hypot(u.x - v.x, u.y - v.y), std::hypot(w.x - v.x, w.y - v.y)) * std::min(gap, 0.04);
}

std::string figure_7(const Scene& scene) {
  Sheet sheet(2);
  const std::vector<TraceEvent> events = run(scene);
  for (const auto& [repair, caption] :
       {std::pair{Repair::reflex_new_face, "Case (a)"}, std::pair{Repair::reflex_right, "Case (b)"},
        std::pair{Repair::reflex_left, "Case (c)"}, std::pair{Repair::convex_flip, "A convex corner"}}) {
    std::size_t best = events.size();
    for (std::size_t i = 0; i < events.size(); ++i) {
      if (events[i].repair == repair &&
          (best == events.size() || clarity(scene, events, i) > clarity(scene, events, best)))
        best = i;
    }
    if (best == events.size()) throw std::logic_error("Fig. 7's scene has no event of one kind");
    add_event(sheet, scene, events, best, 0.05, fmt::format("{}, event {}", caption, events[best].number), 1.1);
  }
  return sheet.draw();
}

std::string figure_8(const Scene& inner, const Scene& outer) {
  Sheet sheet(2);
  for (const auto& [scene, name] : {std::pair{&inner, "(a) inner"}, std::pair{&outer, "(b) outer"}}) {
    // The event at which an edge between two vertices of P appears on RCH(P).
    const std::vector<TraceEvent> events = run(*scene);
    bool found = false;
    for (std::size_t i = 0; i < events.size() && !found; ++i) {
      const Around times = around(*scene, events, i, 0.12);
      const Simulation before = at(*scene, times.before), after = at(*scene, times.after);
      const Tiling tilings[] = {before.tiling(), after.tiling()};
      const GeodesicCycle cycles[] = {before.geodesic_cycle(0, 0), after.geodesic_cycle(0, 0)};
      std::set<Segment> edges[2];
      for (int k = 0; k < 2; ++k) {
        const auto& v = cycles[k].vertices;
        for (std::size_t j = 0; j < v.size(); ++j) edges[k].insert(std::minmax(v[j], v[(j + 1) % v.size()]));
      }
      for (const Segment& s : edges[1]) {
        const auto body = [&](int v) { return tilings[1].vertices[static_cast<std::size_t>(v)].body; };
        const bool on_boundary =
            std::any_of(tilings[1].edges.begin(), tilings[1].edges.end(),
                        [&](const TilingEdge& e) { return e.polygon && Segment(std::minmax(e.from, e.to)) == s; });
        if (edges[0].count(s) || body(s.first) != 0 || body(s.second) != 0 || on_boundary || found) continue;
        found = true;
        for (int k = 0; k < 2; ++k) {
          DrawOptions o = panel_options();
          o.faces = o.edges = o.certificates = false;
          DrawnPath cycle = drawn_cycle(tilings[k], cycles[k]);
          cycle.stars.clear();
          o.paths = {cycle};
          const Point p1 = position(tilings[k], s.first), p2 = position(tilings[k], s.second);
          if (k == 1) o.paths.push_back({{p1, p2}, DrawnPath::Kind::come, false, {}});
          o.labels = {{outwards(*scene, tilings[k], s.first, 0.5), "p1"},
                      {outwards(*scene, tilings[k], s.second, 0.5), "p2"}};
          sheet.add(draw_svg(*scene, tilings[k], o), fmt::format("{} appearance of p1p2 on RCH(P): {} t = {:.4g}", name,
                                                                 k == 0 ? "before" : "after", events[i].lo));
        }
      }
    }
    if (!found) throw std::logic_error("Fig. 8's scene has no appearance");
  }
  return sheet.draw();
}

// ----- Fig. 16 and 17 -----

std::string figure_16(const Scene& scene) {
  Sheet sheet(3);
  // Down from the first maximum to the first minimum of the path.
  for (const double t : {-1.0, -0.84, -0.72}) {
    const Simulation simulation = at(scene, t);
    const Tiling tiling = simulation.tiling();
    DrawOptions o = panel_options();
    o.width = 330;
    o.certificates = false;
    DrawnPath hull = drawn_cycle(tiling, simulation.geodesic_cycle(0, 0));
    hull.stars.clear();
    o.paths = {hull};
    o.window = {{-2.8, -1.3}, {2.8, 7.3}};
    sheet.add(draw_svg(scene, tiling, o),
              fmt::format("RCH(P): {} vertices, {} events", simulation.geodesic_cycle(0, 0).vertices.size(),
                          simulation.events()));
  }
  return sheet.draw();
}

std::string figure_17(const Scene& scene) {
  Sheet sheet(2);
  const Simulation simulation = at(scene, 0.013);
  const Tiling tiling = simulation.tiling();
  DrawnPath hull = drawn_cycle(tiling, simulation.geodesic_cycle(0, 0));
  hull.stars.clear();
  const Polygon& holder = scene.bodies[0].polygon;
  const std::size_t teeth = scene.bodies[1].polygon.size() / 2, links = holder.size() - 4;
  for (const bool near : {false, true}) {
    DrawOptions o = panel_options();
    o.width = 500;
    o.certificates = false;
    // The extensions of the chain's edges.
    for (std::size_t i = 1; i <= links; ++i) {
      const Point a = holder[i], b = holder[i + 1];
      const double slope = (b.x - a.x) / (b.y - a.y);
      o.paths.push_back(
          {{{a.x + slope * (-4.2 - a.y), -4.2}, {a.x + slope * (4.2 - a.y), 4.2}}, DrawnPath::Kind::guide, false, {}});
    }
    o.paths.push_back(hull);
    if (near) {
      o.window = {{-3.25, 0.4}, {-2.25, 1.4}};
    } else {
      for (const TilingVertex& v : tiling.vertices) o.window.push_back(v.position);
    }
    sheet.add(draw_svg(scene, tiling, o), near ? "The teeth cross the extensions one after another"
                                               : fmt::format("{} teeth, {} edges in the chain: {} events in one turn",
                                                             teeth, links, run(scene).size()));
  }
  return sheet.draw();
}

// ----- separators -----

std::string separators(const std::vector<std::pair<Scene, double>>& placements) {
  Sheet sheet(3);
  for (const auto& [scene, t] : placements) {
    const Separator found = separator(scene, t);
    Tiling tiling;
    const std::array<Polygon, 2> bodies = placed(scene, t);
    for (int body : {0, 1}) {
      const Polygon& polygon = bodies[static_cast<std::size_t>(body)];
      for (std::size_t i = 0; i < polygon.size(); ++i)
        tiling.vertices.push_back({body, static_cast<int>(i), polygon[i]});
    }
    const MinimumLinkSeparator& m = found.minimum_link;
    DrawOptions o = panel_options();
    o.width = 400;
    o.paths = {{m.vertices, DrawnPath::Kind::separator, m.closed, {}}};
    const std::string links =
        m.lower == m.upper ? fmt::format("{} links", m.upper) : fmt::format("{} to {} links", m.lower, m.upper);
    sheet.add(draw_svg(scene, tiling, o), fmt::format("{} and {}, t = {}: {}, {}", scene.bodies[0].name,
                                                      scene.bodies[1].name, t, links, m.closed ? "closed" : "open"));
  }
  return sheet.draw();
}

}  // namespace

void draw_figures(Output& output, const std::string& folder) {
  const auto scene = [&folder](const std::string& name) { return read_scene(fmt::format("{}/{}.json", folder, name)); };
  output.write_text("fig1.svg", figure_1(scene("fig1")));
  output.write_text("fig2.svg", figure_2(scene("fig2")));
  output.write_text("fig3.svg", figure_3(scene("fig3")));
  output.write_text("fig4.svg", figure_4(scene("fig3")));
  output.write_text("fig5.svg", figure_5(scene("fig5")));
  output.write_text("fig7.svg", figure_7(scene("fig7")));
  output.write_text("fig8.svg", figure_8(scene("fig8a"), scene("fig8b")));
  output.write_text("fig16.svg", figure_16(scene("fig16")));
  output.write_text("fig17.svg", figure_17(scene("fig17")));
  output.write_text("separators.svg", separators({{scene("../gears"), 0.3},
                                                  {scene("../spiral"), 0.3},
                                                  {scene("../combs"), 0},
                                                  {scene("../jigsaw"), 0},
                                                  {scene("fig3"), 0},
                                                  {scene("fig5"), 6.5}}));
  output.note("figures: 1, 2, 3, 4, 5, 7, 8, 16, 17");
}

}  // namespace taut::paper
