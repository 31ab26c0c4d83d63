// Goes through a log of separations: windows of time, pairs in them, trees in these. What a valid log proves, and why:
// docs/proof-format.md.
#include "proof/verify_separations.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "certificate/feature_map.hpp"
#include "numeric/budget.hpp"
#include "proof/mechanism_cells.hpp"
#include "proof/separation.hpp"
#include "proof/verifier_world.hpp"
#include "scene/placement.hpp"
#include "scene/untested.hpp"

namespace taut::internal::proof {
namespace {

/// How often a window may be halved.
constexpr int deepest_window = 60;

class SeparationsVerifier {
 public:
  SeparationsVerifier(const Scene& scene, ByteReader& in, const Header& header)
      : scene_(scene),
        in_(in),
        header_(header),
        claim_(claim_of(header)),
        verifier_scene_(scene),
        margin_(read_margin()),
        world_(verifier_scene_, claim_ == Claim::touching ? Offset::inward : offset_for(header.touch), margin_) {}

  Verified run() {
    result_.kind = ProofKind::separations;
    result_.coverage = verifier_scene_.coverage();
    if (result_.coverage.is_empty()) throw ProofError(why_untested(result_.coverage));
    result_.touch = header_.touch;
    result_.fingerprint = header_.fingerprint;
    result_.outcome = claim_ == Claim::free         ? Outcome::free
                      : claim_ == Claim::free_until ? Outcome::undecided
                                                    : Outcome::contact;
    try {
      check();
    } catch (const ProofError& error) {
      throw ProofError("before byte " + std::to_string(in_.offset()) + ": " + error.what());
    }
    in_.close();
    return result_;
  }

 private:
  static Claim claim_of(const Header& header) {
    const std::uint8_t kind = header.kind & ~with_clearance;
    if (kind > static_cast<std::uint8_t>(Claim::fine_contact)) throw ProofError("the log's header makes no sense");
    return static_cast<Claim>(kind);
  }

  /// In internal units; 0 if the claim is about contact.
  double read_margin() {
    if (!(header_.kind & with_clearance)) return 0;
    result_.clearance = in_.f64();
    const double margin = std::ldexp(result_.clearance, verifier_scene_.exponent());
    if (claim_ == Claim::fine_contact || !(result_.clearance > 0 && std::isfinite(result_.clearance)) ||
        !(margin > 0x1p-900))
      throw ProofError("a clearance that makes no sense");
    return margin;
  }

  void check() {
    result_.free_until = scene_.end;
    if (claim_ == Claim::free_until) result_.free_until = in_.f64();
    if (claim_ == Claim::contact) margin_ > 0 ? closer() : contact();
    if (claim_ == Claim::fine_contact) contact();
    if (claim_ == Claim::touching) margin_ > 0 ? close_at_start() : touching();
    if (!(result_.free_until >= scene_.start && result_.free_until <= scene_.end))
      throw ProofError("the end of the proof is not within the scene's time");
    boxes_.emplace(verifier_scene_, world_.room());
    window({scene_.start, result_.free_until, true}, {}, 0);
  }

  /// Two bodies that are asked about; the next two numbers.
  std::pair<int, int> read_pair() {
    const std::uint32_t a = in_.u32(), b = in_.u32(), n = static_cast<std::uint32_t>(verifier_scene_.size());
    if (!(a < b && b < n) || !verifier_scene_.asked(static_cast<int>(a), static_cast<int>(b)))
      throw ProofError("a pair of bodies that is not asked about");
    return {static_cast<int>(a), static_cast<int>(b)};
  }

  /// Every open pair whose boxes meet is shown to be apart over the window, or is left to its halves.
  void window(const WorldTime& time, const OpenPairs& open, int depth) {
    const std::uint8_t kind = in_.u8();
    if (kind > 1) throw ProofError("a window of an unknown kind");
    if (kind == 0) return halves(time, open, depth);
    const std::vector<std::pair<int, AxisBox>> before = stated_boxes(time, open);
    OpenPairs left;
    left.listed.emplace();
    // Each of them takes a byte, at least: no more are listed than the log can speak of.
    std::optional<BodyPairs> meeting;
    if (open.all()) meeting = boxes_->meeting(verifier_scene_, static_cast<std::size_t>(in_.left()));
    if (open.all() && !meeting)
      throw ProofError("the log is cut off: more pairs have boxes that meet than it has bytes");
    for (const auto& [a, b] : open.all() ? *meeting : *open.listed) {
      checkpoint();
      if (std::pair(a, b) == contact_pair_ || !boxes_->meet(a, b)) continue;
      const std::uint8_t now = in_.u8();
      if (now > 1) throw ProofError("neither a pair's separations nor shorter windows");
      if (now == 0) {
        left.listed->emplace_back(a, b);
      } else {
        const VerifierPair& met = world_.pair(a, b);
        section(met, stretches(met.segments, time), time.first, {});
      }
    }
    if (!left.listed->empty()) halves(time, left, depth);
    for (const auto& [body, box] : before) boxes_->state(body, box);
  }
  void halves(const WorldTime& time, const OpenPairs& open, int depth) {
    if (depth >= deepest_window || !time.divisible()) throw ProofError("a window is halved too often");
    window(time.first_half(), open, depth + 1);
    window(time.second_half(), open, depth + 1);
  }

