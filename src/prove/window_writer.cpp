#include "prove/window_writer.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <set>

#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

using proof::BodyPairs;
using proof::OpenPairs;
using proof::StatedBox;
using proof::WorldTime;

/// The maximum depth of halved windows.
constexpr int deepest_written = 30;
/// The boxes of half a window are much shorter if those of the window are this many times as long as the bodies' own.
constexpr double long_beside = 1.5;
/// If there are at most this many bodies, all pairs are tested.
constexpr int few_bodies = 12;
/// A box is worth its bytes if it separates a body from this many others.
constexpr int pairs_for_a_box = 4;
/// Or, if it turns by more than this, from any.
constexpr double angle_for_a_box = 64;
/// The margin of boxes relative to their length, so that verifiers with coarser bounds accept them, too.
constexpr double share_of_room = 0x1p-12;

float not_above(double x) {
  if (!(x > -3e38)) return -std::numeric_limits<float>::infinity();
  const float f = static_cast<float>(std::min(x, 3e38));
  return static_cast<double>(f) <= x ? f : std::nextafter(f, -std::numeric_limits<float>::infinity());
}
float not_below(double x) { return -not_above(-x); }

/// Enlarges the box along each axis by a share of its length: the box of a body that moves along a lane stays within
/// the lane.
StatedBox around(const AxisBox& b, double room) {
  const double least = room + 0x1p-40 * (std::fabs(b.lo_x) + std::fabs(b.hi_x) + std::fabs(b.lo_y) + std::fabs(b.hi_y));
  const double x = least + share_of_room * (b.hi_x - b.lo_x), y = least + share_of_room * (b.hi_y - b.lo_y);
  return {not_above(b.lo_x - x), not_above(b.lo_y - y), not_below(b.hi_x + x), not_below(b.hi_y + y)};
}

/// The intersection of both boxes. The borders of the second are those of stated boxes, so that nothing is rounded.
StatedBox within(const StatedBox& a, const AxisBox& b) {
  return {std::max(a.lo_x, static_cast<float>(b.lo_x)), std::max(a.lo_y, static_cast<float>(b.lo_y)),
          std::min(a.hi_x, static_cast<float>(b.hi_x)), std::min(a.hi_y, static_cast<float>(b.hi_y))};
}

void put_f32(std::string& out, float x) {
  std::uint32_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  for (int i = 0; i < 4; ++i) out.push_back(static_cast<char>(bits >> (8 * i) & 0xff));
}

}  // namespace

WindowWriter::WindowWriter(const proof::VerifierScene& scene, double room, const Pair& except, std::string& out,
                           Section section)
    : scene_(scene),
      room_(room),
      except_(except),
      out_(out),
      section_(std::move(section)),
      boxes_(scene, room),
      fresh_(static_cast<std::size_t>(scene.size())) {
  for (int i = 0; i < scene.size(); ++i) {
    const AxisBox& b = scene[i].rings->bounds();
    sizes_.push_back(diagonal(b));
    fresh_[static_cast<std::size_t>(i)].reach = {b.lo_x, b.lo_y, b.hi_x, b.hi_y};
  }
}

WindowWriter::Fresh WindowWriter::fresh_box(int body, const WorldTime& time) const {
  checkpoint();
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const std::optional<AxisBox> reach = proof::box_around(scene_[body], time);
  if (!reach) return {{-infinite, -infinite, infinite, infinite}, {}};
  const StatedBox box = around(*reach, room_);
  // Doubles do not decide, for example if coordinates are beyond the range of single precision.
  if (!proof::has_room(box, room_, *reach)) return {*reach, {}};
  return {*reach, within(box, boxes_.of(body))};
}

/// Directions between ranges of edges would have to be found again and again.
bool WindowWriter::turns_often(int body, const WorldTime& time) const {
  const MotionChain& motions = scene_[body].motions;
  return std::any_of(motions.begin(), motions.end(), [&](const PieceList& motion) {
    const auto last = motion.last_rates(time.to);
    return last && std::max(std::fabs(last->turn), std::fabs(last->orbit)) * (time.to - time.from) > angle_for_a_box;
  });
}

