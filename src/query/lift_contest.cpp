#include "query/lift_contest.hpp"

#include <algorithm>
#include <cmath>

namespace taut::internal {

LiftContest::LiftContest(const std::vector<LiftCouple>& couples, const Point& u, double reach, Touch touch)
    : couples_(couples),
      reach_(reach),
      touch_(touch),
      identities_(couples, u),
      window_(couples, u),
      precise_(couples, u) {}

/// The cam's upper side runs with w, the follower's lower side against it.
bool LiftContest::never_faces(std::uint32_t couple, bool of_follower, std::uint32_t edge) const {
  const std::optional<int> way = identities_.side_of_neighbour(couple, of_follower, edge, true);
  return way && (of_follower ? *way >= 0 : *way <= 0);
}

bool LiftContest::is_away(std::uint32_t couple, bool of_follower, std::uint32_t vertex) const {
  const LiftCouple::Outline& outline = of_follower ? couples_[couple].follower : couples_[couple].cam;
  return never_faces(couple, of_follower, vertex) && never_faces(couple, of_follower, outline.previous(vertex));
}

LiftVerdict LiftContest::decide(const TimeInterval& time, const std::vector<LiftPair>& candidates) {
  LiftVerdict verdict = decide_by(window_, time, candidates);
  return verdict.hopeless ? decide_by(precise_, time, verdict.pairs) : verdict;
}

template <class Real>
LiftVerdict LiftContest::decide_by(LiftWindow<Real>& window, const TimeInterval& time,
                                   const std::vector<LiftPair>& candidates) {
  window.set(time.lo, time.hi);
  std::vector<Contestant<Real>> all;
  // What is lower than some pair certainly is, or than the floor, is out.
  double least = 0;
  for (const LiftPair& pair : candidates) {
    const Over over_edge = over(window, pair);
    if (over_edge == Over::no) continue;
    const WindowJet<Real> lift = window.lift(pair);
    const LiftRange range = window.lifts(pair, lift);
    if (range.lo > reach_ || range.hi < least) continue;
    if (over_edge == Over::yes && range.hi < reach_) least = std::max(least, range.lo);
    all.push_back({pair, over_edge, lift, range});
  }
  std::erase_if(all, [least](const auto& c) { return c.range.hi < least; });
  LiftVerdict verdict;
  if (all.empty()) return {FollowState::low, {0, 0}};
  verdict.lift = {least, 0};
  for (const auto& c : all) verdict.lift.hi = std::max(verdict.lift.hi, std::min(reach_, c.range.hi));
  const Contestant<Real>* leader = nullptr;
  for (const auto& c : all) {
    if (c.over != Over::yes || !(c.range.hi < reach_) || !std::isfinite(c.lift.middle.v.rad)) continue;
    if (!leader || c.lift.middle.v.mid > leader->lift.middle.v.mid) leader = &c;
  }
  if (!leader) {
    verdict.hopeless = true;
    for (const auto& c : all) {
      verdict.pairs.push_back(c.pair);
      verdict.hopeless = verdict.hopeless && c.over == Over::never_known;
    }
    return verdict;
  }
  // Not 0 or more for certain, unless it is 0 at all times.
  const bool vanishes = !(leader->range.lo > 0) && leader->lift.vanishes_in_middle();
  bool decided = leader->range.lo > 0 || (vanishes && identities_.zero(leader->pair));
  verdict.hopeless = vanishes && !decided;
  for (const auto& c : all) {
    if (&c == leader) {
      verdict.pairs.push_back(c.pair);
    } else if (challenges(*leader, c, window.radius(), verdict)) {
      decided = false;
    }
  }
  if (!decided) return verdict;
  verdict.state = FollowState::carried;
  verdict.lift = {std::max(least, leader->range.lo), leader->range.hi};
  return verdict;
}

template <class Real>
bool LiftContest::challenges(const Contestant<Real>& leader, const Contestant<Real>& other, double radius,
                             LiftVerdict& verdict) {
  const WindowJet<Real> ahead = leader.lift - other.lift;
  if (leader.range.lo > other.range.hi || ahead.range(radius).lo > 0) return false;
  verdict.pairs.push_back(other.pair);
  if (!ahead.vanishes_in_middle()) return true;
  const bool same = identities_.same(leader.pair, other.pair);
  if (same && other.over == Over::yes) return false;
  if (!same || other.over == Over::never_known) verdict.hopeless = true;
  return true;
}

template <class Real>
auto LiftContest::over(LiftWindow<Real>& window, const LiftPair& pair) -> Over {
  Over all = Over::yes;
  for (const int end : {0, 1}) {
    const WindowJet<Real> distance = window.from_end(pair, end);
    const LiftRange range = distance.range(window.radius());
    if (range.hi < 0) return Over::no;
    if (range.lo > 0) continue;
    Over here = Over::maybe;
    if (distance.vanishes_in_middle()) {
      const bool level = identities_.level(ends_of(couples_, pair)[static_cast<std::size_t>(end)]);
      here = level ? over_level_end(window, pair, end) : Over::never_known;
    }
    if (here == Over::no) return here;
    all = std::min(all, here);
  }
  return all;
}

/// The vertex is always at this end of the edge. Bodies whose interiors meet below are on the same side of it.
template <class Real>
auto LiftContest::over_level_end(LiftWindow<Real>& window, const LiftPair& pair, int end) -> Over {
  if (touch_ == Touch::closed) return Over::yes;
  // Towards the edge, w grows from its first end: see never_faces().
  const bool grows = end == 0, next = grows != pair.of_follower;
  const std::optional<int> side = identities_.side_of_neighbour(pair.couple, pair.of_follower, pair.vertex, next);
  if (side) return *side == (grows ? 1 : -1) ? Over::yes : Over::no;
  const LiftRange way = window.to_neighbour(pair.couple, pair.of_follower, pair.vertex, next).range(window.radius());
  if (grows ? way.lo > 0 : way.hi < 0) return Over::yes;
  return (grows ? way.hi < 0 : way.lo > 0) ? Over::no : Over::maybe;
}

bool LiftContest::same_vertices(const VertexCouple& a, const VertexCouple& b) const {
  const auto same = [](const LiftCouple::Outline& p, std::uint32_t i, const LiftCouple::Outline& q, std::uint32_t k) {
    return p.point(i).x == q.point(k).x && p.point(i).y == q.point(k).y;
  };
  const LiftCouple &first = couples_[a.couple], &second = couples_[b.couple];
  return (a.couple == b.couple || (first.cam.rings == second.cam.rings)) &&
         same(first.follower, a.follower, second.follower, b.follower) && same(first.cam, a.cam, second.cam, b.cam);
}

/// Nothing where that instant is not the border that others have, or is not passed once.
auto LiftContest::changing(const LiftPair& pair, std::optional<VertexCouple>& border) -> std::optional<Changing> {
  const WindowJet<double> lift = window_.lift(pair);
  Changing result{pair, lift, window_.lifts(pair, lift)};
  for (const int end : {0, 1}) {
    const WindowJet<double> distance = window_.from_end(pair, end);
    if (distance.range(window_.radius()).lo > 0) continue;
    const VertexCouple here = ends_of(couples_, pair)[static_cast<std::size_t>(end)];
    if (identities_.level(here) && over_level_end(window_, pair, end) == Over::yes) continue;
    const LiftRange slopes = distance.slopes(window_.radius());
    const int comes = slopes.lo > 0 ? 1 : slopes.hi < 0 ? -1 : 0;
    if (comes == 0 || result.comes != 0 || (border && !same_vertices(*border, here))) return std::nullopt;
    border = here;
    result.comes = comes;
  }
  return result;
}

/// Is the first of the leaders, or 0 if there are none, above all others on that side of the change? At the change, all
/// that come or go have the same lift, that of the two vertices. So the slopes of their differences say what is above
/// there.
bool LiftContest::leads(const std::vector<LiftPair>& leaders, const std::vector<Changing>& all, bool after) {
  const int other_side = after ? -1 : 1;
  const auto is_leader = [&](const Changing& c) {
    return std::find(leaders.begin(), leaders.end(), c.pair) != leaders.end();
  };
  const auto first = std::find_if(all.begin(), all.end(), is_leader);
  if (first != all.end() && !(first->range.lo > 0) && !identities_.zero(first->pair)) return false;
  for (const Changing& c : all) {
    if (is_leader(c)) {
      if (c.comes == other_side) return false;
      continue;
    }
    if (c.comes == other_side) continue;
    if (first == all.end()) {
      if (!(c.range.hi < 0)) return false;
      continue;
    }
    const WindowJet<double> ahead = first->lift - c.lift;
    if (first->comes != 0 && c.comes != 0) {
      const LiftRange slopes = ahead.slopes(window_.radius());
      if (!(after ? slopes.lo > 0 : slopes.hi < 0)) return false;
    } else if (!(first->range.lo > c.range.hi || ahead.range(window_.radius()).lo > 0)) {
      return false;
    }
  }
  return true;
}

LiftChange LiftContest::change(const TimeInterval& time, const std::vector<LiftPair>& before,
                               const std::vector<LiftPair>& among, const std::vector<LiftPair>& after) {
  if (before == after) return {};
  std::vector<LiftPair> pairs;
  for (const auto* some : {&before, &among, &after}) pairs.insert(pairs.end(), some->begin(), some->end());
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  window_.set(time.lo, time.hi);
  std::optional<VertexCouple> border;
  std::vector<Changing> all;
  for (const LiftPair& pair : pairs) {
    const auto one = changing(pair, border);
    if (!one || !(one->range.hi < reach_)) return {};
    all.push_back(*one);
  }
  LiftChange change;
  if (border) {
    change.once = leads(before, all, false) && leads(after, all, true);
  } else {
    change.once = pairs.size() <= before.size() + after.size() && pass(before, after);
  }
  if (!change.once) return change;
  const LiftRange first = range_of(before, all), second = range_of(after, all);
  change.jumps = first.lo > second.hi || first.hi < second.lo;
  return change;
}

/// Where nothing comes or goes: does what was below rise above what was above, at one instant?
bool LiftContest::pass(const std::vector<LiftPair>& before, const std::vector<LiftPair>& after) {
  const WindowJet<double> none = WindowJet<double>::constant(Ball<double>::exact(0));
  const WindowJet<double> a = before.empty() ? none : window_.lift(before[0]);
  const WindowJet<double> b = after.empty() ? none : window_.lift(after[0]);
  return (a - b).slopes(window_.radius()).hi < 0;
}

LiftRange LiftContest::range_of(const std::vector<LiftPair>& some, const std::vector<Changing>& all) {
  if (some.empty()) return {0, 0};
  LiftRange range{INFINITY, -INFINITY};
  for (const Changing& c : all) {
    if (std::find(some.begin(), some.end(), c.pair) == some.end()) continue;
    range = {std::min(range.lo, c.range.lo), std::max(range.hi, c.range.hi)};
  }
  return range;
}

}  // namespace taut::internal
