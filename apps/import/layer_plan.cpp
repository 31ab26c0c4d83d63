#include "import/layer_plan.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "geometry/predicates.hpp"
#include "geometry/segment_strips.hpp"
#include "import/body_text.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

struct LayerSegment {
  Point a, b;
  std::size_t layer;
  const Chain* chain;
};

double distance_to(const LayerSegment& s, const Point& p) { return distance_to_segment(p, s.a, s.b); }

/// Does the first segment reach more than `least` beyond the second one, on both sides?
bool cross_clearly(const LayerSegment& s, const LayerSegment& t, double least) {
  if (orientation(s.a, s.b, t.a) * orientation(s.a, s.b, t.b) >= 0) return false;
  if (orientation(t.a, t.b, s.a) * orientation(t.a, t.b, s.b) >= 0) return false;
  return distance_to(t, s.a) > least && distance_to(t, s.b) > least && distance_to(s, t.a) > least &&
         distance_to(s, t.b) > least;
}

/// Do the segments run along each other, at most `width` apart, for more than `least`?
bool run_along(const LayerSegment& s, const LayerSegment& t, double width, double least) {
  const double x = s.b.x - s.a.x, y = s.b.y - s.a.y, length = std::hypot(x, y);
  if (!(length > least)) return false;
  const auto along = [&](const Point& p) { return ((p.x - s.a.x) * x + (p.y - s.a.y) * y) / length; };
  const auto above = [&](const Point& p) { return ((p.y - s.a.y) * x - (p.x - s.a.x) * y) / length; };
  const double from = along(t.a), to = along(t.b);
  const double lo = std::max(0.0, std::min(from, to)), hi = std::min(length, std::max(from, to));
  if (!(hi - lo > least)) return false;
  const auto height = [&](double u) { return above(t.a) + (u - from) / (to - from) * (above(t.b) - above(t.a)); };
  return std::fabs(height(lo)) <= width && std::fabs(height(hi)) <= width;
}

/// A direction in which lines of one of two sets leave a point where they touch.
struct Ray {
  Point from, to;
  std::size_t set;
};

/// Do lines of the two sets change sides with each other around their point? So they do where one passes between two
/// of the other's; where they only touch, all of one lie between two neighbours of the other. Lines that leave along
/// each other, at most `width` apart, have no order: run_along() finds them.
bool change_sides(std::vector<Ray> rays, double width) {
  const auto angle = [](const Ray& ray) { return std::atan2(ray.to.y - ray.from.y, ray.to.x - ray.from.x); };
  std::sort(rays.begin(), rays.end(), [&](const Ray& a, const Ray& b) { return angle(a) < angle(b); });
  std::size_t changes = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Ray &a = rays[i], &b = rays[(i + 1) % rays.size()];
    if (a.set == b.set) continue;
    if (distance_to_segment(a.to, b.from, b.to) <= width || distance_to_segment(b.to, a.from, a.to) <= width)
      return false;
    ++changes;
  }
  return changes > 2;
}

class Planner {
 public:
  Planner(const std::vector<LineLayer>& layers, const OutlineSettings& settings)
      : layers_(layers), settings_(settings), set_(layers.size()) {
    std::iota(set_.begin(), set_.end(), 0);
    for (std::size_t k = 0; k < layers.size(); ++k)
      for (const Chain& chain : layers[k].chains) add_segments(chain, k, segments_);
    strips_ = std::make_unique<SegmentStrips>(boxes_of(segments_));
  }

  LayerPlan plan() {
    while (join_where_ends_meet()) {
    }
    find_conflicts();
    LayerPlan plan;
    std::map<std::size_t, std::size_t> index;  // of sets
    std::vector<std::size_t> common;
    for (std::size_t k = 0; k < layers_.size(); ++k)
      if (!apart_.count(set_[k])) common.push_back(k);
    plan.common = !common.empty();
    if (plan.common) plan.sets.push_back(std::move(common));
    for (const std::size_t root : apart_) {
      index[root] = plan.sets.size();
      plan.sets.emplace_back();
      for (std::size_t k = 0; k < layers_.size(); ++k)
        if (set_[k] == root) plan.sets.back().push_back(k);
    }
    for (const auto& [pair, where] : where_)
      plan.conflicts.push_back({index.at(pair.first), index.at(pair.second), where.at, where.kind});
    return plan;
  }

