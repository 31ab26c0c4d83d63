#include "taut/map_query.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "motion/pieces.hpp"
#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "scene/untested.hpp"
#include "scene/validate_scene.hpp"
#include "session/static_map_parts.hpp"
#include "solver/robot_search.hpp"
#include "taut/error.hpp"

namespace taut {
using namespace internal;
namespace {

/// A coefficient that the engines can use. Numbers below their range are far below the possible motion of a robot.
double usable(const std::string& robot, const char* what, double x) {
  if (std::fabs(x) < 0x1p-400) return 0;
  if (!(std::fabs(x) <= 0x1p400))
    throw InputError(robot, std::string("a pose's ") + what + " is not a finite number up to 2^400");
  return x;
}

/// Of a straight way, on [0, 1].
constexpr MapFinding free_until_end{Outcome::free, 1, 1, -1, -1, -1};

bool all_even(std::span<const Motion> motions) {
  return std::all_of(motions.begin(), motions.end(), [](const Motion& motion) {
    return std::all_of(motion.pieces.begin(), motion.pieces.end(), spacetime::UniformMotion::is_even);
  });
}

}  // namespace

struct MapQuery::Impl {
  StaticMap map;
  std::vector<StaticMap::Mover> movers;
  const MapBodies* bodies = nullptr;
  double scale = 1;  ///< of lengths in the engines' terms
  MapQueryOptions options;
  std::optional<RobotSearch> search;
  std::vector<MotionPiece> own;  ///< of each link, scaled
  std::string reason;
  FreePoses known_free;
  std::string untested;  ///< why no pair is ever tested; empty if some are

  Impl(const StaticMap& of, const std::vector<RobotLink>& links, const MapQueryOptions& how);

