#include "motion/motion_segments.hpp"

#include <algorithm>
#include <cmath>

#include "motion/far_pieces.hpp"
#include "motion/local_time.hpp"
#include "motion/pieces.hpp"

namespace taut::internal {
namespace {

/// From this many segments on, unused capacity is released.
constexpr std::size_t many_segments = 256;

}  // namespace

/// Two chains of motions, and the numbers of their pieces in each interval between joints.
struct MotionSegments::Route {
  MotionChain p, q;
  std::vector<SegmentPlace> places;
  /// For each interval, the number of the piece that each motion follows, P's motions first.
  std::vector<std::uint32_t> followed;

  std::size_t motions() const { return p.size() + q.size(); }
  const PieceList& motion(std::size_t k) const { return k < p.size() ? p[k] : q[k - p.size()]; }
  void lay(double start, double end);

  PieceChain pieces(bool of_p, std::size_t stretch) const {
    const MotionChain& chain = of_p ? p : q;
    const std::uint32_t* numbers = &followed[stretch * motions() + (of_p ? 0 : p.size())];
    PieceChain all;
    all.reserve(chain.size());
    for (std::size_t k = 0; k < chain.size(); ++k) all.push_back(chain[k][numbers[k]]);
    return all;
  }
  /// Is the interval so far from time 0 that polynomials are expanded about one of its instants?
  static bool far(const PieceChain& p, const PieceChain& q, const SegmentPlace& at) {
    return is_far_for(p, at.start, at.end) || is_far_for(q, at.start, at.end);
  }
  MotionSegment make(std::size_t k) const {
    const SegmentPlace& at = places[k];
    if (!at.bridge && p.size() == 1 && q.size() == 1) {
      const std::uint32_t* numbers = &followed[at.stretch * 2];
      return MotionSegment::motion(p[0][numbers[0]], q[0][numbers[1]], at.start, at.end);
    }
    const PieceChain of_p = pieces(true, at.stretch), of_q = pieces(false, at.stretch);
    if (!at.bridge) return MotionSegment::motion_of_chains(of_p, of_q, at.start, at.end);
    const bool plain = p.size() == 1 && q.size() == 1;
    const PieceChain next_p = pieces(true, at.stretch + 1), next_q = pieces(false, at.stretch + 1);
    const bool is_far = far(of_p, of_q, places[k - 1]) || far(next_p, next_q, places[k + 1]);
    return plain ? MotionSegment::bridging(of_p[0], of_q[0], next_p[0], next_q[0], at.start, is_far)
                 : MotionSegment::bridging_chains(of_p, of_q, next_p, next_q, at.start, is_far);
  }
};

void MotionSegments::Route::lay(double start, double end) {
  std::vector<std::uint32_t> at(motions());
  const auto advance = [&](double t) {
    for (std::size_t k = 0; k < at.size(); ++k) {
      while (motion(k).until(at[k]) <= t) ++at[k];
    }
  };
  for (std::size_t k = 0; k < at.size(); ++k) at[k] = static_cast<std::uint32_t>(motion(k).number_at(start));
  std::vector<std::uint32_t> before;
  std::uint32_t stretch = 0;
  for (double t = start;; ++stretch) {
    double until = end;
    for (std::size_t k = 0; k < at.size(); ++k) until = std::min(until, motion(k).until(at[k]));
    followed.insert(followed.end(), at.begin(), at.end());
    places.push_back({t, until, false, stretch});
    if (until >= end) break;
    t = until;
    before = at;
    advance(t);
    bool changes = false;
    for (std::size_t k = 0; k < at.size(); ++k) changes = changes || !motion(k).same_at(before[k], at[k]);
    if (changes) places.push_back({t, t, true, stretch});
  }
  if (places.size() < many_segments) return;
  places.shrink_to_fit();
  followed.shrink_to_fit();
}

MotionSegments::MotionSegments(MotionSegment segment)
    : only_(std::make_shared<const MotionSegment>(std::move(segment))) {}

MotionSegments::MotionSegments(MotionChain p, MotionChain q, double start, double end) {
  const auto route = std::make_shared<Route>();
  route->p = std::move(p);
  route->q = std::move(q);
  route->lay(start, end);
  route_ = route;
}

std::size_t MotionSegments::route_size() const { return route_ ? route_->places.size() : 0; }

void MotionSegments::drop_first() {
  ++dropped_;
  window_.clear();
  held_.clear();
}

MotionSegments MotionSegments::exchanged() const {
  MotionSegments other(route_->q, route_->p, route_->places.front().start, route_->places.back().end);
  other.dropped_ = dropped_;
  return other;
}

SegmentPlace MotionSegments::place(std::size_t k) const {
  if (route_) return route_->places[dropped_ + k];
  return {only_->time(only_->start), only_->time(only_->end), only_->bridge, 0};
}

double MotionSegments::repeats_from() const {
  if (!route_) return INFINITY;
  return internal::repeats_from(route_->p, route_->q, route_->places.front().start, route_->places.back().end);
}

std::size_t MotionSegments::first_until(double t) const {
  std::size_t first = 0, last = size();
  while (first < last) {
    const std::size_t middle = first + (last - first) / 2;
    if (place(middle).end < t) {
      first = middle + 1;
    } else {
      last = middle;
    }
  }
  return first;
}

bool MotionSegments::straight() const {
  const MotionSegment& segment = front();
  return size() == 1 && segment.translation && segment.degree <= 1 && !segment.bridge;
}

void MotionSegments::give_back() const {
  for (const Kept& place : window_) {
    if (place.segment && place.segment.use_count() > 1) held_.emplace_back(place.number, place.segment);
  }
  window_ = std::vector<Kept>();
  // What a weak pointer points at is destroyed with the last owner, but its memory stays.
  std::erase_if(held_, [](const auto& known) { return known.second.expired(); });
}

const std::shared_ptr<const MotionSegment>& MotionSegments::kept(std::size_t k) const {
  if (only_) return only_;
  if (window_.empty()) window_.resize(std::min(window, size()));
  Kept& place = window_[k % window_.size()];
  if (place.number != k) replace(place, k);
  return place.segment;
}

void MotionSegments::replace(Kept& place, std::size_t k) const {
  if (place.segment && place.segment.use_count() > 1) held_.emplace_back(place.number, place.segment);
  place.segment.reset();
  place.number = k;
  for (std::size_t i = held_.size(); i-- > 0;) {
    std::shared_ptr<const MotionSegment> segment = held_[i].second.lock();
    const bool wanted = held_[i].first == k;
    if (segment && !wanted) continue;
    if (segment) place.segment = std::move(segment);
    held_.erase(held_.begin() + static_cast<std::ptrdiff_t>(i));
  }
  if (!place.segment) place.segment = std::make_shared<const MotionSegment>(route_->make(dropped_ + k));
}

}  // namespace taut::internal