 private:
  static void add_segments(const Chain& chain, std::size_t layer, std::vector<LayerSegment>& segments) {
    const std::size_t n = chain.points.size();
    for (std::size_t i = 0; i + (chain.closed ? 0 : 1) < n; ++i)
      segments.push_back({chain.points[i], chain.points[(i + 1) % n], layer, &chain});
  }

  static std::vector<AxisBox> boxes_of(const std::vector<LayerSegment>& segments) {
    std::vector<AxisBox> boxes;
    boxes.reserve(segments.size());
    for (const LayerSegment& segment : segments) boxes.emplace_back(segment.a, segment.b);
    return boxes;
  }

  bool join_where_ends_meet() {
    bool any = false;
    for (std::size_t root = 0; root < layers_.size(); ++root) {
      if (set_[root] != root || !settled_.insert(root).second) continue;
      for (const Point& end : loose_ends(lines_with_ends(root), settings_)) {
        strips_->each_near(AxisBox(end, end, settings_.join), [&](std::size_t s) {
          if (set_[segments_[s].layer] == set_[root] || distance_to(segments_[s], end) > settings_.join) return;
          join(root, segments_[s].layer);
          any = true;
        });
      }
    }
    return any;
  }

  /// The set's open lines, and what else of it is so near to one of their ends that they may meet it.
  std::vector<Chain> lines_with_ends(std::size_t root) const {
    constexpr double near = 16;  // ends move by as much as settings_.join, several times
    std::set<const Chain*> wanted;
    for (std::size_t k = 0; k < layers_.size(); ++k) {
      if (set_[k] != root) continue;
      for (const Chain& chain : layers_[k].chains) {
        if (chain.closed || chain.points.empty()) continue;
        wanted.insert(&chain);
        for (const Point& end : {chain.points.front(), chain.points.back()})
          strips_->each_near(AxisBox(end, end, near * settings_.join), [&](std::size_t s) {
            if (set_[segments_[s].layer] == root) wanted.insert(segments_[s].chain);
          });
      }
    }
    std::vector<Chain> lines;
    for (std::size_t k = 0; k < layers_.size(); ++k)
      for (const Chain& chain : layers_[k].chains)
        if (wanted.count(&chain)) lines.push_back(chain);
    return lines;
  }

  void join(std::size_t a, std::size_t b) {
    const std::size_t from = std::max(set_[a], set_[b]), to = std::min(set_[a], set_[b]);
    for (std::size_t& set : set_)
      if (set == from) set = to;
    settled_.erase(to);
  }

  /// The segments of chains whose boxes meet those of other sets: others have no conflict with these.
  std::vector<LayerSegment> segments_near_others() const {
    std::vector<std::pair<const Chain*, std::size_t>> chains;
    std::vector<AxisBox> boxes;
    for (std::size_t k = 0; k < layers_.size(); ++k) {
      for (const Chain& chain : layers_[k].chains) {
        if (chain.points.empty()) continue;
        chains.emplace_back(&chain, k);
        boxes.push_back(box_of(chain.points));
      }
    }
    std::vector<bool> near(chains.size(), false);
    SegmentStrips(std::move(boxes)).each_pair([&](std::size_t i, std::size_t j) {
      if (set_[chains[i].second] != set_[chains[j].second]) near[i] = near[j] = true;
    });
    std::vector<LayerSegment> segments;
    for (std::size_t i = 0; i < chains.size(); ++i)
      if (near[i]) add_segments(*chains[i].first, chains[i].second, segments);
    return segments;
  }

  struct Where {
    Point at;
    LayerConflict::Kind kind;
  };

