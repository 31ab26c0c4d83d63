#include "support/cavity_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "geometry/predicates.hpp"
#include "scene/validate_scene.hpp"
#include "taut/error.hpp"

namespace taut::testing {
using namespace internal;

const char* to_string(Cavity cavity) {
  switch (cavity) {
    case Cavity::island:
      return "island";
    case Cavity::rock:
      return "rock";
    case Cavity::ring:
      return "ring";
    default:
      return "cells";
  }
}

namespace {

/// Sixteenths: far from needing all bits, so that bodies can be turned and moved exactly.
double in_sixteenths(double x) { return std::round(x * 16) / 16; }

Polygon ragged_star(Rng& rng, int n, double least, double most, const Point& centre) {
  Polygon polygon;
  for (int k = 0; k < n; ++k) {
    const Point u = unit_vector((k + rng.real(-0.3, 0.3)) / n);
    const double r = rng.real(least, most);
    polygon.push_back({in_sixteenths(centre.x + r * u.x), in_sixteenths(centre.y + r * u.y)});
  }
  return polygon;
}

Polygon box(double left, double low, double right, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

/// A square with teeth, n of them on a circle.
Polygon toothed(int n, double low, double high, double width, double phase) {
  Polygon polygon;
  for (int k = 0; k < n; ++k) {
    for (const auto& [at, r] : {std::pair(-width, low), {-width / 2, high}, {width / 2, high}, {width, low}}) {
      const Point u = unit_vector((k + phase + at) / n);
      polygon.push_back({in_sixteenths(r * u.x), in_sixteenths(r * u.y)});
    }
  }
  return polygon;
}

struct Cell {
  std::vector<Part> outer, inner;
  double play = 1;
};

double highest_x(const Polygon& polygon) {
  return std::max_element(polygon.begin(), polygon.end(), [](const Point& a, const Point& b) { return a.x < b.x; })->x;
}

Point between(const Point& a, const Point& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

/// The hole that is left of a box where a polygon is joined to its right side at its rightmost vertex, by a bar that
/// widens from it.
Polygon around_island(const Polygon& island, const AxisBox& bounds, double margin) {
  const std::size_t n = island.size();
  const auto tip = static_cast<std::size_t>(
      std::max_element(island.begin(), island.end(), [](const Point& a, const Point& b) { return a.x < b.x; }) -
      island.begin());
  const Point& v = island[tip];
  const Point before = between(v, island[(tip + n - 1) % n], 1.0 / 16),
              after = between(v, island[(tip + 1) % n], 1.0 / 16);
  const double right = bounds.hi_x + margin;
  // Counterclockwise around the free space: the box, then clockwise around the island.
  Polygon hole = {{right, after.y + margin / 2},
                  {right, bounds.hi_y + 2 * margin},
                  {bounds.lo_x - margin, bounds.hi_y + 2 * margin},
                  {bounds.lo_x - margin, bounds.lo_y - 2 * margin},
                  {right, bounds.lo_y - 2 * margin},
                  {right, before.y - margin / 2},
                  before};
  for (std::size_t k = 1; k < n; ++k) hole.push_back(island[(tip + n - k) % n]);
  hole.push_back(after);
  return hole;
}

Cell around_and_inside(Rng& rng, bool grid) {
  PolygonPair pair =
      random_pair(rng, rng.pick(std::vector<Family>(std::begin(all_families), std::end(all_families))), grid);
  for (int k = 0; k < 4 && highest_x(pair.p) <= highest_x(pair.q); ++k) {
    for (Polygon* polygon : {&pair.p, &pair.q}) {
      for (Point& p : *polygon) p = {-p.y, p.x};
    }
  }
  if (highest_x(pair.p) <= highest_x(pair.q)) std::swap(pair.p, pair.q);
  Polygon both = pair.p;
  both.insert(both.end(), pair.q.begin(), pair.q.end());
  const AxisBox bounds = taut::internal::box_around(both);
  const double size = std::max(bounds.hi_x - bounds.lo_x, bounds.hi_y - bounds.lo_y);
  const double margin = std::ceil(size * rng.real(0.05, 0.5));
  const Polygon hole = around_island(pair.p, bounds, margin);
  const AxisBox b = taut::internal::box_around(hole);
  return {{{box(b.lo_x - margin, b.lo_y - margin, b.hi_x + margin, b.hi_y + margin), {hole}}}, {{pair.q, {}}}, size};
}

Cell star_in_star(Rng& rng) {
  const Polygon inner = ragged_star(rng, rng.between(3, 24), 20, 100, {0, 0});
  const Polygon hole = ragged_star(rng, rng.between(8, 40), 112, rng.real(120, 300), {0, 0});
  return {{{ragged_star(rng, 20, 410, 500, {0, 0}), {hole}}}, {{inner, {}}}, 150};
}

Cell cog_in_ring(Rng& rng) {
  const int n = rng.between(5, 20);
  const double tooth = rng.real(0.1, 0.2), space = rng.real(0.26, 0.33);
  // A tooth of the cog in each space of the ring.
  const Polygon cog = toothed(n, 300, rng.real(360, 480), tooth, 0),
                hole = toothed(n, rng.real(380, 420), 500, space, 0);
  return {{{box(-700, -700, 700, 700), {hole}}}, {{cog, {}}}, 60};
}

Cell two_cells(Rng& rng) {
  Cell cell;
  const double apart = 900;
  const Polygon left = ragged_star(rng, 16, 160, 220, {-apart / 2, 0}),
                right = ragged_star(rng, 12, 160, 220, {apart / 2, 0});
  cell.outer = {{box(-900, -500, 900, 500), {left, right}}};
  if (rng.chance(0.5)) cell.outer.push_back({box(-20, 450, 20, 800), {}});
  if (rng.chance(0.5))
    cell.outer.push_back({ragged_star(rng, 5, 10, 30, {apart / 2, 0}), {}});  // in the hole that Q surrounds
  cell.inner = {{ragged_star(rng, 9, 40, 130, {-apart / 2, 0}), {}},
                {ragged_star(rng, 11, 120, 150, {apart / 2, 0}), {ragged_star(rng, 9, 50, 90, {apart / 2, 0})}}};
  if (rng.chance(0.3)) cell.inner.push_back({box(-10, -3000, 10, -2500), {}});
  cell.play = 100;
  return cell;
}

Cell made(Rng& rng, Cavity cavity, bool grid) {
  switch (cavity) {
    case Cavity::island:
      return around_and_inside(rng, grid);
    case Cavity::rock:
      return star_in_star(rng);
    case Cavity::ring:
      return cog_in_ring(rng);
    default:
      return two_cells(rng);
  }
}

/// A body of parts that is where they are at time 0, moved as animate() moves a polygon.
Body animated(Rng& rng, const char* name, const std::vector<Part>& parts, const Drive& drive) {
  Polygon all;
  for (const Part& part : parts) {
    all.insert(all.end(), part.outline.begin(), part.outline.end());
    for (const Polygon& hole : part.holes) all.insert(all.end(), hole.begin(), hole.end());
  }
  const Body moving = animate(rng, name, all, drive);
  auto next = moving.polygon.begin();
  const auto take = [&next](Polygon& ring) {
    std::copy_n(next, ring.size(), ring.begin());
    next += static_cast<std::ptrdiff_t>(ring.size());
  };
  Body body;
  body.name = name;
  body.motion = moving.motion;
  body.parts = parts;
  for (Part& part : body.parts) {
    take(part.outline);
    for (Polygon& hole : part.holes) take(hole);
  }
  return body;
}

Drive drive_within(Rng& rng, double play) {
  Drive drive;
  drive.kind = rng.pick(std::vector<MotionKind>(std::begin(all_motions), std::end(all_motions)));
  drive.reach = play * rng.real(0.1, 1.5);
  drive.turn = rng.real(0.1, 4);
  drive.pivot = {static_cast<double>(rng.between(-20, 20)), static_cast<double>(rng.between(-20, 20))};
  drive.quarter_turns = rng.pick(start_turns(drive.kind));
  return drive;
}

Scene attempted_scene(Rng& rng, Cavity cavity, const CavityOptions& options) {
  const Cell cell = made(rng, cavity, options.grid);
  Scene scene;
  scene.end = 1;
  Drive outer = drive_within(rng, cell.play);
  if (rng.chance(0.5)) outer.kind = MotionKind::rest;
  scene.bodies.push_back(animated(rng, "around", cell.outer, outer));
  scene.bodies.push_back(animated(rng, "inside", cell.inner, drive_within(rng, cell.play)));
  if (options.parents) {
    const double far = 0x1p24;
    Body parent = animate(rng, "parent", box(far, far, far + 100, far + 100), {});
    parent.motion = random_motion(rng, cell.play * 0.3, rng.chance(0.5) ? MotionKind::angle : MotionKind::linear);
    scene.bodies.push_back(parent);
    scene.bodies[1].relative_to = "parent";
    scene.ignore = {{"parent", "*"}};
  }
  return scene;
}

}  // namespace

Scene cavity_scene(std::uint64_t seed, Cavity cavity, const CavityOptions& options) {
  Rng rng(seed * 16 + static_cast<std::uint64_t>(cavity) * 4 + options.grid + 2 * options.parents);
  for (;;) {
    Scene scene = attempted_scene(rng, cavity, options);
    try {
      validate_polygons(scene);
      return scene;
    } catch (const InputError&) {
      // What was cut off an island's tip has left something in the bar.
    }
  }
}

}  // namespace taut::testing
