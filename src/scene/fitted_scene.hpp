// A scene whose bodies have been shrunk a little, so that what overlaps by rounding does not.
#pragma once

#include <optional>
#include <vector>

#include "scene/joined_parts.hpp"
#include "taut/check.hpp"

namespace taut::internal {

class Fitter;

/// The same scene with all boundaries moved towards the material by between `fit` and twice as much along every edge:
/// the displacement that puts scenes in general position, only larger, and rounded to doubles. What moves is the
/// boundary of the union of a body's parts: where parts touch or overlap they are joined first (joined_parts()), so
/// that no seam opens. Vertices of other bodies keep their numbers.
class FittedScene {
 public:
  /// The scene must be valid. Throws InputError where a body has features that are finer than the fit, with the place,
  /// or where `fit` is below what doubles decide. Boundaries that may lie outside of those meant by as much as `excess`
  /// move by so much more.
  FittedScene(const Scene& scene, double fit, double excess = 0);

  const Scene& scene() const { return scene_; }
  /// The scene's answer in terms of the bodies given: features of joined parts get the names of the nearest ones there.
  void name_given(Answer& answer) const;

 private:
  void name_given(Contact& contact) const;

  Scene scene_;
  /// What a part of a fitted body was: a part given, or a piece of some that are joined.
  struct Origin {
    int given = 0;
    std::optional<JoinedPart> joined;
  };

  std::vector<Part> fitted_parts(Fitter& fitter, const Body& body, BodyId id, double fit);

  std::vector<std::vector<Origin>> origins_;  ///< by body, of each part
};

}  // namespace taut::internal
