#include "animation.hpp"

#include <fmt/format.h>

#include <optional>

#include "pair/validate_scene.hpp"
#include "report.hpp"
#include "taut/motions.hpp"
#include "taut/simulation.hpp"
#include "world_pictures.hpp"

namespace taut::cli {
using namespace internal;

namespace {

/// Larger files are slow to load where pages show them as images.
constexpr std::size_t largest_file = 200000;
constexpr int most_frames = 120, fewest_frames = 30;

/// The first contact, if there is one.
std::optional<Contact> first_contact(const Scene& scene, Touch touch) {
  Simulation simulation(scene, touch);
  simulation.advance_to(scene.end);
  return simulation.contact();
}

std::vector<Tiling> frames(const Scene& scene, Touch touch, double end, int count) {
  Simulation simulation(scene, touch);
  std::vector<Tiling> out{simulation.tiling()};
  for (int k = 1; k < count; ++k) {
    // The last frame is the contact itself, up to rounding of `end`.
    simulation.advance_to(k + 1 == count ? scene.end : scene.start + (end - scene.start) * k / (count - 1));
    out.push_back(simulation.tiling());
  }
  return out;
}

std::string ending(const Scene& scene, const std::optional<Contact>& contact) {
  if (!contact) return "free";
  const auto angle = contact_angle(scene, *contact);
  if (angle) return fmt::format("contact at {:.6g}°", angle->lo);
  return fmt::format("contact at t = {:.6g}", contact->time.lo);
}

}  // namespace

std::string animation(const Scene& scene, Touch touch, AnimateOptions options) {
  if (!is_ring_pair(scene)) {
    CheckOptions asked;
    asked.touch = touch;
    asked.tell_touching = false;
    return world_animation(scene, check(scene, asked), {options.edges, touch}, {.draw = {.width = options.width}});
  }
  const std::optional<Contact> contact = first_contact(scene, touch);
  options.contact = contact ? &*contact : nullptr;
  options.ending = ending(scene, contact);
  options.free = !contact;
  const double end = contact ? contact->time.lo : scene.end;
  std::string svg;
  for (int count = most_frames; count >= fewest_frames; count /= 2) {
    svg = animate_svg(scene, frames(scene, touch, end, count), options);
    if (svg.size() <= largest_file) return svg;
  }
  options.edges = false;
  return animate_svg(scene, frames(scene, touch, end, most_frames), options);
}

}  // namespace taut::cli
