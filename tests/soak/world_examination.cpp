#include "world_examination.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <sstream>

#include "motion/pieces.hpp"
#include "scene/instance.hpp"
#include "scene/validate_scene.hpp"
#include "support/consistency.hpp"
#include "support/every_pair.hpp"
#include "support/world_changes.hpp"
#include "support/world_judge.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/map_query.hpp"
#include "taut/proof.hpp"
#include "taut/simulation.hpp"
#include "taut/static_map.hpp"

namespace taut::testing {
using namespace internal;
namespace {

/// Enclosures of one instant, whose computations may differ by rounding.
bool meet(const TimeInterval& a, const TimeInterval& b) { return a.lo <= b.hi + 1e-9 && b.lo <= a.hi + 1e-9; }

std::string time_text(const TimeInterval& t) { return fmt::format("[{}, {}]", t.lo, t.hi); }

std::string answer_difference(const Answer& a, const Answer& b) {
  if (a.outcome != b.outcome) return fmt::format("{} against {}", to_string(a.outcome), to_string(b.outcome));
  if (a.contact && !meet(a.contact->time, b.contact->time))
    return time_text(a.contact->time) + " against " + time_text(b.contact->time);
  return {};
}

/// What costs far more than everything else is asked about so large a share of worlds.
constexpr double share_of_ranges = 0.25, share_of_clearances = 0.25, share_of_profiles = 0.25;
constexpr std::size_t large_count = 10;

/// Asks all there is to ask about one world, in one touch mode, and remembers the answers for the next question.
class WorldExamination {
 public:
  WorldExamination(std::uint64_t number, const MadeWorld& world, double max_seconds, Tally& tally)
      : rng_(number), world_(world), scene_(scene_of(world)), tally_(tally), judge_(world, 48) {
    options_.engine = EngineChoice::spacetime;
    options_.tell_touching = false;
    options_.limits.max_seconds = max_seconds;
  }

  std::string run() {
    tally_.large += scene_.bodies.size() >= large_count;
    if (Instance(scene_).coverage(0).is_empty()) return untested();
    for (const Touch touch : {Touch::open, Touch::closed}) {
      options_.touch = touch;
      for (const auto ask : {&WorldExamination::pairs, &WorldExamination::engines, &WorldExamination::simulated,
                             &WorldExamination::proof, &WorldExamination::overlaps, &WorldExamination::stopped,
                             &WorldExamination::ranges, &WorldExamination::map, &WorldExamination::law}) {
        const std::string wrong = (this->*ask)();
        if (!wrong.empty()) return fmt::format("touch {}: {}", to_string(touch), wrong);
      }
    }
    if (const std::string wrong = touching_no_later(); !wrong.empty()) return wrong;
    if (!rng_.chance(share_of_clearances)) return {};
    if (const std::string wrong = inconsistency(scene_, options_.touch, options_.limits.max_seconds); !wrong.empty())
      return wrong;
    if (const std::string wrong = clearances(); !wrong.empty()) return wrong;
    return rng_.chance(share_of_profiles) ? profile() : std::string();
  }

 private:
  std::string name_of(BodyId id) const { return scene_.bodies[static_cast<std::size_t>(id)].name; }

  std::string named(const std::array<BodyId, 2>& pair, const std::string& what) const {
    return what.empty() ? what : name_of(pair[0]) + " and " + name_of(pair[1]) + ": " + what;
  }

  /// Where nothing is tested, no question has a verdict.
  std::string untested() const {
    const auto named_untested = [](const char* question, Outcome outcome) {
      return outcome == Outcome::untested ? std::string()
                                          : fmt::format("{} of nothing: {}", question, to_string(outcome));
    };
    std::ostringstream log;
    for (const std::string& wrong : {named_untested("check", check(scene_, options_).outcome),
                                     named_untested("intervals", intervals(scene_, options_).outcome),
                                     named_untested("clearance", clearance(scene_).outcome),
                                     named_untested("check_clearance", check_clearance(scene_, 1, options_).outcome),
                                     named_untested("distance_profile", distance_profile(scene_).outcome),
                                     named_untested("prove", prove(scene_, log, options_).outcome)}) {
      if (!wrong.empty()) return wrong;
    }
    if (!log.str().empty()) return "prove writes a log of nothing";
    Simulation simulation(scene_, options_.touch);
    simulation.advance_to(scene_.end);
    return simulation.state() == SimulationState::untested ? "" : "a simulation of nothing ends otherwise";
  }

