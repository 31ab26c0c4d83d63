#include "scene/instance.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <unordered_map>

#include "motion/far_pieces.hpp"
#include "motion/pieces.hpp"
#include "scene/joined_parts.hpp"
#include "taut/shape.hpp"

namespace taut::internal {
namespace {

/// A number that is the same for the same motions, and seldom for others: where a point is taken at some time.
double key_of(const MotionChain& chain) {
  double sum = 0;
  for (const PieceList& pieces : chain) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      for (const bool of_y : {false, true}) {
        const std::span<const double> c = pieces.way(i, of_y);
        sum *= 0.6180339887498949;
        double value = 0;
        for (std::size_t k = c.size(); k-- > 0;) value = value * 0.3819660112501051 + c[k];
        sum += value;
      }
    }
  }
  return std::isfinite(sum) ? sum : 0;
}

bool same_chain(const MotionChain& a, const MotionChain& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), same_pieces);
}

std::uint64_t pairs_of(std::uint64_t n) { return n < 2 ? 0 : n * (n - 1) / 2; }

}  // namespace

Instance::Instance(const Scene& scene) : start_(scene.start), end_(scene.end), ignored_(scene) {
  add_bodies(scene);
  find_groups();
  tests_groups_ = scene.at_rest == AtRest::test || (scene.at_rest == AtRest::skip && all_alike());
}

void Instance::add_bodies(const Scene& scene) {
  double largest = 0;
  for (const Body& body : scene.bodies) largest = std::max(largest, largest_coordinate(body));
  std::frexp(largest, &exponent_);
  exponent_ = -exponent_;
  largest_ = std::ldexp(largest, exponent_);
  bodies_.reserve(scene.bodies.size());
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    bodies_.push_back(lowest_section(scene.bodies[i], static_cast<int>(i), start_));
  find_parents(scene);
  in_scene_ = scene.bodies.size();
  add_sections(scene);
  children_.resize(bodies_.size());
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    bodies_[i].motions = chain_of(static_cast<int>(i));
    if (bodies_[i].parent >= 0) children_[static_cast<std::size_t>(bodies_[i].parent)].push_back(static_cast<int>(i));
  }
}

InstanceBody Instance::lowest_section(const Body& given, int index, double from) const {
  InstanceBody body;
  const CrossSection lowest = given.parts.empty() ? CrossSection{given.z, {}} : cross_sections_of(given).front();
  body.rings = std::make_shared<const RingSet>(given, index, exponent_, lowest.parts);
  body.body = index;
  body.z = lowest.z;
  if (!given.motion.pieces.empty()) body.own = pieces_of(given.motion, from);
  return body;
}

PieceList Instance::pieces_of(const Motion& motion, double t) const {
  PieceList pieces = PieceList::between(motion, t, end_, exponent_);
  return pieces.rests() ? PieceList() : pieces;
}

/// Cross-sections beyond the lowest one rest on the body's lowest one.
void Instance::add_sections(const Scene& scene) {
  bool layered = false;
  for (std::size_t i = 0; i < in_scene_; ++i) {
    layered = layered || !(bodies_[i].z == Layers{});
    if (scene.bodies[i].parts.size() < 2) continue;
    const std::vector<CrossSection> sections = cross_sections_of(scene.bodies[i]);
    for (std::size_t k = 1; k < sections.size(); ++k) {
      InstanceBody body;
      body.rings = std::make_shared<const RingSet>(scene.bodies[i], static_cast<int>(i), exponent_, sections[k].parts);
      body.body = body.parent = static_cast<int>(i);
      body.z = sections[k].z;
      bodies_.push_back(std::move(body));
      layered = true;
    }
  }
  if (!layered) return;
  layers_.resize(in_scene_);
  for (const InstanceBody& body : bodies_) layers_[static_cast<std::size_t>(body.body)].push_back(body.z);
}

std::array<BodyId, 2> Instance::scene_pair(int a, int b) const {
  return {std::min(section(a).body, section(b).body), std::max(section(a).body, section(b).body)};
}

std::vector<int> Instance::sections(BodyId body) const {
  std::vector<int> all{body};
  for (std::size_t k = in_scene_; k < bodies_.size(); ++k) {
    if (bodies_[k].body == body) all.push_back(static_cast<int>(k));
  }
  return all;
}

