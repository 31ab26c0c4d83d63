// A scene in the terms of a log of separations: its bodies in one scale, and which pairs are asked about.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "motion/motion_segments.hpp"
#include "scene/body_pair.hpp"
#include "scene/untested.hpp"
#include "taut/coverage.hpp"

namespace taut::internal::proof {

/// One body: its rings, and the motions of its chain, the outermost parent's first, without those that rest. Scaled. A
/// body whose parts have different layers is one of these for each of its cross-sections: the lowest one has the body's
/// number, and the others follow after the last body, in order.
struct VerifierBody {
  std::shared_ptr<const RingSet> rings;
  int in_scene = 0;  ///< the body's number in the scene
  Layers z = {};
  MotionChain motions;
  int alike = 0;  ///< the same number for all bodies with the same motions: nothing happens between them

  bool rests() const { return motions.empty(); }
};

/// What a verifier has to know of a scene, found out here and nowhere else: an engine that left out a pair would not
/// make it disappear from what a log has to prove.
class VerifierScene {
 public:
  /// The scene must be valid.
  explicit VerifierScene(const Scene& scene);

  int size() const { return static_cast<int>(bodies_.size()); }
  const VerifierBody& operator[](int i) const { return bodies_[static_cast<std::size_t>(i)]; }
  double start() const { return start_; }
  double end() const { return end_; }
  /// Internal coordinates are the input's times 2^exponent.
  int exponent() const { return exponent_; }

  /// All pairs but the ignored ones, those without a common layer, and those that move alike unless they are tested,
  /// too.
  bool asked(int a, int b) const;
  /// Are pairs that move alike tested? As the scene says, and where all bodies do that are not ignored altogether.
  bool tests_alike() const { return tests_alike_; }
  /// Is the body ignored altogether?
  bool ignores(int body) const { return ignored_.has_all((*this)[body].in_scene); }
  /// `tested`: all pairs that are asked about.
  Coverage coverage() const;
  /// In their roles: P is the body with the larger diameter, the first one if equal.
  BodyPair pair(int a, int b) const;
  /// From when on the two bodies are only where they have been before: see motion/far_pieces.hpp.
  double repeats_from(int a, int b) const;
  /// From start to end, in a frame that parents which both have are not in.
  MotionSegments segments(const BodyPair& pair) const;

 private:
  void add_bodies(const Scene& scene);
  void add_motions(const Scene& scene);
  void find_alike();
  std::uint64_t without_common_layer() const;

  double start_, end_;
  int exponent_ = 0;
  std::vector<VerifierBody> bodies_;
  IgnoredPairs ignored_;
  bool tests_alike_ = false;
  int in_scene_ = 0;      ///< the number of the scene's bodies
  bool layered_ = false;  ///< some body is not on all layers
};

}  // namespace taut::internal::proof
