#include "prove/exact_scene.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "motion/pieces.hpp"
#include "motion/rotation_forms.hpp"
#include "numeric/budget.hpp"
#include "scene/joined_parts.hpp"
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

namespace {

/// The point of the segment, or of the triangle, that is nearest to the origin; `corners` become those that it lies
/// between. Nothing if the origin is inside.
std::optional<Vector> nearest_to_origin(std::vector<Vector>& corners) {
  if (corners.size() == 1) return corners[0];
  if (corners.size() == 2) {
    const Vector a = corners[0], d = corners[1] - a;
    const double length = dot(d, d), k = length > 0 ? -dot(a, d) / length : 0;
    if (k <= 0) {
      corners = {a};
      return a;
    }
    if (k >= 1) {
      corners = {corners[1]};
      return corners[0];
    }
    return a + Vector{k * d.x, k * d.y};
  }
  // The nearest side; inside if the origin is on the inner side of all three.
  std::optional<Vector> best;
  std::vector<Vector> between;
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector a = corners[i], b = corners[(i + 1) % 3], c = corners[(i + 2) % 3];
    const double of_origin = dot(turned(b - a), -a), of_third = dot(turned(b - a), c - a);
    inside = inside && of_origin * of_third > 0;
    std::vector<Vector> side = {a, b};
    const Vector nearest = *nearest_to_origin(side);
    if (best && dot(*best, *best) <= dot(nearest, nearest)) continue;
    best = nearest;
    between = side;
  }
  if (inside) return std::nullopt;
  corners = between;
  return best;
}

/// A multiple of a power of two that is at most `step`: short in decimals, too, if the step is large.
double rounded_to(double value, double step) {
  if (!(step > 0)) return value;
  const double unit = std::exp2(std::floor(std::log2(step)));
  const double q = std::nearbyint(value / unit);
  return std::fabs(q) < 0x1p52 ? q * unit : value;
}

struct Projection {
  LocalModel base, per_x, per_y;

  Projection(const LocalPlacement& p, Vector n)
      : base(n.x * p.x + n.y * p.y), per_x(n.x * p.cosine + n.y * p.sine), per_y(n.y * p.cosine - n.x * p.sine) {}
  LocalModel of(const Point& v) const { return base + (v.x * per_x + v.y * per_y); }
};

}  // namespace

ExactSeparation::Side ExactSeparation::side(const std::vector<ExactEdge>& edges, const LocalPlacement& place) {
  Side out{edges, place, {}, 0};
  out.middle.reserve(edges.size());
  const Vector at{place.x.c[0], place.y.c[0]}, along{place.cosine.c[0], place.sine.c[0]};
  const auto placed = [&](const Point& v) { return at + along * Vector{v.x, v.y}; };
  for (const ExactEdge& e : edges) {
    out.middle.push_back({placed(e[0]), placed(e[1])});
    for (const Point& v : e) out.reach = std::max({out.reach, std::fabs(v.x), std::fabs(v.y)});
  }
  return out;
}

ExactSeparation::ExactSeparation(const std::vector<ExactEdge>& first, const std::vector<ExactEdge>& second,
                                 const LocalPlacement& first_place, const LocalPlacement& second_place,
                                 const LocalModels& models)
    : first_(side(first, first_place)), second_(side(second, second_place)), models_(models) {}

std::optional<std::vector<ExactStep>> ExactSeparation::find() {
  steps_.clear();
  if (!separate({0, first_.edges.size()}, {0, second_.edges.size()})) return std::nullopt;
  return steps_;
}

bool ExactSeparation::separate(const Range& p, const Range& q) {
  checkpoint(p.size() + q.size());
  if (const auto found = line(p, q)) {
    steps_.push_back(*found);
    return true;
  }
  if (p.size() == 1 && q.size() == 1) return false;
  const bool first = q.size() == 1 || (p.size() > 1 && extent(first_, p) >= extent(second_, q));
  ExactStep step;
  step.kind = first ? ExactStep::Kind::halve_first : ExactStep::Kind::halve_second;
  steps_.push_back(step);
  const Range& r = first ? p : q;
  const std::size_t middle = r.from + r.size() / 2;
  for (const Range& half : {Range{r.from, middle}, Range{middle, r.to}}) {
    if (!(first ? separate(half, q) : separate(p, half))) return false;
  }
  return true;
}

