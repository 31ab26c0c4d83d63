// The windows of a log of separations: which of them are halved, and which boxes they state.
#pragma once

#include <functional>
#include <string>

#include "proof/verifier_world.hpp"

namespace taut::internal {

/// A box costs 16 bytes and separates many pairs; the separations of a pair cost a byte or two. So windows state the
/// boxes of bodies that they separate from several others. Where nearly everything may meet everything, the window is
/// halved without further data, as long as that makes boxes shorter.
class WindowWriter {
 public:
  using Pair = std::pair<int, int>;
  /// Writes the separations of a pair in a window.
  using Section = std::function<void(const Pair&, const proof::WorldTime&)>;

  /// `room` as proof::stays_within() requires it. Nothing is written for the pair `except`. All arguments must outlive
  /// this object.
  WindowWriter(const proof::VerifierScene& scene, double room, const Pair& except, std::string& out, Section section);

  void write(double until) { window({scene_.start(), until, true}, {}, 0); }

 private:
  /// The possible positions of a body in the current window.
  struct Fresh {
    AxisBox reach;
    std::optional<proof::StatedBox> box;  ///< the box to be stated, if there is one
  };

  void window(const proof::WorldTime& time, const proof::OpenPairs& open, int depth);
  void halves(const proof::WorldTime& time, const proof::OpenPairs& open, int depth);
  Fresh fresh_box(int body, const proof::WorldTime& time) const;
  bool turns_often(int body, const proof::WorldTime& time) const;
  std::vector<bool> worth_stating(const std::vector<int>& moving, const proof::OpenPairs& open,
                                  const proof::WorldTime& time);
  bool better_halved(const std::vector<int>& moving) const;
  bool is_left(const Pair& pair, const proof::WorldTime& time) const;

  const proof::VerifierScene& scene_;
  double room_;
  Pair except_;
  std::string& out_;
  Section section_;
  proof::WindowBoxes boxes_;
  std::vector<double> sizes_;  ///< of the bodies' boxes at rest
  std::vector<Fresh> fresh_;   ///< by body, for those that matter in the current window
};

}  // namespace taut::internal
