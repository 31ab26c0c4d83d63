#include "kinetic/engine.hpp"

#include <algorithm>
#include <memory>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"

namespace taut::internal {
namespace {

/// In units of checkpoint(): the work of evaluating a certificate, and of an event with its repair. Where all functions
/// are lines, the cost is half of that.
constexpr std::uint64_t work_of_evaluation = 3, work_of_event = 10, work_of_event_on_lines = 5;

}  // namespace

Engine::Corner Engine::corner(HalfedgeId h) const {
  return {map_.origin(h), map_.target(h), map_.target(map_.next(h))};
}

bool Engine::is_mixed(const Corner& c) const {
  return c.u != c.w && !(geometry_.same_body(c.u, c.v) && geometry_.same_body(c.v, c.w));
}

CertificateId Engine::add_certificate(HalfedgeId h, const Corner& vertices) {
  CertificateId id;
  if (free_.empty()) {
    id = CertificateId(certificates_.size());
    certificates_.emplace_back();
    dormant_.add();
  } else {
    id = free_.back();
    free_.pop_back();
  }
  Certificate& c = certificates_[id.value];
  c.corner = h;
  c.u = vertices.u;
  c.v = vertices.v;
  c.w = vertices.w;
  certificate_of_.touch(h.value) = id;
  ++active_;
  return id;
}

void Engine::drop_corner(HalfedgeId h) {
  const CertificateId id = certificate_of_.get(h.value);
  if (!id.valid()) return;
  queue_.remove(id);
  Certificate& c = certificates_[id.value];
  solver_.release(c);
  c.corner = HalfedgeId();
  certificate_of_.touch(h.value) = CertificateId();
  free_.push_back(id);
  --active_;
}

/// Determines the certificate that the corner has now. The result is invalid if the corner has none, or if its
/// certificate continues unchanged.
CertificateId Engine::certificate_to_start(HalfedgeId h, const Now& now) {
  const Corner at = corner(h);
  if (!is_mixed(at)) {
    drop_corner(h);
    return {};
  }
  const CertificateId id = certificate_of_.get(h.value);
  if (!id.valid()) return add_certificate(h, at);
  Certificate& c = certificates_[id.value];
  // The corners of a vanished triangle survive in the face across: same half-edge, same vertices, opposite sign.
  if (c.u == at.u && c.v == at.v && c.w == at.w && !now.concerns(at.u, at.v, at.w)) return {};
  c.u = at.u;
  c.v = at.v;
  c.w = at.w;
  return id;
}

namespace {

/// Moves a certificate to the position of its bound in the queue, even if the search for the bound is interrupted.
class Requeue {
 public:
  Requeue(EventQueue& queue, CertificateId id) : queue_(queue), id_(id) {}
  ~Requeue() { queue_.update(id_); }
  Requeue(const Requeue&) = delete;
  Requeue& operator=(const Requeue&) = delete;

