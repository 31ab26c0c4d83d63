#include "spacetime/first_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include "numeric/errors.hpp"
#include "scene/placement.hpp"
#include "spacetime/box_separation.hpp"
#include "spacetime/leaf_test.hpp"
#include "spacetime/walk.hpp"
#include "taut/check.hpp"

namespace taut::internal::spacetime {

/// Which vertex crosses which edge first on one segment: what the walk asks.
class ContactOnSegment {
 public:
  ContactOnSegment(const PairGeometry& geometry, const TreePair& trees, std::shared_ptr<const MotionSegment> segment,
                   double from, CrossingDirections directions = CrossingDirections::into)
      : shortest(shortest_stretch * (segment->end - segment->start)),
        geometry_(geometry),
        held_(std::move(segment)),
        segment_(*held_),
        leaves_(geometry, segment_, directions),
        directions_(directions),
        walk_(trees, segment_, *this),
        flat_sides_(geometry, trees, segment_),
        proved_(from) {}

  /// Searches [from, to] of the segment's parameter for the first contact.
  void begin(double from, double to) { walk_.begin(from, to); }
  /// Returns false if the slice was used up before the end.
  bool advance(const Slice& slice) { return walk_.advance(slice); }
  /// The first contact, after the end.
  std::optional<Crossing> finished() {
    if (best_) leaves_.precise().tighten(*best_);
    return best_;
  }
  /// All crossings instead, each once.
  std::vector<Crossing> run_through(double from, double to) {
    walk_.through(from, to);
    return std::move(found_);
  }
  /// Up to when there is certainly no contact.
  double proved() const { return proved_; }
  void count(SpacetimeResult& result) {
    result.pairs += looks_;
    result.roots += leaves_.roots();
    (result.stages += leaves_.stages()) += flat_sides_.stages();
  }

  const double shortest;
  double distance_of_interest() const { return 0; }
  bool begins(double start) {
    leaf_windows_.clear();
    if (best_) return start < best_->hi;
    proved_ = start;
    return true;
  }
  BoxDecision evaluate(const StretchOfTime& time, const BoxNode& p, const BoxNode& q) {
    ++looks_;
    const Stretch& s = time.bounds;
    if (apart(s, p.box, q.box) || flat_sides_.apart(p, q)) return BoxDecision::done;
    const bool leaf = p.count == 1 && q.count == 1;
    if (time.divisible && (motion(s, p.box, q.box) > subdivision_threshold * (p.box.radius + q.box.radius) ||
                           (leaf && apart_around_middle(s, worth_trying, p.box, q.box))))
      return BoxDecision::deferred;
    if (!leaf) return BoxDecision::divided;
    // Each edge stands for its first vertex.
    const VertexId of_p(p.first), of_q(geometry_.np + q.first);
    resolve(time, s.in_q, {of_p, of_q});
    resolve(time, s.in_p, {of_q, of_p});
    return BoxDecision::done;
  }

 private:
  /// The window around t for the leaves of the stretch that ends at `end`.
  FrameWindow& window_at(double t, double end) {
    if (!segment_.translation) return walk_.window();
    for (FrameWindow& w : leaf_windows_) {
      if (w.start() <= t && t < w.end()) return w;
    }
    return leaf_windows_.emplace_back(segment_, t, end, end - t);
  }
  /// What happens after this does not matter.
  double limit(double end) const {
    return best_ ? std::min(end, std::nextafter(best_->hi, std::numeric_limits<double>::infinity())) : end;
  }
  /// The pair's first contact within the stretch becomes the best if it is.
  void resolve(const StretchOfTime& time, const RelativePose& relative_pose, const VertexEdge& pair) {
    const DisplacedPoint &v = geometry_.point(pair.vertex), &a = geometry_.point(pair.edge),
                         &b = geometry_.point(geometry_.next(pair.edge));
    if (misses(time.bounds, relative_pose, {v.x, v.y}, {a.x, a.y}, {b.x, b.y})) return;
    const double end = time.end;
    for (double t = time.start, next = end; t < limit(end); t = next) {
      FrameWindow& window = window_at(t, end);
      next = std::min(end, window.end());
      std::optional<Crossing> found = leaves_.first(window, pair, t, limit(next));
      if (!found) continue;
      if (directions_ == CrossingDirections::both) {
        next = std::min(next, std::max(found->hi, std::nextafter(t, end)));
        found_.push_back(std::move(*found));
        continue;
      }
      // Stretches come in their order: the pair's own crossing, found before, is not later.
      const bool own = best_ && best_->pair.vertex == pair.vertex && best_->pair.edge == pair.edge;
      if (!own && (!best_ || leaves_.precise().before(*found, *best_))) best_ = std::move(found);
      return;
    }
  }

