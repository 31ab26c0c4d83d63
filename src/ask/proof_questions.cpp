// The questions about proofs as text: prove, prove_clearance and verify.
#include <sstream>

#include "ask/question.hpp"
#include "numeric/budget.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/proof.hpp"

namespace taut::internal {
namespace {

/// Of exact logs, in which touching counts.
Reply ask_exact_proof(const Scene& scene, const GivenOptions& given) {
  std::ostringstream log;
  const Answer answer = prove_exact(scene, log, given.check());
  return {answer_json(scene, answer, Touch::closed), log.str(), to_hex(scene_fingerprint(scene, Touch::closed))};
}

Reply ask_proof(const Scene& scene, const GivenOptions& given) {
  if (given.flag("exact")) return ask_exact_proof(scene, given);
  std::ostringstream log;
  const Answer answer = prove(scene, log, given.check());
  // There is nothing to prove about bodies that overlap from the start, or where nothing was decided.
  const bool proved = answer.outcome == Outcome::free || answer.contact || answer.free_until > scene.start;
  return {answer_json(scene, answer, given.touch()), proved ? log.str() : std::string(),
          to_hex(scene_fingerprint(scene, given.touch()))};
}

Reply ask_proof_of_margin(const Scene& scene, const GivenOptions& given) {
  const double clearance = given.number("clearance");
  std::ostringstream log;
  const MarginAnswer answer = prove_clearance(scene, clearance, log, given.check());
  return {margin_json(scene, clearance, answer, given.touch()), log.str(),
          to_hex(scene_fingerprint(scene, given.touch()))};
}

Reply ask_verify(const Scene& scene, const GivenOptions& given) {
  return verified([&](std::istream& log) { return verified_json(scene, verify(scene, log)); }, given);
}

}  // namespace

Reply verified(const std::function<std::string(std::istream&)>& check, const GivenOptions& given) {
  try {
    const Budget scope(given.limits());
    std::istringstream log(given.log());
    return {check(log)};
  } catch (const ProofError& error) {
    return {unverified_json(true, error.what())};
  } catch (const Interrupted& limit) {
    return {unverified_json(false, limit.reason)};
  }
}

std::vector<QuestionEntry> proof_questions() {
  return {{.name = "prove",
           .meaning = "As check, with a proof, which is left out where nothing was proved.",
           .answer = "Answer",
           .options = {touch_option(), engine_option(), max_seconds_option(), max_events_option(),
                       flag_option("exact",
                                   "write an exact log, for the checker that is proved: touching counts, and the log "
                                   "ends before a contact")},
           .about_scene = ask_proof,
           .log = QuestionLog::written},
          {.name = "prove_clearance",
           .meaning = "As check_clearance, with a proof.",
           .answer = "MarginAnswer",
           .options = {clearance_option(), touch_option(), max_seconds_option()},
           .about_scene = ask_proof_of_margin,
           .log = QuestionLog::written},
          {.name = "verify",
           .meaning = "Checks a proof, whoever made it.",
           .answer = "Verified",
           .options = {max_seconds_option()},
           .about_scene = ask_verify,
           .log = QuestionLog::read}};
}

}  // namespace taut::internal
