#include "support/exact_stretches.hpp"

#include <algorithm>
#include <cmath>

#include "support/exact_roots.hpp"

namespace taut::testing::exact {
namespace {

using Pieces = std::array<MotionPiece, 2>;

class Cutter {
 public:
  explicit Cutter(const Scene& scene) : scene_(scene) {}

  std::vector<MotionSegment> run() {
    std::vector<double> times{scene_.start, scene_.end};
    for (const Body& body : scene_.bodies) {
      for (const MotionPiece& piece : body.motion.pieces) {
        if (piece.until > scene_.start && piece.until < scene_.end) times.push_back(piece.until);
      }
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    if (times.size() == 1) times.push_back(times[0]);
    Pieces before;
    for (std::size_t k = 0; k + 1 < times.size(); ++k) {
      const Pieces pieces{piece_after(0, times[k]), piece_after(1, times[k])};
      if (k > 0) add_bridge(before, pieces, times[k]);
      add_stretch(pieces, Rational(times[k]), Rational(times[k + 1]));
      before = pieces;
    }
    return std::move(segments_);
  }

 private:
  MotionPiece piece_after(std::size_t body, double t) const {
    const std::vector<MotionPiece>& pieces = scene_.bodies[body].motion.pieces;
    if (pieces.empty()) return {};
    for (const MotionPiece& piece : pieces) {
      if (piece.until > t) return piece;
    }
    return pieces.back();
  }

  void add(const Pieces& pieces, const Poly& time, const Rational& t0, const Rational& t1, const Rational& u0,
           const Rational& u1) {
    auto p = BodyMotion::of(pieces[0], time, t0, t1), q = BodyMotion::of(pieces[1], time, t0, t1);
    if (!p || !q) throw Beyond{"a cosine with two singular ends"};
    segments_.emplace_back(scene_, std::array<BodyMotion, 2>{*p, *q}, time, u0, u1);
  }

  void add_stretch(const Pieces& pieces, const Rational& from, const Rational& to) {
    std::vector<Rational> marks{from, to};
    if (from < to) {
      for (const MotionPiece& piece : pieces) {
        const auto more = cuts(piece, from, to);
        if (!more) throw Beyond{"a cosine beyond 1"};
        marks.insert(marks.end(), more->begin(), more->end());
      }
    }
    std::sort(marks.begin(), marks.end());
    for (std::size_t k = 0; k + 1 < marks.size(); ++k) {
      if (marks[k] < marks[k + 1] || from == to) add_smooth(pieces, marks[k], marks[k + 1]);
    }
  }

  /// Cosines are singular at the ends only.
  void add_smooth(const Pieces& pieces, Rational from, Rational to) {
    const Rational zero = 0, whole_to = to;
    // A short number whose square is less than half of the way.
    const double size = std::sqrt(Rational(to - from).get_d() / 2);
    const Rational w(std::ldexp(std::floor(std::ldexp(size, 20 - std::ilogb(size > 0 ? size : 1))),
                                std::ilogb(size > 0 ? size : 1) - 20));
    const auto fast = [&](const Rational& end) {
      return from < to && (infinite_speed(pieces[0], end) || infinite_speed(pieces[1], end));
    };
    const bool at_from = fast(from), at_to = fast(to);
    if (at_from) {
      add(pieces, {from, Rational(0), Rational(1)}, from, from + w * w, 0, w);
      from += w * w;
    }
    if (at_to) to -= w * w;
    if (from < to || from == whole_to) add(pieces, {Rational(0), Rational(1)}, from, to, from, to);
    if (at_to) add(pieces, {whole_to, Rational(0), Rational(-1)}, to, whole_to, -w, 0);
  }

  /// Equal as far as 2000 bits tell.
  static bool poses_agree(const MotionPiece& before, const MotionPiece& after, double joint) {
    Precision at(assumed_bits);
    const BodyMotion bridge = BodyMotion::bridge(before, after, joint);
    const Pose<Wide, 8> p = bridge.pose<Wide, 8>(Wide(0.0));
    for (const auto* s : {&p.ox, &p.oy, &p.x, &p.y}) {
      if (s->c[1].sign() != 0) return false;
    }
    return true;
  }

  void add_bridge(const Pieces& before, const Pieces& after, double joint) {
    if (poses_agree(before[0], after[0], joint) && poses_agree(before[1], after[1], joint)) return;
    segments_.emplace_back(scene_,
                           std::array<BodyMotion, 2>{BodyMotion::bridge(before[0], after[0], joint),
                                                     BodyMotion::bridge(before[1], after[1], joint)},
                           trimmed({Rational(joint)}), 0, 1);
  }

  const Scene& scene_;
  std::vector<MotionSegment> segments_;
};

}  // namespace

std::vector<MotionSegment> stretches(const Scene& scene) { return Cutter(scene).run(); }

}  // namespace taut::testing::exact
