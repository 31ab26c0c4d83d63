#include "support/brute_force.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "support/brute_motion.hpp"

namespace taut::testing {

namespace {

/// A body over one interval of time.
struct Snapshot {
  std::vector<Vec> position, velocity;  // in the middle
  FrameBounds bounds;
  Real acceleration = 0;  // of any vertex, throughout the interval
  Real way = 0;           // of any vertex from its place in the middle
};

class MovingBody {
 public:
  explicit MovingBody(const Body& body) {
    for (const Point& p : body.polygon) {
      local_.push_back({p.x, p.y});
      radius_ = std::max(radius_, length(local_.back()));
    }
    pieces_ = body.motion.pieces;
    if (pieces_.empty()) pieces_.emplace_back();
  }

  int size() const { return static_cast<int>(local_.size()); }
  int next(int i) const { return i + 1 == size() ? 0 : i + 1; }
  const std::vector<MotionPiece>& pieces() const { return pieces_; }
  /// The piece that holds on the open interval after `t`.
  void select(double t) {
    std::size_t k = 0;
    while (k + 1 < pieces_.size() && pieces_[k].until <= t) ++k;
    current_ = BrutePiece(pieces_[k]);
  }

  Real magnitude(Real t) const { return current_.magnitude(t, radius_); }

  static Vec place(const Frame& f, const Vec& p) {
    return {f.origin.x + p.x * f.axis.x - p.y * f.axis.y, f.origin.y + p.x * f.axis.y + p.y * f.axis.x};
  }
  Frame frame(Real t) const { return current_.at(t); }
  Vec vertex(const Frame& f, int i) const { return place(f, local_[i]); }

  void snapshot(Real middle, Real half, Snapshot& s) const {
    const Frame f = current_.at(middle);
    s.bounds = current_.over(middle, half);
    s.position.resize(local_.size());
    s.velocity.resize(local_.size());
    for (std::size_t i = 0; i < local_.size(); ++i) {
      s.position[i] = place(f, local_[i]);
      const Vec arm = s.position[i] - f.origin;
      s.velocity[i] = s.bounds.origin_velocity + s.bounds.middle_rate * Vec{-arm.y, arm.x};
    }
    s.acceleration = s.bounds.acceleration + radius_ * turning(s.bounds);
    s.way = s.bounds.origin_way + radius_ * s.bounds.angle_way;
  }
  /// |x''| <= theta'^2 + |theta''|.
  static Real turning(const FrameBounds& b) { return b.rate * b.rate + b.rate_change; }

 private:
  std::vector<Vec> local_;
  Real radius_ = 0;
  std::vector<MotionPiece> pieces_;
  BrutePiece current_{MotionPiece{}};
};

struct Pair {
  int body;  // of the vertex
  int vertex, edge;
  friend bool operator==(const Pair& a, const Pair& b) {
    return a.body == b.body && a.vertex == b.vertex && a.edge == b.edge;
  }
};

/// What is known of a pair over an interval.
struct Look {
  enum Result { apart, crossing, split } result = split;
  Real gap = 0;  // apart: lower bound of the distance
  Real distance = 0;
};

class Oracle {
 public:
  explicit Oracle(const Scene& scene)
      : scene_(scene), bodies_{MovingBody(scene.bodies[0]), MovingBody(scene.bodies[1])} {}

  OracleAnswer run() {
    measure();
    if (overlap_at_start()) {
      answer_.verdict = Verdict::overlap_at_start;
      answer_.margin = 1;
      return answer_;
    }
    std::vector<double> times{scene_.start, scene_.end};
    for (const MovingBody& b : bodies_)
      for (const MotionPiece& p : b.pieces())
        if (p.until > scene_.start && p.until < scene_.end) times.push_back(p.until);
    std::sort(times.begin(), times.end());
    answer_.verdict = Verdict::free;
    for (std::size_t k = 0; k + 1 < times.size() && answer_.verdict == Verdict::free; ++k) {
      if (times[k] == times[k + 1] && scene_.start != scene_.end) continue;
      piece_start_ = times[k];
      piece_end_ = times[k + 1];
      for (MovingBody& b : bodies_) b.select(times[k]);
      search(times[k], times[k + 1], all_pairs(), 0);
    }
    conclude();
    return answer_;
  }

