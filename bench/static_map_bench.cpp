// Questions to a map of 10,000 obstacles: nothing near, and random ways, of which most end in a contact; the same by a
// planner's query, which must not allocate where nothing is near.
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "bench.hpp"
#include "heap.hpp"
#include "taut/map_query.hpp"
#include "taut/motions.hpp"
#include "taut/static_map.hpp"

namespace taut::bench {
namespace {

using Random = std::mt19937;

double share(Random& random) { return std::uniform_real_distribution<double>(0, 1)(random); }

/// 100 by 100 blocks, 4 apart, of 12 vertices, a tenth with a courtyard.
std::vector<Body> city() {
  Random random(1);
  std::vector<Body> blocks;
  for (int i = 0; i < 10000; ++i) {
    const double x = 4 * (i % 100), y = 4 * (i / 100);
    Polygon outline, yard;
    for (int k = 0; k < 12; ++k) {
      const double angle = k * 3.14159265358979 / 6, radius = 1 + 0.5 * share(random);
      outline.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
      yard.push_back({x + 0.5 * std::cos(angle), y + 0.5 * std::sin(angle)});
    }
    Body block;
    block.name = "block" + std::to_string(i);
    if (i % 10 == 0) {
      block.parts = {{outline, {yard}}};
    } else {
      block.polygon = outline;
    }
    blocks.push_back(block);
  }
  return blocks;
}

const StaticMap& city_map() {
  static const StaticMap map(city());
  return map;
}

/// A cart, a tenth as wide as it is long.
StaticMap::Mover cart(double half) {
  Body body;
  body.name = "cart";
  body.polygon = {{-half, -half / 10}, {half, -half / 10}, {half, half / 10}, {-half, half / 10}};
  return city_map().prepare(body);
}

Motion way(double x, double y, double to_x, double to_y, double deg) {
  return from_keyframes({{0, x, y, 0}, {1, to_x, to_y, deg}});
}

/// A crossing of two streets.
Point crossing(Random& random, int blocks) {
  return {4 * std::floor(share(random) * blocks) + 2, 4 * std::floor(share(random) * blocks) + 2};
}

void ask(benchmark::State& state, double half, const std::function<Motion(Random&)>& made) {
  const StaticMap::Mover mover = cart(half);
  Random random(2);
  std::vector<Motion> ways;
  for (int i = 0; i < 500; ++i) ways.push_back(made(random));
  std::uint64_t near = 0, free = 0, asked = 0;
  for (const Motion& motion : ways) city_map().check(mover, motion, 0, 1);  // prepares what it comes near to
  for (auto _ : state) {
    const Answer answer = city_map().check(mover, ways[asked % ways.size()], 0, 1);
    near += answer.coverage.tested;
    free += answer.outcome == Outcome::free ? 1 : 0;
    ++asked;
  }
  state.counters["near"] = static_cast<double>(near) / static_cast<double>(asked);
  state.counters["free"] = static_cast<double>(free) / static_cast<double>(asked);
}

void state_of(benchmark::State& state) {
  const StaticMap::Mover mover = cart(0.3);
  Random random(3);
  std::vector<Motion> placements;
  for (int i = 0; i < 500; ++i) {
    const Point at = crossing(random, 90);
    Motion motion;
    motion.pieces = {{{at.x}, {at.y}, AngleRotation{{share(random)}}}};
    placements.push_back(motion);
  }
  std::size_t asked = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(city_map().overlapped(mover, placements[asked++ % placements.size()], 0));
  }
}

/// From one pose to another.
struct Edge {
  PoseSE2 from, to;
};

/// About 0.2 long and turning by 0.3, in the middle of a crossing.
Edge far_edge(Random& random) {
  const Point at = crossing(random, 90);
  return {{at.x - 0.1, at.y, 0}, {at.x + 0.1, at.y, 0.3}};
}

/// To and fro before a house: one is near, and nothing else.
Edge near_edge(Random& random) {
  const Point at = crossing(random, 90);
  return {{at.x - 0.9, at.y - 0.9, 2.3}, {at.x - 0.8, at.y - 0.8, 2.4}};
}

/// Lengthwise along a street past twenty houses, which are within the cart's reach if it should turn.
Edge street_edge(Random& random) {
  const Point at = crossing(random, 80);
  return {{at.x, at.y, 1.5}, {at.x, at.y + 40, 1.7}};
}

Edge any_edge(Random& random) {
  const Point at{400 * share(random), 400 * share(random)};
  return {{at.x, at.y, 0}, {at.x + 4 * share(random), at.y + 4 * share(random), 1.57 * share(random)}};
}

void query(benchmark::State& state, double half, const std::function<Edge(Random&)>& made, bool place, bool allocates) {
  MapQuery asked_of(city_map(), cart(half));
  Random random(2);
  std::vector<Edge> edges;
  // More than a query remembers.
  for (int i = 0; i < 20000; ++i) edges.push_back(made(random));
  const auto ask_one = [&](const Edge& e) { return place ? asked_of.at(e.from) : asked_of.passes(e.from, e.to); };
  for (const Edge& e : edges) ask_one(e);
  std::uint64_t free = 0, asked = 0;
  const std::uint64_t before = heap_use().allocations;
  for (auto _ : state) free += ask_one(edges[asked++ % edges.size()]).free() ? 1 : 0;
  const std::uint64_t allocated = heap_use().allocations - before;
  if (!allocates && allocated > 0) state.SkipWithError("a question where nothing is near has allocated memory");
  state.counters["free"] = static_cast<double>(free) / static_cast<double>(asked);
  state.counters["allocations"] = static_cast<double>(allocated) / static_cast<double>(asked);
}

void register_queries() {
  const auto add = [](const char* name, const std::function<Edge(Random&)>& made, bool place, bool allocates,
                      double half = 0.3) {
    benchmark::RegisterBenchmark(("map_query/" + std::string(name)).c_str(), [made, place, allocates,
                                                                              half](benchmark::State& state) {
      query(state, half, made, place, allocates);
    })->Unit(benchmark::kMicrosecond);
  };
  add("place/nothing_near", far_edge, true, false);
  add("place/random", any_edge, true, true);
  add("edge/nothing_near", far_edge, false, false);
  add("edge/one_near", near_edge, false, true);
  add("edge/twenty_near", street_edge, false, true, 0.9);
  add("edge/random", any_edge, false, true);
}

}  // namespace

void register_static_map(bool) {
  register_queries();
  const auto add = [](const char* name, double half, const std::function<Motion(Random&)>& made) {
    benchmark::RegisterBenchmark(("static_map/" + std::string(name)).c_str(), [half, made](benchmark::State& state) {
      ask(state, half, made);
    })->Unit(benchmark::kMicrosecond);
  };
  add("nothing_near/straight", 0.3, [](Random& random) {
    const Point at = crossing(random, 90);
    return way(at.x - 0.1, at.y, at.x + 0.1, at.y, 0);
  });
  add("nothing_near/turning", 0.3, [](Random& random) {
    const Point at = crossing(random, 90);
    return way(at.x - 0.1, at.y, at.x + 0.1, at.y, 30);
  });
  add("random", 0.3, [](Random& random) {
    const Point at{400 * share(random), 400 * share(random)};
    return way(at.x, at.y, at.x + 4 * share(random), at.y + 4 * share(random), 90 * share(random));
  });
  benchmark::RegisterBenchmark("static_map/state", state_of)->Unit(benchmark::kMicrosecond);
}

}  // namespace taut::bench
