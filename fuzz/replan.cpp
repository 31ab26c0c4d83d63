#include "replan.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "examine.hpp"
#include "motion/pieces.hpp"
#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "scene/placement.hpp"
#include "support/audit.hpp"
#include "support/tiling_run.hpp"
#include "taut/error.hpp"

namespace taut::fuzz {
using namespace internal;
using testing::TilingRun;
namespace {

/// How the run comes to a joint: as advance_to() does, with every event before it, or as step() does, which leaves
/// it at the event that reaches the joint's time, with others at the same instant still to come.
/// Or the present plan is announced anew after every third event.
enum class Approach { advancing, stepping, repeating };

class Replanned {
 public:
  Replanned(const Scene& scene, const CheckOptions& options, Approach approach)
      : scene_(scene), options_(options), approach_(approach) {}

  std::string run(Answer& answer) {
    if (approach_ == Approach::repeating) return run_repeating(answer);
    Scene first = scene_;
    for (std::size_t b = 0; b < 2; ++b) first.bodies[b].motion = plan(b, scene_.start);
    TilingRun run(first, options_.touch);
    for (const double joint : joints()) {
      if (std::string fault = reach(run, joint); !fault.empty()) return fault;
      if (run.finished() || run.engine().events() >= options_.max_events) break;
      for (std::size_t b = 0; b < 2; ++b) {
        if (has_joint(b, joint)) run.set_motion(static_cast<int>(b), plan(b, joint));
      }
      changed_ = true;
    }
    if (std::string fault = reach(run, scene_.end); !fault.empty()) return fault;
    conclude(run, answer);
    return {};
  }

 private:
  std::string run_repeating(Answer& answer) {
    TilingRun run(scene_, options_.touch);
    if (std::string fault = reach(run, scene_.end); !fault.empty()) return fault;
    conclude(run, answer);
    return {};
  }

  static void conclude(const TilingRun& run, Answer& answer) {
    if (run.finished()) answer = run.answer();
  }

  std::vector<double> joints() const {
    std::vector<double> all;
    for (const Body& body : scene_.bodies) {
      for (std::size_t k = 0; k + 1 < body.motion.pieces.size(); ++k) all.push_back(body.motion.pieces[k].until);
    }
    all.erase(
        std::remove_if(all.begin(), all.end(), [this](double t) { return !(scene_.start < t && t < scene_.end); }),
        all.end());
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
  }

  bool has_joint(std::size_t body, double t) const {
    const auto& pieces = scene_.bodies[body].motion.pieces;
    return std::any_of(pieces.begin(), pieces.end(), [t](const MotionPiece& p) { return p.until == t; });
  }

  /// The piece that begins at t, for ever if it may; else the pieces as they come.
  Motion plan(std::size_t body, double t) const {
    const Body& b = scene_.bodies[body];
    Motion rest;
    for (const MotionPiece& piece : b.motion.pieces) {
      if (piece.until > t || &piece == &b.motion.pieces.back()) rest.pieces.push_back(piece);
    }
    if (rest.pieces.size() < 2) return rest;
    Motion one{{rest.pieces[0]}};
    one.pieces[0].until = INFINITY;
    try {
      validate_motion(one, b.name, box_around(b.polygon), t, scene_.end, 1);
      return one;
    } catch (const InputError&) {
      return rest;
    }
  }

  std::string reach(TilingRun& run, double t) {
    while (!run.finished() && run.engine().events() < options_.max_events) {
      if (changed_) {
        changed_ = false;
        if (std::string fault = testing::compare_with_static(run, counts_); !fault.empty()) return fault;
      }
      const bool more = run.step(t);
      if (more && approach_ == Approach::repeating && run.engine().events() % 3 == 1) repeat(run);
      if (!more && (run.engine().time() >= t || run.finished())) break;
      if (approach_ == Approach::stepping && t < scene_.end && run.engine().time() >= t) break;
    }
    return {};
  }

  /// The plans of both bodies, as they are.
  void repeat(TilingRun& run) {
    for (int b = 0; b < 2; ++b) {
      if (!run.finished()) run.set_motion(b, scene_.bodies[static_cast<std::size_t>(b)].motion);
    }
    changed_ = true;
  }

  const Scene& scene_;
  const CheckOptions& options_;
  Approach approach_;
  testing::AuditCounts counts_;
  bool changed_ = false;  ///< a plan, since the map was compared last
};

}  // namespace

std::string audit_plan_changes(const Scene& scene, const Answer& whole, const CheckOptions& options) {
  const auto moves_on = [](const Body& b) { return b.motion.pieces.size() > 1; };
  const bool joints = std::any_of(scene.bodies.begin(), scene.bodies.end(), moves_on);
  for (const Approach approach : {Approach::repeating, Approach::advancing, Approach::stepping}) {
    if (approach != Approach::repeating && !joints) continue;
    const Budget scope(Limits{4 * options.limits.max_seconds});
    try {
      Answer answer;
      if (std::string fault = Replanned(scene, options, approach).run(answer); !fault.empty()) return fault;
      if (std::string fault = contradiction(answer, whole); !fault.empty()) return fault;
    } catch (const Undecidable&) {
    } catch (const Interrupted&) {
    }
  }
  return {};
}

}  // namespace taut::fuzz
