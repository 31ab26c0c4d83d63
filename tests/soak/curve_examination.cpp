#include "curve_examination.hpp"

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "curve_proofs.hpp"
#include "taut/check.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"

namespace taut::testing {
namespace {

constexpr double curve_pi = 3.14159265358979323846;
/// A picture's tolerance, for bodies of a size of about 4.
constexpr double picture_eps = 0.01;

/// Numbers of a scene: the same on every platform, which distributions of the library are not.
class CurveDice {
 public:
  explicit CurveDice(std::uint64_t number) : engine_(number * 0x9E3779B97F4A7C15u + 1) {}
  double within(double lo, double hi) { return lo + (hi - lo) * (static_cast<double>(engine_() >> 11) * 0x1p-53); }
  int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }

 private:
  std::mt19937_64 engine_;
};

Point on_circle(double angle, double r) { return {r * std::cos(angle), r * std::sin(angle)}; }

/// An ellipse, in two arcs.
Outline random_ellipse(CurveDice& dice) {
  const double rx = dice.within(0.5, 2), ry = dice.below(3) == 0 ? rx : dice.within(0.4, 2), turn = dice.within(0, 180);
  const Point end{rx * std::cos(turn * curve_pi / 180), rx * std::sin(turn * curve_pi / 180)}, start{-end.x, -end.y};
  return {start, {ArcTo{rx, ry, turn, false, true, end}, ArcTo{rx, ry, turn, false, true, start}}};
}

/// A star-shaped ring whose corners are joined by lines, arcs that bulge or dent, and Bezier curves.
Outline random_ring(CurveDice& dice) {
  const int n = 3 + dice.below(7);
  std::vector<Point> corners;
  for (int i = 0; i < n; ++i) corners.push_back(on_circle(2 * curve_pi * i / n, dice.within(0.8, 2)));
  Outline ring{corners[0], {}};
  for (int i = 0; i < n; ++i) {
    const Point a = corners[static_cast<std::size_t>(i)], b = corners[static_cast<std::size_t>((i + 1) % n)];
    const double chord = std::hypot(b.x - a.x, b.y - a.y);
    // Beside the middle of the chord, inwards or outwards.
    const auto beside = [&](double share) {
      const double off = dice.within(-0.15, 0.3);
      return Point{a.x + share * (b.x - a.x) + off * (b.y - a.y), a.y + share * (b.y - a.y) - off * (b.x - a.x)};
    };
    switch (dice.below(4)) {
      case 0:
        ring.segments.emplace_back(LineTo{b});
        break;
      case 1: {
        const double r = chord * dice.within(0.9, 3);
        ring.segments.emplace_back(ArcTo{r, r, 0, false, dice.below(3) > 0, b});
        break;
      }
      case 2:
        ring.segments.emplace_back(QuadraticTo{beside(0.5), b});
        break;
      default:
        ring.segments.emplace_back(CubicTo{beside(0.3), beside(0.7), b});
    }
  }
  return ring;
}

MotionPiece random_way(CurveDice& dice, int kind) {
  MotionPiece piece;
  const double angle = dice.within(0, 2 * curve_pi), separated = dice.within(-3.5, 3.5);
  const Point from = on_circle(angle, 6), step = on_circle(angle, -1.2),
              off = on_circle(angle + curve_pi / 2, separated);
  piece.x = {from.x + off.x, step.x};
  piece.y = {from.y + off.y, step.y};
  if (kind > 0) piece.rotation = AngleRotation{{dice.within(0, 6), dice.within(-1, 1)}};
  if (kind > 1) piece.x.push_back(dice.within(-0.1, 0.1));
  return piece;
}

/// One chord's worth of a segment's parameter, so that it is nowhere farther from its curve than `away`: by bounds of
/// the second derivative.
int chords_for(double second_derivative, double away) {
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(second_derivative / (8 * away)))));
}

/// Appendix B.2.4 of SVG 2, in doubles.
void add_arc_chords(const Point& from, const ArcTo& arc, double away, Polygon& out) {
  const double turn = arc.rotation_deg * curve_pi / 180, c = std::cos(turn), s = std::sin(turn);
  const double hx = (from.x - arc.to.x) / 2, hy = (from.y - arc.to.y) / 2;
  const double ux = c * hx + s * hy, uy = c * hy - s * hx;
  const double grow = std::max(1.0, std::hypot(ux / arc.rx, uy / arc.ry)), rx = arc.rx * grow, ry = arc.ry * grow;
  const double q = ux * ux / (rx * rx) + uy * uy / (ry * ry);
  const double k = std::sqrt(std::max(0.0, (1 - q) / q)) * (arc.large == arc.sweep ? -1 : 1);
  const double vx = k * rx * uy / ry, vy = -k * ry * ux / rx;
  const Point centre{c * vx - s * vy + (from.x + arc.to.x) / 2, s * vx + c * vy + (from.y + arc.to.y) / 2};
  const double start = std::atan2((uy - vy) / ry, (ux - vx) / rx);
  double sweep = std::atan2((-uy - vy) / ry, (-ux - vx) / rx) - start;
  if (arc.sweep && sweep <= 0) sweep += 2 * curve_pi;
  if (!arc.sweep && sweep >= 0) sweep -= 2 * curve_pi;
  const int n = chords_for(std::max(rx, ry) * sweep * sweep, away);
  for (int i = 1; i < n; ++i) {
    const double x = rx * std::cos(start + sweep * i / n), y = ry * std::sin(start + sweep * i / n);
    out.push_back({centre.x + c * x - s * y, centre.y + s * x + c * y});
  }
}

