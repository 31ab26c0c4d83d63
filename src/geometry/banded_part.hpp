// A part bounded by curves, between polygons.
#pragma once

#include <string>
#include <vector>

#include "geometry/band.hpp"

namespace taut::internal::curve {

/// Refines bands until their cells meet neither each other nor their own: then the curves do not, either. Throws
/// InputError with the segments and the place where they still meet when doubles end. `places` name the bands.
void make_apart(std::vector<Band>& bands, const std::string& name, const std::vector<std::string>& places);

/// The outline and its holes, in bands that are apart.
class BandedPart {
 public:
  /// Throws InputError unless the curves are simple, and lie as those of a part must.
  BandedPart(const CurvedPart& part, const std::string& name);

  const std::vector<Band>& bands() const { return bands_; }
  Band& band(std::size_t ring) { return bands_[ring]; }
  /// Are the left walls of this ring on that side of its curve?
  bool left_is(std::size_t ring, CurveSide side) const { return left_is_inner_[ring] == (side == CurveSide::inner); }
  /// The polygons within the part, or around it, ring by ring.
  Part polygons(CurveSide side) const;
  /// The thickest cell's thickness.
  double tolerance() const;

 private:
  std::vector<Band> bands_;
  std::vector<bool> left_is_inner_;
};

}  // namespace taut::internal::curve