void Instance::find_parents(const Scene& scene) {
  const auto has_parent = [](const Body& body) { return !body.relative_to.empty(); };
  if (std::none_of(scene.bodies.begin(), scene.bodies.end(), has_parent)) return;
  const std::map<std::string, int> by_name = bodies_by_name(scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (has_parent(scene.bodies[i])) bodies_[i].parent = by_name.at(scene.bodies[i].relative_to);
  }
}

MotionChain Instance::chain_of(int body) const {
  MotionChain chain;
  for (int k = body; k >= 0; k = bodies_[static_cast<std::size_t>(k)].parent) {
    const PieceList& own = bodies_[static_cast<std::size_t>(k)].own;
    if (!own.empty()) chain.insert(chain.begin(), own);
  }
  return chain;
}

std::vector<int> Instance::followers(int body) const {
  std::vector<int> all{body};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::vector<int>& seen = children_[static_cast<std::size_t>(all[i])];
    all.insert(all.end(), seen.begin(), seen.end());
  }
  std::sort(all.begin(), all.end());
  return all;
}

void Instance::replan(int body, const Motion& motion, double t, double from) {
  PieceList& own = bodies_[static_cast<std::size_t>(body)].own;
  PieceList fresh = PieceList::between(motion, t, end_, exponent_);
  if (from < t) fresh = fresh.after(own.empty() ? MotionPiece{} : own.at(from), t);
  start_ = from;
  if (!moving_) note_moving();
  const std::vector<int> changed = followers(body);
  for (const int k : changed) leave_group(k);
  own = fresh.rests() ? PieceList() : fresh;
  for (const int k : changed) bodies_[static_cast<std::size_t>(k)].motions = chain_of(k);
  for (const int k : changed) join_group(k);
}

bool Instance::can_add(const Body& body) const {
  int exponent = 0;
  std::frexp(largest_coordinate(body), &exponent);
  const bool one_section = body.parts.size() < 2 || cross_sections_of(body).size() == 1;
  return exponent <= -exponent_ && one_section && bodies_.size() == in_scene_;
}

InstanceBody Instance::to_add(const Body& body, int parent, double t) const {
  InstanceBody added = lowest_section(body, static_cast<int>(bodies_.size()), t);
  added.parent = parent;
  added.born = t;
  return added;
}

void Instance::add(InstanceBody added, double from) {
  const int index = static_cast<int>(bodies_.size()), parent = added.parent;
  if (!moving_) note_moving();
  start_ = from;
  if (layers_.empty() && !(added.z == Layers{})) layers_.assign(bodies_.size(), std::vector<Layers>{Layers{}});
  if (!layers_.empty()) layers_.push_back({added.z});
  bodies_.push_back(std::move(added));
  children_.emplace_back();
  if (parent >= 0) children_[static_cast<std::size_t>(parent)].push_back(index);
  ignored_.add_body();
  ++in_scene_;
  bodies_.back().motions = chain_of(index);
  join_group(index);
}

void Instance::remove_last() {
  const int index = static_cast<int>(bodies_.size()) - 1;
  leave_group(index);
  if (bodies_.back().parent >= 0) std::erase(children_[static_cast<std::size_t>(bodies_.back().parent)], index);
  bodies_.pop_back();
  children_.pop_back();
  if (!layers_.empty()) layers_.pop_back();
  ignored_.remove_last_body();
  --in_scene_;
}

void Instance::retire(int body) {
  if (!moving_) note_moving();
  ignored_.add_all(body);
  InstanceBody& retired = bodies_[static_cast<std::size_t>(body)];
  if (retired.parent >= 0) std::erase(children_[static_cast<std::size_t>(retired.parent)], body);
  retired.parent = -1;
  retired.own = PieceList();
  for (const int k : sections(body)) {
    leave_group(k);
    bodies_[static_cast<std::size_t>(k)].motions.clear();
    join_group(k);
  }
}

