// Figures 1 to 5.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

#include "figure_tools.hpp"
#include "scene/placement.hpp"
#include "session/world_simulation.hpp"
#include "sheet.hpp"
#include "tree_picture.hpp"

namespace taut::paper {
using namespace internal;

namespace {

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

}  // namespace

std::string figure_1(const Scene& scene) {
  Sheet sheet(2);
  for (const double t : {0.0, 1.0}) {
    const Simulation simulation = at(scene, t);
    const Tiling tiling = simulation.tiling();
    TilingDrawOptions o = panel_options();
    o.faces = o.edges = o.certificates = false;
    o.paths = {half_geodesic(simulation, tiling)};
    const Point a = o.paths[0].points.front(), b = o.paths[0].points.back();
    o.labels = {{{a.x + 0.45, a.y - 0.1}, "a"}, {{b.x - 0.45, b.y + 0.2}, "b"}};
    sheet.add(draw_svg(scene, tiling, o), t == 0 ? "Q outside" : "Q in the cavity");
  }
  return sheet.draw();
}

namespace {

// ----- Fig. 2 -----

/// The lasso, for hulls apart: from the pin clockwise along P's hull to the outer tangent, around Q, back by the inner
/// tangent, along the root pseudo-triangle's side of P's hull, and to the pin the way it came.
DrawnPath lasso(const Tiling& tiling, int pin) {
  const auto of_p = [&tiling](int v) { return tiling.vertices[static_cast<std::size_t>(v)].vertex.body == 0; };
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
      if (a.vertex.body != body || b.vertex.body != body) continue;
      const double d = std::hypot(a.position.x - b.position.x, a.position.y - b.position.y);
      if (d > longest) longest = d, best = {static_cast<int>(j), static_cast<int>(i)};
    }
  }
  return best;
}

bool beyond(const Tiling& tiling, int pin, int other, int body) {
  const Point a = position(tiling, pin), b = position(tiling, other);
  return std::any_of(tiling.vertices.begin(), tiling.vertices.end(), [&](const TilingVertex& v) {
    return v.vertex.body != body && (v.position.x - a.x) * (b.x - a.x) + (v.position.y - a.y) * (b.y - a.y) < 0;
  });
}

}  // namespace

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
    TilingDrawOptions o = panel_options();
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
  TilingDrawOptions o = panel_options();
  sheet.add(draw_svg(scene, tiling, o), "The tiling; PQ edges bold");
  for (int level = 0; level < 4; ++level) {
    TilingDrawOptions dream = panel_options();
    dream.faces = dream.edges = dream.certificates = false;
    dream.paths = {drawn_cycle(tiling, simulation.geodesic_cycle(1, level))};
    sheet.add(draw_svg(scene, tiling, dream),
              level == 0 ? "Level 0: the relative convex hull of Q"
                         : fmt::format("Level {}: {} pinned vertices", level, dream.paths[0].stars.size()));
  }
  TilingDrawOptions all = panel_options();
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
  TilingDrawOptions o = panel_options();
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

namespace {

// ----- Fig. 5 -----

RootState root_state(const Scene& scene, double t) {
  WorldSimulation simulation(scene, Touch::open, UINT64_MAX);
  simulation.advance(t);
  const Engine& engine = simulation.single_pair()->engines()->engine(0);
  const Placement placement(engine.geometry(), engine.segment(), engine.parameter());
  return build_tiling(placement).root;
}

}  // namespace

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
    TilingDrawOptions o = panel_options();
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

}  // namespace taut::paper
