#include "import/kept_curves.hpp"

#include <algorithm>

#include "numeric/overloaded.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

std::pair<double, double> key_of(const Point& p) { return {p.x, p.y}; }

/// The same curve to this end, the other way round if asked for.
CurveSegment segment_to(const KeptCurve& curve, bool reversed, const Point& end) {
  CurveSegment segment = curve.segment;
  std::visit([&end](auto& s) { s.to = end; }, segment);
  if (!reversed) return segment;
  std::visit(Overloaded{[](LineTo&) {}, [](ArcTo& arc) { arc.sweep = !arc.sweep; }, [](QuadraticTo&) {},
                        [](CubicTo& c) { std::swap(c.first, c.second); }},
             segment);
  return segment;
}

}  // namespace

CurveFinder::CurveFinder(const std::vector<KeptCurve>& curves) {
  for (const KeptCurve& curve : curves) {
    by_first_.emplace(key_of(curve.inner.front()), Match{&curve, false});
    by_first_.emplace(key_of(curve.inner.back()), Match{&curve, true});
    for (const Point& p : curve.inner) by_inner_.emplace(key_of(p), &curve);
  }
}

CurveFinder::Match CurveFinder::match_at(const Polygon& ring, std::size_t first) const {
  const auto known = by_first_.find(key_of(ring[first % ring.size()]));
  if (known == by_first_.end()) return {};
  const std::vector<Point>& inner = known->second.curve->inner;
  if (inner.size() >= ring.size()) return {};
  // Of one inner point both directions are the same to the eye: the ring's own ends decide.
  for (const bool reversed : {known->second.reversed, !known->second.reversed}) {
    bool same = inner.size() > 1 ||
                reversed == (ring[(first + ring.size() - 1) % ring.size()] == end_of(known->second.curve->segment));
    for (std::size_t i = 0; i < inner.size() && same; ++i)
      same = ring[(first + i) % ring.size()] == inner[reversed ? inner.size() - 1 - i : i];
    if (same) return {known->second.curve, reversed};
  }
  return {};
}

FoundOutline CurveFinder::outline(const Polygon& ring, const std::set<const KeptCurve*>& chorded) const {
  const std::size_t n = ring.size();
  const auto kept_at = [&](std::size_t i) {
    const Match match = match_at(ring, i);
    return chorded.count(match.curve) ? Match{} : match;
  };
  // Begin at a point that is inside of no curve.
  std::vector<bool> inside(n, false);
  for (std::size_t i = 0; i < n; ++i) {
    const Match match = kept_at(i);
    for (std::size_t k = 0; match.curve && k < match.curve->inner.size(); ++k) inside[(i + k) % n] = true;
  }
  std::size_t begin = 0;
  while (begin < n && inside[begin]) ++begin;
  FoundOutline found{{ring[begin % n], {}}, {}, {}};
  for (std::size_t i = 1; i <= n;) {
    const Match match = kept_at(begin + i);
    found.curves.push_back(match.curve);
    if (!match.curve) {
      const auto curve = by_inner_.find(key_of(ring[(begin + i) % n]));
      if (curve != by_inner_.end() && !chorded.count(curve->second)) found.cut.insert(curve->second);
      found.outline.segments.emplace_back(LineTo{ring[(begin + i++) % n]});
      continue;
    }
    i += match.curve->inner.size();
    found.outline.segments.push_back(segment_to(*match.curve, match.reversed, ring[(begin + i++) % n]));
  }
  return found;
}

}  // namespace taut::drawing
