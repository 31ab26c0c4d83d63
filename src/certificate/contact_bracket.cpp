#include "certificate/contact_bracket.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "certificate/fast_function.hpp"
#include "certificate/precise_triple.hpp"
#include "numeric/stages.hpp"

namespace taut::internal {
namespace {

/// The edge, given by its first vertex, and the vertex. A body lies to the left of its edges, so outside is negative.
CertificateFunction function_of(const PairGeometry& g, const FoundContact& found) {
  return {found.edge, g.next(found.edge), found.vertex, g.in_p(found.edge)};
}

/// The slope of the vertex's side of the edge over the whole ball. The displacement is too small to matter.
Ball<double> slope_over(const MotionSegment& segment, const FastFunction& f, const Ball<double>& t) {
  // Coefficients are rounded by less than this share of their magnitudes' bounds.
  constexpr double rounding = 0x1p-45;
  const Frame<double> frame = internal::frame(segment, t);
  const std::array<Jet<double>, 5>& side = f.pp ? frame.for_pp : frame.for_qq;
  const double bounds[5] = {f.m0, f.w, f.w, f.m34, f.m34};
  Ball<double> sum = Ball<double>::exact(0);
  for (std::size_t i = 0; i < 5; ++i) sum = sum + Ball<double>(f.a[i], rounding * bounds[i]) * side[i].d;
  return sum;
}

/// A neighbourhood of the contact of a few units in the last place.
struct Neighbourhood {
  double unit;
  double least_slope;  ///< not positive if the slope may be 0
  double displaced;    ///< the displacement's contribution to the function

  Neighbourhood(const PairGeometry& geometry, const MotionSegment& segment, const FoundContact& found)
      : unit(std::max(std::fabs(found.lo), std::fabs(found.hi)) * 0x1p-53) {
    const FastFunction f = FastFunction::undisplaced(segment, geometry, function_of(geometry, found));
    const Ball<double> slope = slope_over(segment, f, Ball<double>::between(found.lo - 4 * unit, found.hi + 4 * unit));
    least_slope = std::fabs(slope.mid) - slope.rad;
    displaced = f.floor_error;
  }
  /// Does the displacement move the contact by far less than a unit in the last place? By the mean value theorem, it
  /// moves it by no more than its contribution to the function divided by the least slope in the neighbourhood.
  bool is_steep() const { return least_slope * unit > 0x1p12 * displaced; }
};

bool is_steep(const PairGeometry& geometry, const MotionSegment& segment, const FoundContact& found) {
  return segment.bridge || Neighbourhood(geometry, segment, found).is_steep();
}

/// The side of the vertex at one instant: negative outside, 0 if even the highest precision does not decide.
class Side {
 public:
  Side(const MotionSegment& segment, const PairGeometry& geometry, const FoundContact& found)
      : function_(segment, geometry, function_of(geometry, found)) {}

  int operator()(double t) const {
    const PreciseTime now = PreciseTime::between(t, t);
    return first_decisive([&](Stage stage) { return function_.sign_at(now, stage); });
  }

 private:
  PreciseTriple function_;
};

/// Goes from `from` to `end` by growing steps until `reached` holds, and then bisects to where it begins to hold. The
/// result is a place at which it holds, or `end`.
template <class Reached>
double first_place(double from, double end, const Reached& reached) {
  const double span = std::fabs(end - from), towards = end < from ? -1 : 1;
  double near = from, far = end;
  for (double step = std::max(std::fabs(from) * 0x1p-53, span * 0x1p-240); step < span; step *= 4) {
    const double t = from + towards * step;
    if (t == near) continue;
    if (reached(t)) {
      far = t;
      break;
    }
    near = t;
  }
  if (far == end && !reached(end)) return end;
  for (int i = 0; i < 80; ++i) {
    const double middle = near + (far - near) / 2;
    if (middle == near || middle == far) break;
    (reached(middle) ? far : near) = middle;
  }
  return far;
}

}  // namespace

double displacement_sway(const PairGeometry& geometry, const MotionSegment& segment, const FoundContact& found) {
  if (segment.bridge) return 0;
  const Neighbourhood around(geometry, segment, found);
  if (!around.is_steep()) return std::numeric_limits<double>::infinity();
  return around.displaced / around.least_slope * (1 + 0x1p-40);
}

ContactBracket contact_bracket(const BodyPair& bodies, const PairGeometry& geometry, Offset offset,
                               const MotionSegment& segment, const FoundContact& found, Passage passage) {
  ContactBracket bracket{found.lo, found.hi, false};
  if (is_steep(geometry, segment, found)) return bracket;
  const std::optional<PairGeometry> other = displaced_pair_if_possible(bodies, opposite(offset));
  if (!other) {
    const bool earlier = (offset == Offset::inward) == (passage == Passage::enters);
    return {earlier ? segment.start : found.lo, earlier ? found.hi : segment.end, true};
  }
  return bracket_of_sides(found.lo, found.hi, offset, segment, Side(segment, geometry, found),
                          Side(segment, *other, found), passage);
}

ContactBracket bracket_of_sides(double lo, double hi, Offset offset, const MotionSegment& segment,
                                const std::function<int(double)>& here, const std::function<int(double)>& there,
                                Passage passage) {
  ContactBracket bracket{lo, hi, false};
  // Smaller bodies enter later, and leave earlier.
  const auto reached = [&](double t) {
    return offset == Offset::inward ? there(t) < 0 || here(t) > 0 : there(t) > 0 || here(t) < 0;
  };
  if ((offset == Offset::inward) == (passage == Passage::enters)) {
    bracket.lo = first_place(lo, segment.start, reached);
  } else {
    bracket.hi = first_place(hi, segment.end, reached);
  }
  const double scale = std::max({std::fabs(segment.start), std::fabs(segment.end), segment.end - segment.start});
  bracket.grazing = (bracket.hi - bracket.lo) - (hi - lo) > 0x1p-50 * scale;
  return bracket;
}

}  // namespace taut::internal