  Answer answer_to(const Scene& scene, bool all = false) const {
    CheckOptions options = options_;
    options.all_pairs = all;
    Answer answer = check(scene, options);
    if (all) answer.pairs = every_pair(scene, answer);
    return answer;
  }

  /// Every pair by definition, and the first one as the headline.
  std::string pairs() {
    last_ = std::move(all_);
    all_ = answer_to(scene_, true);
    earliest_ = answer_to(scene_);
    ++(earliest_.outcome == Outcome::free      ? tally_.free
       : earliest_.outcome == Outcome::contact ? tally_.contact
                                               : tally_.at_start);
    for (const PairAnswer& pair : *all_.pairs) {
      if (const std::string wrong = judge_.pair_fault(pair); !wrong.empty()) return named(pair.bodies, wrong);
      ++tally_.judged;
    }
    if (const std::string wrong = earliest_fault(all_, *all_.pairs); !wrong.empty()) return "all pairs: " + wrong;
    return earliest_fault(earliest_, *all_.pairs);
  }

  /// The kinetic engine against the other one, pair by pair, which throws where they differ.
  std::string engines() {
    CheckOptions options = options_;
    options.all_pairs = true;
    options.engine = EngineChoice::both;
    Answer both = check(scene_, options);
    both.pairs = every_pair(scene_, both);
    tally_.events += both.events;
    for (std::size_t i = 0; i < both.pairs->size(); ++i) {
      const PairAnswer &one = (*both.pairs)[i], &other = (*all_.pairs)[i];
      if (one.outcome != other.outcome)
        return named(one.bodies,
                     fmt::format("both engines: {}, one: {}", to_string(one.outcome), to_string(other.outcome)));
    }
    options.all_pairs = false;
    options.engine = EngineChoice::kinetic;
    const Answer kinetic = check(scene_, options);
    if (kinetic.outcome == Outcome::undecided) return "the kinetic engine is undecided: " + kinetic.reason;
    const std::string wrong = answer_difference(earliest_, kinetic);
    return wrong.empty() ? wrong : "the kinetic engine: " + wrong;
  }

  std::string simulated() {
    if (is_ring_pair(scene_)) return {};
    ++tally_.simulated;
    Simulation simulation(scene_, options_.touch);
    simulation.advance_to(scene_.end);
    Answer reached;
    reached.outcome = simulation.state() == SimulationState::finished           ? Outcome::free
                      : simulation.state() == SimulationState::contact          ? Outcome::contact
                      : simulation.state() == SimulationState::overlap_at_start ? Outcome::overlap_at_start
                                                                                : Outcome::undecided;
    reached.contact = simulation.contact();
    const std::string wrong = answer_difference(earliest_, reached);
    return wrong.empty() ? wrong : "simulated: " + wrong + " " + simulation.reason();
  }

  std::string proof() {
    std::ostringstream out;
    const Answer proved = prove(scene_, out, options_);
    if (const std::string wrong = answer_difference(earliest_, proved); !wrong.empty())
      return "prove: " + wrong + (proved.reason.empty() ? "" : ", " + proved.reason);
    if (proved.outcome == Outcome::overlap_at_start) return {};
    std::istringstream in(out.str());
    const Verified v = verify(scene_, in);
    if (v.outcome != earliest_.outcome) return fmt::format("the log proves {}", to_string(v.outcome));
    if (v.contact && !meet(v.contact->time, earliest_.contact->time)) return "the log proves another time";
    ++tally_.proofs;
    return {};
  }