double ExactSeparation::extent(const Side& side, const Range& range) {
  double extent = 0;
  for (const Vector d : {Vector{1, 0}, Vector{0, 1}}) {
    const double high = dot(d, farthest(side, range, d)), low = dot(d, farthest(side, range, -d));
    extent = std::max(extent, high - low);
  }
  return extent;
}

Vector ExactSeparation::farthest(const Side& side, const Range& range, Vector direction) {
  Vector best = side.middle[range.from][0];
  for (std::size_t k = range.from; k < range.to; ++k) {
    for (const Vector v : side.middle[k]) {
      if (dot(direction, v) > dot(direction, best)) best = v;
    }
  }
  return best;
}

/// From the first range towards the second one, where both are in the middle of the window: between their nearest
/// points (Gilbert, Johnson, Keerthi). Nothing if their hulls meet.
std::optional<Vector> ExactSeparation::towards(const Range& p, const Range& q) const {
  const auto support = [&](Vector d) { return farthest(second_, q, -d) - farthest(first_, p, d); };
  Vector nearest = second_.middle[q.from][0] - first_.middle[p.from][0];
  std::vector<Vector> corners = {nearest};
  for (int k = 0; k < 40; ++k) {
    const double square = dot(nearest, nearest);
    if (!(square > 0)) return std::nullopt;
    const Vector next = support(nearest);
    if (dot(nearest, next) >= square * (1 - 1e-9)) break;
    corners.push_back(next);
    const auto found = nearest_to_origin(corners);
    if (!found) return std::nullopt;
    if (!(dot(*found, *found) < square)) break;
    nearest = *found;
  }
  if (!(dot(nearest, support(nearest)) > 0)) return std::nullopt;
  return nearest;
}

std::optional<ExactStep> ExactSeparation::line(const Range& p, const Range& q) const {
  const auto direction = towards(p, q);
  if (!direction) return std::nullopt;
  const double length = std::sqrt(dot(*direction, *direction));
  for (const double scale : {0x1p8, 0x1p30}) {
    ExactStep step;
    step.normal = {std::nearbyint(direction->x / length * scale), std::nearbyint(direction->y / length * scale)};
    const Vector high = farthest(first_, p, step.normal), low = farthest(second_, q, -step.normal);
    const double gap = dot(step.normal, low) - dot(step.normal, high);
    if (!(gap > 0)) continue;
    // The line moves as the two ranges do next to it, on average.
    const auto speed = [&](const Side& side, Vector middle) {
      const Vector at{side.place.x.c[0], side.place.y.c[0]}, along{side.place.cosine.c[0], side.place.sine.c[0]};
      const Vector own = conj(along) * (middle - at);
      return Projection(side.place, step.normal).of({own.x, own.y}).c[1];
    };
    step.level = rounded_to(dot(step.normal, high) + gap / 2, gap / 16);
    if (models_.radius() > 0)
      step.slope = rounded_to((speed(first_, high) + speed(second_, low)) / 2, gap / (16 * models_.radius()));
    if (holds(step, p, q)) return step;
  }
  return std::nullopt;
}

bool ExactSeparation::holds(const ExactStep& step, const Range& p, const Range& q) const {
  LocalModel level = LocalModel::constant(step.level);
  level.c[1] = step.slope;
  const auto on_side = [&](const Side& side, const Range& range, double sign) {
    const Projection along(side.place, step.normal);
    // Far more than what rounding makes of these sums.
    const double room = 0x1p-46 * (models_.bound(along.base) + models_.bound(level) +
                                   side.reach * (models_.bound(along.per_x) + models_.bound(along.per_y)));
    return std::all_of(side.edges.begin() + static_cast<std::ptrdiff_t>(range.from),
                       side.edges.begin() + static_cast<std::ptrdiff_t>(range.to), [&](const ExactEdge& e) {
                         return models_.lower(sign * (along.of(e[0]) - level)) > room &&
                                models_.lower(sign * (along.of(e[1]) - level)) > room;
                       });
  };
  return on_side(first_, p, -1) && on_side(second_, q, 1);
}

}  // namespace taut::internal