  std::string why_nothing_meets() const;
  bool nothing_near(std::span<const PoseSE2> from, std::span<const PoseSE2> to);
  void line(std::size_t link, const PoseSE2& from, const PoseSE2& to);
  void lines(std::span<const PoseSE2> from, std::span<const PoseSE2> to);
  void expect(std::size_t count) const;
  template <class Ask>
  MapFinding answered(double start, double end, const Ask& ask);
  RobotFinding on_lines(std::span<const PoseSE2> from, bool any);
  RobotFinding on_pieces(std::span<const Motion> motions, double start, double end, bool any);
  RobotFinding on_any_motion(std::span<const Motion> motions, double start, double end);
  RobotFinding on_motions(std::span<const Motion> motions, double start, double end, bool any);
  MotionChain chain_of(std::span<const Motion> motions, std::size_t link, double start, double end) const;
};

MapQuery::Impl::Impl(const StaticMap& of, const std::vector<RobotLink>& links, const MapQueryOptions& how)
    : map(of), options(how) {
  const StaticMap::Impl& parts = *of.impl_;
  bodies = &parts.prepared;
  scale = std::ldexp(1.0, bodies->exponent);
  std::vector<RobotSearch::Link> rings;
  for (const RobotLink& link : links) {
    if (link.shape.impl_->map != &parts)
      throw InputError(link.shape.name(), "the mover was prepared for another map", "prepare it for this one");
    if (link.parent < -1 || link.parent >= static_cast<int>(rings.size()))
      throw InputError(link.shape.name(), "its parent does not come before it", "put links in order from the base on");
    movers.push_back(link.shape);
    rings.push_back({link.shape.impl_->rings, link.shape.impl_->z, link.parent});
  }
  if (links.empty()) throw InputError("robot", "there is no link", "give at least one");
  own.resize(links.size());
  search.emplace(*bodies, std::move(rings), offset_for(options.touch), options.links_meet);
  untested = why_nothing_meets();
}

/// Links that share no layer with any body, or the other way round, collide with nothing, wherever they are.
std::string MapQuery::Impl::why_nothing_meets() const {
  const auto meets_some = [&](const RobotSearch::Link& link) {
    return std::any_of(bodies->z.begin(), bodies->z.end(), [&](const Layers& z) { return z.meet(link.z); });
  };
  if (!search->meeting().empty() || std::any_of(search->links().begin(), search->links().end(), meets_some)) return {};
  Coverage coverage;
  coverage.pairs = coverage.layers = map.size() * movers.size();
  return why_untested(coverage);
}

void MapQuery::Impl::line(std::size_t link, const PoseSE2& from, const PoseSE2& to) {
  const std::string& name = movers[link].name();
  MotionPiece& piece = own[link];
  // A power of two, as are all units here, and far from those beyond which products are rounded.
  const auto set = [&](Coefficients& c, const char* what, double a, double b, double unit) {
    c.assign({unit * usable(name, what, a), unit * usable(name, what, b - a)});
    while (!c.empty() && c.back() == 0) c.pop_back();
  };
  set(piece.x, "x", from.x, to.x, scale);
  set(piece.y, "y", from.y, to.y, scale);
  if (!std::holds_alternative<AngleRotation>(piece.rotation)) piece.rotation = AngleRotation{};
  set(std::get<AngleRotation>(piece.rotation).angle, "angle", from.angle, to.angle, 1);
  piece.pivot = {};
}

/// Is a robot of one body certainly in free space, with as little done as possible?
bool MapQuery::Impl::nothing_near(std::span<const PoseSE2> from, std::span<const PoseSE2> to) {
  const bool limited = options.limits.stop || options.limits.max_seconds < 1e9;
  if (own.size() != 1 || from.size() != 1 || to.size() != 1 || limited || !untested.empty()) return false;
  const PoseSE2 &a = from[0], &b = to[0];
  const auto checked = [&](const char* what, double x) { return usable(movers[0].name(), what, x); };
  const Vector start{scale * checked("x", a.x), scale * checked("y", a.y)};
  const Vector way{scale * checked("x", b.x - a.x), scale * checked("y", b.y - a.y)};
  checked("angle", a.angle);
  checked("angle", b.angle - a.angle);
  if (!search->roams_free(start, way)) return false;
  reason.clear();
  return true;
}

void MapQuery::Impl::expect(std::size_t count) const {
  if (count != own.size())
    throw InputError(movers[0].name(),
                     "the robot has " + std::to_string(own.size()) + " links, and is asked about with " +
                         std::to_string(count) + " poses or motions",
                     "give one for each link, in their order");
}

void MapQuery::Impl::lines(std::span<const PoseSE2> from, std::span<const PoseSE2> to) {
  expect(from.size());
  expect(to.size());
  for (std::size_t k = 0; k < own.size(); ++k) line(k, from[k], to[k]);
  search->set(own);
}

template <class Ask>
MapFinding MapQuery::Impl::answered(double start, double end, const Ask& ask) {
  RobotFinding found;
  reason = untested;
  if (!untested.empty()) return {Outcome::untested, start, end, -1, -1, -1};
  const std::string stopped = what_stops([&] {
    std::optional<Budget> scope;
    if (options.limits.stop || options.limits.max_seconds < 1e9) scope.emplace(options.limits);
    // Queries are short: those made after the flag was set do not begin.
    if (scope) scope->check();
    found = ask();
    if (found.outcome == Outcome::undecided && reason.empty()) reason = "the highest precision does not decide";
  });
  if (!stopped.empty()) {
    reason = stopped;
    found = {Outcome::undecided, start, end, -1, -1, -1};
  }
  const double until = found.outcome == Outcome::free ? end : std::clamp(found.lo, start, end);
  const double by = found.outcome == Outcome::contact            ? std::clamp(found.hi, start, end)
                    : found.outcome == Outcome::overlap_at_start ? start
                                                                 : end;
  return {found.outcome, until, by, found.link, found.body, found.other_link};
}

/// The motion is on [0, 1].
RobotFinding MapQuery::Impl::on_lines(std::span<const PoseSE2> from, bool any) {
  const bool one = from.size() == 1;
  if (!one || !known_free.has(from[0])) {
    const RobotFinding first = search->at(0);
    if (first.outcome != Outcome::free) return first;
    if (one) known_free.add(from[0]);
  }
  return search->along(0, 1, any);
}

/// Proceeds from joint to joint of all motions, which must be uniform and valid.
RobotFinding MapQuery::Impl::on_pieces(std::span<const Motion> motions, double start, double end, bool any) {
  const auto piece_of = [](const Motion& motion, double t) -> MotionPiece {
    for (const MotionPiece& piece : motion.pieces) {
      if (t < piece.until) return piece;
    }
    return motion.pieces.empty() ? MotionPiece{} : motion.pieces.back();
  };
  const auto take = [&](double t) {
    double until = end;
    for (std::size_t k = 0; k < own.size(); ++k) {
      own[k] = piece_of(motions[k], t);
      if (own[k].until > t) until = std::min(until, own[k].until);
      own[k] = scaled(std::move(own[k]), bodies->exponent);
    }
    return until;
  };
  double until = take(start);
  search->set(own);
  RobotFinding found = search->at(start);
  for (double t = start; found.outcome == Outcome::free && t < end; t = until, until = take(t)) {
    if (t > start) found = search->join(own, t);
    if (found.outcome == Outcome::free) found = search->along(t, until, any);
    if (until >= end) break;
  }
  return found;
}

MotionChain MapQuery::Impl::chain_of(std::span<const Motion> motions, std::size_t link, double start,
                                     double end) const {
  MotionChain chain;
  for (int k = static_cast<int>(link); k >= 0; k = search->links()[static_cast<std::size_t>(k)].parent) {
    chain.insert(chain.begin(), PieceList::between(motions[static_cast<std::size_t>(k)], start, end, bodies->exponent));
  }
  return chain;
}

/// Other motions are checked like StaticMap::check(), link by link and pair by pair.
RobotFinding MapQuery::Impl::on_any_motion(std::span<const Motion> motions, double start, double end) {
  RobotFinding best;
  best.lo = best.hi = end;
  const auto note = [&](const PairResult& r, int link, int body, int other) {
    if (r.outcome == Outcome::free) return;
    const double lo = r.contact ? r.contact->time.lo : r.free_until, hi = r.contact ? r.contact->time.hi : lo;
    if (best.outcome == Outcome::free || lo < best.lo) best = {r.outcome, lo, hi, link, body, other};
    if (r.outcome == Outcome::undecided) reason = r.reason;
  };
  const Offset offset = search->offset();
  for (std::size_t k = 0; k < own.size(); ++k) {
    InstanceBody mover;
    mover.rings = search->links()[k].rings;
    mover.z = search->links()[k].z;
    mover.motions = chain_of(motions, k, start, end);
    MapSearch standing(*bodies, std::move(mover), start, end, offset);
    if (standing.start()) standing.run();
    for (const PairResult& r : standing.results()) note(r, static_cast<int>(k), std::min(r.a, r.b), -1);
  }
  for (const auto& [p, q] : search->meeting()) {
    const auto a = static_cast<std::size_t>(p), b = static_cast<std::size_t>(q);
    BodyPair links = pair_of(search->links()[a].rings, chain_of(motions, a, start, end), search->links()[b].rings,
                             chain_of(motions, b, start, end));
    auto segments = std::make_shared<const MotionSegments>(segments_of(links, start, end));
    SpacetimeSolver pair(PairInstance(std::move(links), std::move(segments), offset), offset, start, end);
    pair.ask_start();
    if (pair.open()) pair.ask(start, end);
    note(pair.result(), p, -1, q);
  }
  return best;
}

RobotFinding MapQuery::Impl::on_motions(std::span<const Motion> motions, double start, double end, bool any) {
  expect(motions.size());
  Scene time;
  time.start = start;
  time.end = end;
  validate_time(time);
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const StaticMap::Mover::Impl& mover = *movers[k].impl_;
    validate_motion(motions[k], mover.name, mover.bounds, start, end, mover.extent);
  }
  return all_even(motions) ? on_pieces(motions, start, end, any) : on_any_motion(motions, start, end);
}

