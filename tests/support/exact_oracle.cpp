#include "support/exact_oracle.hpp"

#include <algorithm>
#include <cmath>

#include "support/exact_placement.hpp"
#include "support/exact_roots.hpp"
#include "support/exact_stretches.hpp"

namespace taut::testing::exact {
namespace {

constexpr int time_bits = 256;

/// How far the displacement may move a vertex, in the scene's units and on the safe side.
double greatest_shift(const Scene& scene) {
  double largest = 0, sharpest = 1;
  for (const Body& body : scene.bodies) {
    const std::size_t n = body.polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point &v = body.polygon[i], &a = body.polygon[(i + n - 1) % n], &b = body.polygon[(i + 1) % n];
      largest = std::max({largest, std::fabs(v.x), std::fabs(v.y)});
      const double ax = a.x - v.x, ay = a.y - v.y, bx = b.x - v.x, by = b.y - v.y;
      const double half = std::fabs(std::atan2(ax * by - ay * bx, ax * bx + ay * by)) / 2;
      sharpest = std::max(sharpest, 1 / std::max(std::sin(half), 0x1p-41));
    }
  }
  return largest * sharpest * 0x1p-190;
}

/// A vertex comes to lie on an edge, or leaves it.
struct Event {
  Root root;
  VertexEdge pair;
};

/// Follows one segment.
class ContactOnSegment {
 public:
  ContactOnSegment(const MotionSegment& segment, const Shapes& shapes, Touch touch, double shift)
      : segment_(segment), shapes_(shapes), open_(touch == Touch::open), shift_(shift), finder_(segment) {
    for (int side = 0; side < 2; ++side) {
      for (int v = 0; v < segment.size(1 - side); ++v)
        for (int e = 0; e < segment.size(side); ++e) pairs_.push_back({side, v, e});
    }
    zero_.fill(std::vector<State>(pairs_.size(), unknown));
  }

  /// At the segment's start, exactly.
  bool overlap_at_start() { return interiors_intersect(shapes_, exactly_at(segment_.from())); }

  /// True if there is a contact, at or after the segment's start: `answer` has it.
  bool run(bool first, ExactAnswer& answer) {
    answer_ = &answer;
    const bool touching_at_start = open_ || first ? touch_at_start() : false;
    if (touching_at_start && !open_) return true;
    std::vector<int> all;
    for (std::size_t k = 0; k < pairs_.size(); ++k) all.push_back(static_cast<int>(k));
    return segment_.from() < segment_.to() && search(segment_.from(), segment_.to(), all, 0);
  }
  bool assumed() const { return assumed_ || finder_.assumed; }

 private:
  enum State : std::uint8_t { unknown, zero, varying };

  Function function(int k, What what) const { return {pairs_[static_cast<std::size_t>(k)], what}; }

  State& state(int k, What what) { return zero_[static_cast<std::size_t>(what)][static_cast<std::size_t>(k)]; }
  bool identically_zero(int k, What what) {
    State& known = state(k, what);
    if (known == unknown) known = segment_.identically_zero(function(k, what), assumed_) ? zero : varying;
    return known == zero;
  }

  // ---- judging an instant

  Signs exactly_at(const Rational& u) {
    return [this, u](const Function& f) { return finder_.sign_at(f, 0, u); };
  }

  struct Coincidence {};

  /// At an instant at which nothing vanishes but what always does.
  bool overlap_at(const Rational& u) {
    const Narrow n = Narrow::of(u);
    const std::array<FrameOf<Narrow, 4>, 2> frames{segment_.frame(0, n), segment_.frame(1, n)};
    return interiors_intersect(shapes_, [&](const Function& f) {
      const Narrow v = segment_.coefficient(f, frames[static_cast<std::size_t>(f.pair.side)], 0);
      if (v.positive() || v.negative()) return v.positive() ? 1 : -1;
      for (const int bits : {192, 700}) {
        Precision at(bits);
        const int sign = segment_.coefficient(f, Wide::of(u), 0).sign();
        if (sign != 0) return sign;
        if (segment_.identically_zero(f, assumed_)) return 0;
      }
      throw Coincidence{};
    });
  }
  bool overlap_between(const Rational& lo, const Rational& hi) {
    for (const double share : {0.4142135, 0.7320508, 0.2360679, 0.1622776, 0.8284271}) {
      try {
        return overlap_at(Rational(lo + (hi - lo) * Rational(share)));
      } catch (const Coincidence&) {
      }
    }
    throw Beyond{"coincidences at every instant tried"};
  }

