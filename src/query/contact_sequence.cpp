#include "query/contact_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "query/lift_contest.hpp"

namespace taut::internal {
namespace {

/// What is known of a window of time, in the terms of the pairs.
struct Piece {
  TimeInterval time;
  FollowState state;
  LiftRange lift;
  std::vector<LiftPair> pairs = {};  ///< in order
  bool hopeless = false;             ///< of `open`: shorter windows would not be decided either
};

constexpr const char* no_precision = "320 bits do not distinguish the lifts of contacts there";
constexpr const char* hardly_longer =
    "what touches there is not decided for hardly longer than the tolerance: a smaller one may decide it, a larger one "
    "takes it for a change";

class SequenceSearch {
 public:
  SequenceSearch(const Instance& instance, const SequenceQuestion& question)
      : instance_(instance), question_(question), length_(length(question.direction.x, question.direction.y)) {
    for (const int f : instance.sections(question.follower)) {
      for (int c = 0; c < static_cast<int>(instance.bodies().size()); ++c) {
        const auto& cam = instance.bodies()[static_cast<std::size_t>(c)];
        if (cam.body != question.follower && !instance.excluded(f, c))
          couples_.emplace_back(instance, f, c, offset_for(question.touch));
      }
    }
  }

  std::vector<FollowStretch> run(std::string& reason) {
    const std::string stopped = what_stops([&] { search_all(); });
    if (!stopped.empty()) {
      hand_out();
      const double known = stretches_.empty() ? instance_.start() : stretches_.back().time.hi;
      if (known < instance_.end()) append({FollowState::open, {known, instance_.end()}, {0, question_.reach}, {}});
    }
    name_short_changes();
    const auto first = std::find_if(stretches_.begin(), stretches_.end(),
                                    [](const FollowStretch& s) { return s.state == FollowState::open; });
    const auto number = static_cast<std::size_t>(first - stretches_.begin());
    if (first != stretches_.end())
      reason = !stopped.empty() ? stopped : hopeless_[number] ? no_precision : hardly_longer;
    return std::move(stretches_);
  }

 private:
  void search_all() {
    const double reach = std::ldexp(question_.reach * length_, instance_.exponent());
    contest_.emplace(couples_, question_.direction, reach, question_.touch);
    const std::vector<double> joints = joints_of_all();
    for (std::size_t k = 0; k + 1 < joints.size(); ++k) {
      report_parts("motions", k, joints.size() - 1);
      take_segments(joints[k], joints[k + 1]);
      contest_->begin();
      search({joints[k], joints[k + 1]}, all_pairs(), 0);
      hand_out();
    }
  }

  /// A bound of a lift in units of the scene, from 0 to the reach; `outwards` is 1 but for roundings.
  double in_units(double lift, double outwards) const {
    const double length = lift / std::ldexp(length_, instance_.exponent());
    return std::clamp(length * outwards, 0.0, question_.reach);
  }

  std::vector<double> joints_of_all() const {
    std::vector<double> all{instance_.start(), instance_.end()};
    for (const LiftCouple& couple : couples_) {
      for (std::size_t k = 0; k < couple.segments.size(); ++k) all.push_back(couple.segments.place(k).start);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    std::erase_if(all, [&](double t) { return t < instance_.start() || t > instance_.end(); });
    return all;
  }

  /// Of each couple, the segment that has this interval.
  void take_segments(double from, double to) {
    for (LiftCouple& couple : couples_) {
      std::size_t k = couple.segments.first_until(to);
      while (k + 1 < couple.segments.size() &&
             (couple.segments.place(k).bridge || couple.segments.place(k).end <= from))
        ++k;
      while (k > 0 && (couple.segments.place(k).bridge || couple.segments.place(k).start > from)) --k;
      couple.segment = couple.segments.hold(k);
    }
  }

  /// All that may ever be contacts.
  std::vector<LiftPair> all_pairs() const {
    std::vector<LiftPair> all;
    for (std::uint32_t c = 0; c < couples_.size(); ++c) {
      for (const bool of_follower : {true, false}) {
        const LiftCouple::Outline& vertices = of_follower ? couples_[c].follower : couples_[c].cam;
        const LiftCouple::Outline& edges = of_follower ? couples_[c].cam : couples_[c].follower;
        std::vector<std::uint32_t> facing;
        for (std::uint32_t v = 0; v < vertices.size(); ++v) {
          if (!contest_->is_away(c, of_follower, v)) facing.push_back(v);
        }
        for (std::uint32_t e = 0; e < edges.size(); ++e) {
          checkpoint();
          if (contest_->never_faces(c, !of_follower, e)) continue;
          for (const std::uint32_t v : facing) all.push_back({c, of_follower, v, e});
        }
      }
    }
    return all;
  }

  void search(const TimeInterval& time, const std::vector<LiftPair>& candidates, int depth) {
    checkpoint();
    LiftVerdict verdict = contest_->decide(time, candidates);
    const double middle = time.lo + (time.hi - time.lo) / 2;
    if (verdict.state != FollowState::open) return add({time, verdict.state, verdict.lift, std::move(verdict.pairs)});
    const bool divisible = time.lo < middle && middle < time.hi && depth < 64;
    const bool hopeless = !divisible || verdict.hopeless;
    if (hopeless || time.hi - time.lo <= question_.shortest / 4)
      return add({time, FollowState::open, verdict.lift, std::move(verdict.pairs), hopeless});
    search({time.lo, middle}, verdict.pairs, depth + 1);
    search({middle, time.hi}, verdict.pairs, depth + 1);
  }

  void add(Piece&& piece) {
    std::sort(piece.pairs.begin(), piece.pairs.end());
    if (!pieces_.empty() && pieces_.back().state == piece.state &&
        (piece.state == FollowState::open || pieces_.back().pairs == piece.pairs)) {
      Piece& last = pieces_.back();
      last.time.hi = piece.time.hi;
      last.hopeless = last.hopeless || piece.hopeless;
      last.lift = {std::min(last.lift.lo, piece.lift.lo), std::max(last.lift.hi, piece.lift.hi)};
      last.pairs.insert(last.pairs.end(), piece.pairs.begin(), piece.pairs.end());
      std::sort(last.pairs.begin(), last.pairs.end());
      last.pairs.erase(std::unique(last.pairs.begin(), last.pairs.end()), last.pairs.end());
      return;
    }
    pieces_.push_back(std::move(piece));
  }

  /// The pieces between two joints, as stretches.
  void hand_out() {
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      const Piece& piece = pieces_[k];
      FollowStretch stretch = in_scene(piece);
      if (piece.state == FollowState::open && k > 0 && k + 1 < pieces_.size()) {
        const LiftChange change = contest_->change(piece.time, pieces_[k - 1].pairs, piece.pairs, pieces_[k + 1].pairs);
        stretch.once = change.once;
        stretch.jumps = change.jumps;
      }
      append(std::move(stretch), piece.hopeless);
    }
    pieces_.clear();
  }