void add_bezier_chords(const std::vector<Point>& p, double away, Polygon& out) {
  double second = 0;
  for (std::size_t i = 0; i + 2 < p.size(); ++i)
    second = std::max(second, std::hypot(p[i].x - 2 * p[i + 1].x + p[i + 2].x, p[i].y - 2 * p[i + 1].y + p[i + 2].y));
  const auto degree = static_cast<double>(p.size() - 1);
  const int n = chords_for(degree * (degree - 1) * second, away);
  for (int i = 1; i < n; ++i) {
    const double t = static_cast<double>(i) / n;
    std::vector<Point> q = p;
    while (q.size() > 1) {
      for (std::size_t k = 0; k + 1 < q.size(); ++k)
        q[k] = {q[k].x + t * (q[k + 1].x - q[k].x), q[k].y + t * (q[k + 1].y - q[k].y)};
      q.pop_back();
    }
    out.push_back(q[0]);
  }
}

Polygon chords_of(const Outline& outline, double away) {
  Polygon out{outline.start};
  Point at = outline.start;
  for (const CurveSegment& segment : outline.segments) {
    if (const auto* arc = std::get_if<ArcTo>(&segment)) add_arc_chords(at, *arc, away, out);
    if (const auto* q = std::get_if<QuadraticTo>(&segment)) add_bezier_chords({at, q->control, q->to}, away, out);
    if (const auto* c = std::get_if<CubicTo>(&segment)) add_bezier_chords({at, c->first, c->second, c->to}, away, out);
    at = end_of(segment);
    if (!(at == outline.start)) out.push_back(at);
  }
  return out;
}

/// The same scene of chords.
Scene chords_of(const Scene& scene, double away) {
  Scene out = scene;
  for (Body& body : out.bodies) {
    body.polygon = chords_of(body.curves[0].outline, away);
    body.curves.clear();
  }
  return out;
}

/// The answers about one scene, and about its chords.
class CurveExamination {
 public:
  CurveExamination(const Scene& scene, double max_seconds, Tally& tally)
      : scene_(scene), chords_(chords_of(scene, away_)), tally_(tally) {
    options_.limits.max_seconds = max_seconds;
  }

  std::string run(std::uint64_t number) {
    ask_chords();
    const Answer answer = check(scene_, options_);
    tally_.events += answer.events;
    if (const std::string wrong = first_contact(answer); !wrong.empty()) return wrong;
    CheckOptions coarse = options_;
    coarse.time_tolerance = 1e-3;
    const Answer rough = check(scene_, coarse);
    if (const std::string wrong = first_contact(rough); !wrong.empty()) return "coarsely, " + wrong;
    if (answer.contact && rough.contact &&
        (answer.contact->time.lo > rough.contact->time.hi || rough.contact->time.lo > answer.contact->time.hi))
      return "the coarse bracket and the fine one are apart";
    if (number % 4 == 1) return proof(answer, number);
    return number % 8 == 0 ? distances() : std::string();
  }

 private:
  /// Certainly no touching before these come close, and an overlap once shrunk ones meet.
  void ask_chords() {
    const MarginAnswer close = check_clearance(chords_, 4 * away_, options_);
    CheckOptions shrunk = options_;
    shrunk.fit = 2 * away_;
    const Answer deep = check(chords_, shrunk);
    decided_ = close.outcome != Outcome::undecided && deep.outcome != Outcome::undecided;
    if (close.outcome == Outcome::overlap_at_start) bracket_.earliest = scene_.start;
    if (close.outcome == Outcome::contact) bracket_.earliest = close.first->time.lo;
    if (deep.outcome == Outcome::overlap_at_start) bracket_.latest = scene_.start;
    if (deep.outcome == Outcome::contact) bracket_.latest = deep.contact->time.hi;
  }

