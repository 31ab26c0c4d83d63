#include "answer_row.hpp"

#include <cmath>

namespace taut_python {
namespace {

void put(const taut::Contact& contact, AnswerRow& row) {
  row.t_lo = contact.time.lo;
  row.t_hi = contact.time.hi;
  row.point[0] = contact.point.x;
  row.point[1] = contact.point.y;
  row.normal[0] = contact.normal.x;
  row.normal[1] = contact.normal.y;
  const taut::VertexRef& v = contact.vertex;
  const taut::EdgeRef& e = contact.edge;
  row.vertex = {v.body, v.part, v.ring, v.index};
  row.edge = {e.body, e.part, e.ring, e.index};
  row.grazing = contact.grazing ? 1 : 0;
}

}  // namespace

AnswerRow answer_row(const taut::Answer& answer) {
  AnswerRow row{NAN,
                NAN,
                answer.free_until,
                {NAN, NAN},
                {NAN, NAN},
                answer.events,
                answer.coverage.untested(),
                {-1, -1},
                {},
                {},
                0,
                0,
                0,
                {}};
  row.outcome = static_cast<std::uint8_t>(answer.outcome);
  if (answer.pair) {
    row.pair[0] = (*answer.pair)[0];
    row.pair[1] = (*answer.pair)[1];
  }
  if (answer.contact) put(*answer.contact, row);
  if (answer.touching) put(*answer.touching, row);
  row.touching = answer.touching ? 1 : 0;
  if (answer.overlap_point) {
    row.point[0] = answer.overlap_point->x;
    row.point[1] = answer.overlap_point->y;
  }
  return row;
}

}  // namespace taut_python