  // ---- going on in time

  /// A function over [m - h, m + h], and its derivative: Taylor coefficients at m, and the last one over all of it.
  struct Model {
    MotionSegment::NarrowSeries at;
    Narrow last, h;

    Narrow range() const { return at.c[0] + h * (at.c[1] + h * (at.c[2] + h * (at.c[3] + h * last))); }
    Narrow slope() const {
      return at.c[1] + h * (Narrow(2) * at.c[2] + h * (Narrow(3) * at.c[3] + h * Narrow(4) * last));
    }
  };
  static bool definite(const Narrow& x) { return x.positive() || x.negative(); }

  /// Of one slab of time, in doubles.
  struct View {
    std::array<FrameOf<Narrow, 4>, 2> at, over;
    Narrow h;
  };
  Model model(const Function& f, const View& view) const {
    const auto side = static_cast<std::size_t>(f.pair.side);
    return {segment_.series(f, view.at[side]), segment_.coefficient(f, view.over[side], 4), view.h};
  }

  bool search(const Rational& lo, const Rational& hi, const std::vector<int>& active, int depth) {
    if (active.empty() && !pending_) return false;
    const Narrow low = Narrow::of(lo), high = Narrow::of(hi), m = Narrow((low.lo() + high.hi()) / 2);
    const Narrow whole(low.lo(), high.hi());
    const View view{
        {segment_.frame(0, m), segment_.frame(1, m)}, {segment_.frame(0, whole), segment_.frame(1, whole)}, whole - m};
    std::vector<int> rest;
    bool ready = true;
    for (const int k : active) {
      bool simple = false;
      if (apart(k, view, simple)) continue;
      ready &= simple;
      rest.push_back(k);
    }
    if (ready || depth >= 12) return settle(lo, hi, rest);
    const Rational middle = lo + (hi - lo) * Rational(0.4871093752312312);
    return search(lo, middle, rest, depth + 1) || search(middle, hi, rest, depth + 1);
  }

  /// `simple`: what is asked of the pair in this slab is easy.
  bool apart(int k, const View& view, bool& simple) {
    bool along_simple = true;
    for (const What what : {What::past_a, What::past_b}) {
      const Model past = model(function(k, what), view);
      const Narrow v = past.range();
      if (what == What::past_a ? v.negative() : v.positive()) return true;
      along_simple &= definite(v) || easy(k, what, past);
    }
    const Model height = model(function(k, What::height), view);
    if (definite(height.range())) return true;
    simple = definite(height.slope()) || (along_simple && easy(k, What::height, height));
    return false;
  }
  /// Monotone, or always zero.
  bool easy(int k, What what, const Model& f) {
    if (definite(f.at.c[0])) state(k, what) = varying;
    return definite(f.slope()) || identically_zero(k, what);
  }

  /// All events of the slab, in order.
  bool settle(const Rational& lo, const Rational& hi, const std::vector<int>& pairs) {
    std::vector<Event> events;
    misses_.clear();
    for (const int k : pairs) find_events(k, lo, hi, events);
    for (Event& e : events) finder_.refine(e.root, time_bits);
    if (events.empty()) expect_no_miss(nullptr);
    std::sort(events.begin(), events.end(),
              [](const Event& a, const Event& b) { return a.root.at.middle().before(b.root.at.middle()); });
    Rational from = lo;
    if (pending_ && pending_until_ > from) from = pending_until_;
    for (std::size_t k = 0; k < events.size();) {
      std::size_t end = k + 1;
      Wide hull = events[k].root.at;
      while (end < events.size() && !hull.before(events[end].root.at)) hull = Wide::hull(hull, events[end++].root.at);
      if (!open_) {
        conclude(events, k, end);
        expect_no_miss(answer_);
        return true;
      }
      if (pending_ && hull.exact_lo() > from && overlap_between(from, hull.exact_lo())) {
        for (std::size_t i = k; i < end; ++i) around_.push_back(events[i].pair);
        return deep_between(from, hull.exact_lo());
      }
      ExactAnswer& answer = *answer_;
      answer = {};
      around_.clear();
      conclude(events, k, end);
      pending_ = true;
      pending_until_ = from = hull.exact_hi();
      k = end;
    }
    if (!pending_ || from >= hi) return false;
    if (overlap_between(from, hi)) return deep_between(from, hi);
    pending_ = false;
    return false;
  }

