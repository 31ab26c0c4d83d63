#include "import/open_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

#include "geometry/predicates.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

double span_between(const Point& p, const Point& q) { return std::hypot(p.x - q.x, p.y - q.y); }

/// Free ends in the order of the plane: end 2k is the start of line k, 2k + 1 its end.
class FreeEnds {
 public:
  /// `apart`: do the ends of one line not meet each other?
  FreeEnds(const std::vector<OpenLine>& lines, bool apart) : lines_(lines), apart_(apart) {
    for (std::size_t k = 0; k < lines.size(); ++k) {
      if (lines[k].free_start) ends_.push_back(2 * k);
      if (lines[k].free_end) ends_.push_back(2 * k + 1);
    }
    std::sort(ends_.begin(), ends_.end(), [this](std::size_t a, std::size_t b) {
      return lexicographically_less(at(a), at(b)) || (!lexicographically_less(at(b), at(a)) && a < b);
    });
    rank_.assign(2 * lines.size(), 0);
    for (std::size_t i = 0; i < ends_.size(); ++i) rank_[ends_[i]] = i;
    paired_.assign(2 * lines.size(), none);
  }

  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  const std::vector<std::size_t>& all() const { return ends_; }
  const Point& at(std::size_t end) const {
    const std::vector<Point>& points = lines_[end / 2].points;
    return end % 2 == 0 ? points.front() : points.back();
  }
  std::size_t partner(std::size_t end) const { return paired_[end]; }

  struct Nearest {
    std::size_t end = none;
    double distance = INFINITY, next = INFINITY;  ///< of the one after it
  };

  /// The nearest other end that is not paired, or none: from its place in the order, to both sides.
  Nearest nearest(std::size_t end) const {
    return nearest(end, [](std::size_t) { return true; });
  }
  /// The same among those of lines that count.
  template <class Counts>
  Nearest nearest(std::size_t end, const Counts& counts) const {
    Nearest best;
    const auto examine = [&](std::size_t other) {
      if (paired_[other] != none || !may_meet(end, other) || !counts(other / 2)) return;
      const double d = span_between(at(end), at(other));
      if (d < best.distance)
        best = {other, d, best.distance};
      else
        best.next = std::min(best.next, d);
    };
    std::size_t below = rank_[end], above = rank_[end] + 1;
    for (bool more = true; more;) {
      more = false;
      if (below > 0 && at(end).x - at(ends_[below - 1]).x < best.next) {
        examine(ends_[--below]);
        more = true;
      }
      if (above < ends_.size() && at(ends_[above]).x - at(end).x < best.next) {
        examine(ends_[above++]);
        more = true;
      }
    }
    return best;
  }

  void pair() {
    using Entry = std::tuple<double, std::size_t, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto push = [&](std::size_t end) {
      const Nearest other = nearest(end);
      if (other.end != none) queue.emplace(other.distance, end, other.end);
    };
    for (const std::size_t end : ends_) push(end);
    while (!queue.empty()) {
      const auto [distance, end, other] = queue.top();
      queue.pop();
      if (paired_[end] != none) continue;
      if (paired_[other] != none) {
        push(end);
        continue;
      }
      paired_[end] = other;
      paired_[other] = end;
    }
  }

 private:
  /// The ends of one straight line do not meet: that encloses nothing.
  bool may_meet(std::size_t a, std::size_t b) const {
    if (a == b) return false;
    if (a / 2 != b / 2) return true;
    return !apart_ && !lines_[a / 2].is_straight();
  }

  const std::vector<OpenLine>& lines_;
  const bool apart_;
  std::vector<std::size_t> ends_, rank_, paired_;
};

}  // namespace

double OpenLine::length() const {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) sum += span_between(points[i], points[i + 1]);
  return sum;
}

bool OpenLine::is_straight() const {
  return std::all_of(points.begin(), points.end(),
                     [this](const Point& p) { return orientation(points.front(), points.back(), p) == 0; });
}

