// A scene of any number of bodies in the terms of the engines.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "motion/make_segments.hpp"
#include "scene/body_pair.hpp"
#include "scene/ignored_pairs.hpp"
#include "taut/check.hpp"

namespace taut::internal {

/// One body: its rings, and how it moves.
struct InstanceBody {
  SharedRings rings;
  /// Of its parents, the outermost first, and its own; those that rest are left out. Scaled.
  MotionChain motions;
  int group = 0;
  PieceList own = {};  ///< seen from its parent; empty if it rests there
  int parent = -1;
};

/// All bodies in one scale, their groups, and which pairs are asked about.
class Instance {
 public:
  /// The scene must be valid.
  explicit Instance(const Scene& scene);

  const std::vector<InstanceBody>& bodies() const { return bodies_; }
  double start() const { return start_; }
  double end() const { return end_; }
  /// Internal coordinates are the input's times 2^exponent.
  int exponent() const { return exponent_; }
  /// The largest magnitude of a coordinate, in the plan's units.
  double largest() const { return largest_; }

  /// Two bodies: their pair is followed over the whole time, whether they are near or not.
  bool is_single_pair() const { return bodies_.size() == 2; }
  bool ignored(int a, int b) const { return ignored_.has(a, b); }
  /// Are the two bodies asked about? a != b.
  bool asked(int a, int b) const;
  /// Are pairs of one group asked about? Nothing happens to them after the start.
  bool tests_groups() const { return tests_groups_; }
  /// Of an answer for which engines have examined so many pairs: what is neither excluded nor examined is apart.
  Coverage coverage(std::uint64_t tested) const;

  /// Another motion of a body from t on, which must be valid; what happened before is forgotten but for the piece that
  /// held, and the world starts at `from`, which is t or before. Coverage is not counted anew. Only the body's
  /// followers are looked at, and, for the first change, what moves with what.
  void replan(int body, const Motion& motion, double t, double from);
  /// The body and all that are seen from it, directly or not, in order.
  std::vector<int> followers(int body) const;

  BodyPair pair(int a, int b) const;
  /// Of that pair, from start to end.
  MotionSegments segments(const BodyPair& pair) const { return segments_of(pair, start_, end_); }

 private:
  void add_bodies(const Scene& scene);
  void find_parents(const Scene& scene);
  MotionChain chain_of(int body) const;
  void find_groups();
  void note_moving();
  void leave_group(int body);
  void join_group(int body);
  bool all_alike() const;
  Coverage excluded() const;

  double start_, end_;
  int exponent_ = 0;
  double largest_ = 0;
  std::vector<InstanceBody> bodies_;
  std::vector<std::vector<int>> children_;
  int groups_ = 0;
  int resting_ = -1;  ///< the group of the bodies that rest, if there was one
  /// Known at the start and kept: a body that comes to rest later does not make the others a layout.
  bool tests_groups_ = false;
  /// Bodies that move, by the key of their motion. Known from the first change of a motion on.
  std::optional<std::unordered_map<double, std::vector<int>>> moving_;
  IgnoredPairs ignored_;
};

}  // namespace taut::internal