  /// Bodies that overlap by less than the displacement may miss each other displaced. Every vertex that crossed an edge
  /// just before this overlap, or crosses one just after it, is farther than that from the edge's line meanwhile.
  bool deep_between(const Rational& lo, const Rational& hi) {
    const Rational u(lo + (hi - lo) * Rational(0.4142135));
    Precision at(3 * time_bits);
    for (const VertexEdge& pair : around_) {
      const Wide height = segment_.coefficient({pair, What::height}, Wide::of(u), 0);
      const double distance = std::max(std::fabs(height.lo()), std::fabs(height.hi())) / unit_of(pair, u);
      if (height.sign() != 0 && distance <= shift_) throw Beyond{"bodies that overlap by less than the displacement"};
    }
    return true;
  }
  /// The height of a vertex one unit above an edge.
  double unit_of(const VertexEdge& pair, const Rational& u) const {
    return segment_.length(pair.side, pair.edge) * segment_.frame(pair.side, Narrow::of(u)).r.c[0].hi();
  }

  void find_events(int k, const Rational& lo, const Rational& hi, std::vector<Event>& events) {
    const VertexEdge& pair = pairs_[static_cast<std::size_t>(k)];
    if (!identically_zero(k, What::height)) {
      for (Root& r : finder_.zeros(function(k, What::height), lo, hi)) {
        if (on_edge(k, r)) {
          events.push_back({std::move(r), pair});
        } else if (!open_ && within_shift_of_edge(pair, r)) {
          misses_.push_back(std::move(r));
        }
      }
      return;
    }
    for (const What what : {What::past_a, What::past_b}) {
      if (identically_zero(k, what)) continue;
      for (Root& r : finder_.zeros(function(k, what), lo, hi)) {
        if (on_edge(k, r)) events.push_back({std::move(r), pair});
      }
    }
  }
  bool on_edge(int k, Root& r) {
    return finder_.sign_at(function(k, What::past_a), 0, r) >= 0 &&
           finder_.sign_at(function(k, What::past_b), 0, r) <= 0;
  }

  /// Beyond an end of the edge by less than the displacement: displaced, larger bodies may touch there.
  bool within_shift_of_edge(const VertexEdge& pair, Root& r) {
    const double near = shift_ * unit_of(pair, r.at.exact_lo());
    const auto may_be = [&] {
      Precision at(2 * time_bits);
      return segment_.coefficient({pair, What::past_a}, r.at, 0).hi() >= -near &&
             segment_.coefficient({pair, What::past_b}, r.at, 0).lo() <= near;
    };
    if (!may_be()) return false;
    finder_.refine(r, time_bits);
    return may_be();
  }

  /// Before a contact, if there is one, by more than the displacement may move that.
  void expect_no_miss(const ExactAnswer* contact) const {
    for (const Root& miss : misses_) {
      if (!contact || (segment_.time(miss.at) + Wide(contact->sway)).before(contact->time))
        throw Beyond{"bodies that miss each other by less than the displacement"};
    }
  }

  // ---- the answer

  void meet(const VertexEdge& pair) {
    const Meeting m{1 - pair.side, pair.vertex, pair.edge};
    std::vector<Meeting>& all = answer_->meetings;
    if (std::find(all.begin(), all.end(), m) == all.end()) all.push_back(m);
  }

  void conclude(std::vector<Event>& events, std::size_t from, std::size_t to) {
    ExactAnswer& answer = *answer_;
    answer.verdict = Verdict::contact;
    Precision precision(2 * time_bits);
    Wide hull = events[from].root.at;
    way_ = 0;
    for (std::size_t k = from; k < to; ++k) {
      hull = Wide::hull(hull, events[k].root.at);
      weigh(events[k]);
      meet(events[k].pair);
      around_.push_back(events[k].pair);
    }
    answer.time = segment_.time(hull);
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
      const int i = static_cast<int>(k);
      Root& first = events[from].root;
      if (state(i, What::height) == zero ? on_edge(i, first) : within_shift(pairs_[k], first.at)) {
        meet(pairs_[k]);
      }
    }
  }