std::vector<OpenLine> open_lines(const LineGraph& graph, const std::vector<bool>& all,
                                 const std::vector<bool>& removed) {
  const Incidence whole(graph, all), left(graph, removed);
  std::vector<OpenLine> lines;
  std::vector<bool> used(graph.edges.size(), false);
  const auto passes = [&](int node) { return whole.degree(node) == 2 && left.degree(node) == 2; };
  for (int node = 0; node < static_cast<int>(graph.nodes.size()); ++node) {
    if (passes(node)) continue;
    for (const int* out = left.begin(node); out != left.end(node); ++out) {
      int h = *out;
      if (used[static_cast<std::size_t>(h / 2)]) continue;
      OpenLine line;
      line.points.push_back(graph.point(node));
      line.source = graph.edge(h).source;
      line.free_start = whole.degree(node) == 1;
      for (;;) {
        used[static_cast<std::size_t>(h / 2)] = true;
        const int there = graph.target(h);
        line.points.push_back(graph.point(there));
        line.free_end = whole.degree(there) == 1;
        if (!passes(there)) break;
        h = left.begin(there)[0] == (h ^ 1) ? left.begin(there)[1] : left.begin(there)[0];
      }
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

void find_nearest_ends(std::vector<OpenLine>& lines) {
  const FreeEnds ends(lines, false);
  for (const std::size_t end : ends.all()) {
    const FreeEnds::Nearest other = ends.nearest(end);
    if (other.end == FreeEnds::none) continue;
    OpenLine& line = lines[end / 2];
    (end % 2 == 0 ? line.nearest_start : line.nearest_end) = ends.at(other.end);
    (end % 2 == 0 ? line.gap_start : line.gap_end) = other.distance;
    (end % 2 == 0 ? line.next_start : line.next_end) = other.next;
  }
}

namespace {

/// How many times farther away than these two ends are from each other the next free end is.
double clearness_of(const std::vector<OpenLine>& lines, std::size_t end, std::size_t other) {
  const auto at = [&](std::size_t e) { return e % 2 == 0 ? lines[e / 2].points.front() : lines[e / 2].points.back(); };
  const auto next = [&](std::size_t e) { return e % 2 == 0 ? lines[e / 2].next_start : lines[e / 2].next_end; };
  return std::min(next(end), next(other)) / span_between(at(end), at(other));
}

}  // namespace

std::vector<Closure> find_closures(const std::vector<OpenLine>& lines, bool of_several) {
  FreeEnds ends(lines, of_several);
  ends.pair();
  std::vector<Closure> closures;
  std::vector<bool> used(lines.size(), false);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (used[k]) continue;
    Closure closure;
    closure.clearness = INFINITY;
    std::size_t end = 2 * k;
    for (;;) {
      const OpenLine& line = lines[end / 2];
      used[end / 2] = true;
      closure.lines.push_back(end / 2);
      closure.line_length += line.length();
      std::vector<Point> points = line.points;
      if (end % 2 == 1) std::reverse(points.begin(), points.end());
      closure.ring.insert(closure.ring.end(), points.begin(), points.end());
      const std::size_t exit = end ^ 1, next = ends.partner(exit);
      if (next == FreeEnds::none) break;
      closure.gaps.push_back({ends.at(exit), ends.at(next)});
      const double width = span_between(ends.at(exit), ends.at(next));
      closure.gap_length += width;
      closure.clearness = std::min(closure.clearness, clearness_of(lines, exit, next));
      if (next == 2 * k) {
        closures.push_back(std::move(closure));
        break;
      }
      if (used[next / 2]) break;
      end = next;
    }
  }
  return closures;
}

namespace {

bool crosses(const OpenLine& line, const Point& a, const Point& b) {
  const auto between = [](const Point& p, const Point& q, const Point& u, const Point& v) {
    return orientation(p, q, u) * orientation(p, q, v) < 0;
  };
  for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
    const Point &p = line.points[i], &q = line.points[i + 1];
    if (between(a, b, p, q) && between(p, q, a, b)) return true;
  }
  return false;
}

}  // namespace

std::vector<Closure> closures_across_lines(const std::vector<OpenLine>& lines) {
  const FreeEnds ends(lines, false);
  std::vector<Closure> closures;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const OpenLine& line = lines[k];
    if (!line.free_start || !line.free_end || line.is_straight()) continue;
    const Point &from = line.points.back(), &to = line.points.front();
    Closure closure;
    closure.lines = {k};
    closure.gaps = {{from, to}};
    closure.gap_length = span_between(from, to);
    closure.line_length = line.length();
    // Only of a line that is much longer than its gap: there may be many others.
    if (closure.gap_length > closure.line_length / 4) continue;
    const auto nearest_of = [&](const auto& counts) {
      return std::min(ends.nearest(2 * k, counts).distance, ends.nearest(2 * k + 1, counts).distance);
    };
    const double any = nearest_of([&](std::size_t other) { return other != k; });
    const double next = nearest_of([&](std::size_t other) { return other != k && !crosses(lines[other], from, to); });
    if (next == any) continue;
    closure.clearness = next / closure.gap_length;
    closure.ring = line.points;
    closures.push_back(std::move(closure));
  }
  return closures;
}

