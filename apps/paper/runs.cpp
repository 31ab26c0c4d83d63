#include "runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "generators/generators.hpp"
#include "generators/shapes.hpp"
#include "taut/separator.hpp"

namespace taut::paper {
namespace {

/// c(a t + b), expanded.
Coefficients substituted(const Coefficients& c, double a, double b) {
  Coefficients out(1, 0.0);
  for (std::size_t i = c.size(); i-- > 0;) {
    Coefficients next(out.size() + 1, 0.0);
    for (std::size_t j = 0; j < out.size(); ++j) next[j + 1] += a * out[j], next[j] += b * out[j];
    next[0] += c[i];
    out = std::move(next);
  }
  out.resize(c.size());
  return out;
}

/// A random polynomial of this degree that stays within +-size on [0, 1].
Coefficients random_polynomial(gen::Random& random, int degree, double size) {
  Coefficients sum(static_cast<std::size_t>(degree) + 1, 0.0);
  double weight = 0;
  for (int k = 1; k <= degree; ++k) {
    const double w = random.uniform(-1, 1);
    weight += std::fabs(w);
    const Coefficients shifted = substituted(gen::chebyshev(k, w, 0), 2, -1);
    for (std::size_t i = 0; i < sum.size() && i < shifted.size(); ++i) sum[i] += shifted[i];
  }
  for (double& c : sum) c *= size / weight;
  return sum;
}

/// Teeth upwards from a bar below y = 0 at distance 1, of random heights up to 4.
Polygon random_comb(gen::Random& random, int teeth) {
  Polygon polygon{{-0.5, -1}, {teeth - 0.5, -1}};
  for (int i = teeth - 1; i >= 0; --i) {
    const double height = random.uniform(1, 4);
    for (const Point& p : {Point{0.2, 0}, Point{0.2, height}, Point{-0.2, height}, Point{-0.2, 0}})
      polygon.push_back({i + p.x, p.y});
  }
  return polygon;
}

/// Inscribed in the unit circle.
Polygon random_convex(gen::Random& random, int n) {
  std::vector<double> angles;
  for (int i = 0; i < n; ++i) angles.push_back(2 * gen::pi * (i + random.uniform(0, 0.9)) / n);
  Polygon polygon;
  for (const double a : angles) polygon.push_back(gen::polar(1, a));
  return polygon;
}

Coefficients plus(Coefficients c, double constant) {
  c[0] += constant;
  return c;
}

/// Counts what repairs touch.
class RepairWatcher : public Tracer {
 public:
  void on_event(const TraceEvent& e) override {
    corners = std::max(corners, e.corners_touched);
    const bool one = e.repair == Repair::convex_triangle || e.repair == Repair::reflex_new_face;
    edges = std::max(edges, one ? 1 : 2);
  }
  int corners = 0, edges = 0;
};

}  // namespace

Scene fig16(int k, int n) {
  gen::DipOptions o;
  o.sides = n;
  o.dips = k <= max_degree ? k / 2 : 4;
  Scene scene = gen::make_dips(o);
  if (k <= max_degree) return scene;
  // Four dips in each piece: the Chebyshev polynomial is 1 at both its ends, so that the pieces join.
  const MotionPiece whole = scene.bodies[1].motion.pieces[0];
  const int pieces = k / 8;
  scene.bodies[1].motion.pieces.clear();
  for (int i = 0; i < pieces; ++i) {
    MotionPiece piece = whole;
    piece.y = substituted(whole.y, pieces, pieces - 1 - 2 * i);
    piece.until = -1 + 2.0 * (i + 1) / pieces;
    scene.bodies[1].motion.pieces.push_back(piece);
  }
  return scene;
}

Scene fig17(int n) {
  gen::RotorOptions o;
  o.teeth = std::max(3, n / 2);
  o.chain_edges = std::max(2, n - 4);
  return gen::make_rotor(o);
}

Scene combs_leaving(int n, std::uint64_t seed) {
  gen::Random random(seed);
  const int teeth = std::max(2, (n / 2 - 2) / 4);
  Polygon lower = random_comb(random, teeth), upper = random_comb(random, teeth);
  for (Point& p : upper) p = {teeth - 0.5 - p.x, 4.5 - p.y};
  const Coefficients x = random_polynomial(random, 4, 0.08);
  Coefficients y{0, random.uniform(0.5, 1.5), random.uniform(0.5, 1.5), random.uniform(0.5, 1.5), random.uniform(2, 4)};
  Scene scene;
  scene.end = 1;
  // From within the play: the path's start is the poses' zero.
  scene.bodies = {{"lower", lower, {}}, {"upper", upper, Motion{{gen::translation(x, y)}}}};
  return scene;
}

Scene convex_passing(int n, std::uint64_t seed) {
  gen::Random random(seed);
  Scene scene;
  scene.end = 1;
  const Coefficients x = random_polynomial(random, 4, 8), y = plus(random_polynomial(random, 4, 1), 3.1);
  const Polygon p = random_convex(random, n / 2), q = random_convex(random, n - n / 2);
  scene.bodies = {{"resting", p, {}}, {"passing", q, Motion{{gen::translation(x, y)}}}};
  return scene;
}

Scene convex_turning(int n, std::uint64_t seed) {
  Scene scene = convex_passing(n, seed);
  gen::Random random(seed + 1000);
  scene.bodies[1].motion.pieces[0].rotation = AngleRotation{random_polynomial(random, 3, 6)};
  scene.bodies[0].motion.pieces = {gen::translation({}, {})};
  scene.bodies[0].motion.pieces[0].rotation = AngleRotation{random_polynomial(random, 3, 6)};
  return scene;
}

Scene gears(int n) {
  gen::GearOptions o;
  o.teeth_1 = std::max(11, n / 24);
  o.teeth_2 = o.teeth_1 + 1;
  o.flank_points = std::max(3, (n / o.teeth_1 / 2 - 2) / 2);
  return gen::make_gears(o);
}

Scene at_rest(Scene scene, double t) {
  const auto polygons = placed(scene, t);
  for (std::size_t k = 0; k < 2; ++k) {
    scene.bodies[k].polygon = polygons[k];
    scene.bodies[k].motion = {};
  }
  scene.start = 0;
  scene.end = 1;
  return scene;
}

Run run_free(const Scene& scene, int repeats) {
  RepairWatcher watcher;
  CheckOptions options;
  options.engine = EngineChoice::kinetic;
  options.tracer = &watcher;
  Answer answer = check(scene, options);
  if (answer.outcome != Outcome::free)
    throw std::runtime_error(fmt::format("a scene of the study is not free: {} and {}, {}, at {}", scene.bodies[0].name,
                                         scene.bodies[1].name, to_string(answer.outcome),
                                         answer.contact ? answer.contact->time.lo : answer.free_until));
  Run run;
  run.vertices = scene.bodies[0].polygon.size() + scene.bodies[1].polygon.size();
  run.events = answer.events;
  run.certificates_max = answer.certificates_max;
  run.seconds = answer.run_seconds;
  options.tracer = nullptr;
  for (int k = 1; k < repeats; ++k) run.seconds = std::min(run.seconds, check(scene, options).run_seconds);
  run.corners_touched = watcher.corners;
  run.edges_changed = watcher.edges;
  return run;
}

}  // namespace taut::paper