  /// Reads the boxes that hold in this window; returns what they take the place of.
  std::vector<std::pair<int, AxisBox>> stated_boxes(const WorldTime& time, const OpenPairs& open) {
    std::vector<std::pair<int, AxisBox>> before;
    for (const int body : moving_bodies(verifier_scene_, open)) {
      checkpoint();
      const std::uint8_t stated = in_.u8();
      if (stated > 1) throw ProofError("neither a box nor none");
      if (stated == 0) continue;
      const StatedBox box = read_box(in_);
      if (!stays_within(verifier_scene_[body], time, world_.room(), box))
        throw ProofError("body " + std::to_string(body) + " does not stay within its box");
      before.emplace_back(body, boxes_->of(body));
      boxes_->state(body, as_doubles(box));
    }
    return before;
  }

  /// The pair does not meet on these stretches of its segments, the last one up to `until` only if that is set.
  void section(const VerifierPair& pair, const std::vector<SegmentStretch>& stretches, bool from_start,
               const std::optional<Instant>& until) {
    Lifetimes lifetimes(pair.geometry);
    for (std::size_t i = 0; i < stretches.size(); ++i) {
      const std::shared_ptr<const MotionSegment> segment = pair.segments.hold(stretches[i].segment);
      lifetimes.enter(*segment);
      const std::optional<Instant> last = i + 1 == stretches.size() ? until : std::nullopt;
      // In the jump at a joint bodies need not meet, no more: the clearance is one at instants.
      ApartChecker apart(pair.ranges, lifetimes, last, in_, segment->bridge ? 0 : margin_);
      apart.check(stretches[i].from, stretches[i].to);
      result_.separations += apart.separations();
    }
    if (from_start && overlap_at(pair, pair.segments[0], scene_.start))
      throw ProofError("the bodies overlap at the start");
  }

  /// A vertex reaches an edge from outside, and has not met it before; and the two bodies have separations of their
  /// own.
  void contact() {
    contact_pair_ = read_pair();
    const VerifierPair& pair = world_.pair(contact_pair_.first, contact_pair_.second);
    const std::uint32_t segment = in_.u32();
    const Incidence hit{read_vertex(pair), read_vertex(pair)};
    FineInstant since{in_.f64(), 0, 0};
    if (claim_ == Claim::fine_contact) since = {since[0], in_.f64(), in_.f64()};
    const double about = in_.f64(), end = in_.f64();
    result_.free_until = in_.f64();
    if (segment >= pair.segments.size() || pair.geometry.same_body(hit.vertex, hit.edge))
      throw ProofError("a contact that cannot be");
    const std::shared_ptr<const MotionSegment> held = pair.segments.hold(segment);
    const MotionSegment& last = *held;
    Lifetimes lifetimes(pair.geometry);
    lifetimes.enter(last);
    // The material is to the left of its edges.
    if (!is_within(since, last.start, last.end)) throw ProofError("a contact outside of its segment");
    const Corner corner{hit.edge, pair.geometry.next(hit.edge), hit.vertex, -1, instant_at(since)};
    const Instant now = lifetimes.failure(corner, about);
    if (!lifetimes.is_near(now, about) || !lifetimes.in_order(corner.birth, now) || !lifetimes.holds(corner, now))
      throw ProofError("the vertex does not come to the edge's line from outside then");
    if (lifetimes.middle(now) != hit.vertex) throw ProofError("the vertex meets the edge's line, but not the edge");
    if (!(end >= now.hi && end <= last.end)) throw ProofError("the contact is not within its stretch of time");
    std::vector<SegmentStretch> stretches;
    add_stretches_before(pair.segments, segment, stretches);
    stretches.push_back({segment, last.start, end});
    section(pair, stretches, true, now);
    conclude(pair, hit, last, lifetimes.tightened(now));
  }

  /// Two features that are closer than the clearance at an instant, and all pairs keep it up to some time before.
  void closer() {
    const auto [a, b] = read_pair();
    const VerifierPair& pair = world_.pair(a, b);
    const std::uint32_t segment = in_.u32();
    const VertexId vertex = read_vertex(pair), peer = read_vertex(pair);
    const std::uint8_t is_edge = in_.u8();
    const FineInstant at{in_.f64(), in_.f64(), in_.f64()};
    result_.free_until = in_.f64();
    if (segment >= pair.segments.size() || pair.segments[segment].bridge || pair.geometry.same_body(vertex, peer) ||
        is_edge > 1 || !is_within(at, pair.segments[segment].start, pair.segments[segment].end) ||
        !(result_.free_until <= at[0]))
      throw ProofError("a closeness that cannot be");
    if (!closer_at(pair.geometry, pair.segments[segment], margin_, {vertex, peer}, is_edge == 1, at))
      throw ProofError("the two features are not closer than the clearance then");
    conclude_closer(pair, vertex, peer, is_edge == 1, rounded_up(at));
  }