double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  const double x = b.x - a.x, y = b.y - a.y, length = x * x + y * y;
  const double along = length > 0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / length, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - along * x, p.y - a.y - along * y);
}

namespace {

using EndPair = std::array<std::size_t, 2>;

/// Pairs of free ends of different groups of lines, nearer to each other than to the other ends of their own groups.
/// Kept are those that lead from a group with one free end, by groups with two, to another one with one: the gaps of an
/// outline that other lines cross. `ends_of`: all ends of the lines of each group.
std::vector<EndPair> ends_across_gaps(const FreeEnds& ends, const std::vector<std::size_t>& root_of_line,
                                      const std::map<std::size_t, std::vector<Point>>& ends_of) {
  const auto group = [&](std::size_t end) { return root_of_line[end / 2]; };
  std::map<std::size_t, std::size_t> free, next;  // of groups: how many free ends, and another one that it goes on in
  for (const std::size_t end : ends.all()) ++free[group(end)];
  const auto last = [&next](std::size_t g) {
    while (next.count(g) > 0) g = next[g];
    return g;
  };
  const auto is_nearer = [&](std::size_t end, double gap) {
    const std::vector<Point>& own = ends_of.at(group(end));
    return std::all_of(own.begin(), own.end(),
                       [&](const Point& p) { return p == ends.at(end) || span_between(p, ends.at(end)) > gap; });
  };
  std::vector<EndPair> across;
  for (const std::size_t end : ends.all()) {
    const std::size_t other = ends.partner(end);
    if (other == FreeEnds::none || other < end || group(end) == group(other)) continue;
    const double gap = span_between(ends.at(end), ends.at(other));
    if (free[group(end)] > 2 || free[group(other)] > 2 || !is_nearer(end, gap) || !is_nearer(other, gap)) continue;
    across.push_back({end, other});
    const std::size_t a = last(group(end)), b = last(group(other));
    if (a != b) next[std::max(a, b)] = std::min(a, b);
  }
  std::map<std::size_t, int> outermost;
  for (const auto& [g, count] : free) outermost[last(g)] += count == 1;
  std::erase_if(across, [&](const EndPair& pair) { return outermost[last(group(pair[0]))] != 2; });
  return across;
}

/// Lines in groups, each called by its first line.
class LineGroups {
 public:
  /// Lines that share an end are in one group.
  explicit LineGroups(const std::vector<OpenLine>& lines) : group_(lines.size()) {
    std::map<std::pair<double, double>, std::size_t> first;  // of the lines that have an end there
    for (std::size_t k = 0; k < lines.size(); ++k) {
      group_[k] = k;
      for (const Point& end : {lines[k].points.front(), lines[k].points.back()})
        join(k, first.try_emplace({end.x, end.y}, k).first->second);
    }
  }

