#include "question_examination.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "support/consistency.hpp"
#include "support/rng.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/motions.hpp"
#include "taut/pose.hpp"
#include "taut/separate.hpp"

namespace taut::testing {
namespace {

/// A limit of time is no fault of an answer.
struct TimeIsUp {};

constexpr double share_of_covers = 0.3;

class QuestionExamination {
 public:
  QuestionExamination(const SoakScene& s, std::uint64_t number, double max_seconds, Tally& tally)
      : rng_(number), scene_(s.scene), max_seconds_(max_seconds), tally_(tally) {
    for (const Body& body : scene_.bodies) {
      for (const Point& p : body.polygon) size_ = std::max({size_, std::fabs(p.x), std::fabs(p.y)});
    }
    whole_ = scene_.end - scene_.start;
    room_ = 1e-9 * std::max({whole_, std::fabs(scene_.start), std::fabs(scene_.end)});
  }

  std::string run() {
    for (const Touch touch : {Touch::open, Touch::closed}) {
      options_.touch = touch;
      options_.engine = EngineChoice::spacetime;
      options_.limits.max_seconds = max_seconds_;
      for (const auto ask :
           {&QuestionExamination::consistent, &QuestionExamination::overlaps, &QuestionExamination::ranges,
            &QuestionExamination::standing, &QuestionExamination::backwards}) {
        const std::string wrong = (this->*ask)();
        if (!wrong.empty()) return fmt::format("touch {}: {}", to_string(touch), wrong);
      }
    }
    for (const auto ask : {&QuestionExamination::nearest, &QuestionExamination::margins, &QuestionExamination::profile,
                           &QuestionExamination::below_a_cover}) {
      const std::string wrong = (this->*ask)();
      if (!wrong.empty()) return wrong;
    }
    return directions();
  }

 private:
  bool meet(const TimeInterval& a, const TimeInterval& b) const { return a.lo <= b.hi + room_ && b.lo <= a.hi + room_; }

  /// What was not decided is a finding, unless for lack of time.
  std::string undecided(const std::string& question, const std::string& reason) const {
    if (reason.find("time limit") != std::string::npos) throw TimeIsUp{};
    return question + ": undecided: " + reason;
  }

  std::string consistent() { return inconsistency(scene_, options_.touch, max_seconds_); }

  std::string overlaps() {
    answer_ = check(scene_, options_);
    if (answer_.outcome == Outcome::undecided) return undecided("check", answer_.reason);
    ++(answer_.outcome == Outcome::free      ? tally_.free
       : answer_.outcome == Outcome::contact ? tally_.contact
                                             : tally_.at_start);
    found_ = intervals(scene_, options_);
    if (!found_.undecided.empty()) return undecided("intervals", found_.undecided[0].reason);
    if (found_.intervals.empty() != (answer_.outcome == Outcome::free))
      return fmt::format("{} intervals, and {}", found_.intervals.size(), to_string(answer_.outcome));
    for (std::size_t i = 1; i < found_.intervals.size(); ++i) {
      if (found_.intervals[i].from.hi < found_.intervals[i - 1].to.lo) return "intervals out of order";
    }
    if (found_.intervals.empty()) return {};
    const TimeInterval first = answer_.contact ? answer_.contact->time : TimeInterval{scene_.start, scene_.start};
    return meet(found_.intervals[0].from, first) ? "" : "intervals do not begin at the first contact";
  }

  /// +1 certainly inside of an interval, -1 certainly in none, 0 near an end.
  int place_of(double t) const {
    for (const OverlapInterval& o : found_.intervals) {
      if (o.from.hi + room_ < t && t < o.to.lo - room_) return 1;
      if (o.from.lo - room_ <= t && t <= o.to.hi + room_) return 0;
    }
    return -1;
  }

