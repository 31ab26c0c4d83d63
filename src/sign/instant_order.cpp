#include "sign/instant_order.hpp"

#include <cmath>

#include "sign/precise_triple.hpp"

namespace taut {
namespace {

/// The instant, enclosed better from stage to stage.
class Closing {
 public:
  explicit Closing(const ContactInstant& instant)
      : leg_(instant.leg),
        root_(instant.leg, instant.geometry,
              {instant.contact.edge, instant.geometry.next(instant.contact.edge), instant.contact.vertex,
               instant.geometry.in_p(instant.contact.edge)}),
        parameter_(PreciseTime::between(instant.contact.lo, instant.contact.hi)) {}

  /// What a stage cannot improve stays as it is. A vertex is outside before it meets an edge.
  void refine(int stage) { root_.refine(-1, parameter_, stage); }
  const PreciseTime& parameter() const { return parameter_; }
  /// Of the world.
  PreciseTime time() const { return leg_.bridge ? PreciseTime::between(leg_.joint, leg_.joint) : parameter_; }

 private:
  const Leg& leg_;
  PreciseTriple root_;
  PreciseTime parameter_;
};

bool certainly_before(const PreciseTime& a, const PreciseTime& b, double room) {
  return room == 0 ? a.certainly_before(b) : a.hi() + RealMax(room) < b.lo();
}

}  // namespace

int order_of(const ContactInstant& a, const ContactInstant& b, double room) {
  if (!std::isfinite(room)) return 0;
  const bool one_bridge = &a.leg == &b.leg && a.leg.bridge;
  Closing x(a), y(b);
  for (int stage = -1; stage < precise_stages; ++stage) {
    if (stage >= 0) {
      x.refine(stage);
      y.refine(stage);
    }
    const PreciseTime s = one_bridge ? x.parameter() : x.time(), t = one_bridge ? y.parameter() : y.time();
    if (certainly_before(s, t, room)) return -1;
    if (certainly_before(t, s, room)) return 1;
  }
  return 0;
}

int order_of_given(const ContactInstant& a, const ContactInstant& b) {
  const auto sway = [](const ContactInstant& c) { return displacement_sway(c.geometry, c.leg, c.contact); };
  return order_of(a, b, sway(a) + sway(b));
}

}  // namespace taut