  /// Intervals begin at the first contacts, and hold what the definition says.
  std::string overlaps() {
    intervals_ = intervals(scene_, options_);
    ++tally_.intervals;
    if (!intervals_.undecided.empty()) return "intervals: undecided: " + intervals_.undecided[0].reason;
    auto next = intervals_.intervals.begin();
    for (const PairAnswer& pair : *all_.pairs) {
      std::vector<OverlapInterval> own;
      while (next != intervals_.intervals.end() && next->pair == pair.bodies) own.push_back(*next++);
      if (const std::string wrong = judge_.intervals_fault(pair.bodies, own); !wrong.empty())
        return named(pair.bodies, "intervals: " + wrong);
      if (own.empty() != (pair.outcome == Outcome::free))
        return named(pair.bodies, fmt::format("{} intervals, and {}", own.size(), to_string(pair.outcome)));
      if (own.empty()) continue;
      const TimeInterval first = pair.contact ? pair.contact->time : TimeInterval{scene_.start, scene_.start};
      if (!meet(own[0].from, first))
        return named(pair.bodies, "intervals begin in " + time_text(own[0].from) + ", not in " + time_text(first));
    }
    return next == intervals_.intervals.end() ? "" : "intervals of pairs that are not asked about";
  }

  /// A run that a limit may end says what the whole run says, or that it is undecided.
  std::string stopped() {
    CheckOptions options = options_;
    options.limits.max_seconds = rng_.real(0, 1e-3);
    const Answer answer = check(scene_, options);
    if (answer.outcome != Outcome::undecided && answer.outcome != earliest_.outcome)
      return fmt::format("stopped: {}, not {}", to_string(answer.outcome), to_string(earliest_.outcome));
    if (answer.outcome == Outcome::undecided && answer.reason.empty()) return "stopped: undecided without a reason";
    if (earliest_.contact && answer.free_until > earliest_.contact->time.hi) return "stopped: free beyond the contact";
    const Intervals found = intervals(scene_, options);
    const bool all = found.outcome != Outcome::undecided;
    if (all != found.undecided.empty()) return "stopped: intervals are undecided, or not";
    if (all && found.intervals.size() != intervals_.intervals.size()) return "stopped: other intervals";
    return {};
  }

  /// The stretch around an instant is what the intervals leave.
  std::string ranges() {
    if (!rng_.chance(share_of_ranges)) return {};
    ++tally_.ranges;
    const double t = rng_.real(scene_.start, scene_.end);
    TimeInterval before{-INFINITY, -INFINITY}, after{INFINITY, INFINITY};
    bool inside = false;
    for (const OverlapInterval& o : intervals_.intervals) {
      if (o.from.hi <= t && t <= o.to.lo) inside = true;
      if (o.to.hi < t && o.to.lo > before.lo) before = o.to;
      if (o.from.lo > t && o.from.lo < after.lo) after = o.from;
    }
    try {
      const Range found = range(scene_, t, options_);
      if (inside) return fmt::format("a range around {}, where bodies overlap", t);
      if (found.outcome != Outcome::free) return "range: undecided: " + found.reason;
      if (found.from ? !meet(*found.from, before) : before.lo > scene_.start + 1e-9)
        return fmt::format("the range around {} does not begin at {}", t, time_text(before));
      if (found.to ? !meet(*found.to, after) : after.lo < scene_.end - 1e-9)
        return fmt::format("the range around {} does not end at {}", t, time_text(after));
      return {};
    } catch (const InputError& error) {
      return inside ? "" : std::string("range: ") + error.what();
    }
  }

