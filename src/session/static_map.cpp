#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "motion/pieces.hpp"
#include "numeric/budget.hpp"
#include "numeric/errors.hpp"
#include "scene/joined_parts.hpp"
#include "scene/untested.hpp"
#include "scene/validate_scene.hpp"
#include "session/static_map_parts.hpp"
#include "solver/earliest.hpp"
#include "solver/run.hpp"
#include "taut/grid.hpp"
#include "taut/static_map.hpp"

namespace taut {

using namespace internal;
namespace {

using Clock = std::chrono::steady_clock;

/// The scene of these bodies at rest.
Scene resting(std::vector<Body> bodies) {
  Scene scene;
  scene.bodies = std::move(bodies);
  return scene;
}

void expect_rest(const Body& body) {
  const bool rests = std::all_of(body.motion.pieces.begin(), body.motion.pieces.end(),
                                 [](const MotionPiece& piece) { return same_motion(piece, MotionPiece{}); });
  if (!rests || !body.relative_to.empty())
    throw InputError(body.name, "the body moves, or is relative to another one",
                     "a map is of bodies at rest in the world's frame; ask `check` about scenes of moving ones");
}

/// The range of the magnitudes of all nonzero coordinates.
ShapeFacts range_of(const std::vector<Body>& bodies) {
  ShapeFacts range;
  range.least = INFINITY;
  for (const Body& body : bodies) {
    for (const Part& part : parts_of(body)) {
      for (std::size_t k = 0; k <= part.holes.size(); ++k) {
        const ShapeFacts facts = facts_of(k == 0 ? part.outline : part.holes[k - 1]);
        range.least = std::min(range.least, facts.least);
        range.largest = std::max(range.largest, facts.largest);
      }
    }
  }
  return range;
}

std::vector<AxisBox> boxes_of(const std::vector<SharedRings>& rings) {
  std::vector<AxisBox> boxes;
  for (const SharedRings& r : rings) {
    InstanceBody body;
    body.rings = r;
    boxes.push_back(swept_box(body, 0, 0));
  }
  return boxes;
}

MapBodies prepared_bodies(const std::vector<Body>& bodies, double largest) {
  int exponent = 0;
  std::frexp(largest, &exponent);
  MapBodies all;
  double extent = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (const CrossSection& section : cross_sections_of(bodies[i])) {
      all.rings.push_back(std::make_shared<const RingSet>(bodies[i], static_cast<int>(i), -exponent, section.parts));
      all.z.push_back(section.z);
      all.layered = all.layered || !(section.z == Layers{});
      extent = std::max(extent, std::ldexp(diagonal(all.rings.back()->bounds()), exponent));
    }
  }
  all.boxes_of = boxes_of(all.rings);
  all.boxes = BoxTree(all.boxes_of);
  all.exponent = -exponent;
  all.extent = extent;
  return all;
}

/// One query, and its answer so far.
class MapRun {
 public:
  MapRun(const MapBodies& bodies, const StaticMap::Mover::Impl& mover, const Motion& motion, double start, double end,
         const CheckOptions& options)
      : bodies_(bodies), start_(start), end_(end), options_(options), scope_(options.limits) {
    mover_.rings = mover.rings;
    mover_.z = mover.z;
    const PieceList pieces = PieceList::between(motion, start, end, bodies.exponent);
    if (!pieces.rests()) mover_.motions.push_back(pieces);
  }

  Answer run() {
    Answer answer = asked(offset_for(options_.touch));
    if (answer.outcome != Outcome::free || options_.touch != Touch::open || !options_.tell_touching || !beyond_doubles_)
      return answer;
    // The bodies are free by an amount below the resolution of doubles: test whether they touch.
    try {
      const Answer touching = asked(Offset::outward);
      answer.touching = touching.contact;
      answer.run_seconds += touching.run_seconds;
      answer.touching_undecided = touching.reason;
    } catch (const InputError& refused) {
      answer.touching_undecided = refused.what();
    }
    return answer;
  }

 private:
  Answer asked(Offset offset) {
    const Clock::time_point begun = Clock::now();
    Answer answer;
    answer.engine = EngineName::spacetime;
    MapSearch search(bodies_, mover_, start_, end_, offset);
    std::string stopped;
    try {
      scope_.check();
      if (search.start()) search.run();
      answer.outcome = Outcome::free;
      answer.free_until = end_;
    } catch (const Interrupted& limit) {
      stopped = limit.reason;
    }
    conclude(search, stopped, answer);
    beyond_doubles_ = search.stages().beyond_doubles() > 0;
    answer.run_seconds = seconds_since(begun);
    return answer;
  }

