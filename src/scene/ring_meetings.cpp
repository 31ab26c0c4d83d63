#include "scene/ring_meetings.hpp"

#include "numeric/budget.hpp"
#include "scene/placement.hpp"

namespace taut::internal {
namespace {

/// The rings of P, or Q, where they are.
class PlacedRings {
 public:
  PlacedRings(const BodyPair& bodies, const Placement& placement, Role role)
      : place_(placement), rings_(bodies.rings[index_of(role)]->rings()), first_(placement.geometry().first(role)) {}

  /// Of each part, its outline.
  std::vector<std::size_t> outlines() const {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < rings_.size(); ++i) {
      if (rings_[i].ring == 0) all.push_back(i);
    }
    return all;
  }
  VertexId vertex_of(std::size_t ring) const { return VertexId(first_ + rings_[ring].offset); }

  /// The ring of the part with this outline that a vertex of the other body is just inside of; `outline` itself if it
  /// is in no hole. Nothing if it is outside.
  std::optional<std::size_t> around(VertexId v, std::size_t outline) const {
    if (!encloses(outline, v)) return std::nullopt;
    for (std::size_t i = outline + 1; i < rings_.size() && rings_[i].ring > 0; ++i) {
      if (encloses(i, v)) return i;
    }
    return outline;
  }

 private:
  /// A ray along the sweep's "up" crosses a ring an odd number of times from inside.
  bool encloses(std::size_t ring, VertexId v) const {
    checkpoint();
    const RingMap& map = rings_[ring];
    bool inside = false;
    VertexId a(first_ + map.offset + map.size - 1);
    bool a_before = place_.before(a, v);
    for (std::uint32_t k = 0; k < map.size; ++k) {
      const VertexId b(first_ + map.offset + k);
      const bool b_before = place_.before(b, v);
      if (a_before != b_before && place_.orientation(a_before ? a : b, a_before ? b : a, v) < 0) inside = !inside;
      a = b;
      a_before = b_before;
    }
    return inside;
  }

  const Placement& place_;
  const std::vector<RingMap>& rings_;
  std::uint32_t first_;
};

}  // namespace

RingMeetings ring_meetings(const BodyPair& bodies, const Placement& placement) {
  const PlacedRings p(bodies, placement, Role::p), q(bodies, placement, Role::q);
  const std::vector<std::size_t> parts_p = p.outlines(), parts_q = q.outlines();
  RingMeetings result;
  for (const std::size_t i : parts_p) {
    for (const std::size_t j : parts_q) {
      const VertexId of_p = p.vertex_of(i), of_q = q.vertex_of(j);
      RingMeeting meeting{i, j};
      if (const auto ring = p.around(of_q, i)) {
        if (*ring == i) return {{}, of_q};
        meeting.p = *ring;
      } else if (const auto other = q.around(of_p, j)) {
        if (*other == j) return {{}, of_p};
        meeting.q = *other;
      }
      result.pairs.push_back(meeting);
    }
  }
  return result;
}

}  // namespace taut::internal