  std::string ranges() {
    const double t = rng_.real(scene_.start, scene_.end);
    const int place = place_of(t);
    if (place == 0) return {};
    TimeInterval before{-INFINITY, -INFINITY}, after{INFINITY, INFINITY};
    for (const OverlapInterval& o : found_.intervals) {
      if (o.to.hi < t && o.to.lo > before.lo) before = o.to;
      if (o.from.lo > t && o.from.lo < after.lo) after = o.from;
    }
    try {
      const Range around = range(scene_, t, options_);
      if (place > 0) return fmt::format("a range around {}, where bodies overlap", t);
      if (around.outcome != Outcome::free) return undecided("range", around.reason);
      if (around.from ? !meet(*around.from, before) : before.lo > scene_.start + room_)
        return fmt::format("the range around {} begins elsewhere than at {}", t, before.lo);
      if (around.to ? !meet(*around.to, after) : after.lo < scene_.end - room_)
        return fmt::format("the range around {} ends elsewhere than at {}", t, after.lo);
      return {};
    } catch (const InputError& error) {
      return place > 0 ? "" : std::string("range: ") + error.what();
    }
  }

  /// The bodies as they stand at an instant, rounded.
  Scene standing_at(double t) const {
    Scene still;
    for (const Body& body : scene_.bodies) {
      Body posed;
      posed.name = body.name;
      const BodyPose at = pose_at(body.motion, t);
      for (const Point& p : body.polygon) {
        posed.polygon.push_back(
            {at.origin.x + at.axis.x * p.x - at.axis.y * p.y, at.origin.y + at.axis.y * p.x + at.axis.x * p.y});
      }
      still.bodies.push_back(posed);
    }
    return still;
  }

  std::string standing() {
    for (int i = 0; i < 3; ++i) {
      const double t = rng_.real(scene_.start, scene_.end);
      const int place = place_of(t);
      if (place == 0) continue;
      try {
        const Scene still = standing_at(t);
        CheckOptions shrunk = options_;
        shrunk.touch = Touch::open;
        shrunk.fit = 1e-9 * size_;
        if (place < 0 && check(still, shrunk).outcome == Outcome::overlap_at_start)
          return fmt::format("they overlap at {}, which is in no interval", t);
        if (place > 0 && clearance(still).nearest->lo > 1e-9 * size_)
          return fmt::format("they are apart at {}, which is in an interval", t);
      } catch (const InputError&) {
        // Rounded, or shrunk, a polygon may not be simple.
      }
      ++tally_.judged;
    }
    return {};
  }

  /// The same scene with time running from the end to the start, where that is no matter of rounding: polynomials with
  /// small integer coefficients over [0, 1].
  std::optional<Scene> reversed() const {
    if (scene_.start != 0 || scene_.end != 1) return std::nullopt;
    Scene back = scene_;
    for (Body& body : back.bodies) {
      if (body.motion.pieces.size() > 1) return std::nullopt;
      for (MotionPiece& piece : body.motion.pieces) {
        Coefficients* rotation = nullptr;
        if (auto* angle = std::get_if<AngleRotation>(&piece.rotation)) rotation = &angle->angle;
        if (!rotation && !std::holds_alternative<NoRotation>(piece.rotation)) return std::nullopt;
        if (!piece.orbit.angle.empty() || piece.origin != 0) return std::nullopt;
        for (Coefficients* c : {&piece.x, &piece.y, rotation}) {
          if (c && !reverse(*c)) return std::nullopt;
        }
      }
    }
    return back;
  }

  /// c(1 - t), if that is exact.
  static bool reverse(Coefficients& c) {
    const bool exact = std::all_of(
        c.begin(), c.end(), [](double x) { return std::fabs(x) < 0x1p30 && x * 0x1p12 == std::nearbyint(x * 0x1p12); });
    if (!exact || c.size() > 9) return false;
    Coefficients back(c.size(), 0);
    // Horner's rule with 1 - t in place of t.
    for (std::size_t i = c.size(); i-- > 0;) {
      for (std::size_t k = back.size(); k-- > 1;) back[k] -= back[k - 1];
      back[0] += c[i];
    }
    c = back;
    return true;
  }

