// Figures 7, 8, 16 and 17.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "figure_tools.hpp"
#include "sheet.hpp"

namespace taut::paper {

namespace {

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
    TilingDrawOptions o = panel_options();
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

}  // namespace

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
        const auto body = [&](int v) { return tilings[1].vertices[static_cast<std::size_t>(v)].vertex.body; };
        const bool on_boundary =
            std::any_of(tilings[1].edges.begin(), tilings[1].edges.end(),
                        [&](const TilingEdge& e) { return e.polygon && Segment(std::minmax(e.from, e.to)) == s; });
        if (edges[0].count(s) || body(s.first) != 0 || body(s.second) != 0 || on_boundary || found) continue;
        found = true;
        for (int k = 0; k < 2; ++k) {
          TilingDrawOptions o = panel_options();
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
    TilingDrawOptions o = panel_options();
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
    TilingDrawOptions o = panel_options();
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

}  // namespace taut::paper
