#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coverage_text.hpp"
#include "feature_text.hpp"
#include "io/text.hpp"
#include "motion/loop_equations.hpp"
#include "taut/motions.hpp"

namespace taut::cli {

namespace {

/// The value of a driven joint, as far as doubles show it.
double value_at(const Drive& drive, double t) {
  const auto holds = [t](const Drive::Piece& piece) { return t < piece.until; };
  const auto found = std::find_if(drive.pieces.begin(), drive.pieces.end(), holds);
  const Drive::Piece& piece = found == drive.pieces.end() ? drive.pieces.back() : *found;
  using Value = internal::Series<double, 0>;
  return internal::drive_value(piece, Value::constant(t)).c[0].mid;
}

/// The values of the mechanism's driven joints at a time.
std::string drives_text(const Scene& scene, const TimeInterval& time) {
  if (!scene.mechanism) return "";
  std::string text;
  for (const Drive& drive : scene.mechanism->drives) {
    const double value = value_at(drive, time.lo + (time.hi - time.lo) / 2);
    text += fmt::format("{}{} = {:.9g}", text.empty() ? "   (" : ", ", drive.joint, value);
  }
  return text.empty() ? "" : text + ")";
}

/// The angle of a sweep, or the values of the driven joints.
std::string angle_text(const Scene& scene, const Contact& contact) {
  const auto angle = contact_angle(scene, contact);
  return angle ? fmt::format("   (angle {:.9g} deg)", angle->lo + (angle->hi - angle->lo) / 2)
               : drives_text(scene, contact.time);
}

std::string first_line(const Scene& scene, const Answer& answer) {
  const std::string pair = subject_text(scene, answer.pair);
  switch (answer.outcome) {
    case Outcome::free:
      return "FREE  " + pair;
    case Outcome::contact:
      return "CONTACT  " + pair + "   t = " + time_text(answer.contact->time) + angle_text(scene, *answer.contact);
    case Outcome::overlap_at_start:
      return fmt::format("OVERLAP AT START  {}   t = {}", pair, scene.start);
    case Outcome::undecided:
      return "UNDECIDED  " + pair;
    case Outcome::locked:
      return fmt::format("LOCKED  {}   t = {}{}", pair, time_text({scene.lock->time[0], scene.lock->time[1]}),
                         drives_text(scene, {scene.lock->time[0], scene.lock->time[1]}));
    case Outcome::untested:
      return "UNTESTED  " + pair;
    case Outcome::closer_at_start:  // is no answer of check()
      break;
  }
  return pair;
}

/// What to do where links that share a joint overlap as they are drawn.
std::string pin_text(const Scene& scene, const Answer& answer) {
  if (!scene.mechanism || !answer.pair) return "";
  const std::string& a = scene.bodies[static_cast<std::size_t>((*answer.pair)[0])].name;
  const std::string& b = scene.bodies[static_cast<std::size_t>((*answer.pair)[1])].name;
  for (const MechanismJoint& joint : scene.mechanism->joints) {
    if ((joint.first != a || joint.second != b) && (joint.first != b || joint.second != a)) continue;
    return fmt::format("  they share the joint {}: put them on layers (\"z\"), or the pair into \"ignore\"\n",
                       joint.name);
  }
  return "";
}

const char* const grazing_means =
    "  grazing: how deep they are then, or whether they just touch, is below 2^-150 of their size\n";

std::string witness(const Scene& scene, const Contact& contact) {
  return fmt::format("  {} meets {} at ({:.9g}, {:.9g})\n", vertex_text(scene, contact.vertex),
                     edge_text(scene, contact.edge), contact.point.x, contact.point.y);
}

/// Of bodies that stay free.
std::string touching(const Scene& scene, const Contact& contact) {
  return fmt::format("  they touch, first at t = {}, but overlap by less than 2^-150 of their size\n{}",
                     time_text(contact.time), witness(scene, contact));
}

std::string pair_name(const Scene& scene, const PairAnswer& pair) {
  return scene.bodies[static_cast<std::size_t>(pair.bodies[0])].name + " x " +
         scene.bodies[static_cast<std::size_t>(pair.bodies[1])].name;
}

/// Other pairs to which it happens at the same time, as far as is known: the first few, unless all pairs follow.
std::string also(const Scene& scene, const Answer& answer) {
  constexpr std::size_t most = 10;
  if (answer.pairs) return "";
  std::string text;
  const std::size_t n = answer.also.size(), shown = n > most ? most : n;
  for (std::size_t i = 0; i < shown; ++i) text += "  also " + pair_name(scene, answer.also[i]) + "\n";
  return n > shown ? text + fmt::format("  and {} more pairs (--pairs all)\n", n - shown) : text;
}

/// One pair of all.
std::string pair_line(const Scene& scene, const PairAnswer& pair) {
  const std::string at = pair.contact ? "   t = " + time_text(pair.contact->time) : "";
  return fmt::format("    {:<16}  {}{}\n", to_string(pair.outcome), pair_name(scene, pair), at);
}

/// What it took: events, engines, seconds.
std::string work(const Answer& answer) {
  const std::string seconds = seconds_text(answer.build_seconds + answer.run_seconds);
  if (!answer.compared && answer.engine == EngineName::spacetime) return fmt::format("spacetime engine, {}\n", seconds);
  return fmt::format("{} event{}, {}{}\n", answer.events, answer.events == 1 ? "" : "s",
                     answer.compared ? "two engines agree, " : "", seconds);
}

/// How well curves were known.
std::string geometry_text(const CurveGeometry& geometry) {
  return fmt::format("  curves known to {:.3g}, by {} straight edges\n", geometry.tolerance, geometry.segments);
}

std::string proved(const Scene& scene, const Answer& answer, Touch touch) {
  std::string interval = fmt::format("[{}, {}]", scene.start, scene.end);
  if (answer.outcome == Outcome::contact || answer.outcome == Outcome::undecided) {
    const double until = answer.contact ? answer.contact->time.lo : answer.free_until;
    if (!(until > scene.start)) return "  " + work(answer);
    interval = fmt::format("[{}, {})", scene.start, until);
  }
  return fmt::format("  proved free on {}{}   {}", interval, touch == Touch::closed ? ", touching included" : "",
                     work(answer));
}

}  // namespace

std::string instant_text(const Scene& scene, double t) {
  return internal::io::instant_text(t, scene.start, scene.end, 9);
}

std::string time_text(const TimeInterval& time) {
  if (time.lo == time.hi) return fmt::format("{}", time.lo);
  const std::string lo = fmt::format("{:.17g}", time.lo), hi = fmt::format("{:.17g}", time.hi);
  const auto exponent = [](const std::string& s) { return s.find('e') == s.npos ? "" : s.substr(s.find('e')); };
  const auto end = std::mismatch(lo.begin(), lo.end(), hi.begin(), hi.end()).first;
  const std::string common(lo.begin(), end);
  const auto digits = std::count_if(common.begin(), common.end(), [](char c) { return c >= '0' && c <= '9'; });
  // 0.9999 and 1.0001 share no digit at all; the point shows that the integer part is complete.
  if (digits < 5 || common.find('.') == common.npos || exponent(lo) != exponent(hi)) {
    return fmt::format("[{}, {}]", time.lo, time.hi);
  }
  return common + "…" + exponent(lo);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string seconds_text(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.0f} us", seconds * 1e6);
  if (seconds < 1) return fmt::format("{:.3g} ms", seconds * 1e3);
  return fmt::format("{:.3g} s", seconds);
}

std::string lock_text(const Scene& scene) {
  if (!scene.lock || scene.lock->kind == MechanismLock::Kind::undecided) return "";
  const MechanismLock& lock = *scene.lock;
  const auto list = [](const std::vector<std::string>& names) {
    std::string s;
    for (const std::string& name : names) s += (s.empty() ? "" : ", ") + name;
    return s;
  };
  const std::string text = fmt::format("  the mechanism locks at t = {} ({}): {} in line",
                                       time_text({lock.time[0], lock.time[1]}), to_string(lock.kind), list(lock.links));
  return text + (lock.joints.empty()
                     ? "\n"
                     : fmt::format("; joints that could move there with the drives held: {}\n", list(lock.joints)));
}

std::string grounds_text(const Scene& scene, const Coverage& coverage) {
  return coverage_text(coverage) + lock_text(scene);
}

std::string report(const Scene& scene, const Answer& answer, Touch touch) {
  std::string text = first_line(scene, answer) + "\n";
  if (answer.outcome == Outcome::untested) return text + "  " + answer.reason + "\n";
  text += grounds_text(scene, answer.coverage);
  if (answer.contact) text += witness(scene, *answer.contact);
  if (answer.contact && answer.contact->grazing) text += grazing_means;
  if (answer.touching) text += touching(scene, *answer.touching);
  if (!answer.touching_undecided.empty())
    text += "  whether they touch was not decided: " + answer.touching_undecided + "\n";
  text += also(scene, answer);
  if (answer.pairs) {
    for (const PairAnswer& pair : *answer.pairs) text += pair_line(scene, pair);
  }
  if (answer.outcome == Outcome::overlap_at_start) {
    const auto& inside = answer.overlap_point;
    text += "  the bodies overlap already when the motion starts";
    text += inside ? fmt::format(": ({}, {}) is inside both", inside->x, inside->y)
                   : ": by too little for a point to be named that is inside both";
    return text + "\n" + pin_text(scene, answer);
  }
  if (answer.outcome == Outcome::undecided) text += "  " + answer.reason + "\n";
  if (answer.fit > 0) text += fmt::format("  of bodies shrunk by {:.9g} to {:.9g}\n", answer.fit, 2 * answer.fit);
  if (answer.geometry) text += geometry_text(*answer.geometry);
  return text + proved(scene, answer, touch);
}

}  // namespace taut::cli
