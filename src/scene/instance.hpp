// A scene of any number of bodies in the terms of the engines.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "motion/motion_segments.hpp"
#include "scene/body_pair.hpp"
#include "scene/untested.hpp"
#include "taut/check.hpp"

namespace taut::internal {

/// One body: its rings, and how it moves. A body with parts on different layers is several of these, one for each of
/// its cross-sections.
struct InstanceBody {
  SharedRings rings;
  int body = 0;  ///< of the scene
  Layers z = {};
  /// Of its parents, the outermost first, and its own; those that rest are left out. Scaled.
  MotionChain motions;
  int group = 0;
  PieceList own = {};  ///< seen from its parent; empty if it rests there
  int parent = -1;
  /// Its pairs begin no earlier: the body came at that time, or was attached to another one.
  double born = -std::numeric_limits<double>::infinity();
};

/// The motions of a body's parents, the outermost first, and its own, in the scene's coordinates; the scene must be
/// valid.
MotionChain chain_of(const Scene& scene, const Body& body);

/// All bodies in one scale, their groups, and which pairs are asked about.
///
/// Bodies have the numbers that they have in the scene. Those of the scene with several cross-sections have the lowest
/// one there, and the others follow after the last body, in order.
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
  /// The bodies of the scene that two bodies are cross-sections of, the first one first.
  std::array<BodyId, 2> scene_pair(int a, int b) const;
  /// Of how many pairs of the scene are these pairs of bodies?
  template <class Pairs>
  std::uint64_t scene_pairs(const Pairs& pairs) const {
    if (bodies_.size() == in_scene_) return pairs.size();
    std::set<std::array<BodyId, 2>> of_scene;
    for (const auto& [a, b] : pairs) of_scene.insert(scene_pair(a, b));
    return of_scene.size();
  }
  /// All cross-sections of a body of the scene, in order.
  std::vector<int> sections(BodyId body) const;
  /// Is the pair never asked about, however the bodies move? It is ignored, or has no common layer, or is of one body.
  bool excluded(int a, int b) const;
  /// Are the two bodies asked about? a != b.
  bool asked(int a, int b) const;
  /// Are pairs of one group asked about? Nothing happens to them after the start.
  bool tests_groups() const { return tests_groups_; }
  /// For a scene of a part of this time, in which more bodies may rest: the same pairs are asked about.
  AtRest at_rest() const { return tests_groups_ ? AtRest::test : AtRest::never; }
  /// Of an answer for which engines have examined so many pairs of the scene: what is neither excluded nor examined is
  /// apart.
  Coverage coverage(std::uint64_t tested) const;
  /// Of an answer that is about bodies that move alike, too: what is not excluded is tested.
  Coverage coverage_of_all_groups() const;

  /// Another motion of a body from t on, which must be valid; what happened before is forgotten but for the piece that
  /// held, and the world starts at `from`, which is t or before. Coverage is not counted anew. Only the body's
  /// followers are looked at, and, for the first change, what moves with what.
  void replan(int body, const Motion& motion, double t, double from);
  /// Can the body be added, which must be valid? If not, as it is larger than all others, or has cross-sections of its
  /// own, or another body has, all numbers would change.
  bool can_add(const Body& body) const;
  /// The body as the last one, which is there from t on, for add().
  InstanceBody to_add(const Body& body, int parent, double t) const;
  /// `from`: as for replan().
  void add(InstanceBody body, double from);
  /// Takes back what add() has done, but for `from`.
  void remove_last();
  /// The body is seen from that parent, or none, from t on; its followers' pairs begin there. `own`: pieces_of().
  void attach(int body, int parent, const PieceList& own, double t, double from);
  /// From t on; none if the body rests.
  PieceList pieces_of(const Motion& motion, double t) const;
  const IgnoredPairs& ignored() const { return ignored_; }
  /// Two bodies of the scene are not asked about any more.
  void ignore(int a, int b) { ignored_.add(a, b); }
  /// A body of the scene, to which none is attached, is not asked about any more, and rests.
  void retire(int body);
  /// The body and all that are seen from it, directly or not, in order.
  std::vector<int> followers(int body) const;

  BodyPair pair(int a, int b) const;
  /// From when on the two bodies are only where they have been before: see motion/far_pieces.hpp.
  double repeats_from(int a, int b) const;
  /// From when on both bodies are there.
  double start_of(int a, int b) const { return std::max({start_, section(a).born, section(b).born}); }
  /// Of that pair, from start to end.
  MotionSegments segments(const BodyPair& pair) const { return segments_of(pair, start_, end_); }

 private:
  const InstanceBody& section(int body) const { return bodies_[static_cast<std::size_t>(body)]; }
  InstanceBody lowest_section(const Body& given, int index, double from) const;
  void add_bodies(const Scene& scene);
  void add_sections(const Scene& scene);
  void find_parents(const Scene& scene);
  MotionChain chain_of(int body) const;
  void find_groups();
  void note_moving();
  void leave_group(int body);
  void join_group(int body);
  bool all_alike() const;
  Coverage excluded(bool groups_are_tested) const;
  std::uint64_t on_other_layers(bool groups_are_tested) const;

  double start_, end_;
  int exponent_ = 0;
  double largest_ = 0;
  std::vector<InstanceBody> bodies_;
  std::vector<std::vector<Layers>>
      layers_;                ///< of the scene's bodies, each interval once; empty if all have all layers
  std::size_t in_scene_ = 0;  ///< the number of the scene's bodies
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
