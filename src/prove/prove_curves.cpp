#include "prove/separations_writer.hpp"

#include <functional>
#include <optional>
#include <sstream>
#include <string>

#include "numeric/errors.hpp"
#include "proof/curved_scene.hpp"
#include "proof/format.hpp"
#include "query/bracket.hpp"
#include "scene/ring_set.hpp"
#include "solver/run.hpp"
#include "taut/proof.hpp"

namespace taut::internal {
namespace {

using proof::Bodies;

/// The reason why there is no log.
struct NotProved {
  std::string reason;
};

/// The polygons of the bodies with curves, unchanged.
proof::PolygonsOfBodies polygons_in(const Scene& scene, const Scene& flat) {
  proof::PolygonsOfBodies polygons(scene.bodies.size());
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!scene.bodies[i].curves.empty()) polygons[i] = parts_of(flat.bodies[i]);
  }
  return polygons;
}

/// Polygons on one side of the curves, and the log that proves their answer.
struct Side {
  proof::PolygonsOfBodies polygons;
  std::string log;
  std::string stopped;  ///< why the log proves a part of the time; empty if it proves the answer
};

/// What was not proved, why, and up to when nothing happens by the log that there is.
struct Unproved {
  std::string reason;
  double free_until;
};

/// Writes a log about polygons. Returns why it proves less than the answer, or why there is none.
using ProvePolygons = std::function<std::string(const Scene& polygons, std::ostream& log)>;

class CurvesProver {
 public:
  CurvesProver(const Scene& scene, const CurvedWorld& world, ProvePolygons prove)
      : scene_(scene), world_(world), prove_(std::move(prove)), bodies_(scene) {}

  /// The verifier's own test confirms the side of the polygons before anything is proved about them.
  Side side(CurveSide where) {
    const Scene flat = world_.polygons(where);
    Side made{polygons_in(scene_, flat), {}, {}};
    try {
      bodies_.require(made.polygons, where == CurveSide::outer ? Bodies::around : Bodies::within);
    } catch (const ProofError& error) {
      throw NotProved{error.what()};
    }
    std::ostringstream out;
    made.stopped = prove_(flat, out);
    made.log = out.str();
    if (made.log.empty()) throw NotProved{made.stopped};
    return made;
  }

  /// Names features of the polygons that were confirmed last.
  void name(Contact& contact) const {
    bodies_.name(contact.vertex);
    bodies_.name(contact.edge);
  }

 private:
  const Scene& scene_;
  const CurvedWorld& world_;
  ProvePolygons prove_;
  proof::CurvedBodies bodies_;
};

void write_curved_ring(proof::ByteWriter& out, const Polygon& ring) {
  out.u32(static_cast<std::uint32_t>(ring.size()));
  for (const Point& p : ring) {
    out.f64(p.x);
    out.f64(p.y);
  }
}

void write_curves_log(std::ostream& log, const Scene& scene, Touch touch, const std::vector<Side>& sides) {
  proof::ByteWriter out(log);
  const auto kind = static_cast<std::uint8_t>(sides.size() - 1);
  proof::write_header(out, {proof::of_curves, scene_fingerprint(scene, touch), touch, kind});
  for (const Side& side : sides) {
    for (const std::vector<Part>& parts : side.polygons) {
      for (const Part& part : parts) {
        write_curved_ring(out, part.outline);
        for (const Polygon& hole : part.holes) write_curved_ring(out, hole);
      }
    }
    out.u64(side.log.size());
    for (const char c : side.log) out.u8(static_cast<std::uint8_t>(c));
  }
  out.close();
}

/// Up to when this log proves that nothing happens. The instant of a contact is what the verifier finds, which may be
/// earlier by some units in the last place.
double proved_until(const Scene& polygons, const std::string& log) {
  std::istringstream in(log);
  return verify(polygons, in).free_until;
}

/// States the contact as the verifier reports it: that of polygons within the bodies, and not before those around them
/// may meet.
void state_as_proved(Answer& answer, const CurvesProver& prover, const Answer& around, const Answer& within) {
  if (!within.contact) return;
  answer.contact = within.contact;
  prover.name(*answer.contact);
  answer.contact->time.lo = answer.free_until = around.free_until;
}
void state_as_proved(MarginAnswer& answer, const CurvesProver&, const MarginAnswer& around,
                     const MarginAnswer& within) {
  if (!answer.first || !within.first) return;
  answer.first->time = {around.free_until, within.first->time.hi};
  answer.first->free_until = answer.free_until = around.free_until;
}