  /// A body of the world alone among the others, at rest: as a map says it, and as a scene.
  std::string map() {
    std::vector<int> movers;
    for (std::size_t i = 0; i < world_.bodies.size(); ++i) {
      if (!world_.bodies[i].keyframes.empty()) movers.push_back(static_cast<int>(i));
    }
    if (movers.empty()) return {};
    MadeWorld alone = with_one_mover(world_, rng_.pick(movers));
    const auto moves = [](const MadeBody& body) { return !body.keyframes.empty(); };
    std::rotate(std::find_if(alone.bodies.begin(), alone.bodies.end(), moves),
                std::find_if(alone.bodies.begin(), alone.bodies.end(), moves) + 1, alone.bodies.end());
    // What moves in a map is on one interval of layers.
    const std::vector<Part>& moved = alone.bodies.back().parts;
    if (std::any_of(moved.begin(), moved.end(), [](const Part& part) { return part.z.has_value(); })) return {};
    ++tally_.maps;
    const Scene scene = scene_of(alone);
    const Body& mover = scene.bodies.back();
    double reach = 0;
    for (const Part& part : alone.bodies.back().parts) {
      for (const Point& p : part.outline) reach = std::max({reach, std::fabs(p.x), std::fabs(p.y)});
    }
    const StaticMap map({scene.bodies.begin(), scene.bodies.end() - 1}, reach);
    const Answer answer = map.check(map.prepare(mover), mover.motion, scene.start, scene.end, options_);
    const Answer of_scene = answer_to(scene);
    // Keyframes that are all alike are no motion: then the mover is one of the bodies at rest, of which the scene asks
    // about every two.
    const std::vector<MotionPiece>& pieces = mover.motion.pieces;
    if (std::all_of(pieces.begin(), pieces.end(), [](const MotionPiece& p) { return same_motion(p, MotionPiece{}); }))
      return {};
    const std::string wrong = answer_difference(answer, of_scene);
    if (!wrong.empty()) return "map, " + mover.name + " moves: " + wrong;
    return planners_answer(map, map.prepare(mover), scene, answer);
  }

  /// The same by a planner's query: the same outcome, and enclosures of one instant, which meet.
  std::string planners_answer(const StaticMap& map, const StaticMap::Mover& mover, const Scene& scene,
                              const Answer& answer) const {
    MapQueryOptions how;
    how.touch = options_.touch;
    MapQuery query(map, mover, how);
    const std::span motion(&scene.bodies.back().motion, 1);
    const MapFinding along = query.along(motion, scene.start, scene.end);
    const MapFinding passes = query.passes(motion, scene.start, scene.end);
    const auto decided = [](Outcome o) { return o != Outcome::undecided; };
    if (!decided(answer.outcome) || !decided(along.outcome) || !decided(passes.outcome)) return {};
    // Bodies that touch at the start may be said to overlap there, or to come into contact.
    const auto kind = [](Outcome o) { return o == Outcome::overlap_at_start ? Outcome::contact : o; };
    if (kind(along.outcome) != kind(answer.outcome) || kind(passes.outcome) != kind(answer.outcome))
      return fmt::format("a planner's query says {} and {}, not {}", to_string(along.outcome),
                         to_string(passes.outcome), to_string(answer.outcome));
    if (along.outcome != Outcome::contact || !answer.contact) return {};
    const TimeInterval& time = answer.contact->time;
    return along.free_until <= time.hi && time.lo <= along.contact_by
               ? ""
               : fmt::format("a planner's query has the contact within [{}, {}]", along.free_until, along.contact_by);
  }

  /// The same world in other words.
  std::string law() {
    int cut = 0;
    std::optional<MadeWorld> other;
    const char* const laws[] = {"cut at seams", "carried as a whole", "with far bodies", "in another order",
                                "seen from a moving frame"};
    const int which = rng_.below(5);
    // Where nothing moves relative to anything else every pair is asked about, and not any more with a body that moves.
    const bool alike = Instance(scene_).tests_groups();
    if (which == 0) other = cut_at_seams(rng_, world_, cut);
    if (which == 1 && !alike) other = carried_as_a_whole(rng_, world_);
    if (which == 2 && !alike) other = with_far_bodies(rng_.next(), world_);
    if (which == 3) other = in_another_order(rng_, world_);
    if (which == 4 && !alike) other = seen_from_a_moving_frame(rng_, world_);
    if (!other) return {};
    ++tally_.laws;
    const std::string wrong = answer_difference(earliest_, answer_to(scene_of(*other)));
    return wrong.empty() ? wrong : std::string(laws[which]) + ": " + wrong;
  }