  std::string backwards() {
    const std::optional<Scene> back = reversed();
    if (!back) return {};
    const Intervals other = intervals(*back, options_);
    if (!other.undecided.empty()) return undecided("intervals of time reversed", other.undecided[0].reason);
    const std::size_t n = found_.intervals.size();
    if (other.intervals.size() != n)
      return fmt::format("{} intervals, and {} with time reversed", n, other.intervals.size());
    for (std::size_t i = 0; i < n; ++i) {
      const OverlapInterval &a = found_.intervals[i], &b = other.intervals[n - 1 - i];
      if (!meet(a.from, {1 - b.to.hi, 1 - b.to.lo}) || !meet(a.to, {1 - b.from.hi, 1 - b.from.lo}))
        return "time reversed has other intervals";
    }
    ++tally_.judged;
    return {};
  }

  /// Asked last of touching: `answer_` is of the closed one.
  std::string nearest() {
    ClearanceOptions how;
    how.relative = 1e-6;
    how.limits.max_seconds = max_seconds_;
    const Clearance found = clearance(scene_, how);
    if (!found.reason.empty()) return undecided("clearance", found.reason);
    nearest_ = *found.nearest;
    const bool free = answer_.outcome == Outcome::free;
    const double width = nearest_.hi - nearest_.lo;
    if (width > 2e-6 * nearest_.hi && found.wide.empty()) return "a wide clearance that does not say so";
    if (width > 1e-6 * nearest_.hi + 1e-9 * size_ && !found.wide.empty()) return undecided("clearance", found.wide);
    if (nearest_.lo > nearest_.hi || width > 1e-6 * nearest_.hi + 1e-9 * size_)
      return fmt::format("clearance within [{}, {}]", nearest_.lo, nearest_.hi);
    if (free ? !(nearest_.hi > 0) : nearest_.lo > 0)
      return fmt::format("clearance within [{}, {}], and closed {}", nearest_.lo, nearest_.hi,
                         to_string(answer_.outcome));
    return {};
  }

  std::string margins() {
    CheckOptions how = options_;
    how.touch = Touch::open;
    const double more = std::max(nearest_.hi * 1.01, 1e-6 * size_), less = nearest_.lo * 0.99;
    const MarginAnswer closer = check_clearance(scene_, more, how);
    if (closer.outcome == Outcome::undecided) return undecided("check_clearance", closer.reason);
    if (closer.outcome == Outcome::free) return fmt::format("{} is kept, and the clearance {}", more, nearest_.hi);
    if (!(less > 1e-9 * size_)) return {};
    const MarginAnswer kept = check_clearance(scene_, less, how);
    if (kept.outcome == Outcome::undecided) return undecided("check_clearance", kept.reason);
    return kept.outcome == Outcome::free ? "" : fmt::format("{} is not kept, and the clearance {}", less, nearest_.lo);
  }

  std::string profile() {
    ProfileOptions how;
    how.instants = rng_.between(2, 9);
    how.relative = 1e-6;
    how.halvings = 200;
    how.limits.max_seconds = max_seconds_;
    const DistanceProfile found = distance_profile(scene_, how);
    if (!found.reason.empty()) return undecided("profile", found.reason);
    double least = INFINITY;
    for (const DistanceWithin& s : found.curves[0].stretches) least = std::min(least, s.lo);
    const double room = 1e-6 * nearest_.hi + 1e-9 * size_;
    if (least > nearest_.hi || (nearest_.lo > 0 && least < nearest_.lo - room))
      return fmt::format("profile: at least {}, clearance within [{}, {}]", least, nearest_.lo, nearest_.hi);
    return {};
  }

