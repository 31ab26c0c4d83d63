// StaticMap for the npm package.
#include <emscripten.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ask/map_answer.hpp"
#include "ask/question.hpp"
#include "io/json_writer.hpp"
#include "numeric/budget.hpp"
#include "replies.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/static_map.hpp"

namespace taut::web {
using namespace internal;
namespace {

/// A map, and what was prepared to move in it.
struct OpenMap {
  StaticMap map;
  std::vector<std::pair<StaticMap::Mover, Body>> movers = {};
};

std::map<int, OpenMap> maps;
int last_map = 0;

OpenMap& map_of(int id) {
  const auto found = maps.find(id);
  if (found == maps.end()) throw InputError("", "the map was freed", "make another one");
  return found->second;
}

/// The options of questions about maps, read and checked as those of others are.
CheckOptions map_options(const char* text) {
  static const QuestionEntry entry{"map", "", "", {touch_option(), max_seconds_option()}};
  const Question asked{"map", text};
  return GivenOptions(asked, entry).check();
}

}  // namespace
}  // namespace taut::web

using namespace taut;
using namespace taut::web;

extern "C" {

/// The number by which later calls name the map of the scene's bodies.
EMSCRIPTEN_KEEPALIVE const char* taut_map_open(const char* scene, double reach) {
  return replied([&] {
    maps.insert_or_assign(++last_map, OpenMap{StaticMap(parse_scene(scene, "map").bodies, reach)});
    return std::to_string(last_map);
  });
}
EMSCRIPTEN_KEEPALIVE const char* taut_map_close(int id) {
  maps.erase(id);
  return "null";
}
/// The number of the scene's only body among the map's movers.
EMSCRIPTEN_KEEPALIVE const char* taut_map_prepare(const char* scene, int id) {
  return replied([&] {
    OpenMap& open = map_of(id);
    Body body = parse_scene(scene, "mover").bodies.at(0);
    StaticMap::Mover mover = open.map.prepare(body);
    open.movers.emplace_back(std::move(mover), std::move(body));
    return std::to_string(open.movers.size() - 1);
  });
}
/// The answer, whose scope names no bodies. `scene` has one body, with the motion, on the time that is asked about.
EMSCRIPTEN_KEEPALIVE const char* taut_map_check(const char* scene, const char* options, int id, int mover) {
  return replied([&] {
    const OpenMap& open = map_of(id);
    const CheckOptions how = map_options(options);
    const Scene asked = parse_scene(scene, "motion");
    Body body = open.movers.at(static_cast<std::size_t>(mover)).second;
    body.motion = asked.bodies.at(0).motion;
    const Answer answer =
        open.map.check(open.movers[static_cast<std::size_t>(mover)].first, body.motion, asked.start, asked.end, how);
    const MapAnswerText found = map_answer_text(open.map, body, asked.start, asked.end, answer, how.touch);
    return found.before + found.after;
  });
}
/// The number of a body of the map, or -1, at the end of the scene's time.
EMSCRIPTEN_KEEPALIVE const char* taut_map_overlapped(const char* scene, const char* options, int id, int mover) {
  return replied([&] {
    const OpenMap& open = map_of(id);
    const CheckOptions how = map_options(options);
    const Budget scope(how.limits);
    const Scene asked = parse_scene(scene, "motion");
    const StaticMap::Mover& moving = open.movers.at(static_cast<std::size_t>(mover)).first;
    return std::to_string(open.map.overlapped(moving, asked.bodies.at(0).motion, asked.end, how.touch).value_or(-1));
  });
}

}  // extern "C"
