// Goes through a log of a tiling event by event. What a valid log proves, and why: docs/proof-format.md.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "certificate/feature_map.hpp"
#include "motion/motion_segment.hpp"
#include "motion/motion_segments.hpp"
#include "motion/pieces.hpp"
#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "proof/curved_scene.hpp"
#include "proof/format.hpp"
#include "proof/lifetime.hpp"
#include "proof/proof_map.hpp"
#include "proof/verifier_world.hpp"
#include "proof/verify_separations.hpp"
#include "scene/mechanism_lock.hpp"
#include "scene/validate_scene.hpp"
#include "taut/validate.hpp"

namespace taut::internal::proof {
namespace {

Shapes shapes_of(const Header& header) {
  if (header.kind > 1) throw ProofError("the log's header makes no sense");
  return header.kind ? Shapes::outwards : Shapes::inwards;
}

Offset offset_of(Shapes shapes) { return shapes == Shapes::inwards ? Offset::inward : Offset::outward; }

class Verifier {
 public:
  Verifier(const Scene& scene, ByteReader& in, const Header& header)
      : scene_(scene),
        in_(in),
        header_(header),
        shapes_(shapes_of(header)),
        bodies_(pair_of(scene)),
        geometry_(displaced_pair(bodies_, offset_of(shapes_))),
        segments_(segments_of(bodies_, scene.start, scene.end)),
        map_(in_, Placement(geometry_, segments_[0], scene.start)),
        lifetimes_(geometry_),
        stretch_(geometry_) {
    make_room();
    for (std::uint32_t i = 0; i < map_.size(); ++i) begin(HalfedgeId(i), Instant::exactly(segment().start));
    enter(0);
  }

  Verified run() {
    result_.coverage.pairs = result_.coverage.tested = 1;
    result_.touch = header_.touch;
    result_.fingerprint = header_.fingerprint;
    try {
      for (std::uint64_t records = 0; record(); ++records) {
        checkpoint();
        if (records % 64 == 0) report_parts("records", records);
      }
    } catch (const ProofError& error) {
      throw ProofError("event " + std::to_string(result_.events) + ", before byte " + std::to_string(in_.offset()) +
                       ": " + error.what());
    }
    in_.close();
    return result_;
  }

 private:
  const MotionSegment& segment() const { return *segment_; }
  FeatureMap witness() const { return {bodies_, geometry_, offset_of(shapes_)}; }

  /// One record; false after the last.
  bool record() {
    const std::uint8_t kind = in_.u8();
    if (kind > static_cast<std::uint8_t>(Record::touching)) throw ProofError("unknown record");
    switch (static_cast<Record>(kind)) {
      case Record::next_segment:
        end_segment();
        return true;
      case Record::free:
        if (!claims_motion()) throw ProofError("the tiling surrounds the wrong polygons");
        while (current_ + 1 < segments_.size()) end_segment();
        all_hold(Instant::exactly(seen_by(segment().end)));
        result_.outcome = Outcome::free;
        result_.free_until = scene_.end;
        return false;
      case Record::free_until:
        free_until(in_.f64());
        return false;
      case Record::touching: {
        const VertexId e(in_.u32());
        touching(e, VertexId(in_.u32()));
        return false;
      }
      default:
        return event(static_cast<Record>(kind));
    }
  }

  /// Polygons displaced outwards must stay apart for `closed`; inwards will do for `open`.
  bool claims_motion() const { return (header_.touch == Touch::closed) == (shapes_ == Shapes::outwards); }

  void enter(std::size_t segment) {
    current_ = segment;
    segment_ = segments_.hold(segment);
    lifetimes_.enter(*segment_);
    last_ = Instant::exactly(segment_->start);
    if (stretch_.enter(segments_, segment, active_.size())) {
      watched_.clear();
      for (const HalfedgeId h : active_) {
        if (!is_dormant(h)) watched_.add(h);
      }
      stretch_.judge(watched_.size(), active_.size());
    }
    for (const HalfedgeId h : watched_) births_[h.value] = last_;
  }

  bool is_dormant(HalfedgeId h) const {
    return stretch_.decides(map_.origin(h), map_.target(h), map_.target(map_.next(h)), map_.sign(h));
  }

  void end_segment() {
    if (current_ + 1 == segments_.size()) throw ProofError("there is no further segment");
    all_hold(Instant::exactly(segment().end));
    enter(current_ + 1);
  }