  /// What the first body has on another layer, over everything, changes no answer.
  std::string below_a_cover() {
    if (!rng_.chance(share_of_covers)) return {};
    Scene covered = scene_;
    Body& first = covered.bodies[0];
    const double far = 8 * size_;
    first.parts = {{first.polygon, {}}, {{{-far, -far}, {far, -far}, {far, far}, {-far, far}}, {}, Layers{3, 5}}};
    first.polygon.clear();
    for (Body& body : covered.bodies) body.z = {0, 3};
    if (const std::string wrong = inconsistency(covered, options_.touch, max_seconds_); !wrong.empty())
      return "below a cover: " + wrong;
    const Answer answer = check(covered, options_);
    if (answer.outcome == Outcome::undecided) return undecided("check below a cover", answer.reason);
    if (answer.outcome != answer_.outcome || (answer.contact && !meet(answer.contact->time, answer_.contact->time)))
      return fmt::format("below a cover: {}, not {}", to_string(answer.outcome), to_string(answer_.outcome));
    ClearanceOptions how;
    how.relative = 1e-6;
    how.limits.max_seconds = max_seconds_;
    const Clearance least = clearance(covered, how);
    if (!least.reason.empty()) return undecided("clearance below a cover", least.reason);
    if (least.nearest->lo > nearest_.hi || nearest_.lo > least.nearest->hi)
      return fmt::format("below a cover: clearance within [{}, {}], not [{}, {}]", least.nearest->lo, least.nearest->hi,
                         nearest_.lo, nearest_.hi);
    return {};
  }

  /// From where the bodies stand at the start.
  std::string directions() {
    SeparateOptions how;
    if (rng_.chance(0.5)) how.travel = size_ * std::exp(rng_.real(-2, 2));
    how.limits.max_seconds = max_seconds_;
    const Separation found = separate(scene_, how);
    if (!found.reason.empty()) return undecided("separate", found.reason);
    if (found.overlap) return {};
    Scene still;
    try {
      still = standing_at(scene_.start);
    } catch (const InputError&) {
      return {};
    }
    const double way = std::isfinite(how.travel) ? how.travel : 100 * size_;
    for (int i = 0; i < 3; ++i) {
      const double deg = rng_.real(0, 360), angle = deg * 3.14159265358979323846 / 180;
      const int place = place_in(found.bodies[0], deg);
      if (place == 0) continue;
      still.bodies[1].motion = from_velocity({way * std::cos(angle), way * std::sin(angle)});
      still.end = 1;
      CheckOptions shrunk = options_;
      shrunk.touch = Touch::open;
      try {
        const Outcome outcome = check(still, shrunk).outcome;
        if (outcome == Outcome::overlap_at_start || outcome == Outcome::undecided) return {};
        if ((outcome == Outcome::free) != (place > 0))
          return fmt::format("towards {} deg as far as {}: {}, said to be {}", deg, way, to_string(outcome),
                             place > 0 ? "free" : "blocked");
      } catch (const InputError&) {
        return {};
      }
      ++tally_.judged;
    }
    return {};
  }

  /// +1 certainly in an arc, -1 certainly in none, 0 near an end.
  static int place_in(const BodyDirections& body, double deg) {
    if (body.all) return 1;
    constexpr double hair = 1e-6;
    const auto turned = [](double x) { return x - 360 * std::floor(x / 360); };
    int place = -1;
    for (const DirectionArc& arc : body.free) {
      const double width = arc.point ? 0 : turned(arc.to.lo - arc.from.hi), at = turned(deg - arc.from.hi);
      if (at > hair && at < width - hair) return 1;
      if (at < hair || at > 360 - hair || std::fabs(at - width) < hair) place = 0;
    }
    return place;
  }

  Rng rng_;
  const Scene& scene_;
  double max_seconds_;
  Tally& tally_;
  double size_ = 0, whole_ = 0, room_ = 0;
  CheckOptions options_;
  Answer answer_;
  Intervals found_;
  NearestPoints nearest_;
};

}  // namespace

std::string examine_questions(const SoakScene& s, std::uint64_t number, double max_seconds, Tally& tally) {
  ++tally.scenes;
  try {
    return QuestionExamination(s, number, max_seconds, tally).run();
  } catch (const InputError&) {
    ++tally.invalid;
    return {};
  } catch (const TimeIsUp&) {
    ++tally.beyond;
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace taut::testing
