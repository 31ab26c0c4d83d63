#include "scene/curved_world.hpp"

#include <algorithm>
#include <utility>

#include "geometry/band.hpp"
#include "scene/ring_set.hpp"
#include "scene/validate_scene.hpp"
#include "taut/error.hpp"
#include "taut/outline.hpp"
#include "taut/scene.hpp"

namespace taut::internal {
namespace {

std::string part_name(const Body& body, std::size_t part) {
  return body.curves.size() > 1 ? body.name + ": part " + std::to_string(part) : body.name;
}

InputError located_on_curve(const InputError& error, std::size_t body, std::size_t part) {
  Culprits culprits = error.culprits();
  for (EdgeRef& e : culprits.edges) {
    e.body = static_cast<int>(body);
    e.part = static_cast<int>(part);
  }
  return InputError(error.place(), error.problem(), error.hint(), std::move(culprits));
}

}  // namespace

bool has_curves(const Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const Body& b) { return !b.curves.empty(); });
}

void validate_curved_world(const Scene& scene) {
  if (!has_curves(scene)) return validate_polygons(scene);
  validate_polygons(CurvedWorld(scene).polygons(CurveSide::outer));
}

CurvedWorld::CurvedWorld(const Scene& scene) : scene_(scene) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    parts_.emplace_back();
    if (body.curves.empty()) continue;
    if (!body.polygon.empty() || !body.parts.empty() || body.prepared)
      throw InputError(body.name, "the body has polygons besides its curves",
                       "write all of its parts as curves: outline_of() makes one of a polygon");
    for (std::size_t k = 0; k < body.curves.size(); ++k) {
      try {
        parts_.back().emplace_back(body.curves[k], part_name(body, k));
      } catch (const InputError& error) {
        throw located_on_curve(error, i, k);
      }
    }
  }
}

Scene CurvedWorld::polygons(CurveSide side) const {
  Scene flat = scene_;
  // What a lock makes of an answer is said of the bodies themselves.
  flat.lock.reset();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (parts_[i].empty()) continue;
    Body& body = flat.bodies[i];
    body.curves.clear();
    for (std::size_t k = 0; k < parts_[i].size(); ++k) {
      body.parts.push_back(parts_[i][k].polygons(side));
      body.parts.back().z = scene_.bodies[i].curves[k].z;
    }
    if (body.parts.size() > 1 || !body.parts[0].holes.empty() || body.parts[0].z) continue;
    body.polygon = std::move(body.parts[0].outline);
    body.parts.clear();
  }
  return flat;
}

CurvedWorld::Halvings CurvedWorld::no_halvings() const {
  Halvings halvings;
  for (const auto& body : parts_) {
    halvings.emplace_back();
    for (const curve::BandedPart& part : body) {
      halvings.back().emplace_back();
      for (const curve::Band& band : part.bands()) halvings.back().back().emplace_back(band.cells().size(), 0);
    }
  }
  return halvings;
}

bool CurvedWorld::refine(const Halvings& halvings) {
  bool finer = false;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    for (std::size_t k = 0; k < parts_[i].size(); ++k) {
      for (std::size_t ring = 0; ring < halvings[i][k].size(); ++ring) {
        const std::vector<int>& wanted = halvings[i][k][ring];
        if (std::all_of(wanted.begin(), wanted.end(), [](int h) { return h == 0; })) continue;
        finer = parts_[i][k].band(ring).refine(wanted) || finer;
      }
    }
  }
  return finer;
}

void CurvedWorld::refine_to(double tolerance) {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    for (std::size_t k = 0; k < parts_[i].size(); ++k)
      curve::refine_to(parts_[i][k], tolerance, part_name(scene_.bodies[i], k));
  }
}

template <class Feature>
double CurvedWorld::name(CurveSide side, Feature& feature, double within) const {
  const auto& body = parts_[static_cast<std::size_t>(feature.body)];
  if (body.empty()) return 0;
  const auto ring = static_cast<std::size_t>(feature.ring);
  const curve::BandedPart& part = body[static_cast<std::size_t>(feature.part)];
  const curve::Band& band = part.bands()[ring];
  const std::vector<curve::Source> sources = band.sources(part.left_is(ring, side));
  const auto index = static_cast<std::size_t>(feature.index);
  const curve::Source& here = sources[index];
  const curve::Source& next = sources[(index + 1) % sources.size()];
  const curve::Cell& cell = band.cells()[static_cast<std::size_t>(here.cell)];
  const double end = next.cell == here.cell ? next.parameter : cell.piece.to;
  feature.index = cell.piece.segment;
  feature.parameter = here.parameter + within * (end - here.parameter);
  return cell.thickness;
}

double CurvedWorld::name_curve(CurveSide side, VertexRef& vertex) const { return name(side, vertex, 0); }
double CurvedWorld::name_curve(CurveSide side, EdgeRef& edge) const { return name(side, edge, 0.5); }

double CurvedWorld::name_curves(CurveSide side, Contact& contact) const {
  return std::max(name_curve(side, contact.vertex), name_curve(side, contact.edge));
}

std::size_t CurvedWorld::mark_vertex(CurveSide side, const VertexRef& vertex, Halvings& marks) const {
  const auto body = static_cast<std::size_t>(vertex.body), p = static_cast<std::size_t>(vertex.part);
  if (parts_[body].empty()) return 0;
  const auto ring = static_cast<std::size_t>(vertex.ring);
  const curve::BandedPart& part = parts_[body][p];
  const curve::Band& band = part.bands()[ring];
  const std::size_t n = band.cells().size();
  const auto cell =
      static_cast<std::size_t>(band.sources(part.left_is(ring, side))[static_cast<std::size_t>(vertex.index)].cell);
  std::size_t count = 0;
  for (const std::size_t k : {(cell + n - 1) % n, cell, (cell + 1) % n}) {
    if (band.cells()[k].is_final || marks[body][p][ring][k] != 0) continue;
    marks[body][p][ring][k] = 1;
    ++count;
  }
  return count;
}

double CurvedWorld::tolerance() const {
  double worst = 0;
  for (const auto& body : parts_) {
    for (const curve::BandedPart& part : body) worst = std::max(worst, part.tolerance());
  }
  return worst;
}

std::uint64_t CurvedWorld::segments() const {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    for (const curve::BandedPart& part : parts_[i]) {
      const Part polygons = part.polygons(CurveSide::outer);
      count += polygons.outline.size();
      for (const Polygon& hole : polygons.holes) count += hole.size();
    }
    if (!parts_[i].empty()) continue;
    for (const Part& part : parts_of(scene_.bodies[i])) {
      count += part.outline.size();
      for (const Polygon& hole : part.holes) count += hole.size();
    }
  }
  return count;
}

}  // namespace taut::internal

namespace taut {

// Polygons for the curves of a scene.

namespace {

void replace_curves(Body& body, CurveSide side, double tolerance) {
  if (body.curves.empty()) return;
  body.parts = flatten(std::exchange(body.curves, {}), side, tolerance, body.name);
  if (body.parts.size() > 1 || !body.parts[0].holes.empty() || body.parts[0].z) return;
  body.polygon = std::move(body.parts[0].outline);
  body.parts.clear();
}

}  // namespace

Scene flatten(const Scene& scene, CurveSide side, double tolerance) {
  Scene flat = scene;
  for (Body& body : flat.bodies) replace_curves(body, side, tolerance);
  return flat;
}

}  // namespace taut