  std::string touching_no_later() const {
    for (std::size_t i = 0; i < all_.pairs->size(); ++i) {
      const PairAnswer &open = (*last_.pairs)[i], &closed = (*all_.pairs)[i];
      if (open.outcome == Outcome::free || closed.outcome == Outcome::overlap_at_start) continue;
      if (closed.outcome == Outcome::free || (open.contact && closed.contact->time.lo > open.contact->time.hi))
        return named(open.bodies, "they overlap before they touch");
    }
    return {};
  }

  /// Asked last: `all_` is of closed touching.
  std::string clearances() {
    ++tally_.clearances;
    ClearanceOptions options;
    options.all_pairs = true;
    options.relative = 1e-6;
    options.limits.max_seconds = options_.limits.max_seconds;
    const Clearance& answer = clearance_ = clearance(scene_, options);
    if (!answer.reason.empty()) return "clearance: undecided: " + answer.reason;
    if (answer.pairs.size() != all_.pairs->size()) return "clearance: other pairs";
    for (std::size_t i = 0; i < answer.pairs.size(); ++i) {
      const NearestPoints& n = answer.pairs[i];
      const PairAnswer& pair = (*all_.pairs)[i];
      // Bodies that nearly touch may have 0 as their lower end.
      if ((n.hi > 0) != (pair.outcome == Outcome::free))
        return named(pair.bodies, fmt::format("clearance [{}, {}], and {}", n.lo, n.hi, to_string(pair.outcome)));
      if (n.lo > n.hi || n.hi - n.lo > 1e-6 * n.hi + 1e-9) return named(pair.bodies, "a wide clearance");
      if (const std::string wrong = judge_.clearance_fault(pair.bodies, n.lo); n.lo > 0 && !wrong.empty())
        return named(pair.bodies, wrong);
    }
    return {};
  }

  /// Of some pair, at some instants and between.
  std::string profile() {
    if (clearance_.pairs.empty()) return {};
    ++tally_.profiles;
    const NearestPoints& n = rng_.pick(clearance_.pairs);
    Scene two = scene_;
    for (const PairAnswer& pair : *all_.pairs) {
      if (pair.bodies != n.pair) two.ignore.push_back({name_of(pair.bodies[0]), name_of(pair.bodies[1])});
    }
    ProfileOptions options;
    options.instants = rng_.between(2, 12);
    options.relative = 1e-6;
    options.limits.max_seconds = options_.limits.max_seconds;
    const DistanceProfile answer = distance_profile(two, options);
    if (!answer.reason.empty()) return "profile: undecided: " + answer.reason;
    const std::string wrong = answer.curves.size() == 1 ? judge_.curve_fault(n.pair, answer.curves[0]) : "no curve";
    if (!wrong.empty()) return named(n.pair, "profile: " + wrong);
    double least = INFINITY;
    for (const DistanceWithin& s : answer.curves[0].stretches) least = std::min(least, s.lo);
    const bool same = least <= n.hi && (n.lo == 0 || least >= n.lo - 1e-6 * n.hi - 1e-9);
    return same ? "" : named(n.pair, fmt::format("profile: at least {}, clearance [{}, {}]", least, n.lo, n.hi));
  }

  Rng rng_;
  const MadeWorld& world_;
  Scene scene_;
  Tally& tally_;
  WorldJudge judge_;
  CheckOptions options_;
  Answer earliest_, all_, last_;
  Intervals intervals_;
  Clearance clearance_;
};

}  // namespace

std::string examine_world(std::uint64_t number, const LargeWorld& made, double max_seconds, Tally& tally) {
  ++tally.scenes;
  try {
    return WorldExamination(number, made.world, max_seconds, tally).run();
  } catch (const InputError& error) {
    ++tally.invalid;
    return std::string("not valid: ") + error.what();
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace taut::testing