  std::string first_contact(const Answer& answer) {
    if (!decided_) {
      ++tally_.beyond;
      return {};
    }
    ++tally_.judged;
    switch (answer.outcome) {
      case Outcome::free:
        ++tally_.free;
        return bracket_.latest < INFINITY ? fmt::format("free, but chords that were shrunk meet by {}", bracket_.latest)
                                          : std::string();
      case Outcome::overlap_at_start:
        ++tally_.at_start;
        return bracket_.earliest > scene_.start
                   ? fmt::format("overlap, but chords are apart until {}", bracket_.earliest)
                   : std::string();
      case Outcome::contact:
        ++tally_.contact;
        if (answer.contact->time.hi < bracket_.earliest || answer.contact->time.lo > bracket_.latest)
          return fmt::format("contact in [{}, {}], but by chords in [{}, {}]", answer.contact->time.lo,
                             answer.contact->time.hi, bracket_.earliest, bracket_.latest);
        return {};
      default:
        ++tally_.assumed;
        return answer.free_until > bracket_.latest
                   ? fmt::format("free until {}, but by chords not from {} on", answer.free_until, bracket_.latest)
                   : std::string();
    }
  }

  /// In either touch mode, with the same bracket by chords.
  std::string proof(const Answer& open, std::uint64_t number) {
    CheckOptions mode = options_;
    if (number % 8 == 5) mode.touch = Touch::closed;
    const Answer answer = mode.touch == Touch::open ? open : check(scene_, mode);
    const ChordBracket decided = decided_ ? bracket_ : ChordBracket{scene_.start, INFINITY};
    return examine_curve_proof(scene_, answer, decided, mode, number, tally_);
  }

  static bool apart(double lo, double hi, double other_lo, double other_hi) {
    return lo > other_hi + 2 * away_ || other_lo > hi + 2 * away_;
  }

  std::string distances() {
    ClearanceOptions own;
    own.limits.max_seconds = options_.limits.max_seconds;
    own.relative = 1e-6;
    const Clearance ours = clearance(scene_, own), theirs = clearance(chords_, own);
    if (!ours.nearest || !theirs.nearest || !ours.reason.empty() || !theirs.reason.empty()) return {};
    if (apart(ours.nearest->lo, ours.nearest->hi, theirs.nearest->lo, theirs.nearest->hi))
      return fmt::format("a clearance in [{}, {}], but of chords in [{}, {}]", ours.nearest->lo, ours.nearest->hi,
                         theirs.nearest->lo, theirs.nearest->hi);
    if (ours.nearest->hi - ours.nearest->lo > 1e-4 && ours.wide.empty()) return "a wide clearance that does not say so";
    ProfileOptions profile;
    profile.instants = 4;
    profile.relative = 1e-6;
    profile.halvings = 20;
    profile.limits.max_seconds = options_.limits.max_seconds;
    const DistanceProfile over = distance_profile(scene_, profile), of_chords = distance_profile(chords_, profile);
    if (over.curves.empty() || of_chords.curves.empty()) return {};
    for (std::size_t k = 0; k < 4; ++k) {
      const DistanceAt& a = over.curves[0].instants[k];
      const DistanceAt& b = of_chords.curves[0].instants[k];
      if (apart(a.lo, a.hi, b.lo, b.hi)) return fmt::format("another distance at t = {}", a.t);
      if (k < 3 && over.curves[0].stretches[k].lo > a.hi) return fmt::format("a stretch from {} is farther", a.t);
    }
    return {};
  }

  static constexpr double away_ = picture_eps / 4096;
  const Scene& scene_;
  Scene chords_;
  Tally& tally_;
  CheckOptions options_;
  bool decided_ = false;
  ChordBracket bracket_;
};

}  // namespace

CurvedSoakScene curved_soak_scene(std::uint64_t number) {
  CurveDice dice(number);
  CurvedSoakScene made;
  made.scene.end = 8;
  const int shapes = dice.below(3), way = dice.below(3);
  const char* const names[] = {"ellipses", "an ellipse and a ring", "rings"};
  const char* const ways[] = {"on a line", "turning", "turning on a parabola"};
  made.family = fmt::format("curves, {}, {}", names[shapes], ways[way]);
  for (const int k : {0, 1}) {
    Body body;
    body.name = k == 0 ? "rests" : "moves";
    body.curves = {{shapes > k ? random_ring(dice) : random_ellipse(dice), {}}};
    if (k == 1) body.motion.pieces = {random_way(dice, way)};
    made.scene.bodies.push_back(std::move(body));
  }
  return made;
}

std::string examine_curves(std::uint64_t number, const CurvedSoakScene& made, double max_seconds, Tally& tally) {
  ++tally.scenes;
  try {
    return CurveExamination(made.scene, max_seconds, tally).run(number);
  } catch (const InputError&) {
    // Rings whose curves meet, or chords that do.
    ++tally.invalid;
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace taut::testing