/// Writes the log of an answer: polygons around the bodies and, if there is a contact, polygons within. The answer
/// becomes what the log proves. If that is a part of the time, or nothing, it is returned.
template <class AnyAnswer, class Prove>
std::optional<Unproved> prove_sides(const Scene& scene, const CurvedWorld& world, AnyAnswer& answer, Touch touch,
                                    const Prove& prove, std::ostream& log) {
  std::vector<AnyAnswer> proved;
  try {
    CurvesProver prover(scene, world, [&](const Scene& polygons, std::ostream& out) {
      proved.push_back(prove(polygons, out));
      return proved.back().reason;
    });
    std::vector<Side> sides{prover.side(CurveSide::outer)};
    if (!sides[0].stopped.empty()) {
      write_curves_log(log, scene, touch, sides);
      return Unproved{sides[0].stopped, proved[0].free_until};
    }
    if (answer.outcome == Outcome::contact) sides.push_back(prover.side(CurveSide::inner));
    if (!sides.back().stopped.empty()) throw NotProved{sides.back().stopped};
    if (answer.outcome == Outcome::undecided)
      answer.free_until = proved_until(world.polygons(CurveSide::outer), sides[0].log);
    if (answer.outcome == Outcome::contact) state_as_proved(answer, prover, proved[0], proved[1]);
    write_curves_log(log, scene, touch, sides);
    return std::nullopt;
  } catch (const ProofError& error) {
    return Unproved{error.what(), scene.start};
  } catch (const NotProved& trouble) {
    return Unproved{trouble.reason, scene.start};
  } catch (const Interrupted& limit) {
    return Unproved{limit.reason, scene.start};
  }
}

/// Is there anything that a log would prove?
template <class AnyAnswer>
bool is_worth_a_log(const AnyAnswer& answer, const Scene& scene) {
  return answer.outcome == Outcome::free || answer.outcome == Outcome::contact ||
         (answer.outcome == Outcome::undecided && answer.free_until > scene.start);
}

template <class AnyAnswer>
std::string unfinished(const AnyAnswer& answer, const std::string& why) {
  const std::string start = "the answer is ";
  // That of polygons is the same.
  if (why.starts_with(start)) return why;
  return start + to_string(answer.outcome) + ", but its proof was not finished: " + why;
}

}  // namespace

Answer prove_curves(const Scene& scene, std::ostream& log, const CheckOptions& given) {
  CheckOptions options = given;
  options.all_pairs = false;
  CurvedContact found = first_contact_of_curves(scene, options);
  if (!is_worth_a_log(found.answer, scene)) return found.answer;
  options.tell_touching = false;
  const std::optional<Unproved> unproved = prove_sides(
      scene, found.world, found.answer, options.touch,
      [&](const Scene& flat, std::ostream& out) { return prove(flat, out, options); }, log);
  if (!unproved) return found.answer;
  Answer undecided;
  undecided.engine = found.answer.engine;
  undecided.coverage = found.answer.coverage;
  undecided.geometry = found.answer.geometry;
  undecided.free_until = unproved->free_until;
  undecided.reason = unfinished(found.answer, unproved->reason);
  return undecided;
}

MarginAnswer prove_clearance_of_curves(const Scene& scene, double clearance, std::ostream& log,
                                       const CheckOptions& given) {
  CheckOptions options = given;
  options.all_pairs = false;
  CurvedMargin found = margin_of_curves(scene, PairMargins(clearance), options);
  if (!is_worth_a_log(found.answer, scene)) return found.answer;
  const std::optional<Unproved> unproved = prove_sides(
      scene, found.world, found.answer, options.touch,
      [&](const Scene& flat, std::ostream& out) { return prove_clearance(flat, clearance, out, options); }, log);
  if (!unproved) return found.answer;
  MarginAnswer undecided;
  undecided.outcome = Outcome::undecided;
  undecided.coverage = found.answer.coverage;
  undecided.geometry = found.answer.geometry;
  undecided.free_until = unproved->free_until;
  undecided.reason = unfinished(found.answer, unproved->reason);
  return undecided;
}

}  // namespace taut::internal