  FollowStretch in_scene(const Piece& piece) const {
    FollowStretch stretch{piece.state, piece.time, {0, 0}, {}};
    if (piece.state != FollowState::low)
      stretch.lift = {in_units(piece.lift.lo, 1 - 0x1p-49), in_units(piece.lift.hi, 1 + 0x1p-49)};
    for (const LiftPair& pair : piece.pairs) {
      const LiftCouple& couple = couples_[pair.couple];
      const RingSet &own = *couple.follower.rings, &other = *couple.cam.rings;
      stretch.contacts.push_back(
          {(pair.of_follower ? own : other).vertex(pair.vertex), (pair.of_follower ? other : own).edge(pair.edge)});
    }
    return stretch;
  }

  /// After a joint, what is known may be the same as before. Contacts that differ there change at that instant.
  void append(FollowStretch&& stretch, bool hopeless = false) {
    if (stretches_.empty()) return add_stretch(std::move(stretch), hopeless);
    FollowStretch& last = stretches_.back();
    const bool both_open = last.state == FollowState::open && stretch.state == FollowState::open;
    if (both_open || (last.state == stretch.state && last.contacts == stretch.contacts)) {
      last.time.hi = stretch.time.hi;
      last.lift = {std::min(last.lift[0], stretch.lift[0]), std::max(last.lift[1], stretch.lift[1])};
      last.once = last.jumps = false;
      hopeless_.back() = hopeless_.back() || hopeless;
      for (const FollowContact& contact : stretch.contacts) add_contact(last, contact);
      return;
    }
    if (last.state != FollowState::open && stretch.state != FollowState::open) {
      FollowStretch change{FollowState::change, {last.time.hi, last.time.hi}, {}, {}};
      change.lift = {std::min(last.lift[0], stretch.lift[0]), std::max(last.lift[1], stretch.lift[1])};
      for (const FollowContact& contact : last.contacts) add_contact(change, contact);
      for (const FollowContact& contact : stretch.contacts) add_contact(change, contact);
      add_stretch(std::move(change), false);
    }
    add_stretch(std::move(stretch), hopeless);
  }
  void add_stretch(FollowStretch&& stretch, bool hopeless) {
    stretches_.push_back(std::move(stretch));
    hopeless_.push_back(hopeless);
  }
  static void add_contact(FollowStretch& stretch, const FollowContact& contact) {
    std::vector<FollowContact>& all = stretch.contacts;
    if (std::find(all.begin(), all.end(), contact) == all.end()) all.push_back(contact);
  }

  void name_short_changes() {
    for (FollowStretch& stretch : stretches_) {
      if (stretch.state == FollowState::open && stretch.time.hi - stretch.time.lo <= question_.shortest)
        stretch.state = FollowState::change;
    }
  }

  const Instance& instance_;
  const SequenceQuestion& question_;
  double length_;  ///< of the direction
  std::vector<LiftCouple> couples_;
  std::optional<LiftContest> contest_;
  std::vector<Piece> pieces_;
  std::vector<FollowStretch> stretches_;
  std::vector<bool> hopeless_;  ///< of each of these: shorter windows would not decide all of it either
};

}  // namespace

std::vector<FollowStretch> contact_sequence(const Instance& instance, const SequenceQuestion& question,
                                            std::string& reason) {
  return SequenceSearch(instance, question).run(reason);
}

}  // namespace taut::internal
