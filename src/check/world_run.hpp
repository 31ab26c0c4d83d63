// The run for many bodies, with one answer.
#pragma once

#include <optional>
#include <string>

#include "base/budget.hpp"
#include "check/earliest.hpp"
#include "check/run.hpp"
#include "search/world_search.hpp"

namespace taut::internal {

/// The search for the first contact of any pair, and its result.
class WorldRun final : public Run {
 public:
  WorldRun(const Scene& scene, const CheckOptions& options);

  bool work(std::uint64_t effort) override;
  const Answer& answer() const override { return answer_; }
  StageCounts stages() const override { return search_ ? search_->stages() : StageCounts(); }
  /// None if the run was interrupted before there was one.
  const std::optional<WorldPlan>& plan() const { return plan_; }
  const std::optional<WorldSearch>& search() const { return search_; }

 private:
  bool leave_untested();
  void conclude();
  std::vector<PairEvent> pairs() const;
  void name_engine();

  const Scene& scene_;
  const CheckOptions& options_;
  Budget scope_;
  std::optional<WorldPlan> plan_;
  std::optional<WorldSearch> search_;
  Answer answer_;
  std::string stopped_;
};

}  // namespace taut::internal
