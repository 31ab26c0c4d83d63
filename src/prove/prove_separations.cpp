#include "prove/separations_writer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "proof/format.hpp"
#include "proof/mechanism_cells.hpp"
#include "scene/curved_world.hpp"
#include "scene/mechanism_lock.hpp"
#include "spacetime/first_contact.hpp"
#include "taut/proof.hpp"

namespace taut {
using namespace internal;
namespace {

/// Writes the whole log, if there is one: the header, the clearance if there is one, and the body. Returns the body.
std::optional<SeparationsBody> write_log(std::ostream& log, const Scene& scene, Touch touch,
                                         std::optional<SeparationsBody> body, double clearance = 0) {
  if (!body) return std::nullopt;
  const std::uint8_t kind = static_cast<std::uint8_t>(body->claim) | (clearance > 0 ? proof::with_clearance : 0);
  proof::ByteWriter out(log);
  proof::write_header(out, {proof::of_separations, scene_fingerprint(scene, touch), touch, kind});
  if (proof::has_loops(scene)) proof::write_cells(out, *scene.assembly);
  if (clearance > 0) out.f64(clearance);
  for (const char c : body->bytes) out.u8(static_cast<std::uint8_t>(c));
  out.close();
  return body;
}

/// States a contact, and a closeness, as the log proves it. It may differ from what an engine found by some units in
/// the last place.
void state_as_proved(Answer& answer, const SeparationsBody& log) {
  if (!log.contact) return;
  answer.contact = log.contact;
  answer.free_until = log.free_until;
}
void state_as_proved(MarginAnswer& answer, const SeparationsBody& log) {
  if (!log.closer) return;
  answer.first->time = *log.closer;
  answer.first->free_until = answer.free_until = log.free_until;
}

/// The result that the answer names, of cross-sections of the two bodies.
const PairResult* earliest(const Answer& answer, const Instance& instance, const std::vector<PairResult>& results) {
  const PairResult* named = nullptr;
  for (const PairResult& r : results) {
    if (!r.contact || instance.scene_pair(r.a, r.b) != answer.pair) continue;
    if (!named || r.contact->time.lo < named->contact->time.lo) named = &r;
  }
  return named;
}

/// The cross-sections of two bodies that have these features, and have a layer in common.
std::array<int, 2> sections_with(const proof::VerifierScene& scene, const std::array<BodyId, 2>& bodies,
                                 const CloseFeatures& features) {
  const auto part_of = [&](BodyId body) {
    if (features.vertex.body == body) return features.vertex.part;
    return features.edge ? features.edge->part : features.other->part;
  };
  const auto is_of = [&](int section, BodyId body) {
    return scene[section].in_scene == body && scene[section].rings->has_part(part_of(body));
  };
  for (int a = 0; a < scene.size(); ++a) {
    for (int b = 0; b < scene.size() && is_of(a, bodies[0]); ++b) {
      if (is_of(b, bodies[1]) && scene.asked(a, b)) return {std::min(a, b), std::max(a, b)};
    }
  }
  throw StructureError("features of parts that have no layer in common");
}

/// Returns the answer as far as `write()` proves it, which returns what there is a log of. If the log is not finished,
/// the answer is undecided from the end of what it proves.
template <class AnyAnswer, class Write>
AnyAnswer as_proved(const AnyAnswer& answer, double start, const Write& write) {
  std::optional<SeparationsBody> proved;
  std::string stopped = what_stops([&] { proved = write(); });
  if (proved) stopped = proved->stopped;
  if (stopped.empty()) {
    AnyAnswer known = answer;
    if (answer.outcome == Outcome::undecided) known.free_until = proved ? proved->free_until : start;
    if (proved) state_as_proved(known, *proved);
    return known;
  }
  AnyAnswer undecided;
  if constexpr (std::is_same_v<AnyAnswer, Answer>) undecided.engine = answer.engine;
  undecided.outcome = Outcome::undecided;
  undecided.coverage = answer.coverage;
  undecided.free_until = proved ? proved->free_until : start;
  undecided.reason =
      std::string("the answer is ") + to_string(answer.outcome) + ", but its proof was not finished: " + stopped;
  return undecided;
}

/// The end of the windows if nothing happens before `until`. At a joint, windows include all of its bridges, and an
/// event may occur on one of these, so the windows end at the double before.
double end_of_windows(const proof::VerifierScene& scene, double until) {
  const double t = std::clamp(until, scene.start(), scene.end());
  for (int body = 0; body < scene.size(); ++body) {
    for (const PieceList& motion : scene[body].motions) {
      const double before = std::nextafter(t, scene.start());
      if (t > scene.start() && motion.until(motion.number_at(before)) == t) return before;
    }
  }
  return t;
}

/// Logs that take more work than this are preceded by shorter ones.
constexpr std::uint64_t work_at_once = 200'000;

/// `whole` writes a log about all of the time up to `until`, in which nothing meets. Logs of worlds are finished for no
/// part of the time before they are finished for all of it. So if this one takes long, logs of a 64th and of a 16th
/// of the time are written before; if a limit stops the whole one, the longest of these remains.
template <class Write>
SeparationsBody after_parts(const proof::VerifierScene& scene, Offset offset, double margin, double until,
                            const Write& whole) {
  // Those of two bodies are finished for more and more of the time.
  if (scene.size() == 2) return whole();
  try {
    const Budget at_once(work_at_once);
    return whole();
  } catch (const Interrupted&) {
    // An enclosing budget that is used up stops the next one, too.
  }
  std::optional<SeparationsBody> part;
  try {
    for (const double share : {1 / 64.0, 1 / 16.0}) {
      const double end = end_of_windows(scene, scene.start() + share * (until - scene.start()));
      if (end > scene.start()) part = SeparationsWriter(scene, offset, margin).free_until(end);
    }
    return whole();
  } catch (const Undecidable& limit) {
    if (!part) throw;
    part->stopped = not_decided(limit);
  } catch (const Interrupted& limit) {
    if (!part) throw;
    part->stopped = limit.reason;
  }
  return *part;
}

/// The proof that nothing happens up to the time in the answer; none for other answers.
template <class AnyAnswer>
std::optional<SeparationsBody> freedom(const AnyAnswer& answer, const proof::VerifierScene& proved, Offset offset,
                                       double margin) {
  const bool free = answer.outcome == Outcome::free;
  const double until = free ? proved.end() : end_of_windows(proved, answer.free_until);
  if (!free && (answer.outcome != Outcome::undecided || until <= proved.start())) return std::nullopt;
  return after_parts(proved, offset, margin, until, [&] {
    SeparationsWriter writer(proved, offset, margin);
    return free ? writer.free() : writer.free_until(until);
  });
}

/// The body of the log of an answer, without its header; none if there is nothing to prove.
std::optional<SeparationsBody> body_of_log(const Run& run, const proof::VerifierScene& proved, const Answer& answer,
                                           Touch touch) {
  const Offset offset = offset_for(touch);
  if (answer.outcome != Outcome::contact) return freedom(answer, proved, offset, 0);
  // If there are two bodies, their only pair has its own section.
  const double until = proved.size() == 2 ? std::clamp(answer.free_until, proved.start(), proved.end())
                                          : end_of_windows(proved, answer.free_until);
  const std::vector<PairResult> results = run.search()->results();
  const PairResult* named = earliest(answer, *run.instance(), results);
  if (named->touching) return SeparationsWriter(proved, Offset::inward).touching(*named);
  return after_parts(proved, offset, 0, until,
                     [&] { return SeparationsWriter(proved, offset).contact(*named, until); });
}

}  // namespace

}  // namespace taut