 private:
  EventQueue& queue_;
  CertificateId id_;
};

}  // namespace

/// Ensures that the earliest failure up to `limit` is isolated and certainly the earliest, and stores it in next_.
bool Engine::find_next(double limit) {
  while (!queue_.empty()) {
    checkpoint(work_of_evaluation);
    const CertificateId top = queue_.top();
    Certificate& c = certificates_[top.value];
    if (c.lo > limit) return false;
    if (c.kind != RootKind::isolated) {
      const Requeue requeue(queue_, top);
      solver_.advance(c);
      continue;
    }
    if (!certainly_first(top)) continue;
    if (c.hi > limit && !solver_.fails_by(c, limit)) return false;
    next_ = top;
    return true;
  }
  return false;
}

/// Is the isolated certificate at the head of the queue certainly the earliest failure? If another one might still come
/// before it, that one is moved or enclosed more tightly, and the result is false: the caller must test again.
bool Engine::certainly_first(CertificateId head) {
  Certificate& first = certificates_[head.value];
  CertificateId rival;
  queue_.visit_rivals(first.hi, [&](CertificateId id) {
    const Certificate& c = certificates_[id.value];
    // The queue is ordered by exact lower bounds. If a certificate comes later than the head, so do all that follow it.
    if (solver_.known_before(first, c)) return EventQueue::Visit::past;
    const auto in = [&first](VertexId x) { return x == first.u || x == first.v || x == first.w; };
    const bool same = in(c.u) && in(c.v) && in(c.w);  // the same failure, seen at another corner
    if (c.kind == RootKind::isolated && same) return EventQueue::Visit::on;
    rival = id;
    return EventQueue::Visit::stop;
  });
  if (!rival.valid()) return true;
  Certificate& c = certificates_[rival.value];
  const Requeue requeue(queue_, rival);
  if (c.kind != RootKind::isolated) {
    solver_.advance(c);
  } else {
    const Requeue requeue_head(queue_, head);
    solver_.separate(first, c);
  }
  return false;
}

std::optional<std::pair<double, double>> Engine::next_event(double t) {
  while (state_ == EngineState::running) {
    const bool last = current_ + 1 == segments_.size();
    const double limit = segment().bridge ? segment().end : std::min(t, segment().end);
    if (find_next(std::min(limit, dormant_.until()))) {
      const Certificate& c = certificates_[next_.value];
      return std::pair<double, double>(segment().time(c.lo), segment().time(c.hi));
    }
    if (dormant_.until() < limit) {
      check_dormant(dormant_.until(), false);
      continue;
    }
    if (!segment().bridge && segment().end > t) return std::nullopt;
    if (last) return std::nullopt;
    dormant_.note_motion(segment(), segment().end);
    segment().forget();
    ++current_;
    enter_segment();
  }
  return std::nullopt;
}

bool Engine::step(double t) {
  if (state_ != EngineState::running) return false;
  if (next_event(t)) {
    checkpoint(TaylorModelCache::is_straight(segment()) ? work_of_event_on_lines : work_of_event);
    process(next_, segment().bridge ? segment().end : std::min(t, segment().end));
    return state_ != EngineState::contact;
  }
  parameter_ = segment().bridge ? segment().end : std::max(parameter_, std::min(t, segment().end));
  reached_ = parameter_;
  // Not where an event has led the engine beyond t: another one may be yet to come.
  const bool at_end = current_ + 1 == segments_.size() && (segment().bridge || t >= segment().end);
  if (at_end && parameter_ >= segment().end) state_ = EngineState::finished;
  return false;
}

double Engine::proved_until() const {
  if (state_ != EngineState::running) return time();
  const double dormant_until = std::min(dormant_.until(), segment().end);
  const double first = queue_.empty() ? dormant_until : std::min(certificates_[queue_.top().value].lo, dormant_until);
  return segment().time(std::max(first, reached_));
}

/// A bridge at that time has not begun as long as its parameter is 0.
bool Engine::can_replan_at(double t) const {
  if (state_ == EngineState::overlap) return false;
  const double processed = contact_ ? before_contact_ : parameter_;
  if (segment().bridge) return segment().joint == t && processed == 0 && !contact_;
  return segment().start <= t && processed <= t && t <= (contact_ ? contact_->lo : segment().end);
}

void Engine::replan(MotionSegments segments) {
  if (!segment().bridge) parameter_ = segments.place(0).start;
  contact_.reset();
  dormant_.note_motion(segment(), parameter_);
  segments_ = std::move(segments);
  current_ = 0;
  state_ = EngineState::running;
  reserve_for_segments();
  enter_segment();
}

void Engine::reserve_for_segments() {
  if (!segments_.straight()) solver_.reserve_cells();
}

void Engine::enter_segment() {
  segment_ = segments_.hold(current_);
  parameter_ = reached_ = segment().start;
  queue_.clear();
  solver_.enter(segment());
  dormant_.begin_segment();
  check_dormant(segment().start, true);
}

/// Ensures that every certificate is dormant or scheduled from t on. `all_due`: none is scheduled yet; otherwise those
/// that were not dormant already are.
void Engine::check_dormant(double t, bool all_due) {
  using Due = DormantCertificates::Due;
  const Due due = dormant_.evaluate(segment(), t, active_, all_due);
  if (due == Due::nothing) return;
  const std::vector<CertificateId>& open = dormant_.open();
  const bool those_open = due == Due::those_open;
  const std::size_t count = those_open ? open.size() : certificates_.size();
  for (std::size_t i = 0; i < count; ++i) {
    const CertificateId id = those_open ? open[i] : CertificateId(i);
    Certificate& c = certificates_[id.value];
    if (!c.corner.valid()) continue;
    if (those_open || (!dormant_.is_dormant(id) && (all_due || dormant_.was_dormant(id)))) {
      // A line costs half of that.
      checkpoint(TaylorModelCache::is_straight(segment()) ? i % 2 * work_of_evaluation : work_of_evaluation);
      schedule(id, t);
    } else if (dormant_.is_dormant(id)) {
      queue_.remove(id);
      solver_.rest(c);
    }
  }
}

void Engine::schedule(CertificateId id, double t) {
  solver_.start(certificates_[id.value], t);
  queue_.update(id);
}

/// The corner of the failed face to which the rule for convex corners applies. If the face is a triangle, all three of
/// its corners fail at once, and the rule requires one whose vertex is not the middle one.
HalfedgeId Engine::closing_corner(const Certificate& c, Now& now, VertexId& middle, bool& three) {
  middle = solver_.middle(c.u, c.v, c.w, now);
  const HalfedgeId h = c.corner, n = map_.next(h);
  three = map_.next(map_.next(n)) == h;
  if (middle != c.v) return h;
  if (!three) throw StructureError("a convex corner opened to a straight angle");
  return n;
}

/// Changes nothing until everything on which the repair depends is known.
void Engine::process(CertificateId id, double limit) {
  Certificate& c = certificates_[id.value];
  Now now = solver_.event(c);
  EngineEvent event{now.lo, now.hi, &segment(), current_, c.u, c.v, c.w, c.corner, {}, false, map_.node(c.corner)};
  reached_ = now.lo;
  if (c.sign > 0) {
    VertexId middle;
    event.corner = closing_corner(c, now, middle, event.three_corners);
    event.report = repair_convex(map_, event.corner, middle);
  } else {
    event.report = repair_reflex(map_, c.corner);
  }
  const RepairReport& report = event.report;
  const bool collides = report.repair == Repair::collision;
  before_contact_ = parameter_;
  if (collides) solver_.tighten(c);
  ++events_;
  // Enclosures of events that nearly coincide overlap, but time must not go back. Nor may it pass the limit: the
  // failure is known to occur by then, although its enclosure may extend further.
  parameter_ = std::max(parameter_, collides ? c.lo : std::min(now.hi, limit));
  if (collides) {
    contact_ = FoundContact{report.hitting, map_.origin(report.hit), c.lo, c.hi};
    if (const auto known = solver_.known_precisely(c)) contact_->at = std::make_shared<const PreciseTime>(*known);
    state_ = EngineState::contact;
    if (observer_) observer_->on_event(event);
    return;
  }
  start_corners(report, now);
  max_active_ = std::max(max_active_, active_);
  if (observer_) observer_->on_event(event);
}

/// Starts the certificates of the corners that a repair may have changed.
void Engine::start_corners(const RepairReport& report, Now& now) {
  if (report.removed.valid()) {
    drop_corner(report.removed);
    drop_corner(PlanarMap::twin(report.removed));
  }
  std::array<CertificateId, 6> fresh;
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < report.corner_count; ++i) {
    const CertificateId id = certificate_to_start(report.corners[i], now);
    if (id.valid()) fresh[count++] = id;
  }
  for (std::size_t k = 0; k < count; ++k) {
    solver_.start_at(certificates_[fresh[k].value], now);
    dormant_.wake(fresh[k]);
    queue_.update(fresh[k]);
  }
}

std::size_t Engine::bytes() const {
  return geometry_.bytes() + map_.bytes() + certificates_.capacity() * sizeof(Certificate) + dormant_.bytes() +
         free_.capacity() * 4 + certificate_of_.bytes() + queue_.bytes() + solver_.bytes();
}

}  // namespace taut::internal
