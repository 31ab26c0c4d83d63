// The first contact of any of many pairs. Boxes determine which of them can meet at all, and when; the rest is searched
// pair by pair.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/meeting_boxes.hpp"
#include "solver/portfolio_solver.hpp"

namespace taut::internal {

/// A single pair is searched over the whole time at once. Otherwise, the search proceeds through time in windows, which
/// are halved where motions are fast relative to the bodies' sizes. In each window, boxes are swept and pruned. A pair
/// whose boxes meet, and that shorter windows would not separate, is decided by an engine for the whole window. Windows
/// come in order of time, so that a world with an early contact costs little.
class WorldSearch {
 public:
  /// With `all`, every pair continues to its own first contact. Otherwise, events after the first contact do not
  /// matter.
  WorldSearch(const Instance& instance, Touch touch, bool all, const SolverChoice& choice,
              std::uint64_t max_events = UINT64_MAX);
  ~WorldSearch();

  /// Determines overlaps, and contacts, at the start. Returns false if nothing is left to search.
  bool start();
  /// Searches from the start to the end.
  void run();

  /// The results of the pairs that do not stay free, or of all whose boxes met, in the order of the file.
  std::vector<PairResult> results() const { return results_of(pairs_); }
  /// The time up to which nothing happens, as far as the search went.
  double proved() const { return proved_; }
  StageCounts stages() const { return stages_of(pairs_); }
  /// Visits the pairs that went to an engine.
  template <class Visit>
  void for_each_pair(const Visit& visit) const {
    for (const auto& [key, pair] : pairs_) visit(*pair);
  }

 private:
  struct DecidedPairs;
  PairSolver& pair(int a, int b);
  void search_single_pair();
  void cover(double from, double to, const std::vector<int>& bodies, const DecidedPairs* above, int depth);
  void resolve(PairSolver& pair, double from, double to);
  bool over(double t) const { return !all_ && t > stop_; }

  const Instance& instance_;
  Offset offset_;
  bool all_;
  SolverChoice choice_;
  EventBudget budget_;
  std::map<std::pair<int, int>, std::unique_ptr<PairSolver>> pairs_;
  double stop_, proved_;
  std::uint64_t decided_ = 0, to_resolve_ = 0;  ///< pairs in windows, for progress reports
};

}  // namespace taut::internal
