// What every kind of curve segment is made of.
#pragma once

#include <initializer_list>

#include "numeric/overloaded.hpp"
#include "taut/outline.hpp"

namespace taut::internal {

/// Calls visit(x) for each number of a segment: its end first, then what else there is, but for an arc's flags.
template <class Visit>
void for_each_number(const CurveSegment& segment, const Visit& visit) {
  const auto all = [&](std::initializer_list<double> numbers) {
    for (const double x : numbers) visit(x);
  };
  all({end_of(segment).x, end_of(segment).y});
  std::visit(Overloaded{[](const LineTo&) {},
                        [&](const ArcTo& s) {
                          all({s.rx, s.ry, s.rotation_deg});
                        },
                        [&](const QuadraticTo& s) {
                          all({s.control.x, s.control.y});
                        },
                        [&](const CubicTo& s) {
                          all({s.first.x, s.first.y, s.second.x, s.second.y});
                        }},
             segment);
}

}  // namespace taut::internal