MapQuery::MapQuery(const StaticMap& map, const StaticMap::Mover& robot, const MapQueryOptions& options)
    : MapQuery(map, std::vector<RobotLink>{{robot, -1}}, options) {}

MapQuery::MapQuery(const StaticMap& map, const std::vector<RobotLink>& links, const MapQueryOptions& options)
    : impl_(std::make_unique<Impl>(map, links, options)) {}

MapQuery::~MapQuery() = default;
MapQuery::MapQuery(MapQuery&&) noexcept = default;
MapQuery& MapQuery::operator=(MapQuery&&) noexcept = default;

MapFinding MapQuery::at(std::span<const PoseSE2> poses) {
  if (poses.size() == 1 && impl_->own.size() == 1 && impl_->known_free.has(poses[0])) return {};
  if (impl_->nothing_near(poses, poses)) return {};
  impl_->lines(poses, poses);
  const MapFinding found = impl_->answered(0, 0, [this] { return impl_->search->at(0); });
  if (poses.size() == 1 && found.free()) impl_->known_free.add(poses[0]);
  return found;
}

MapFinding MapQuery::along(std::span<const PoseSE2> from, std::span<const PoseSE2> to) {
  if (impl_->nothing_near(from, to)) return free_until_end;
  impl_->lines(from, to);
  return impl_->answered(0, 1, [&] { return impl_->on_lines(from, false); });
}

MapFinding MapQuery::passes(std::span<const PoseSE2> from, std::span<const PoseSE2> to) {
  if (impl_->nothing_near(from, to)) return free_until_end;
  impl_->lines(from, to);
  return impl_->answered(0, 1, [&] { return impl_->on_lines(from, true); });
}

MapFinding MapQuery::along(std::span<const Motion> motions, double start, double end) {
  return impl_->answered(start, end, [&] { return impl_->on_motions(motions, start, end, false); });
}

MapFinding MapQuery::passes(std::span<const Motion> motions, double start, double end) {
  return impl_->answered(start, end, [&] { return impl_->on_motions(motions, start, end, true); });
}

const std::string& MapQuery::reason() const { return impl_->reason; }

}  // namespace taut