  void find_conflicts() {
    const std::vector<LayerSegment> segments = segments_near_others();
    std::map<std::pair<std::size_t, std::size_t>, std::vector<Ray>> touches;
    SegmentStrips(boxes_of(segments)).each_pair([&](std::size_t i, std::size_t j) {
      const LayerSegment &s = segments[i], &t = segments[j];
      const std::size_t a = std::min(set_[s.layer], set_[t.layer]), b = std::max(set_[s.layer], set_[t.layer]);
      if (a == b) return;
      const auto known = where_.find({a, b});
      if (known != where_.end() && known->second.kind == LayerConflict::Kind::cross) return;
      const bool cross = cross_clearly(s, t, settings_.join);
      if (!cross) find_touches(s, t, touches[{a, b}]);
      if (!cross && (known != where_.end() || !run_along(s, t, settings_.join / 2, settings_.join))) return;
      where_[{a, b}] = {middle_of_common_box(s, t), cross ? LayerConflict::Kind::cross : LayerConflict::Kind::along};
      apart_.insert(a);
      apart_.insert(b);
    });
    for (auto& [pair, rays] : touches) {
      const auto known = where_.find(pair);
      if (known != where_.end() && known->second.kind == LayerConflict::Kind::cross) continue;
      const std::optional<Where> at_ends = conflict_at_ends(std::move(rays));
      if (!at_ends || (known != where_.end() && at_ends->kind == LayerConflict::Kind::touch)) continue;
      where_[pair] = *at_ends;
      apart_.insert(pair.first);
      apart_.insert(pair.second);
    }
  }

  /// Where an end of one of the segments lies on the other one: the directions of both from there.
  void find_touches(const LayerSegment& s, const LayerSegment& t, std::vector<Ray>& rays) const {
    const auto leave = [&](const LayerSegment& segment, const Point& p) {
      for (const Point& end : {segment.a, segment.b})
        if (std::hypot(end.x - p.x, end.y - p.y) > settings_.join) rays.push_back({p, end, set_[segment.layer]});
    };
    for (const auto& [one, other] : {std::pair(&s, &t), std::pair(&t, &s)}) {
      for (const Point& end : {one->a, one->b}) {
        if (distance_to(*other, end) > settings_.join) continue;
        leave(*one, end);
        leave(*other, end);
      }
    }
  }

  /// Where lines change sides although no segment reaches beyond another one on both sides; or else the second point at
  /// which they touch.
  std::optional<Where> conflict_at_ends(std::vector<Ray> rays) const {
    std::sort(rays.begin(), rays.end(),
              [](const Ray& a, const Ray& b) { return std::pair(a.from.x, a.from.y) < std::pair(b.from.x, b.from.y); });
    std::vector<bool> taken(rays.size(), false);
    std::vector<Point> points;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      if (taken[i]) continue;
      std::vector<Ray> here;
      for (std::size_t j = i; j < rays.size() && rays[j].from.x - rays[i].from.x <= settings_.join; ++j) {
        if (taken[j] || std::fabs(rays[j].from.y - rays[i].from.y) > settings_.join) continue;
        taken[j] = true;
        here.push_back(rays[j]);
      }
      if (change_sides(std::move(here), settings_.join / 2)) return Where{rays[i].from, LayerConflict::Kind::cross};
      points.push_back(rays[i].from);
    }
    if (points.size() < 2) return std::nullopt;
    return Where{points[1], LayerConflict::Kind::touch};
  }

  static Point middle_of_common_box(const LayerSegment& s, const LayerSegment& t) {
    return {(std::max(std::min(s.a.x, s.b.x), std::min(t.a.x, t.b.x)) +
             std::min(std::max(s.a.x, s.b.x), std::max(t.a.x, t.b.x))) /
                2,
            (std::max(std::min(s.a.y, s.b.y), std::min(t.a.y, t.b.y)) +
             std::min(std::max(s.a.y, s.b.y), std::max(t.a.y, t.b.y))) /
                2};
  }

  const std::vector<LineLayer>& layers_;
  const OutlineSettings& settings_;
  std::vector<std::size_t> set_;  ///< of each layer: the least layer of its set
  std::vector<LayerSegment> segments_;
  std::unique_ptr<SegmentStrips> strips_;
  std::set<std::size_t> settled_;  ///< sets whose loose ends are known
  std::set<std::size_t> apart_;    ///< sets that have a conflict with another one
  std::map<std::pair<std::size_t, std::size_t>, Where> where_;
};

struct Enclosed {
  double area = 0;
  bool doubtful = false;  ///< some lines seem meant to be closed
};

Enclosed enclosed_by(const std::vector<LineLayer>& layers, const std::vector<bool>& left_out,
                     const OutlineSettings& settings) {
  std::vector<Chain> chains;
  for (std::size_t k = 0; k < layers.size(); ++k)
    if (!left_out[k]) chains.insert(chains.end(), layers[k].chains.begin(), layers[k].chains.end());
  const Outlines outlines = outlines_of_lines(chains, settings);
  double area = 0;
  for (const Region& region : outlines.regions) area += area_of(region.part);
  return {area, !outlines.suspicious.empty()};
}