  const PairGeometry& geometry_;
  std::shared_ptr<const MotionSegment> held_;
  const MotionSegment& segment_;
  LeafTest leaves_;
  CrossingDirections directions_;
  Walk<ContactOnSegment> walk_;
  FlatSides flat_sides_;
  std::vector<Crossing> found_;
  std::vector<FrameWindow> leaf_windows_;  ///< of a translation: the leaves of a stretch make their own
  std::optional<Crossing> best_;
  double proved_;
  std::uint64_t looks_ = 0;
};

namespace {

void note(const Crossing& found, std::size_t segment, double end, SpacetimeResult& result) {
  result.outcome = SpacetimeResult::contact;
  result.found = {found.pair.vertex, found.pair.edge, found.lo, std::min(found.hi, end)};
  if (found.precise && found.precise->stage >= Stage::precise)
    result.found.at = std::make_shared<const PreciseTime>(*found.precise);
  result.lo = found.lo;
  result.segment = segment;
}

/// What of a segment lies in the window, as an interval of its parameter.
std::optional<TimeInterval> clipped(const SegmentPlace& segment, const TimeWindow& window) {
  if (segment.bridge) {
    if (segment.start > window.from && segment.start <= window.to) return TimeInterval{0, 1};
    return std::nullopt;
  }
  const double from = std::max(segment.start, window.from), to = std::min(segment.end, window.to);
  if (from < to || (from == to && window.first)) return TimeInterval{from, to};
  return std::nullopt;
}

}  // namespace

/// The segment at hand, and what the ones before it have come to.
struct ContactSearch::State {
  const PairGeometry& geometry;
  TreePair trees;
  const MotionSegments& segments;
  std::optional<TimeWindow> window;
  std::size_t segment = 0;
  std::optional<ContactOnSegment> search;  ///< on it, once it has begun
  SpacetimeResult counts;                  ///< of those before
  /// After this instant bodies are only where they have been before.
  double repeats = segments.repeats_from();

  std::optional<TimeInterval> part() const {
    const SegmentPlace at = segments.place(segment);
    if (window) return clipped(at, {window->from, std::min(window->to, repeats), window->first});
    return at.bridge ? TimeInterval{0, 1} : TimeInterval{at.start, std::min(at.end, repeats)};
  }
  /// Returns false if the segment needs no search: nothing meets.
  bool begin_segment(const TimeInterval& interval) {
    if (search) return true;
    if (window && quickly_apart(trees, segments[segment], interval.lo, interval.hi)) return false;
    search.emplace(geometry, trees, segments.hold(segment), interval.lo);
    search->begin(interval.lo, interval.hi);
    return true;
  }
  SpacetimeResult result() {
    SpacetimeResult all = counts;
    if (search) search->count(all);
    return all;
  }
  SpacetimeResult stopped(const std::string& reason, double proved) {
    SpacetimeResult all = result();
    all.reason = reason;
    all.segment = segment;
    all.lo = search ? search->proved() : proved;
    return all;
  }
  void leave_segment(const TimeInterval& interval) {
    counts = result();
    search.reset();
    if (interval.hi >= segments[segment].end) segments[segment].forget();
  }
  /// Nothing if the slice was used up before the end.
  std::optional<SpacetimeResult> advance(const Slice& slice) {
    for (; segment < segments.size() && !(window && segments.place(segment).start > window->to); ++segment) {
      const std::optional<TimeInterval> interval = part();
      if (!interval) continue;
      try {
        if (begin_segment(*interval)) {
          if (!search->advance(slice)) return std::nullopt;
          if (const std::optional<Crossing> found = search->finished()) {
            SpacetimeResult all = result();
            note(*found, segment, segments[segment].end, all);
            return all;
          }
        }
      } catch (const Undecidable& limit) {
        return stopped(not_decided(limit), interval->lo);
      } catch (const Interrupted& limit) {
        return stopped(limit.reason, interval->lo);
      }
      leave_segment(*interval);
    }
    SpacetimeResult all = result();
    all.outcome = SpacetimeResult::free;
    return all;
  }
};

ContactSearch::ContactSearch(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments,
                             const std::optional<TimeWindow>& window)
    : state_(new State{
          geometry, trees, segments, window, window ? segments.first_until(window->from) : 0, std::nullopt, {}}) {}
ContactSearch::~ContactSearch() = default;
ContactSearch::ContactSearch(ContactSearch&&) noexcept = default;

std::optional<SpacetimeResult> ContactSearch::advance(const Slice& slice) { return state_->advance(slice); }

SpacetimeResult ContactSearch::run() { return *state_->advance(Slice()); }

SpacetimeResult first_contact(const PairGeometry& geometry, const TreePair& trees, const MotionSegments& segments) {
  return ContactSearch(geometry, trees, segments).run();
}

std::vector<SegmentCrossing> all_crossings(const PairGeometry& geometry, const TreePair& trees,
                                           const MotionSegments& segments, const std::vector<TimeWindow>& windows) {
  std::vector<SegmentCrossing> all;
  for (const TimeWindow& window : windows) {
    for (std::size_t i = segments.first_until(window.from); i < segments.size(); ++i) {
      const SegmentPlace at = segments.place(i);
      if (at.start > window.to) break;
      const std::optional<TimeInterval> part = clipped(at, window);
      if (!part) continue;
      ContactOnSegment search(geometry, trees, segments.hold(i), part->lo, CrossingDirections::both);
      for (const Crossing& c : search.run_through(part->lo, part->hi))
        all.push_back({c.pair.vertex, c.pair.edge, c.out, i, c.lo, c.hi, c.precise});
    }
  }
  return all;
}

void tighten(const PairGeometry& geometry, const MotionSegments& segments, SegmentCrossing& crossing, double share) {
  if (crossing.hi - crossing.lo <= 0x1p-51 * std::fabs(crossing.hi)) return;
  PreciseTime t = crossing.precise.value_or(PreciseTime::between(crossing.lo, crossing.hi));
  if (t.stage >= Stage::precise) return;
  const VertexEdge pair{crossing.vertex, crossing.edge};
  const PreciseTriple line(segments[crossing.segment], geometry, pair.line(geometry));
  if (!line.refine(crossing.out ? 1 : -1, t, Stage::precise, share * std::fabs(crossing.hi))) return;
  crossing.precise = t;
  crossing.lo = t.floor();
  crossing.hi = t.ceiling();
}

}  // namespace taut::internal::spacetime
