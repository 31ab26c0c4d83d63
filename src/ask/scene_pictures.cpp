#include "ask/scene_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "scene/curved_world.hpp"
#include "scene/untested.hpp"
#include "taut/motions.hpp"

namespace taut::internal {
namespace {

/// Larger files are slow to load where pages show them as images.
constexpr std::size_t largest_moving_world = 200000;
constexpr int fewest_world_frames = 30;
constexpr std::size_t most_bodies_with_moving_tilings = 100;

/// The last instant of which something is known.
double end_of(const Scene& scene, const Answer& answer) {
  switch (answer.outcome) {
    case Outcome::contact:
      return answer.contact->time.lo;
    case Outcome::overlap_at_start:
      return scene.start;
    case Outcome::undecided:
      return answer.free_until;
    default:
      return scene.end;
  }
}

std::string name_of(const Scene& scene, BodyId body) { return scene.bodies[static_cast<std::size_t>(body)].name; }

std::string pair_of(const Scene& scene, const Answer& answer) {
  const auto [a, b] = answer.pair.value_or(std::array{0, 1});
  return name_of(scene, a) + " x " + name_of(scene, b);
}

std::string ending_of(const Scene& scene, const Answer& answer) {
  switch (answer.outcome) {
    case Outcome::contact:
      if (const auto angle = contact_angle(scene, *answer.contact)) return fmt::format("contact at {:.6g}°", angle->lo);
      return fmt::format("contact at t = {:.6g}", answer.contact->time.lo);
    case Outcome::overlap_at_start:
      return "overlap at the start";
    case Outcome::undecided:
      return fmt::format("undecided from t = {:.6g}", answer.free_until);
    case Outcome::locked:
      return fmt::format("locks at t = {:.6g}", scene.lock->time[0]);
    case Outcome::untested:
      return scene.bodies.size() == 1 ? "" : "nothing was tested";
    case Outcome::closer_at_start:  // is no answer of check()
    case Outcome::free:
      break;
  }
  return "free" + untested_note(answer.coverage);
}

}  // namespace

std::string world_picture(const Scene& scene, const Answer& answer, std::optional<double> at, const DrawnTilings& how,
                          DrawOptions options) {
  const double end = end_of(scene, answer), t = std::min(at.value_or(end), end);
  if (how.wanted && !has_curves(scene)) options.tilings = tilings_of_near_pairs(scene, t, how.touch);
  return draw_svg(scene, t, t == end ? marked(answer, options) : options);
}

std::string world_animation(const Scene& scene, const Answer& answer, const DrawnTilings& how, AnimateOptions options) {
  if (how.wanted && !has_curves(scene) && scene.bodies.size() <= most_bodies_with_moving_tilings)
    options.tilings = [&](double t) { return tilings_of_near_pairs(scene, t, how.touch); };
  options.draw = marked(answer, options.draw);
  options.ending = ending_of(scene, answer);
  options.free = answer.outcome == Outcome::free;
  std::string svg;
  for (;; options.frames /= 2) {
    svg = animate_svg(scene, end_of(scene, answer), options);
    if (svg.size() <= largest_moving_world) return svg;
    if (options.frames / 2 >= fewest_world_frames) continue;
    if (!options.tilings) return svg;
    options.tilings = {};
    options.frames = 2 * AnimateOptions().frames;
  }
}

std::string world_animation(const Scene& scene, const DrawnTilings& how, AnimateOptions options) {
  CheckOptions asked;
  asked.touch = how.touch;
  asked.tell_touching = false;
  return world_animation(scene, check(scene, asked), how, std::move(options));
}

std::string world_note(const Scene& scene, const Answer& answer, std::optional<double> at) {
  const double end = end_of(scene, answer);
  if (answer.outcome == Outcome::overlap_at_start)
    return fmt::format("{} overlap at the start; drawing that instant", pair_of(scene, answer));
  if (answer.outcome == Outcome::undecided && at.value_or(scene.end) > end)
    return fmt::format("undecided from t = {} on ({}); drawing that instant", end, answer.reason);
  if (answer.outcome == Outcome::contact && at && *at > end)
    return fmt::format("{} touch at t = {}; drawing that instant", pair_of(scene, answer), end);
  return "";
}

}  // namespace taut::internal