  void conclude(MapSearch& search, const std::string& stopped, Answer& answer) const {
    std::vector<PairEvent> events;
    search.for_each_pair([&](const PairSolver& pair) {
      if (!pair.open()) events.push_back({answer_of(pair.result()), pair.instant()});
    });
    if (!stopped.empty()) {
      std::erase_if(events, [&](const PairEvent& e) { return !(time_of(e.pair) < search.proved()); });
      answer.outcome = Outcome::undecided;
      answer.free_until = search.proved();
      answer.reason = stopped;
    }
    take_earliest(earliest_of_each_pair(std::move(events)), answer);
    if (answer.outcome == Outcome::overlap_at_start && answer.pair)
      answer.overlap_point = search.common_point((*answer.pair)[0]);
    answer.coverage = coverage();
    answer.coverage.tested = search.tested();
    answer.coverage.apart -= search.tested();
    if (!stopped.empty() && !(search.proved() > start_))
      answer.coverage = coverage_when_stopped(answer.coverage, search.tested());
    if (!answer.coverage.is_empty()) return;
    answer.outcome = Outcome::untested;
    answer.reason = why_untested(answer.coverage);
  }

  /// Before any body is examined.
  Coverage coverage() const {
    std::set<int> all, reached;
    for (std::size_t k = 0; k < bodies_.rings.size(); ++k) {
      all.insert(bodies_.rings[k]->body());
      if (bodies_.z[k].meet(mover_.z)) reached.insert(bodies_.rings[k]->body());
    }
    Coverage coverage;
    coverage.pairs = all.size();
    coverage.apart = reached.size();
    coverage.layers = all.size() - reached.size();
    return coverage;
  }

  const MapBodies& bodies_;
  double start_, end_;
  const CheckOptions& options_;
  Budget scope_;
  InstanceBody mover_;
  bool beyond_doubles_ = false;
};

}  // namespace

StaticMap::StaticMap(std::vector<Body> bodies, double reach) {
  const auto impl = std::make_shared<Impl>();
  for (const Body& body : bodies) expect_rest(body);
  const Scene scene = resting(std::move(bodies));
  validate_polygons(scene);
  impl->bodies = scene.bodies;
  impl->range = range_of(impl->bodies);
  impl->largest = reach;
  for (const Body& body : impl->bodies) impl->largest = std::max(impl->largest, largest_coordinate(body));
  impl->prepared = prepared_bodies(impl->bodies, impl->largest);
  impl_ = impl;
}

std::size_t StaticMap::size() const { return impl_->bodies.size(); }

const Body& StaticMap::body(BodyId id) const { return impl_->bodies.at(static_cast<std::size_t>(id)); }

StaticMap::Mover StaticMap::prepare(const Body& body) const {
  Body shape = body;
  shape.motion = {};
  shape.relative_to.clear();
  validate_polygons(resting({shape}));
  validate_range(impl_->range, range_of({shape}));
  if (largest_coordinate(shape) > impl_->largest)
    throw InputError(body.name, "the shape has coordinates beyond the map's reach",
                     "give the map a larger `reach`, or the shape coordinates about its own middle");
  const std::vector<CrossSection> sections = cross_sections_of(shape);
  if (sections.size() > 1)
    throw InputError(
        body.name, "the shape has parts on different layers",
        "prepare its parts of each layer as shapes of their own; a robot can have one as a link on the other");
  const auto mover = std::make_shared<Mover::Impl>();
  mover->z = sections[0].z;
  mover->name = body.name;
  mover->rings = std::make_shared<const RingSet>(shape, static_cast<int>(size()), impl_->prepared.exponent);
  mover->bounds = mover->rings->input_bounds();
  mover->extent = std::max(impl_->prepared.extent, diagonal(mover->bounds));
  mover->map = impl_.get();
  return Mover(mover);
}

Answer StaticMap::check(const Mover& mover, const Motion& motion, double start, double end,
                        const CheckOptions& options) const {
  if (mover.impl_->map != impl_.get())
    throw InputError(mover.name(), "the mover was prepared for another map", "prepare it for this one");
  Scene time;
  time.start = start;
  time.end = end;
  validate_time(time);
  validate_motion(motion, mover.name(), mover.impl_->bounds, start, end, mover.impl_->extent);
  return MapRun(impl_->prepared, *mover.impl_, motion, start, end, options).run();
}

std::optional<BodyId> StaticMap::overlapped(const Mover& mover, const Motion& motion, double t, Touch touch) const {
  CheckOptions options;
  options.touch = touch;
  options.tell_touching = false;
  const Answer answer = check(mover, motion, t, t, options);
  if (answer.outcome == Outcome::undecided) throw UndecidedError(answer.reason);
  if (answer.outcome == Outcome::free) return std::nullopt;
  return (*answer.pair)[0];
}

const std::string& StaticMap::Mover::name() const { return impl_->name; }

using namespace internal;

StaticMap StaticMap::from_grid(const OccupancyGrid& grid, double reach) { return StaticMap(grid_bodies(grid), reach); }

StaticMap StaticMap::from_grid(const std::string& yaml_file, double reach) {
  return from_grid(read_grid(yaml_file), reach);
}

}  // namespace taut