namespace taut::internal {

Answer prove_by_separations(const Scene& scene, std::ostream& log, const CheckOptions& options) {
  Run run(scene, options);
  run.run();
  return prove_by_separations(run, scene, log, options);
}

Answer prove_by_separations(const Run& run, const Scene& scene, std::ostream& log, const CheckOptions& options) {
  const Answer answer = run.answer_with_touching();
  if (!run.search()) return answer;
  return as_proved(answer, scene.start, [&] {
    return write_log(log, scene, options.touch, body_of_log(run, proof::VerifierScene(scene), answer, options.touch));
  });
}

}  // namespace taut::internal

namespace taut {
using namespace internal;

namespace {

/// The body of the log of an answer about a clearance.
std::optional<SeparationsBody> body_about_clearance(const Scene& scene, const MarginAnswer& answer, double clearance,
                                                    Touch touch) {
  const proof::VerifierScene proved(scene);
  const Offset offset = offset_for(touch);
  const double margin = std::ldexp(clearance, proved.exponent());
  if (answer.outcome != Outcome::contact) return freedom(answer, proved, offset, margin);
  const PairMargin& first = *answer.first;
  const std::array<int, 2> bodies = sections_with(proved, first.bodies, *first.features);
  if (offset == Offset::outward && first.time.hi <= proved.start())
    return SeparationsWriter(proved, Offset::inward, margin).close_at_start(bodies, *first.features);
  const double until = end_of_windows(proved, answer.free_until);
  return after_parts(proved, offset, margin, until, [&] {
    return SeparationsWriter(proved, offset, margin).closer(bodies, *first.features, {until, first.time.hi});
  });
}

}  // namespace

MarginAnswer prove_clearance(const Scene& scene, double clearance, std::ostream& log, const CheckOptions& given) {
  // The parts of this query have limits of their own. This limit applies to all of them together.
  const Budget scope(given.limits);
  if (!scene.clearances.empty())
    throw InputError("clearances", "a log is about one clearance for all pairs",
                     "take them out of the scene, or ask check_clearance()");
  if (has_curves(scene)) return prove_clearance_of_curves(scene, clearance, log, given);
  CheckOptions options = given;
  options.all_pairs = false;
  MarginAnswer answer = check_clearance(scene, clearance, options);
  // The log is about the time before a lock.
  if (answer.outcome == Outcome::locked) answer.outcome = Outcome::free;
  MarginAnswer proved = as_proved(answer, scene.start, [&] {
    return write_log(log, scene, options.touch, body_about_clearance(scene, answer, clearance, options.touch),
                     clearance);
  });
  note_lock(scene, proved.outcome, proved.reason);
  return proved;
}

}  // namespace taut