 private:
  std::vector<Pair> all_pairs() const {
    std::vector<Pair> pairs;
    for (int b = 0; b < 2; ++b)
      for (int v = 0; v < bodies_[b].size(); ++v)
        for (int e = 0; e < bodies_[1 - b].size(); ++e) pairs.push_back({b, v, e});
    return pairs;
  }

  std::vector<Vec> place_all(int body, Real t) const {
    const Frame f = bodies_[body].frame(t);
    std::vector<Vec> at;
    for (int i = 0; i < bodies_[body].size(); ++i) at.push_back(bodies_[body].vertex(f, i));
    return at;
  }

  /// The extent of both bodies at the start: the unit of the margins.
  void measure() {
    for (MovingBody& b : bodies_) b.select(scene_.start);
    Vec lo{INFINITY, INFINITY}, hi{-INFINITY, -INFINITY};
    for (int b = 0; b < 2; ++b)
      for (const Vec& p : place_all(b, scene_.start)) {
        lo = {std::min(lo.x, p.x), std::min(lo.y, p.y)};
        hi = {std::max(hi.x, p.x), std::max(hi.y, p.y)};
      }
    extent_ = length(hi - lo);
    least_gap_ = extent_;
    const Real latest = std::max(std::fabs(scene_.start), std::fabs(scene_.end));
    rounding_ = (bodies_[0].magnitude(latest) + bodies_[1].magnitude(latest)) * 0x1p-60L;
    tiny_ = std::max(extent_ * 1e-13L, 16 * rounding_);
  }

  static bool inside(const std::vector<Vec>& polygon, const Vec& c) {
    bool in = false;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      if ((a.y > c.y) != (b.y > c.y) && (cross(b - a, c - a) > 0) == (b.y > a.y)) in = !in;
    }
    return in;
  }

  /// A proper crossing of two edges by more than rounding, or one body within the other.
  bool overlap_at_start() const {
    const std::vector<Vec> p = place_all(0, scene_.start), q = place_all(1, scene_.start);
    const auto sides = [&](const Vec& a, const Vec& b, const Vec& c, const Vec& d) {
      const Real l = length(b - a), s = cross(b - a, c - a) / l, t = cross(b - a, d - a) / l;
      return std::min(std::fabs(s), std::fabs(t)) > tiny_ && (s > 0) != (t > 0);
    };
    for (std::size_t i = 0; i < p.size(); ++i)
      for (std::size_t j = 0; j < q.size(); ++j) {
        const Vec &a = p[i], &b = p[(i + 1) % p.size()], &c = q[j], &d = q[(j + 1) % q.size()];
        if (sides(a, b, c, d) && sides(c, d, a, b)) return true;
      }
    return (inside(p, q[0]) && inside(p, q[1])) || (inside(q, p[0]) && inside(q, p[1]));
  }

  void fail(Real t) {
    answer_.verdict = Verdict::unclear;
    answer_.t = static_cast<double>(t);
  }

  /// Depth first, earlier half first. Pairs that stay apart throughout are dropped.
  void search(Real from, Real to, const std::vector<Pair>& pairs, int depth) {
    if (pairs.empty() || answer_.verdict == Verdict::unclear) return;
    if (answer_.verdict == Verdict::contact && from > contact_) return;
    const Real middle = (from + to) / 2, half = (to - from) / 2;
    if (depth > 60 || answer_.evaluations > 200000000) return fail(middle);
    std::array<Snapshot, 2>& s = snapshots_[depth];
    for (int b = 0; b < 2; ++b) bodies_[b].snapshot(middle, half, s[b]);
    std::vector<Pair> rest;
    for (const Pair& p : pairs) {
      const Look look = look_at(p, s, half);
      if (look.result == Look::apart) {
        least_gap_ = std::min(least_gap_, look.gap);
      } else if (look.result == Look::split || !accept_crossing(p, from, to)) {
        if (look.distance < tiny_ && half < (scene_.end - scene_.start) * 1e-9L) return fail(middle);
        rest.push_back(p);
      }
    }
    search(from, middle, rest, depth + 1);
    search(middle, to, rest, depth + 1);
  }

