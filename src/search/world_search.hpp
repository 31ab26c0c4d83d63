// The first contact of any of many pairs: which of them can meet at all, and when, is told by boxes; the rest is asked
// pair by pair.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "search/portfolio_solver.hpp"
#include "world/swept_box.hpp"

namespace taut::internal {

/// The search goes through time in windows, halved where motions are fast beside the bodies' sizes. In each window
/// boxes are swept and pruned: a pair whose boxes meet, and that would not be told apart by shorter windows, is settled
/// by an engine for all of the window. Windows come in the order of time, so that a world with an early
/// contact costs little.
class WorldSearch {
 public:
  /// `all`: every pair goes on to its own first contact; else what happens after the first contact does not matter.
  WorldSearch(const WorldPlan& plan, Touch touch, bool all, EngineChoice engine = EngineChoice::spacetime,
              std::uint64_t max_events = UINT64_MAX);
  ~WorldSearch();

  /// Overlaps, and contacts, at the start. False if nothing is left to ask.
  bool start();
  /// From there to the end.
  void run();

  /// Of the pairs that do not stay free, or all that met in boxes, in the order of the file.
  std::vector<PairResult> results() const { return results_of(pairs_); }
  /// Up to when nothing happens, as far as the search went.
  double proved() const { return proved_; }
  StageCounts stages() const { return stages_of(pairs_); }
  /// Visits the pairs that went to an engine.
  template <class Visit>
  void for_each_pair(const Visit& visit) const {
    for (const auto& [key, pair] : pairs_) visit(*pair);
  }

 private:
  struct DormantCertificates;
  PairSolver& pair(int a, int b);
  void cover(double from, double to, const std::vector<int>& bodies, const DormantCertificates* above, int depth);
  void settle(PairSolver& pair, double from, double to);
  bool over(double t) const { return !all_ && t > stop_; }

  const WorldPlan& plan_;
  bool inwards_, all_;
  EngineChoice engine_;
  EventBudget budget_;
  std::map<std::pair<int, int>, std::unique_ptr<PairSolver>> pairs_;
  double stop_, proved_;
  std::uint64_t dormant_ = 0, to_settle_ = 0;  ///< pairs in windows, for who waits
};

}  // namespace taut::internal
