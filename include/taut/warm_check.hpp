// The same question about the same two shapes, again and again, from places near the last ones.
#pragma once

#include <cstdint>
#include <memory>

#include "taut/check.hpp"
#include "taut/scene.hpp"

namespace taut {

/// Answers one scene after another by the kinetic engine. Four fifths of a short question's time is the tiling of the
/// free space at its start; where the bodies have moved but a little since the last question's start, the tiling it
/// began with is repaired instead, event by event, on a straight way from there.
///
/// Guarantee: check(scene) is what taut::check() answers with these options and `engine` kinetic, but for the times
/// that it took. No answer hangs on what was asked before: where there is a contact on the way from the last start, or
/// more to repair than a tiling is worth, it is built. So it is for scenes without prepared shapes (taut/shape.hpp), of
/// shapes or scales other than those of the last question, of bodies that have turned by more than 18 degrees, of
/// worlds, and of motions around a centre. A tracer is told of the question's events, and of no others.
///
/// Not thread-safe; distinct ones are independent, and may share shapes.
class WarmCheck {
 public:
  /// `engine` is taken to be kinetic. What else the options point to must live as long.
  explicit WarmCheck(const CheckOptions& options = {});
  ~WarmCheck();
  /// The one moved from may only be destroyed or assigned to.
  WarmCheck(WarmCheck&&) noexcept;
  /// The same.
  WarmCheck& operator=(WarmCheck&&) noexcept;

  /// Throws InputError, as taut::check() does, and then forgets nothing.
  Answer check(const Scene& scene);
  /// How many of the questions began from the last one's tiling.
  std::uint64_t warm_starts() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace taut