void Instance::attach(int body, int parent, const PieceList& own, double t, double from) {
  start_ = from;
  if (!moving_) note_moving();
  const std::vector<int> changed = followers(body);
  for (const int k : changed) leave_group(k);
  InstanceBody& attached = bodies_[static_cast<std::size_t>(body)];
  if (attached.parent >= 0) std::erase(children_[static_cast<std::size_t>(attached.parent)], body);
  if (parent >= 0) children_[static_cast<std::size_t>(parent)].push_back(body);
  attached.parent = parent;
  attached.own = own;
  for (const int k : changed) {
    bodies_[static_cast<std::size_t>(k)].motions = chain_of(k);
    bodies_[static_cast<std::size_t>(k)].born = t;
  }
  for (const int k : changed) join_group(k);
}

void Instance::note_moving() {
  moving_.emplace();
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    if (!bodies_[i].motions.empty()) (*moving_)[key_of(bodies_[i].motions)].push_back(static_cast<int>(i));
  }
}

void Instance::leave_group(int body) {
  const MotionChain& motions = bodies_[static_cast<std::size_t>(body)].motions;
  if (motions.empty()) return;
  const auto alike = moving_->find(key_of(motions));
  std::erase(alike->second, body);
  if (alike->second.empty()) moving_->erase(alike);
}

/// That of another body that moves alike, or one of its own.
void Instance::join_group(int body) {
  InstanceBody& joining = bodies_[static_cast<std::size_t>(body)];
  if (joining.motions.empty()) {
    if (resting_ < 0) resting_ = groups_++;
    joining.group = resting_;
    return;
  }
  std::vector<int>& alike = (*moving_)[key_of(joining.motions)];
  const auto same = std::find_if(alike.begin(), alike.end(), [&](int k) {
    return same_chain(bodies_[static_cast<std::size_t>(k)].motions, joining.motions);
  });
  joining.group = same != alike.end() ? bodies_[static_cast<std::size_t>(*same)].group : groups_++;
  alike.push_back(body);
}

void Instance::find_groups() {
  // One body of each group, by the key of its motion.
  std::unordered_map<double, std::vector<int>> representatives;
  const auto moves = [](const InstanceBody& body) { return !body.motions.empty(); };
  const bool one_moves = std::count_if(bodies_.begin(), bodies_.end(), moves) == 1;
  for (InstanceBody& body : bodies_) {
    if (body.motions.empty()) {
      if (resting_ < 0) resting_ = groups_++;
      body.group = resting_;
      continue;
    }
    if (one_moves) {
      body.group = groups_++;
      continue;
    }
    const int index = static_cast<int>(&body - bodies_.data());
    std::vector<int>& alike = representatives[key_of(body.motions)];
    const auto same = std::find_if(alike.begin(), alike.end(), [&](int r) {
      return same_chain(bodies_[static_cast<std::size_t>(r)].motions, body.motions);
    });
    if (same != alike.end()) {
      body.group = bodies_[static_cast<std::size_t>(*same)].group;
    } else {
      body.group = groups_++;
      alike.push_back(index);
    }
  }
}

bool Instance::excluded(int a, int b) const {
  const InstanceBody &first = section(a), &second = section(b);
  return first.body == second.body || !first.z.meet(second.z) || ignored_.has(first.body, second.body);
}

bool Instance::asked(int a, int b) const {
  return (section(a).group != section(b).group || tests_groups_) && !excluded(a, b);
}

/// Does nothing move relative to anything else? Bodies that are ignored altogether, as what carries others, do not
/// count.
bool Instance::all_alike() const {
  int group = -1;
  for (std::size_t i = 0; i < in_scene_; ++i) {
    if (ignored_.has_all(static_cast<int>(i))) continue;
    if (group >= 0 && bodies_[i].group != group) return false;
    group = bodies_[i].group;
  }
  return true;
}

/// All pairs, and those that are not asked about.
Coverage Instance::excluded(bool groups_are_tested) const {
  const std::uint64_t n = in_scene_;
  std::vector<std::uint64_t> size(static_cast<std::size_t>(groups_), 0);  // of the group, without those that ignore all
  std::uint64_t listening = 0;
  for (std::size_t i = 0; i < in_scene_; ++i) {
    if (ignored_.has_all(static_cast<int>(i))) continue;
    ++listening;
    ++size[static_cast<std::size_t>(bodies_[i].group)];
  }
  Coverage count;
  const auto together = [&](int group) -> std::uint64_t& {
    return group == resting_ ? count.at_rest : count.moving_alike;
  };
  count.pairs = pairs_of(n);
  count.ignored = pairs_of(n) - pairs_of(listening);
  for (int group = 0; group < groups_; ++group) together(group) += pairs_of(size[static_cast<std::size_t>(group)]);
  for (const auto& [a, b] : ignored_.pairs()) {
    if (ignored_.has_all(a) || ignored_.has_all(b)) continue;
    ++count.ignored;
    const int group = bodies_[static_cast<std::size_t>(a)].group;
    if (group == bodies_[static_cast<std::size_t>(b)].group) --together(group);
  }
  if (groups_are_tested) count.at_rest = count.moving_alike = 0;
  count.layers = on_other_layers(groups_are_tested);
  return count;
}