/// If few pairs are listed: does a body's box separate enough of them? If all pairs are open, every box does.
std::vector<bool> WindowWriter::worth_stating(const std::vector<int>& moving, const OpenPairs& open,
                                              const WorldTime& time) {
  if (open.all()) return std::vector<bool>(moving.size(), true);
  std::map<int, int> pairs_decided;
  const auto box = [&](int i) {
    const Fresh& fresh = fresh_[static_cast<std::size_t>(i)];
    return !scene_[i].rests() && fresh.box ? as_doubles(*fresh.box) : boxes_.of(i);
  };
  for (const auto& [a, b] : *open.listed) {
    if (!boxes_.meet(a, b) || box(a).meets(box(b))) continue;
    ++pairs_decided[a];
    ++pairs_decided[b];
  }
  std::vector<bool> worth;
  for (const int i : moving) {
    const int decided = pairs_decided[i];
    worth.push_back(decided >= pairs_for_a_box || (decided > 0 && turns_often(i, time)));
  }
  return worth;
}

/// Would the boxes of halves be much shorter, and do so many pairs meet now that a list of them is long?
bool WindowWriter::better_halved(const std::vector<int>& moving) const {
  const auto longer = std::count_if(moving.begin(), moving.end(), [&](int i) {
    return fresh_[static_cast<std::size_t>(i)].reach.longest() > long_beside * sizes_[static_cast<std::size_t>(i)];
  });
  if (2 * static_cast<std::size_t>(longer) < moving.size()) return false;
  proof::WindowBoxes stated = boxes_;
  for (const int i : moving) {
    if (const auto& box = fresh_[static_cast<std::size_t>(i)].box) stated.state(i, as_doubles(*box));
  }
  return !stated.meeting(scene_, 4 * static_cast<std::size_t>(scene_.size()));
}

/// The bodies with so many open pairs that a box may be worth its bytes in a shorter window.
std::set<int> crowded_bodies(const std::vector<WindowWriter::Pair>& pairs) {
  std::map<int, int> count;
  std::set<int> crowded;
  for (const auto& [a, b] : pairs) {
    for (const int body : {a, b}) {
      if (++count[body] == pairs_for_a_box) crowded.insert(body);
    }
  }
  return crowded;
}

/// Could shorter windows separate the pair? Not if there is nothing left to separate.
bool WindowWriter::is_left(const Pair& pair, const WorldTime& time) const {
  const auto a = static_cast<std::size_t>(pair.first), b = static_cast<std::size_t>(pair.second);
  const double reach = fresh_[a].reach.longest() + fresh_[b].reach.longest();
  return reach > long_beside * (sizes_[a] + sizes_[b]) && scene_.repeats_from(pair.first, pair.second) > time.from;
}

void WindowWriter::halves(const WorldTime& time, const OpenPairs& open, int depth) {
  window(time.first_half(), open, depth + 1);
  window(time.second_half(), open, depth + 1);
}

/// Writes the window as the verifier reads it.
void WindowWriter::window(const WorldTime& time, const OpenPairs& open, int depth) {
  const std::vector<int> moving = moving_bodies(scene_, open);
  for (const int i : moving) fresh_[static_cast<std::size_t>(i)] = fresh_box(i, time);
  const bool divisible = time.divisible() && depth < deepest_written, few = scene_.size() <= few_bodies;
  if (open.all() && !few && divisible && better_halved(moving)) {
    out_.push_back(0);
    return halves(time, open, depth);
  }
  out_.push_back(1);
  const OpenPairs looked_at = open.all() && few ? OpenPairs{*boxes_.meeting(scene_)} : open;
  const std::vector<bool> worth = worth_stating(moving, looked_at, time);
  std::vector<std::pair<int, AxisBox>> before;
  for (std::size_t k = 0; k < moving.size(); ++k) {
    const auto& box = fresh_[static_cast<std::size_t>(moving[k])].box;
    out_.push_back(box && worth[k] ? 1 : 0);
    if (!box || !worth[k]) continue;
    for (const float side : {box->lo_x, box->lo_y, box->hi_x, box->hi_y}) put_f32(out_, side);
    before.emplace_back(moving[k], boxes_.of(moving[k]));
    boxes_.state(moving[k], as_doubles(*box));
  }
  OpenPairs left;
  left.listed.emplace();
  const std::vector<Pair> pairs = looked_at.all() ? *boxes_.meeting(scene_) : *looked_at.listed;
  const std::set<int> crowded = crowded_bodies(pairs);
  for (const Pair& pair : pairs) {
    checkpoint();
    if (pair == except_ || !boxes_.meet(pair.first, pair.second)) continue;
    // Where no box will be stated, the separations halve time themselves, which is better.
    const bool later = divisible && crowded.count(pair.first) + crowded.count(pair.second) > 0 && is_left(pair, time);
    out_.push_back(later ? 0 : 1);
    if (later) {
      left.listed->push_back(pair);
    } else {
      section_(pair, time);
    }
  }
  if (!left.listed->empty()) halves(time, left, depth);
  for (const auto& [body, box] : before) boxes_.state(body, box);
}

}  // namespace taut::internal
