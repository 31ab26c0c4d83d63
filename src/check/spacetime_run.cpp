// A run of the spacetime engine that can be interrupted and resumed.
#include <algorithm>
#include <chrono>
#include <optional>
#include <string>

#include "base/budget.hpp"
#include "base/progress.hpp"
#include "check/run.hpp"
#include "motion/pieces.hpp"
#include "numeric/undecided.hpp"
#include "pair/overlap_witness.hpp"
#include "pair/placement.hpp"
#include "relative/make_segments.hpp"
#include "relative/motion_segment.hpp"
#include "sign/contact_at_start.hpp"
#include "spacetime/first_contact.hpp"

namespace taut::internal {
namespace {

/// In units of checkpoint(), in addition to the plan.
constexpr std::uint64_t work_of_spacetime_start = 25;

using Clock = std::chrono::steady_clock;
using spacetime::Hierarchy;
using spacetime::SpacetimeResult;

/// The tree of P or of Q: kept with a prepared shape, or built for this query.
class Tree {
 public:
  Tree(Role role, const PairPlan& plan, const PairGeometry& geometry, bool inwards) {
    const auto make = [&] {
      return std::make_shared<const Hierarchy>(role == Role::p ? spacetime::hierarchy_of_p(geometry)
                                                               : spacetime::hierarchy_of_q(geometry));
    };
    if (const ShapeInRole* shape = shape_in_role(plan, role, inwards)) {
      tree_ = shape->kept<Hierarchy>(ShapeInRole::hierarchy, make);
    } else {
      own_ = make();
      tree_ = own_.get();
    }
  }
  const Hierarchy& get() const { return *tree_; }

 private:
  std::shared_ptr<const Hierarchy> own_;
  const Hierarchy* tree_ = nullptr;
};

/// One query with all its data.
class SpacetimeSearch {
 public:
  SpacetimeSearch(const Scene& scene, Touch touch, bool apart)
      : scene_(scene),
        touch_(touch),
        apart_(apart),
        plan_(plan_pair(scene, validated_facts(scene))),
        geometry_(displaced_pair(plan_, touch == Touch::open)),
        tree_p_(Role::p, plan_, geometry_, touch == Touch::open),
        tree_q_(Role::q, plan_, geometry_, touch == Touch::open),
        segments_(make_segments(plan_.pieces[0], plan_.pieces[1], scene.start, scene.end)),
        search_(geometry_, trees(), segments_) {
    count_work(work_of_spacetime_start);
  }

  /// Answers for the start. Returns true if the search has to continue.
  bool start(Answer& answer) {
    const auto overlap = spacetime::overlapping(geometry_, trees(), segments_[0], scene_.start, &stages_at_start_);
    stages_ = stages_at_start_;
    if (!overlap) return true;
    const auto overlap_of = [&](const PairGeometry& shapes) { return !apart_ && overlap_inwards(shapes); };
    if (const auto touching = contact_at_start(
            witness(), segments_[0], scene_.start, [&] { return *overlap; }, overlap_of)) {
      answer.outcome = Outcome::contact;
      answer.contact = touching->contact;
      return false;
    }
    answer.outcome = Outcome::overlap_at_start;
    answer.overlap_point = common_point(plan_, scene_.start);
    return false;
  }

  /// Continues where the last run was interrupted.
  void run(Answer& answer) {
    const SpacetimeResult found = search_.go_on();
    stages_ = stages_at_start_;
    stages_ += found.stages;
    answer.free_until = std::clamp(segments_[found.segment].time(found.lo), scene_.start, scene_.end);
    report_time(answer.free_until);
    if (found.outcome == SpacetimeResult::free) {
      conclude_free(scene_.end, answer);
    } else if (found.outcome == SpacetimeResult::contact) {
      answer.outcome = Outcome::contact;
      answer.contact = witness().contact(found.found, segments_[found.segment]);
      answer.contact->time.lo = std::max(answer.contact->time.lo, scene_.start);
      answer.free_until = answer.contact->time.lo;
    } else {
      answer.reason = found.reason;
    }
  }

  const StageCounts& stages() const { return stages_; }

 private:
  spacetime::TreePair trees() const { return {tree_p_.get(), tree_q_.get()}; }
  bool overlap_inwards(const PairGeometry& shapes) const {
    const Tree p(Role::p, plan_, shapes, true), q(Role::q, plan_, shapes, true);
    return spacetime::overlapping(shapes, {p.get(), q.get()}, segments_[0], scene_.start).has_value();
  }
  FeatureMap witness() const { return {plan_, geometry_, touch_ == Touch::open}; }

  const Scene& scene_;
  Touch touch_;
  bool apart_;  ///< the bodies are known not to overlap at the start
  PairPlan plan_;
  PairGeometry geometry_;
  Tree tree_p_, tree_q_;
  MotionSegments segments_;
  spacetime::ContactSearch search_;
  StageCounts stages_at_start_, stages_;
};

class SpacetimeRun final : public Run {
 public:
  SpacetimeRun(const Scene& scene, const CheckOptions& options, bool apart) : scope_(options.limits) {
    answer_.engine = EngineName::spacetime;
    answer_.free_until = scene.start;
    speak_of_two(answer_);
    const Clock::time_point start = Clock::now();
    const std::string stopped = what_stops([&] {
      question_.emplace(scene, options.touch, apart);
      done_ = !question_->start(answer_);
      scope_.check();
    });
    if (!stopped.empty()) give_up(stopped);
    answer_.build_seconds = seconds_since(start);
  }

  bool work(std::uint64_t effort) override {
    if (done_) return true;
    const Clock::time_point start = Clock::now();
    const Budget turn(effort);
    answer_.reason.clear();
    try {
      question_->run(answer_);
      done_ = !turn.exhausted();
    } catch (const Undecidable& limit) {
      give_up(not_decided(limit));
    } catch (const Interrupted& limit) {
      if (!turn.exhausted()) give_up(limit.reason);
    }
    answer_.run_seconds += seconds_since(start);
    return done_;
  }
  const Answer& answer() const override { return answer_; }
  StageCounts stages() const override { return question_ ? question_->stages() : StageCounts(); }

 private:
  void give_up(const std::string& reason) {
    answer_.reason = reason;
    done_ = true;
  }

  Budget scope_;
  std::optional<SpacetimeSearch> question_;
  Answer answer_;
  bool done_ = false;
};

}  // namespace

std::unique_ptr<Run> begin_spacetime(const Scene& scene, const CheckOptions& options) {
  return std::make_unique<SpacetimeRun>(scene, options, false);
}

std::unique_ptr<Run> begin_spacetime_apart(const Scene& scene, const CheckOptions& options) {
  return std::make_unique<SpacetimeRun>(scene, options, true);
}

Answer run_spacetime(const Scene& scene, const CheckOptions& options) {
  SpacetimeRun run(scene, options, false);
  run.work(UINT64_MAX);
  return with_touching(run, scene, options, run_spacetime);
}

}  // namespace taut::internal