  /// With D along the edge and W from its first end to the vertex, F = D x W is zero when the vertex is on the line.
  Look look_at(const Pair& p, const std::array<Snapshot, 2>& s, Real h) {
    ++answer_.evaluations;
    const Snapshot &vs = s[p.body], &es = s[1 - p.body];
    const int f = bodies_[1 - p.body].next(p.edge);
    const Vec d = es.position[f] - es.position[p.edge], w = vs.position[p.vertex] - es.position[p.edge];
    const Vec d1 = es.velocity[f] - es.velocity[p.edge], w1 = vs.velocity[p.vertex] - es.velocity[p.edge];
    const Real dd = dot(d, d), l = std::sqrt(dd);
    const Real along = std::min<Real>(1, std::max<Real>(0, dot(w, d) / dd));
    Look look;
    look.distance = length(w - along * d);
    // The vertex moves relative to the edge's points by at most `way`. Written so that NaN never accepts.
    const Real pull = vs.acceleration + es.acceleration;
    const Real speed = std::max(length(w1), length(w1 - d1));
    Real way = h * speed + h * h / 2 * pull;
    if (!(way <= vs.way + es.way)) way = vs.way + es.way;
    look.gap = look.distance - way;
    if (look.gap >= look.distance / 4 && look.gap > tiny_) {
      look.result = Look::apart;
      return look;
    }
    const Real w_speed = length(w1) + h * pull, w_far = length(w) + h * w_speed;
    const Real second = MovingBody::turning(es.bounds) * l * w_far + 2 * es.bounds.rate * l * w_speed + l * pull;
    const Real value = cross(d, w), slope = cross(d1, w) + cross(d, w1);
    const Real height = (std::fabs(value) - h * std::fabs(slope) - h * h / 2 * second) / l;
    if (height >= look.distance / 4 && height > tiny_) {
      look.gap = height;
      look.result = Look::apart;
    } else if (std::fabs(slope) > h * second && std::fabs(value) <= h * (std::fabs(slope) + h / 2 * second)) {
      look.result = Look::crossing;  // F is monotone, and may vanish
    }
    return look;
  }

  struct Instant {
    Vec d, w;
    Real f() const { return cross(d, w); }
    Real along() const { return dot(d, w) / dot(d, d); }
  };
  Instant instant(const Pair& p, Real t) const {
    const Frame vf = bodies_[p.body].frame(t), ef = bodies_[1 - p.body].frame(t);
    const Vec a = bodies_[1 - p.body].vertex(ef, p.edge);
    const Vec b = bodies_[1 - p.body].vertex(ef, bodies_[1 - p.body].next(p.edge));
    return {b - a, bodies_[p.body].vertex(vf, p.vertex) - a};
  }

  bool on_line(const Pair& p, Real t) const {
    const Instant at = instant(p, t);
    return std::fabs(at.f()) < tiny_ * length(at.d);
  }

  /// The sign change of F in [from, to], where it is monotone.
  bool bisect(const Pair& p, Real from, Real to, Real& root) const {
    const bool up = instant(p, to).f() > 0;
    if (up == (instant(p, from).f() > 0)) return false;
    for (;;) {
      const Real m = (from + to) / 2;
      if (!(from < m && m < to)) break;
      ((instant(p, m).f() > 0) == up ? to : from) = m;
    }
    root = to;
    return true;
  }