  /// Displaced, these two may be those that meet.
  bool within_shift(const VertexEdge& pair, const Wide& u) const {
    const double near = shift_ * unit_of(pair, u.exact_lo());
    // A little before or after, too, as far as the displacement moves the instant.
    const auto not_below = [&](What what, int sign) {
      const Wide value = segment_.coefficient({pair, what}, u, 0), slope = segment_.coefficient({pair, what}, u, 1);
      const double most = sign > 0 ? value.hi() : -value.lo();
      return most + way_ * std::max(std::fabs(slope.lo()), std::fabs(slope.hi())) >= -near;
    };
    return not_below(What::height, 1) && not_below(What::height, -1) && not_below(What::past_a, 1) &&
           not_below(What::past_b, -1);
  }

  void weigh(Event& e) {
    const int m = finder_.multiplicity(e.root);
    const double u = e.root.at.lo();
    const Wide coefficient = segment_.coefficient(e.root.function, e.root.at, m);
    const double size = std::max(std::fabs(coefficient.lo()), std::fabs(coefficient.hi()));
    const double height = size / unit_of(e.pair, e.root.at.exact_lo());
    const double way = std::pow(shift_ / height, 1.0 / m);
    way_ = std::max(way_, way);
    const Wide t = segment_.time(Wide(u));
    for (const double side : {-way, way}) {
      Precision precision(2 * time_bits);
      const Wide moved = segment_.time(Wide(u) + Wide(side)) - t;
      answer_->sway = std::max({answer_->sway, std::fabs(moved.lo()), std::fabs(moved.hi())});
    }
    answer_->multiplicity = std::max(answer_->multiplicity, m);
  }

  /// Sets the answer to a contact at the start of the segment, if the bodies touch there.
  bool touch_at_start() {
    const Signs signs = exactly_at(segment_.from());
    const Narrow n = Narrow::of(segment_.from());
    const std::array<FrameOf<Narrow, 4>, 2> frames{segment_.frame(0, n), segment_.frame(1, n)};
    std::vector<VertexEdge> touching_pairs;
    for (const VertexEdge& pair : pairs_) {
      const auto side = static_cast<std::size_t>(pair.side);
      if (definite(segment_.coefficient({pair, What::height}, frames[side], 0))) continue;
      if (touching(pair, signs)) touching_pairs.push_back(pair);
    }
    if (touching_pairs.empty()) return false;
    Precision precision(2 * time_bits);
    *answer_ = {};
    around_.clear();
    for (const VertexEdge& pair : touching_pairs) meet(pair);
    answer_->verdict = Verdict::contact;
    answer_->time = segment_.time(Wide::of(segment_.from()));
    pending_ = open_;
    pending_until_ = segment_.from();
    return true;
  }

  const MotionSegment& segment_;
  const Shapes& shapes_;
  bool open_;
  double shift_;
  RootFinder finder_;
  std::vector<VertexEdge> pairs_;
  /// Of the height, past_a and past_b of each pair.
  std::array<std::vector<State>, 3> zero_;
  ExactAnswer* answer_ = nullptr;
  /// Open reading: the bodies touch at the answer's time, and what follows is not known yet.
  bool pending_ = false;
  Rational pending_until_;
  /// By how much the displacement may move the parameter of the answer's instant.
  double way_ = 0;
  /// Those that met at the answer's time.
  std::vector<VertexEdge> around_;
  /// Closed reading: when vertices pass an edge's end by less than the displacement.
  std::vector<Root> misses_;
  bool assumed_ = false;
};

ExactAnswer search(const Scene& scene, Touch touch) {
  const Shapes shapes(scene);
  const double shift = greatest_shift(scene);
  const std::vector<MotionSegment> segments = stretches(scene);
  ExactAnswer answer;
  bool assumed = false;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    ContactOnSegment segment(segments[k], shapes, touch, shift);
    if (k == 0 && segment.overlap_at_start()) {
      answer.verdict = Verdict::overlap_at_start;
      return answer;
    }
    const bool found = segment.run(k == 0, answer);
    assumed |= segment.assumed();
    if (found) {
      answer.assumed = assumed;
      return answer;
    }
  }
  answer = {};
  answer.verdict = Verdict::free;
  answer.assumed = assumed;
  return answer;
}

}  // namespace

const char* to_string(Verdict verdict) {
  static constexpr const char* names[] = {"free", "contact", "overlap_at_start", "beyond"};
  return names[static_cast<int>(verdict)];
}

ExactAnswer first_contact(const Scene& scene, Touch touch) {
  try {
    return search(scene, touch);
  } catch (const Beyond& beyond) {
    ExactAnswer answer;
    answer.why = beyond.why;
    return answer;
  }
}

}  // namespace taut::testing::exact
