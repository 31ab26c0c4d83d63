// The walk that all searches of the spacetime engine take: through stretches of a segment, and pairs of boxes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "numeric/budget.hpp"
#include "numeric/thread_local_pool.hpp"
#include "spacetime/any_rotation.hpp"
#include "spacetime/box_separation.hpp"

namespace taut::internal::spacetime {

/// Two boxes, as nodes of P's and Q's trees.
struct BoxPair {
  std::uint32_t p, q;
};

/// A stretch of time, and what can be done with it.
struct StretchOfTime {
  const Stretch& bounds;
  double start, end;
  bool divisible;  ///< into halves, in which the same pairs are evaluated again
  double scale;    ///< about how long the motion keeps its character: of a segment that turns, the window's length
};

/// What becomes of two boxes in a stretch.
enum class BoxDecision : unsigned char {
  done,      ///< nothing more is to be known of them there
  divided,   ///< into the boxes below the larger one
  deferred,  ///< to the halves of the stretch
};

/// Boxes that move farther than this share of their size are left to shorter stretches of time; others are divided.
constexpr double subdivision_threshold = 0.75;

/// A stretch that is to be searched, and its pairs. Those before them belong to longer stretches, those after them to
/// shorter ones, which are done by then.
struct WalkLevel {
  double start, end;
  std::size_t first, last;
  double middle() const { return start + (end - start) / 2; }
};

/// What a walk has to do. A thread keeps it for its next walk, unless it has become large.
struct WalkMemory {
  std::vector<WalkLevel> levels;
  std::vector<BoxPair> pairs, todo;

  void trim() {
    constexpr std::size_t large = 4096;
    if (pairs.capacity() > large) pairs = {};
    if (todo.capacity() > large) todo = {};
  }
};

/// Stretches of time are halved, each with the pairs of boxes about which something is still to be known in it, and
/// worked on in their order: the motion is evaluated once for all pairs of a stretch. What is to be known is the
/// question's to say; it has
///   bool begins(double start)                            a stretch begins; false if nothing in it matters any more
///   BoxDecision evaluate(const StretchOfTime&, const BoxNode& p, const BoxNode& q)
///   double shortest                                      of the stretches' lengths, that are halved
///   double distance_of_interest()                        pairs of boxes that stay farther apart are not evaluated
/// and, optionally, `nearer_first`, by which of a pair's halves the nearer one comes first.
///
/// A slice ends between two pairs of boxes: those that are still to be evaluated are the state of the walk.
template <class Query>
class Walk {
 public:
  Walk(const TreePair& trees, const MotionSegment& segment, Query& question)
      : trees_(trees), segment_(segment), question_(question), polynomial_(segment) {}
  ~Walk() { memory_->trim(); }
  Walk(const Walk&) = delete;
  Walk& operator=(const Walk&) = delete;

  /// From the root of both trees, throughout [from, to] of the segment's parameter.
  void through(double from, double to) {
    begin(from, to);
    advance(Slice());
  }
  /// The same, for advance() to do.
  void begin(double from, double to) {
    from_ = reached_ = from;
    to_ = to;
    begun_ = false;
    levels_.clear();
    spans_.clear();
    if (!segment_.translation) spans_.push_back({to, {{0, 0}}});
  }
  /// Returns false if the slice was used up before the end.
  bool advance(const Slice& slice) {
    do {
      if (!work_off(slice)) return false;
    } while (begin_next());
    return true;
  }
  /// At an instant of it. Windows have a length: this one begins with the instant, or ends with the segment. Where the
  /// motion is singular, it moves the less the shorter the window is. A segment may be an instant itself.
  void at(double t) {
    if (segment_.translation) return through(t, t);
    const double whole = segment_.end - segment_.start;
    for (double some = whole * length_of_instant;; some *= 0x1p-10) {
      window_.emplace(segment_, t < segment_.end ? t : std::max(segment_.start, segment_.end - some), segment_.end,
                      some);
      while (window_->end() < t) window_.emplace(segment_, window_->end(), segment_.end, window_->fitting_length());
      if (window_->smooth() || !(some > whole * shortest_instant)) break;
    }
    begin_at_root(t, t);
    work_off(Slice());
  }
  /// In the middle of a stretch that somebody has, with that one's errors.
  void in_middle_of(const Stretch& s) {
    begin_at_root(s.middle, s.middle);
    begin_pairs(levels_.back());
    any_rotation_.reset();
    stretch_.emplace(s);
    stretch_->r = 0;
    work_off(Slice());
  }
  /// The window around the stretch at hand, unless the segment is a translation.
  FrameWindow& window() { return *window_; }