  /// F is monotone on [from, to]. True if it vanishes there with the vertex well within the edge.
  bool accept_crossing(const Pair& p, Real from, Real to) {
    Real root = from;
    if (to < piece_end_ && on_line(p, to)) {
      root = to;
    } else if (!(from > piece_start_ && on_line(p, from)) && !bisect(p, from, to, root)) {
      return false;
    }
    const Instant at = instant(p, root);
    const Real along = at.along();
    if (!(along > 0 && along < 1)) return false;
    const Real end_distance = std::min(along, 1 - along) * length(at.d);
    if (!(end_distance > tiny_)) return false;
    if (answer_.verdict == Verdict::contact) {
      if (p == pair_ && std::fabs(root - contact_) <= (to - from)) return true;  // met again from the other side
      runner_up_ = std::min(runner_up_, std::max(root, contact_));
      if (contact_ <= root) return true;
    }
    answer_.verdict = Verdict::contact;
    contact_ = root;
    pair_ = p;
    end_distance_ = end_distance;
    return true;
  }

  void conclude() {
    if (answer_.verdict == Verdict::unclear) return;
    Real gap = least_gap_;
    if (answer_.verdict == Verdict::contact) {
      answer_.t = static_cast<double>(contact_);
      answer_.vertex_body = pair_.body;
      answer_.vertex = pair_.vertex;
      answer_.edge_body = 1 - pair_.body;
      answer_.edge = pair_.edge;
      gap = std::min({gap, end_distance_, judge_crossing()});
      answer_.lead = static_cast<double>(lead_ / extent_);
    }
    answer_.gap = static_cast<double>(gap / extent_);
    answer_.margin = std::min({answer_.gap, answer_.transversality, answer_.speed});
  }

  /// Sets transversality, speed and lead; returns how far in, at this speed, the start and the end are.
  Real judge_crossing() {
    Snapshot s[2];
    Real fastest = 0;
    for (int k = 0; k <= 16; ++k)
      for (int b = 0; b < 2; ++b) {
        const Real t = scene_.start + (Real(scene_.end) - scene_.start) * k / 16;
        bodies_[b].select(static_cast<double>(t));
        bodies_[b].snapshot(t, 0, s[b]);
        for (const Vec& v : s[b].velocity)
          if (std::isfinite(length(v))) fastest = std::max(fastest, length(v));
      }
    for (int b = 0; b < 2; ++b) {
      bodies_[b].select(static_cast<double>(piece_start_));
      bodies_[b].snapshot(contact_, 0, s[b]);
    }
    const Snapshot &vs = s[pair_.body], &es = s[1 - pair_.body];
    const Instant at = instant(pair_, contact_);
    const Vec d1 = es.velocity[bodies_[1 - pair_.body].next(pair_.edge)] - es.velocity[pair_.edge];
    const Vec relative = vs.velocity[pair_.vertex] - es.velocity[pair_.edge] - at.along() * d1;
    const Real speed = length(relative), normal = std::fabs(cross(at.d, relative)) / length(at.d);
    answer_.transversality = static_cast<double>(normal / speed);
    answer_.speed = static_cast<double>(std::min<Real>(1, speed / fastest));
    answer_.time_error = static_cast<double>(rounding_ / normal) + std::fabs(answer_.t) * 0x1p-52;
    lead_ = std::min(extent_, (runner_up_ - contact_) * speed);
    return speed * std::min(contact_ - scene_.start, scene_.end - contact_);
  }

  const Scene& scene_;
  std::array<MovingBody, 2> bodies_;
  std::array<std::array<Snapshot, 2>, 64> snapshots_;
  OracleAnswer answer_;
  Real extent_ = 0, least_gap_ = 0, rounding_ = 0, tiny_ = 0;
  Real piece_start_ = 0, piece_end_ = 0;  // the time between joints that is searched
  Real contact_ = INFINITY, runner_up_ = INFINITY, end_distance_ = 0, lead_ = 0;
  Pair pair_{0, 0, 0};
};

}  // namespace

const char* to_string(Verdict verdict) {
  static constexpr const char* names[] = {"free", "contact", "overlap_at_start", "unclear"};
  return names[static_cast<int>(verdict)];
}

OracleAnswer brute_force(const Scene& scene) { return Oracle(scene).run(); }

}  // namespace taut::testing