  std::size_t of(std::size_t k) const {
    while (group_[k] != k) k = group_[k];
    return k;
  }
  void join(std::size_t k, std::size_t other) {
    const std::size_t a = of(k), b = of(other);
    group_[std::max(a, b)] = std::min(a, b);
    group_[k] = group_[other] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> group_;
};

/// Joins groups across the gaps of outlines that other lines cross. What is known then of these gaps, by group.
std::map<std::size_t, Closure> join_across_gaps(const std::vector<OpenLine>& lines, LineGroups& groups) {
  std::vector<std::size_t> roots(lines.size());
  std::map<std::size_t, std::vector<Point>> ends_of;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    roots[k] = groups.of(k);
    for (const Point& end : {lines[k].points.front(), lines[k].points.back()}) ends_of[roots[k]].push_back(end);
  }
  FreeEnds paired(lines, false);
  paired.pair();
  const std::vector<EndPair> across = ends_across_gaps(paired, roots, ends_of);
  for (const auto& [end, other] : across) groups.join(end / 2, other / 2);
  std::map<std::size_t, Closure> closures;
  for (const auto& [end, other] : across) {
    Closure& closure = closures[groups.of(end / 2)];
    const double clearness = clearness_of(lines, end, other);
    closure.clearness = closure.gaps.empty() ? clearness : std::min(closure.clearness, clearness);
    closure.gaps.push_back({paired.at(end), paired.at(other)});
    closure.gap_length += span_between(paired.at(end), paired.at(other));
  }
  return closures;
}

}  // namespace

std::vector<Closure> closures_of_groups(const std::vector<OpenLine>& lines) {
  LineGroups groups(lines);
  std::map<std::size_t, Closure> closures = join_across_gaps(lines, groups);
  std::map<std::size_t, std::vector<Point>> free, all;  // ends
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const OpenLine& line = lines[k];
    const std::size_t group = groups.of(k);
    Closure& closure = closures[group];
    closure.lines.push_back(k);
    closure.line_length += line.length();
    // Of two lines the second one begins where the first one ends, at the gap between them.
    std::vector<Point> points = line.points;
    if (line.free_start && closure.ring.empty()) std::reverse(points.begin(), points.end());
    if (line.free_end && !closure.ring.empty()) std::reverse(points.begin(), points.end());
    closure.ring.insert(closure.ring.end(), points.begin(), points.end());
    if (line.free_start) free[group].push_back(line.points.front());
    if (line.free_end) free[group].push_back(line.points.back());
    for (const Point& end : {line.points.front(), line.points.back()}) all[group].push_back(end);
  }
  std::vector<Closure> out;
  for (auto& [k, closure] : closures) {
    const std::vector<Point>& ends = free[k].size() > 1 ? free[k] : all[k];
    if (closure.gaps.empty()) {
      closure.gaps.push_back({ends.front(), ends.back()});
      closure.gap_length = span_between(ends.front(), ends.back());
    }
    out.push_back(std::move(closure));
  }
  return out;
}

bool roughly_inside(const Polygon& ring, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    if (is_left_of(p, a, b)) inside = !inside;
  }
  return inside;
}

bool roughly_inside(const Part& part, const Point& p) {
  return roughly_inside(part.outline, p) && std::none_of(part.holes.begin(), part.holes.end(),
                                                         [&](const Polygon& hole) { return roughly_inside(hole, p); });
}

Point inner_point(const Part& part) {
  std::vector<double> heights;
  for (const Point& p : part.outline) heights.push_back(p.y);
  for (const Polygon& hole : part.holes)
    for (const Point& p : hole) heights.push_back(p.y);
  std::sort(heights.begin(), heights.end());
  std::size_t highest = 1;
  for (std::size_t i = 1; i < heights.size(); ++i)
    if (heights[i] - heights[i - 1] > heights[highest] - heights[highest - 1]) highest = i;
  const double y = (heights[highest - 1] + heights[highest]) / 2;
  std::vector<double> at;
  const auto cut = [&](const Polygon& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((a.y > y) != (b.y > y)) at.push_back(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
    }
  };
  cut(part.outline);
  for (const Polygon& hole : part.holes) cut(hole);
  std::sort(at.begin(), at.end());
  Point best = part.outline.front();
  double width = 0;
  for (std::size_t i = 0; i + 1 < at.size(); i += 2) {
    if (at[i + 1] - at[i] <= width) continue;
    width = at[i + 1] - at[i];
    best = {at[i] + width / 2, y};
  }
  return best;
}

}  // namespace taut::drawing