 private:
  static constexpr double length_of_instant = 0x1p-20, shortest_instant = 0x1p-45;
  /// A part of the whole that takes more windows than this is bounded as a whole first, with so many pairs of boxes.
  static constexpr double many_windows = 16;
  static constexpr std::size_t most_pairs = 32;

  /// A part of the whole up to `end`, and the pairs of boxes that may meet in it.
  struct Span {
    double end;
    std::vector<BoxPair> pairs;
  };

  /// Motions seldom change their character: what fitted the last one will do.
  void next_window(double start, double from, double to) {
    const double wanted = window_ ? std::min(to - from, window_->fitting_length()) : to - from;
    window_.emplace(segment_, start, to, wanted);
  }
  /// The next part of the whole that is searched with one window, of a translation all of it; false if there is none.
  bool begin_next() {
    if (segment_.translation) {
      if (begun_) return false;
      begun_ = true;
      begin_at_root(from_, to_);
      return true;
    }
    if (!(reached_ < to_) || !question_.begins(reached_)) return false;
    if (!skip() || !question_.begins(reached_)) return false;
    const Span& span = spans_.back();
    next_window(reached_, from_, span.end);
    begin_at(span.pairs, reached_, window_->end());
    reached_ = window_->end();
    return true;
  }
  /// Moves on to the next span that needs windows; false if there is none.
  bool skip() {
    while (!spans_.empty()) {
      Span& span = spans_.back();
      const double middle = reached_ + (span.end - reached_) / 2;
      if (!(reached_ < span.end)) {
        spans_.pop_back();
      } else if (segment_.bridge || !window_ || !(span.end - reached_ > many_windows * window_->fitting_length()) ||
                 !(reached_ < middle && middle < span.end)) {
        return true;
      } else {
        checkpoint();
        keep_near(span.pairs, AnyRotation(segment_, reached_, span.end));
        if (span.pairs.empty()) {
          reached_ = span.end;
        } else {
          spans_.push_back({middle, span.pairs});
        }
      }
    }
    return false;
  }
  /// Drops pairs that stay far from each other, and divides others while there are few.
  void keep_near(std::vector<BoxPair>& pairs, const AnyRotation& motion) {
    const double distance = question_.distance_of_interest();
    for (bool divided = true; divided;) {
      divided = false;
      todo_.clear();
      for (const BoxPair& pair : pairs) {
        const BoxNode &p = trees_.p.node(pair.p), &q = trees_.q.node(pair.q);
        if (motion.farther(p.box, q.box, distance) || motion.nested(trees_, p, q, distance)) continue;
        if ((p.count == 1 && q.count == 1) || pairs.size() > most_pairs) {
          todo_.push_back(pair);
          continue;
        }
        const auto [left, right] = halves_of(pair, p, q);
        todo_.insert(todo_.end(), {left, right});
        divided = true;
      }
      pairs.swap(todo_);
    }
    todo_.clear();
  }
  void begin_at_root(double from, double to) {
    const BoxPair root{0, 0};
    begin_at({&root, 1}, from, to);
  }
  void begin_at(std::span<const BoxPair> pairs, double from, double to) {
    pairs_.assign(pairs.begin(), pairs.end());
    levels_.assign(1, {from, to, 0, pairs_.size()});
    stretch_.reset();
  }
  Stretch stretch(double from, double to) {
    if (segment_.translation) return Stretch::of_translation(segment_, polynomial_, from, to);
    return window_->smooth() ? Stretch::of_window(segment_, *window_, from, to) : Stretch::of_range(segment_, *window_);
  }
  /// All that there is on levels_, the last one first; false if the slice was used up before.
  bool work_off(const Slice& slice) {
    while (!levels_.empty()) {
      const WalkLevel level = levels_.back();
      if (!stretch_ && !begin(level)) {
        levels_.pop_back();
        continue;
      }
      if (!evaluate(level, slice)) return false;
      stretch_.reset();
      levels_.pop_back();
      if (pairs_.size() == level.last) continue;
      levels_.push_back({level.middle(), level.end, level.last, pairs_.size()});
      levels_.push_back({level.start, level.middle(), level.last, pairs_.size()});
    }
    return true;
  }
  void begin_pairs(const WalkLevel& level) {
    pairs_.resize(level.last);
    todo_.clear();
    next_ = level.first;
  }
  bool begin(const WalkLevel& level) {
    begin_pairs(level);
    if (!question_.begins(level.start)) return false;
    stretch_.emplace(stretch(level.start, level.end));
    any_rotation_.reset();
    return true;
  }
  /// Is one body in a hole of the other one, to which one of the nodes belongs, and of no interest there?
  bool nested(const StretchOfTime& time, const BoxNode& p, const BoxNode& q) {
    if (segment_.bridge || !may_be_nested(trees_, p, q)) return false;
    if (!any_rotation_) any_rotation_.emplace(segment_, time.start, time.end);
    return any_rotation_->nested(trees_, p, q, question_.distance_of_interest());
  }
  /// At all pairs of a stretch; false if the slice was used up before.
  bool evaluate(const WalkLevel& level, const Slice& slice) {
    const bool divisible =
        stretch_->r > question_.shortest && level.start < level.middle() && level.middle() < level.end;
    const double scale = segment_.translation || !window_ ? segment_.end - segment_.start : window_->length();
    const StretchOfTime time{*stretch_, level.start, level.end, divisible, scale};
    for (;;) {
      if (todo_.empty()) {
        if (next_ == level.last) return true;
        todo_.push_back(pairs_[next_++]);
      }
      if (slice.used_up()) return false;
      checkpoint();
      const BoxPair pair = todo_.back();
      const BoxNode &p = trees_.p.node(pair.p), &q = trees_.q.node(pair.q);
      const BoxDecision decision = nested(time, p, q) ? BoxDecision::done : question_.evaluate(time, p, q);
      todo_.pop_back();
      if (decision == BoxDecision::deferred) pairs_.push_back(pair);
      if (decision == BoxDecision::divided) divide(pair, p, q, *stretch_);
    }
  }
  /// Of the larger box.
  static std::array<BoxPair, 2> halves_of(const BoxPair& pair, const BoxNode& p, const BoxNode& q) {
    const bool of_p = divides_first(p, q);
    return {BoxPair{of_p ? p.left : pair.p, of_p ? pair.q : q.left},
            BoxPair{of_p ? p.right : pair.p, of_p ? pair.q : q.right}};
  }
  /// With what comes first on top.
  void divide(const BoxPair& pair, const BoxNode& p, const BoxNode& q, const Stretch& s) {
    auto [left, right] = halves_of(pair, p, q);
    if constexpr (requires { Query::nearer_first; }) {
      if (between_centres(s, right) < between_centres(s, left)) std::swap(left, right);
    }
    todo_.push_back(right);
    todo_.push_back(left);
  }
  /// The square of the distance in the middle of the stretch.
  double between_centres(const Stretch& s, const BoxPair& pair) const {
    const Path relative = s.in_p.place(trees_.q.node(pair.q).box.centre, trees_.p.node(pair.p).box.centre);
    return relative.x.a * relative.x.a + relative.y.a * relative.y.a;
  }

  TreePair trees_;
  const MotionSegment& segment_;
  Query& question_;
  TranslationPolynomial polynomial_;
  std::optional<FrameWindow> window_;
  double from_ = 0, to_ = 0, reached_ = 0;   ///< of the whole; of a segment that turns, windows begin there
  bool begun_ = false;                       ///< the only part of a translation
  std::vector<Span> spans_;                  ///< what is left of a segment that turns, the next one last
  std::optional<Stretch> stretch_;           ///< of the last level, if it has begun
  std::optional<AnyRotation> any_rotation_;  ///< of the same stretch, if it was asked for
  std::size_t next_ = 0;                     ///< of its pairs
  ThreadLocalPool<WalkMemory>::Pointer memory_ = ThreadLocalPool<WalkMemory>::take();
  std::vector<WalkLevel>& levels_ = memory_->levels;
  std::vector<BoxPair>&pairs_ = memory_->pairs, &todo_ = memory_->todo;
};

}  // namespace taut::internal::spacetime
