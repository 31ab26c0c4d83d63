#include "recording.hpp"

#include <chrono>

namespace taut::web {

namespace {

/// Kind, body and depth of a face in one number.
std::int32_t face_code(const TilingHalfedge& h) { return static_cast<std::int32_t>(h.kind) + 4 * h.body + 8 * h.depth; }

void append(std::vector<std::int32_t>& out, const TilingHalfedge& h) {
  out.insert(out.end(), {h.origin, h.next, face_code(h)});
}

double now_milliseconds() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Recording::Recording(const Scene& scene, Touch touch) : scene_(scene), touch_(touch), simulation_(scene, touch, this) {
  if (simulation_.state() == SimulationState::undecided) throw UndecidedError(simulation_.reason());
  if (simulation_.state() == SimulationState::overlap_at_start) return;
  initial_ = simulation_.certificates();
  map_ = simulation_.halfedges();
  for (const TilingHalfedge& h : map_) append(start_, h);
  for (const TilingVertex& v : simulation_.tiling().vertices)
    vertices_.insert(vertices_.end(), {v.vertex.body, v.vertex.index});
}

bool Recording::advance(double until, double milliseconds) {
  const double stop = now_milliseconds() + milliseconds;
  while (simulation_.state() == SimulationState::running) {
    const auto next = simulation_.next_event();
    if (!next || next->lo > until) {
      simulation_.advance_to(until);
      return true;
    }
    simulation_.step();
    if (now_milliseconds() > stop) return simulation_.state() != SimulationState::running;
  }
  return true;
}

void Recording::change_plan(const Scene& edited, int body) {
  simulation_.set_motion(body, edited.bodies.at(static_cast<std::size_t>(body)).motion);
  scene_ = edited;
}

Answer Recording::answer() const {
  Answer answer;
  answer.engine = EngineName::kinetic;
  answer.coverage = simulation_.coverage();
  answer.pair = simulation_.pair();
  answer.contact = simulation_.contact();
  answer.events = simulation_.events();
  answer.free_until = simulation_.time();
  if (answer.contact) {
    answer.outcome = Outcome::contact;
    answer.free_until = answer.contact->time.lo;
  } else if (simulation_.state() == SimulationState::undecided) {
    answer.reason = simulation_.reason();
    return answer;
  } else if (simulation_.state() == SimulationState::overlap_at_start) {
    answer.outcome = Outcome::overlap_at_start;
    answer.overlap_point = simulation_.overlap_point();
    return answer;
  } else if (simulation_.state() == SimulationState::finished) {
    answer.outcome = Outcome::free;
  } else if (simulation_.state() == SimulationState::locked) {
    answer.outcome = Outcome::locked;
  } else {
    answer.reason = "still running";
  }
  answer.certificates_initial = initial_;
  answer.certificates_max = simulation_.certificates_max();
  return answer;
}

void Recording::on_event(const TraceEvent& event) {
  const auto begin = static_cast<std::int32_t>(changes_.size() / change_ints);
  for (const int h : simulation_.changed_halfedges()) {
    const auto i = static_cast<std::size_t>(h);
    if (i >= map_.size()) map_.resize((i | 1u) + 1);
    const TilingHalfedge after = simulation_.halfedge(h);
    if (after == map_[i]) continue;
    changes_.push_back(h);
    append(changes_, map_[i]);
    append(changes_, after);
    map_[i] = after;
  }
  const auto end = static_cast<std::int32_t>(changes_.size() / change_ints);
  const int flags = (event.bridging ? 1 : 0) | (event.pinch_rule ? 2 : 0) | (event.three_corners ? 4 : 0);
  events_.insert(events_.end(),
                 {begin, end, static_cast<std::int32_t>(event.repair), flags, event.u.body, event.u.index, event.v.body,
                  event.v.index, event.w.body, event.w.index, static_cast<std::int32_t>(event.certificates)});
  times_.insert(times_.end(), {event.lo, event.hi});
}

}  // namespace taut::web
