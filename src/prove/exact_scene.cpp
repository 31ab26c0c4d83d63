#include "prove/exact_scene.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "motion/pieces.hpp"
#include "motion/rotation_forms.hpp"
#include "scene/cross_sections.hpp"
#include "taut/error.hpp"

namespace taut::internal {
namespace {

[[noreturn]] void refuse_exactly(const std::string& place, const std::string& what) {
  throw InputError(place, "exact proofs do not cover " + what,
                   "prove it without --exact: taut verify checks that proof, by bounds that are rounded outwards");
}

bool rests_exactly(const Motion& motion) {
  return std::all_of(motion.pieces.begin(), motion.pieces.end(), [](const MotionPiece& p) {
    return p.x.empty() && p.y.empty() && p.orbit.angle.empty() && std::holds_alternative<NoRotation>(p.rotation);
  });
}

/// As the checker compares them: a pivot counts where something turns.
bool equal_motions(const Motion& a, const Motion& b) {
  const auto same = [](const MotionPiece& p, const MotionPiece& q) {
    const bool turns = !std::holds_alternative<NoRotation>(p.rotation) || !p.orbit.angle.empty();
    return p.x == q.x && p.y == q.y && p.until == q.until && p.origin == q.origin &&
           same_rotation(p.rotation, q.rotation) && (!turns || p.pivot == q.pivot) && p.orbit.angle == q.orbit.angle &&
           (p.orbit.angle.empty() || p.orbit.centre == q.orbit.centre);
  };
  return &a == &b || std::equal(a.pieces.begin(), a.pieces.end(), b.pieces.begin(), b.pieces.end(), same);
}

bool equal_chains(const ExactChain& a, const ExactChain& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const Motion* p, const Motion* q) { return equal_motions(*p, *q); });
}

/// Is it a rotation at all times, whatever they are? A direction may vanish.
bool turns_regularly(const Motion& motion) {
  return std::all_of(motion.pieces.begin(), motion.pieces.end(), [](const MotionPiece& p) {
    const auto* direction = std::get_if<DirectionRotation>(&p.rotation);
    return !direction ||
           (direction->a.size() == 1 && direction->b.size() == 1 && (direction->a[0] != 0 || direction->b[0] != 0));
  });
}

ExactChain chain_in(const Scene& scene, const std::map<std::string, int>& names, const Body& body) {
  ExactChain chain;
  const Body* at = &body;
  while (true) {
    if (!rests_exactly(at->motion)) chain.insert(chain.begin(), &at->motion);
    if (at->relative_to.empty()) return chain;
    at = &scene.bodies[static_cast<std::size_t>(names.at(at->relative_to))];
  }
}

const MotionPiece& piece_in(const Motion& motion, double from, double to) {
  const double t = from + (to - from) / 2;
  return piece_at(motion.pieces, t);
}

LocalPlacement composed(const LocalPlacement& a, const LocalPlacement& b, const LocalModels& m) {
  return {a.x + m.product(a.cosine, b.x) - m.product(a.sine, b.y),
          a.y + m.product(a.sine, b.x) + m.product(a.cosine, b.y),
          m.product(a.cosine, b.cosine) - m.product(a.sine, b.sine),
          m.product(a.sine, b.cosine) + m.product(a.cosine, b.sine)};
}

std::optional<LocalPlacement> placement_of(const MotionPiece& piece, const RealMax& middle, const LocalModels& m) {
  const RealMax offset = middle - piece.origin;
  const auto turn = m.rotation(piece.rotation, offset);
  if (!turn) return std::nullopt;
  const bool turns = !std::holds_alternative<NoRotation>(piece.rotation) || !piece.orbit.angle.empty();
  const Point pivot = turns ? piece.pivot : Point{};
  LocalPlacement out{m.shifted(piece.x, offset), m.shifted(piece.y, offset), turn->cosine, turn->sine};
  out.x.c[0] += pivot.x;
  out.y.c[0] += pivot.y;
  if (!piece.orbit.angle.empty()) {
    const auto around = m.cos_sin(m.shifted(piece.orbit.angle, offset));
    if (!around) return std::nullopt;
    const Point& centre = piece.orbit.centre;
    out.x.c[0] -= centre.x;
    out.y.c[0] -= centre.y;
    const LocalModel x = m.product(around->cosine, out.x) - m.product(around->sine, out.y);
    const LocalModel y = m.product(around->sine, out.x) + m.product(around->cosine, out.y);
    out.x = LocalModel::constant(centre.x) + x;
    out.y = LocalModel::constant(centre.y) + y;
  }
  out.x = out.x - (pivot.x * out.cosine - pivot.y * out.sine);
  out.y = out.y - (pivot.x * out.sine + pivot.y * out.cosine);
  return out;
}