  bool event(Record kind) {
    const double about = in_.f64();
    const HalfedgeId h(in_.u32());
    if (!claims_motion()) throw ProofError("the tiling surrounds the wrong polygons");
    ++result_.events;
    if (!map_.alive(h) || !active_.has(h)) throw ProofError("no corner of both bodies is there");
    if (!watched_.has(h)) throw ProofError("the corner does not fail on this segment");
    const Corner corner = corner_at(h);
    const Instant now = lifetimes_.failure(corner, about);
    if (!lifetimes_.is_near(now, about)) throw ProofError("the corner fails at another time");
    if (!lifetimes_.in_order(last_, now)) throw ProofError("the event comes before the one before it");
    check_sides(corner, now, kind);
    last_ = now;
    if (kind == Record::contact_first || kind == Record::contact_second) {
      contact(corner, now, kind == Record::contact_first ? h : map_.next(h), kind);
      return false;
    }
    change(h, now, kind);
    return true;
  }

  /// The map's rules speak of what is between what.
  void check_sides(const Corner& c, const Instant& now, Record kind) {
    const VertexId middle = lifetimes_.middle(now);
    if (c.sign < 0) {
      if (middle != c.v) throw ProofError("a reflex corner does not straighten");
      return;
    }
    const bool first = kind == Record::event_first || kind == Record::contact_first;
    if (middle != (first ? c.w : c.u)) throw ProofError("a convex corner closes otherwise");
  }

  void change(HalfedgeId h, const Instant& now, Record kind) {
    const Change before = map_.ending(h, kind);
    for (int i = 0; i < before.count; ++i) end(before.corners[static_cast<std::size_t>(i)], now);
    const Change after = map_.apply(h, kind);
    make_room();
    for (int i = 0; i < after.count; ++i) begin(after.corners[static_cast<std::size_t>(i)], now);
  }

  /// The edge at `hit` is a body's, and the corner's other end reaches it.
  void contact(const Corner& c, const Instant& now, HalfedgeId hit, Record kind) {
    if (c.sign < 0 || !map_.is_body_edge(hit)) throw ProofError("no vertex meets an edge of a body");
    all_hold(now);
    const Instant tight = lifetimes_.tightened(now);
    const VertexId vertex = kind == Record::contact_first ? c.w : c.u;
    const ProvedContact proved = proved_contact(witness(), {vertex, map_.origin(HalfedgeId(hit.value & ~1u))},
                                                segment(), tight, scene_.start, INFINITY);
    result_.contact = proved.contact;
    const bool at_start = result_.contact->time.hi <= scene_.start;
    result_.contact_at = segment().bridge ? ContactAt::joint : at_start ? ContactAt::start : ContactAt::motion;
    result_.free_until = proved.free_until;
    result_.outcome = Outcome::contact;
  }

  /// How far corners must last, so that nothing is new until t: after the last event, bodies that repeat their places
  /// from an instant on need not be followed beyond it.
  double seen_by(double t) const {
    const double repeats = segments_.repeats_from();
    return current_ + 1 == segments_.size() && lifetimes_.tightened(last_).hi < repeats ? std::min(t, repeats) : t;
  }

  void free_until(double t) {
    if (!claims_motion()) throw ProofError("the tiling surrounds the wrong polygons");
    if (!(t >= segment().start && t <= segment().end))
      throw ProofError("the end of the proof is not within its segment");
    // An enclosure in doubles may be wide.
    const Instant last = lifetimes_.tightened(last_);
    if (t > last.hi) {
      all_hold(Instant::exactly(seen_by(t)));
      result_.free_until = segment().time(t);
      return;
    }
    // The next event may be at the same instant, as far as doubles can show: the tiling is good up to the last one.
    for (const HalfedgeId h : watched_) {
      if (!births_[h.value].is(last_)) check_holds(h, last_);
    }
    result_.free_until = segment().time(std::min(t, last.lo));
  }