bool encloses_nothing(const LineLayer& layer, const OutlineSettings& settings) {
  const auto is_closed = [](const Chain& chain) { return chain.closed; };
  return std::none_of(layer.chains.begin(), layer.chains.end(), is_closed) &&
         outlines_of_lines(layer.chains, settings).regions.empty();
}

/// One after the other, in an order that does not depend on the file's.
std::vector<bool> layers_of_marks(const std::vector<LineLayer>& layers, const std::vector<std::string>& names,
                                  const OutlineSettings& settings) {
  std::vector<bool> marks(layers.size(), false);
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < layers.size(); ++k)
    if (encloses_nothing(layers[k], settings)) open.push_back(k);
  if (open.empty()) return marks;
  std::sort(open.begin(), open.end(), [&](std::size_t a, std::size_t b) { return names[a] < names[b]; });
  constexpr double rounding = 1e-9;
  // Where lines seem meant to be closed, those of any layer may belong to them.
  const Enclosed all = enclosed_by(layers, marks, settings);
  if (all.doubtful || !(all.area > 0)) return marks;
  for (const std::size_t k : open) {
    marks[k] = true;
    const Enclosed without = enclosed_by(layers, marks, settings);
    if (without.doubtful || std::fabs(without.area - all.area) > rounding * all.area) marks[k] = false;
  }
  return marks;
}

}  // namespace

LayerPlan plan_layers(const std::vector<LineLayer>& layers, const std::vector<std::string>& names,
                      const OutlineSettings& settings) {
  if (layers.size() < 2) {
    LayerPlan plan;
    if (!layers.empty()) plan.sets.push_back({0});
    return plan;
  }
  LayerPlan plan = Planner(layers, settings).plan();
  if (plan.conflicts.empty()) return plan;
  // Marks may be the cause. To find them takes several readings of all lines.
  const std::vector<bool> marks = layers_of_marks(layers, names, settings);
  if (std::find(marks.begin(), marks.end(), true) == marks.end()) return plan;
  std::vector<LineLayer> drawn = layers;
  for (std::size_t k = 0; k < layers.size(); ++k)
    if (marks[k]) drawn[k].chains.clear();
  plan = Planner(drawn, settings).plan();
  for (std::vector<std::size_t>& set : plan.sets) std::erase_if(set, [&](std::size_t k) { return marks[k]; });
  for (std::size_t k = 0; k < layers.size(); ++k) {
    if (!marks[k]) continue;
    plan.marks.push_back(k);
    plan.sets.push_back({k});
  }
  return plan;
}

void adopt_holes(std::vector<LineLayer>& layers, LayerPlan& plan, const OutlineSettings& settings) {
  if (!plan.common || plan.sets.size() < 2) return;
  std::vector<std::vector<Region>> material(plan.sets.size());
  for (std::size_t s = 1; s < plan.sets.size(); ++s) {
    std::vector<Chain> chains;
    for (const std::size_t k : plan.sets[s])
      chains.insert(chains.end(), layers[k].chains.begin(), layers[k].chains.end());
    material[s] = outlines_of_lines(chains, settings).regions;
  }
  const auto set_around = [&](const Chain& chain) {
    std::size_t found = 0;
    for (std::size_t s = 1; s < material.size(); ++s) {
      const bool within = std::any_of(material[s].begin(), material[s].end(), [&](const Region& region) {
        return std::all_of(chain.points.begin(), chain.points.end(),
                           [&](const Point& p) { return roughly_inside(region.part, p); });
      });
      if (within && found != 0) return std::size_t{0};
      if (within) found = s;
    }
    return found;
  };
  const std::vector<std::size_t> common = plan.sets.front();
  for (const std::size_t k : common) {
    std::map<std::size_t, std::vector<Chain>> adopted;
    std::vector<Chain> left;
    for (Chain& chain : layers[k].chains) {
      const std::size_t s = set_around(chain);
      (s == 0 ? left : adopted[s]).push_back(std::move(chain));
    }
    layers[k].chains = std::move(left);
    for (auto& [s, chains] : adopted) {
      plan.sets[s].push_back(layers.size());
      layers.push_back({layers[k].layer, std::move(chains), layers[k].name});
    }
  }
}

}  // namespace taut::drawing