std::vector<ExactEdge> edges_of(const Body& body, const std::vector<std::size_t>& parts) {
  std::vector<ExactEdge> edges;
  const auto add = [&edges](const Polygon& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k) edges.push_back({ring[k], ring[(k + 1) % ring.size()]});
  };
  if (body.parts.empty()) {
    add(body.polygon);
    return edges;
  }
  for (const std::size_t k : parts) {
    add(body.parts[k].outline);
    for (const Polygon& hole : body.parts[k].holes) add(hole);
  }
  return edges;
}

}  // namespace

ExactScene::ExactScene(const Scene& scene) : ignored_(scene) {
  if (scene.mechanism) refuse_exactly("mechanism", "mechanisms");
  add_sections(scene);
  const auto names = bodies_by_name(scene);
  for (const Body& body : scene.bodies) chains_.push_back(chain_in(scene, names, body));
  at_rest_ = scene.at_rest == AtRest::test;
  if (scene.at_rest != AtRest::skip) return;
  // Where nothing moves against anything else, all is tested.
  const ExactChain* first = nullptr;
  at_rest_ = true;
  for (std::size_t k = 0; k < chains_.size(); ++k) {
    if (ignored_.has_all(static_cast<int>(k))) continue;
    if (first && !equal_chains(*first, chains_[k])) at_rest_ = false;
    if (!first) first = &chains_[k];
  }
}

void ExactScene::add_sections(const Scene& scene) {
  std::vector<Section> others;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Body& body = scene.bodies[k];
    if (!body.curves.empty()) refuse_exactly(body.name, "curves");
    if (body.parts.empty() && body.polygon.empty()) refuse_exactly(body.name, "prepared shapes without their polygons");
    bool first = true;
    for (const CrossSection& section : cross_sections_of(body)) {
      (first ? sections_ : others).push_back({&body, static_cast<int>(k), section.z, edges_of(body, section.parts)});
      first = false;
    }
  }
  sections_.insert(sections_.end(), others.begin(), others.end());
}

bool ExactScene::tested(int a, int b) const {
  const Section &p = section(a), &q = section(b);
  if (p.in_scene == q.in_scene || !p.z.meet(q.z) || ignored_.has(p.in_scene, q.in_scene)) return false;
  return at_rest_ || !equal_chains(chain(a), chain(b));
}

std::array<ExactChain, 2> ExactScene::relative_chains(int a, int b) const {
  const ExactChain &p = chain(a), &q = chain(b);
  std::size_t common = 0;
  while (common < p.size() && common < q.size() && equal_motions(*p[common], *q[common]) && turns_regularly(*p[common]))
    ++common;
  const auto rest = [common](const ExactChain& c) {
    return ExactChain(c.begin() + static_cast<std::ptrdiff_t>(common), c.end());
  };
  return {rest(p), rest(q)};
}

std::vector<double> joints_between(const std::array<ExactChain, 2>& chains, double start, double end) {
  std::vector<double> times;
  for (const ExactChain& chain : chains) {
    for (const Motion* motion : chain) {
      for (std::size_t k = 0; k + 1 < motion->pieces.size(); ++k) {
        const double t = motion->pieces[k].until;
        if (t > start && t <= end) times.push_back(t);
      }
    }
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

std::optional<LocalPlacement> placement_in(const ExactChain& chain, double from, double to, const LocalModels& models) {
  std::optional<LocalPlacement> place;
  const RealMax middle = (RealMax(from) + to) * 0.5;
  // From the innermost motion outwards, as the checker does: the order shows in the slack.
  for (std::size_t k = chain.size(); k-- > 0;) {
    const auto next = placement_of(piece_in(*chain[k], from, to), middle, models);
    if (!next) return std::nullopt;
    place = place ? composed(*next, *place, models) : *next;
  }
  if (!place) place = LocalPlacement{{}, {}, LocalModel::constant(1), {}};
  return place;
}

}  // namespace taut::internal