  void conclude_closer(const VerifierPair& pair, VertexId vertex, VertexId peer, bool is_edge, double until) {
    const FeatureMap witness(pair.bodies, pair.geometry, world_.offset());
    ProvedCloseness found;
    found.features.vertex = witness.vertex(vertex);
    if (is_edge) found.features.edge = witness.edge(peer);
    if (!is_edge) found.features.other = witness.vertex(peer);
    found.time = {result_.free_until, until};
    result_.closer = found;
  }

  /// Shapes displaced inwards keep the clearance at the start, as the windows show; two features of those displaced
  /// outwards do not.
  void close_at_start() {
    if (header_.touch != Touch::closed) throw ProofError("bodies may be as close as the clearance here");
    const auto [a, b] = read_pair();
    const VerifierPair& pair = world_.pair(a, b);
    const VertexId vertex = read_vertex(pair), peer = read_vertex(pair);
    const std::uint8_t is_edge = in_.u8();
    if (pair.geometry.same_body(vertex, peer) || is_edge > 1) throw ProofError("a closeness that cannot be");
    const PairGeometry outer = displaced_pair(pair.bodies, Offset::outward);
    if (!closer_at(outer, pair.segments[0], margin_, {vertex, peer}, is_edge == 1, {scene_.start, 0, 0}))
      throw ProofError("the two features are not as close as the clearance at the start");
    result_.contact_at = ContactAt::start;
    result_.free_until = scene_.start;
    conclude_closer(pair, vertex, peer, is_edge == 1, scene_.start);
  }

  VertexId read_vertex(const VerifierPair& pair) {
    const VertexId v(in_.u32());
    if (v.value >= pair.geometry.size()) throw ProofError("there is no such vertex");
    return v;
  }

  void conclude(const VerifierPair& pair, const Incidence& hit, const MotionSegment& segment, const Instant& tight) {
    // All pairs are shown to be free up to this one instant.
    if (!(result_.free_until <= segment.time(tight.hi))) throw ProofError("free beyond the contact");
    const ProvedContact proved = proved_contact({pair.bodies, pair.geometry, world_.offset()}, hit, segment, tight,
                                                scene_.start, result_.free_until);
    result_.contact = proved.contact;
    result_.contact_at = segment.bridge                           ? ContactAt::joint
                         : proved.contact.time.hi <= scene_.start ? ContactAt::start
                                                                  : ContactAt::motion;
    result_.free_until = proved.free_until;
  }

  /// Shapes displaced inwards are apart at the start, as the windows show; those displaced outwards are not.
  void touching() {
    if (header_.touch != Touch::closed) throw ProofError("a contact at the start without a motion");
    const auto [a, b] = read_pair();
    const VerifierPair& pair = world_.pair(a, b);
    const std::uint8_t how = in_.u8();
    const VertexId e = read_vertex(pair), f = read_vertex(pair);
    if (how > 1 || (how == 1 && e != f)) throw ProofError("a contact at the start of an unknown kind");
    const PairGeometry outer = displaced_pair(pair.bodies, Offset::outward);
    const Placement place(outer, pair.segments[0], scene_.start, Positions::on_demand);
    const StartOverlap overlap{how == 0, outer.in_p(e) ? e : f, outer.in_p(e) ? f : e, e};
    if (overlap.crossing) {
      require_crossing(place, e, f);
    } else if (!inside_the_other(place, e)) {
      throw ProofError("the vertex is not inside the other body");
    }
    result_.contact =
        FeatureMap(pair.bodies, outer, Offset::outward).contact_of_overlap(overlap, pair.segments[0], scene_.start);
    result_.contact_at = ContactAt::start;
    result_.free_until = scene_.start;
  }

  const Scene& scene_;
  ByteReader& in_;
  const Header& header_;
  Verified result_;
  Claim claim_;
  VerifierScene verifier_scene_;
  double margin_;  ///< of a claim about a clearance, else 0
  VerifierWorld world_;
  std::optional<WindowBoxes> boxes_;
  std::pair<int, int> contact_pair_{-1, -1};  ///< whose separations are not in the windows
};

}  // namespace

Verified verify_separations(const Scene& scene, ByteReader& in, const Header& header) {
  if (has_loops(scene)) return SeparationsVerifier(with_stated_cells(scene, in), in, header).run();
  return SeparationsVerifier(scene, in, header).run();
}

}  // namespace taut::internal::proof
