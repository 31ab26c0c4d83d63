// Roots beside roots: of forms that are nearly proportional.
//
// Equal teeth, parallel edges and points on one line give forms that are one function but for a factor, the rounding of
// turned coordinates, and the displacement. Their roots fall on one instant, and what tells them apart is far below its
// last digit; but of that little, a few digits are enough. So once one of them is known to all its digits, by the
// numbers of TieForm, others are found from it in doubles.
//
// A form's coefficients are linear in its edge e, and in its points v: they are C(e, v). Where m is the larger
// coordinate of the other form's edge, the two differ by
//   e'_m C(e, v) - e_m C(e', v') = e'_m C(e, v - v') + C(d, v'),  d = e'_m e - e_m e',
// and the second coordinate of d is the cross product of the edges. At the other form's root this combination of frame
// functions is e'_m f alone, and divided by the slope it is how far off the root of f is. Edges and points are
// differences of coordinates, which doubles nearly always have exactly; so where edges are parallel and points in line,
// nothing is left of it but what comes from the displacement.
#pragma once

#include <optional>

#include "numeric/double_double.hpp"
#include "sign/form.hpp"
#include "sign/precise_time.hpp"
#include "sign/tie_frames.hpp"

namespace taut {

struct KnownRoot;

/// A form within reach of a frame's instant, as that takes it.
class NearForm {
 public:
  NearForm() = default;
  NearForm(const TieFrame& frame, const Leg& leg, const PairGeometry& g, const Form& form);

  /// Of the same leg, and about the same instant?
  bool is_beside(const NearForm& o) const { return about_ == o.about_ && pp_ == o.pp_; }
  /// All over the reach; 0 if the slope may change its sign there.
  int slope_sign() const { return slope_.sign(); }
  /// Where the form has its only root within reach, seen from that of another one beside it, whose enclosure counts as
  /// a point. Nothing if the two are not so nearly proportional that this is known far better than a double holds
  /// instants. The slope has a sign.
  std::optional<Bounded> distance_from(const TieFrame& frame, const Leg& leg, const KnownRoot& known) const;

 private:
  bool may_be_proportional_to(const Leg& leg, const NearForm& o) const;
  Bounded scaled_value(const FrameSample& over, const Leg& leg, const NearForm& other, bool turned) const;

  double about_ = 0;
  bool pp_ = false;
  FormPoints<DoubleDouble> given_;  ///< before the displacement
  FormPoints<double> rough_{};
  Bounded displaced_{};  ///< the value that the displacement adds, in its unit, all over the reach
  Bounded slope_{};      ///< all over the reach
};

/// The root of a form, enclosed from an instant on.
struct KnownRoot {
  NearForm form;
  ShortSum from;
  double width = 0;
  double farthest = 0;  ///< from the frame's instant

  KnownRoot() = default;
  /// Given by sums.
  KnownRoot(const NearForm& of, const TieFrame& frame, const PreciseTime& root);
  /// Of a form beside it.
  PreciseTime at_distance(const Bounded& h) const;
};

}  // namespace taut