/// Pairs without a common layer, of those that are neither ignored nor left out as of one group. Counted by the
/// different sets of layers, which are few.
std::uint64_t Instance::on_other_layers(bool groups_are_tested) const {
  if (layers_.empty()) return 0;
  using Set = std::vector<std::pair<double, double>>;
  std::map<Set, std::map<int, std::uint64_t>> sets;  // of bodies that are not ignored altogether, by group
  const auto set_of = [&](std::size_t body) {
    Set set;
    for (const Layers& z : layers_[body]) set.emplace_back(z.lo, z.hi);
    return set;
  };
  const auto apart = [](const Set& a, const Set& b) {
    return std::none_of(a.begin(), a.end(), [&](const auto& x) {
      return std::any_of(b.begin(), b.end(), [&](const auto& y) {
        return Layers{x.first, x.second}.meet(Layers{y.first, y.second});
      });
    });
  };
  for (std::size_t i = 0; i < in_scene_; ++i) {
    if (!ignored_.has_all(static_cast<int>(i)))
      ++sets[set_of(i)][groups_are_tested ? static_cast<int>(i) : bodies_[i].group];
  }
  std::uint64_t count = 0;
  for (auto a = sets.begin(); a != sets.end(); ++a) {
    for (auto b = std::next(a); b != sets.end(); ++b) {
      if (!apart(a->first, b->first)) continue;
      std::uint64_t all_of_b = 0;
      for (const auto& [group, number] : b->second) all_of_b += number;
      for (const auto& [group, number] : a->second) {
        const auto alike = b->second.find(group);
        count += number * (all_of_b - (alike == b->second.end() ? 0 : alike->second));
      }
    }
  }
  for (const auto& [a, b] : ignored_.pairs()) {
    if (ignored_.has_all(a) || ignored_.has_all(b)) continue;
    const bool alike = !groups_are_tested && section(a).group == section(b).group;
    if (!alike && apart(set_of(static_cast<std::size_t>(a)), set_of(static_cast<std::size_t>(b)))) --count;
  }
  return count;
}

Coverage Instance::coverage(std::uint64_t tested) const {
  Coverage all = excluded(tests_groups_);
  all.tested = tested;
  all.apart = all.pairs - all.untested() - tested;
  return all;
}

Coverage Instance::coverage_of_all_groups() const {
  Coverage all = excluded(true);
  all.tested = all.pairs - all.untested();
  return all;
}

MotionChain chain_of(const Scene& scene, const Body& body) {
  MotionChain motions;
  for (const Body* link = &body;;) {
    motions.insert(motions.begin(), PieceList::between(link->motion, scene.start, scene.end));
    if (link->relative_to.empty()) return motions;
    link = &*std::find_if(scene.bodies.begin(), scene.bodies.end(),
                          [&](const Body& b) { return b.name == link->relative_to; });
  }
}

double Instance::repeats_from(int a, int b) const {
  const auto turns = [this](int body) {
    const MotionChain& motions = section(body).motions;
    return std::any_of(motions.begin(), motions.end(), [this](const PieceList& motion) {
      const auto last = motion.last_rates(end_);
      return last && (last->turn != 0 || last->orbit != 0);
    });
  };
  if (!turns(a) && !turns(b)) return INFINITY;
  const BodyPair bodies = pair(a, b);
  return internal::repeats_from(bodies.motions[0], bodies.motions[1], start_, end_);
}

BodyPair Instance::pair(int a, int b) const {
  const InstanceBody &first = bodies_[static_cast<std::size_t>(a)], &second = bodies_[static_cast<std::size_t>(b)];
  return pair_of(first.rings, first.motions, second.rings, second.motions);
}

}  // namespace taut::internal