  /// The inward shapes do not overlap at the start, as the tiling shows; two edges of the outward ones do cross.
  void touching(VertexId e, VertexId f) {
    if (header_.touch != Touch::closed || shapes_ != Shapes::inwards || result_.events > 0 || current_ > 0)
      throw ProofError("a contact at the start needs a tiling around the inward shapes, and nothing else");
    if (e.value >= geometry_.np || f.value < geometry_.np || f.value >= geometry_.size())
      throw ProofError("the edges that cross do not exist");
    const PairGeometry outer = displaced_pair(bodies_, Offset::outward);
    const Placement place(outer, segments_[0], scene_.start, Positions::on_demand);
    require_crossing(place, e, f);
    result_.contact =
        FeatureMap(bodies_, outer, Offset::outward).contact_of_overlap({true, e, f, {}}, segments_[0], scene_.start);
    result_.contact_at = ContactAt::start;
    result_.free_until = scene_.start;
    result_.outcome = Outcome::contact;
  }

  Corner corner_at(HalfedgeId h) const {
    return {map_.origin(h), map_.target(h), map_.target(map_.next(h)), map_.sign(h), births_[h.value]};
  }

  void check_holds(HalfedgeId h, const Instant& until) {
    checkpoint();
    if (!lifetimes_.holds(corner_at(h), until)) throw ProofError("a corner does not last until it is changed");
  }
  void all_hold(const Instant& until) {
    for (const HalfedgeId h : watched_) check_holds(h, until);
  }

  /// Events add half-edges.
  void make_room() {
    births_.resize(map_.size());
    active_.resize(map_.size());
    watched_.resize(map_.size());
  }

  /// The corner that h enters begins: if its vertices are of both bodies, it must be watched.
  void begin(HalfedgeId h, const Instant& birth) {
    if (!map_.alive(h) || map_.is_inside(h)) return;
    const VertexId u = map_.origin(h), v = map_.target(h), w = map_.target(map_.next(h));
    if (u == w) throw ProofError("a face turns back on an edge");
    if (geometry_.same_body(u, v) && geometry_.same_body(v, w)) return;
    active_.add(h);
    births_[h.value] = birth;
    if (is_dormant(h)) {
      watched_.remove(h);
    } else {
      watched_.add(h);
    }
  }
  void end(HalfedgeId h, const Instant& now) {
    if (watched_.has(h)) check_holds(h, now);
    watched_.remove(h);
    active_.remove(h);
  }

  const Scene& scene_;
  ByteReader& in_;
  const Header& header_;
  Shapes shapes_;
  BodyPair bodies_;
  PairGeometry geometry_;
  MotionSegments segments_;
  std::shared_ptr<const MotionSegment> segment_ = segments_.hold(0);  ///< the present one
  std::size_t current_ = 0;
  ProofMap map_;
  Lifetimes lifetimes_;
  StretchOfSegments stretch_;
  std::vector<Instant> births_;  ///< by half-edge; of those that are watched
  HalfedgeList active_;          ///< half-edges that enter a corner of both bodies
  HalfedgeList watched_;         ///< the same without those that hold all over the stretch
  Instant last_;
  Verified result_;
};

}  // namespace
}  // namespace taut::internal::proof

namespace taut {
using namespace internal;

namespace {

/// Of the scene's time, or that before a lock.
Verified verify_to_the_end(const Scene& scene, std::istream& log) {
  const bool curved = proof::any_curves(scene);
  // The polygons that stand for curves are in the log.
  if (!curved) validate_polygons(scene);
  try {
    if (curved) return proof::verify_curves(scene, log);
    proof::ByteReader in(log);
    const proof::Header header = proof::read_header(in, scene);
    if (header.version == proof::of_separations) return proof::verify_separations(scene, in, header);
    return proof::Verifier(scene, in, header).run();
  } catch (const Undecidable& limit) {
    throw ProofError(not_decided(limit));
  }
}

}  // namespace

Verified verify(const Scene& scene, std::istream& log) {
  Verified proved = verify_to_the_end(scene, log);
  std::string reason;
  note_lock(scene, proved.outcome, reason);
  return proved;
}

}  // namespace taut

namespace taut::internal::proof {

ProvedContact proved_contact(const FeatureMap& features, const Incidence& hit, const MotionSegment& segment,
                             const Instant& tight, double start, double free_until) {
  ProvedContact proved{features.contact({hit.vertex, hit.edge, tight.lo, std::min(tight.hi, segment.end)}, segment),
                       free_until};
  TimeInterval& time = proved.contact.time;
  time.lo = std::max(time.lo, start);
  // A jump has its instant. Elsewhere other pairs may meet before, as far as is known, once nothing is said of them.
  if (!segment.bridge) time.lo = std::min(time.lo, free_until);
  proved.free_until = std::min(time.lo, free_until);
  return proved;
}

}  // namespace taut::internal::proof
