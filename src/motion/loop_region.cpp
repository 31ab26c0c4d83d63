#include "motion/loop_region.hpp"

#include <atomic>
#include <cmath>
#include <queue>
#include <tuple>

#include "motion/joint_functions.hpp"
#include "numeric/budget.hpp"

namespace taut::internal {
namespace {

/// A side is divided so often.
constexpr double least_box_share = 0x1p-10;
constexpr std::size_t most_boxes = std::size_t{1} << 16;
/// Boxes are asked about that are larger than they should be, by what rounds.
constexpr double box_slack_share = 0x1p-40;

/// Is each exact value certainly within the radii of the other one?
bool is_within(const Balls<double>& values, const Balls<double>& of, const std::vector<double>& radii) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!((values[i] - of[i]).magnitude() < radii[i])) return false;
  }
  return true;
}

Balls<double> widened_by(Balls<double> values, const std::vector<double>& error) {
  for (std::size_t i = 0; i < values.size(); ++i) values[i].rad = detail::inflate(values[i].rad + error[i]);
  return values;
}

std::vector<double> middles_of(const Balls<double>& values) {
  std::vector<double> out;
  for (const Ball<double>& x : values) out.push_back(x.mid);
  return out;
}

}  // namespace

bool LoopRegion::touches(const Node& node, const Values& lo, const Values& hi) const {
  for (std::size_t k = 0; k < ranges_.size(); ++k) {
    if (node.lo[k] > hi[k] || lo[k] > node.hi[k]) return false;
  }
  return true;
}

template <class Visit>
void LoopRegion::for_each_leaf(const Values& lo, const Values& hi, const Visit& visit) const {
  std::vector<int> todo{0};
  while (!todo.empty()) {
    const int number = todo.back();
    const Node& node = nodes_[static_cast<std::size_t>(number)];
    todo.pop_back();
    if (!touches(node, lo, hi)) continue;
    if (node.state == State::divided) {
      todo.push_back(node.children + 1);
      todo.push_back(node.children);
    } else {
      visit(number);
    }
  }
}

std::vector<double> LoopRegion::place(const Values& at) const {
  std::vector<double> d(equations_.drives.size());
  for (std::size_t k = 0; k < ranges_.size(); ++k) d[static_cast<std::size_t>(ranges_[k].drive)] = at[k];
  return d;
}

DriveBox LoopRegion::drives(const Values& middle, const Values& half) const { return {place(middle), place(half)}; }

DriveBox LoopRegion::drives(const Node& node) const {
  Values middle{}, half{};
  for (std::size_t k = 0; k < ranges_.size(); ++k) {
    middle[k] = node.lo[k] + (node.hi[k] - node.lo[k]) / 2;
    half[k] = std::max(node.hi[k] - middle[k], middle[k] - node.lo[k]) * (1 + 0x1p-50);
  }
  return drives(middle, half);
}

/// From the box with the drawn pose on, the larger boxes first, each from a neighbour that is known.
class LoopRegion::Builder {
 public:
  explicit Builder(LoopRegion& region) : region_(region) {}

  void run() {
    push({0, -1, {}});
    while (!queue_.empty()) {
      checkpoint();
      const Attempt next = std::get<Attempt>(queue_.top());
      queue_.pop();
      attempt(next);
    }
  }

 private:
  Node& node(int number) { return region_.nodes_[static_cast<std::size_t>(number)]; }

  void push(const Attempt& attempt) { queue_.push({-node(attempt.node).depth, --order_, attempt}); }

  void attempt(const Attempt& given) {
    if (node(given.node).state == State::divided) {
      for (const int half : {0, 1}) {
        const int child = node(given.node).children + half;
        if (region_.touches(node(child), given.place, given.place)) push({child, given.from, given.place});
      }
      return;
    }
    if (node(given.node).state != State::unknown) return;
    if (solve(given)) {
      accept(given.node);
    } else if (divide(given.node)) {
      attempt(given);
    } else {
      node(given.node).state = State::irregular;
    }
  }

  bool solve(const Attempt& given) {
    const DriveBox box = region_.drives(node(given.node));
    std::vector<double> about(static_cast<std::size_t>(region_.equations_.unknowns));
    if (given.from >= 0) {
      const Node& known = node(given.from);
      about = middles_of(known.solution.about(region_.drives(known), box.middle));
    }
    auto found = solve_over(region_.equations_, region_.weights_, box, std::move(about));
    if (!found) return false;
    BoxSolution& solution = node(given.node).solution;
    solution = std::move(*found);
    if (given.from >= 0)
      return agree(given.from, given.node, given.place) || agree(given.node, given.from, given.place);
    const Balls<double> drawn(solution.at.size(), Ball<double>::exact(0));
    return is_within(drawn, solution.about(box, region_.place({})), solution.tube);
  }

  /// Do the solutions of two boxes agree where these meet?
  bool agree(int a, int b, const Values& at) {
    const std::vector<double> d = region_.place(at);
    const Node &first = node(a), &second = node(b);
    const Balls<double> values = widened_by(first.solution.about(region_.drives(first), d), first.solution.error);
    return is_within(values, second.solution.about(region_.drives(second), d), second.solution.tube);
  }

  Values common_point(int a, int b) {
    Values at{};
    for (std::size_t k = 0; k < region_.ranges_.size(); ++k) {
      const double lo = std::max(node(a).lo[k], node(b).lo[k]), hi = std::min(node(a).hi[k], node(b).hi[k]);
      at[k] = lo + (hi - lo) / 2;
    }
    return at;
  }

  void accept(int number) {
    std::vector<int> around;
    region_.for_each_leaf(node(number).lo, node(number).hi, [&](int other) {
      if (other != number) around.push_back(other);
    });
    for (const int other : around) {
      if (node(other).state != State::regular) continue;
      const Values at = common_point(number, other);
      if (agree(number, other, at) || agree(other, number, at)) continue;
      // The branches that lead here from two sides are not the same.
      node(number).state = State::irregular;
      return;
    }
    node(number).state = State::regular;
    for (const int other : around) {
      if (node(other).state == State::unknown) push({other, number, common_point(number, other)});
    }
  }

  /// Across the longest side, as drives count equally.
  bool divide(int number) {
    if (region_.nodes_.size() + 2 > most_boxes) return false;
    const std::vector<double> weights = weights_of_drives(region_.equations_);
    std::optional<std::size_t> axis;
    double longest = 0;
    for (std::size_t k = 0; k < region_.ranges_.size(); ++k) {
      const double side = node(number).hi[k] - node(number).lo[k];
      const double counts = side / weights[static_cast<std::size_t>(region_.ranges_[k].drive)];
      if (!(side > least_box_share * (node(0).hi[k] - node(0).lo[k])) || !(counts > longest)) continue;
      longest = counts;
      axis = k;
    }
    if (!axis) return false;
    Node half;
    half.lo = node(number).lo;
    half.hi = node(number).hi;
    half.depth = node(number).depth + 1;
    const double middle = half.lo[*axis] + (half.hi[*axis] - half.lo[*axis]) / 2;
    node(number).state = State::divided;
    node(number).children = static_cast<int>(region_.nodes_.size());
    const double end = std::exchange(half.hi[*axis], middle);
    region_.nodes_.push_back(half);
    half.lo[*axis] = middle;
    half.hi[*axis] = end;
    region_.nodes_.push_back(half);
    return true;
  }

  struct Later {
    bool operator()(const std::tuple<int, int, Attempt>& a, const std::tuple<int, int, Attempt>& b) const {
      return std::tie(std::get<0>(a), std::get<1>(a)) < std::tie(std::get<0>(b), std::get<1>(b));
    }
  };
  LoopRegion& region_;
  std::priority_queue<std::tuple<int, int, Attempt>, std::vector<std::tuple<int, int, Attempt>>, Later> queue_;
  int order_ = 0;
};

LoopRegion::LoopRegion(LoopEquations equations, std::vector<Range> ranges)
    : equations_(std::move(equations)), weights_(weights_of(equations_)), ranges_(std::move(ranges)) {
  static std::atomic<std::uint64_t> next{1};
  id_ = next++;
  Node all;
  for (std::size_t k = 0; k < ranges_.size(); ++k) {
    all.lo[k] = std::min(0.0, ranges_[k].lo);
    all.hi[k] = std::max(0.0, ranges_[k].hi);
    const double more = (all.hi[k] - all.lo[k]) * box_slack_share;
    all.lo[k] -= more;
    all.hi[k] += more;
  }
  nodes_.push_back(std::move(all));
  Builder(*this).run();
}

namespace {

/// The unknowns of the joints between a loop's two ends; nothing if one of them is not an unknown itself or its
/// negative, or if two joints have the same one.
std::optional<std::vector<int>> plain_unknowns_of(const LoopEquations& equations, const LoopEquations::Closure& loop) {
  if (loop.value) return std::nullopt;
  std::vector<int> around;
  for_each_joint_on_path(equations, loop.first, [&](int k) { around.push_back(k); });
  for_each_joint_on_path(equations, loop.second, [&](int k) {
    const auto common = std::find(around.begin(), around.end(), k);
    if (common == around.end()) {
      around.push_back(k);
    } else {
      around.erase(common);
    }
  });
  std::vector<int> unknowns;
  for (const int k : around) {
    const std::vector<LinearForm::Term>& terms = equations.joints[static_cast<std::size_t>(k)].value.unknowns;
    if (terms.empty()) continue;
    const Ball<double>& factor = terms.front().near;
    if (terms.size() != 1 || factor.rad != 0 || std::fabs(factor.mid) != 1) return std::nullopt;
    if (std::find(unknowns.begin(), unknowns.end(), terms.front().of) != unknowns.end()) return std::nullopt;
    unknowns.push_back(terms.front().of);
  }
  return unknowns;
}

/// Can the loops be solved one after the other, each for two joints of its own and the one that closes it?
bool is_solved_loop_by_loop(const LoopEquations& equations) {
  std::vector<std::vector<int>> loops;
  for (const LoopEquations::Closure& closure : equations.closures) {
    auto unknowns = plain_unknowns_of(equations, closure);
    if (!unknowns) return false;
    loops.push_back(std::move(*unknowns));
  }
  std::vector<char> known(static_cast<std::size_t>(equations.unknowns));
  const auto is_known = [&](int u) { return known[static_cast<std::size_t>(u)] != 0; };
  while (!loops.empty()) {
    const auto next = std::find_if(loops.begin(), loops.end(), [&](const std::vector<int>& unknowns) {
      return unknowns.size() - static_cast<std::size_t>(std::count_if(unknowns.begin(), unknowns.end(), is_known)) == 2;
    });
    if (next == loops.end()) return false;
    for (const int u : *next) known[static_cast<std::size_t>(u)] = 1;
    loops.erase(next);
  }
  return true;
}

}  // namespace

bool LoopRegion::has_one_pose() const {
  int varied = 0;
  for (std::size_t k = 0; k < ranges_.size(); ++k) varied += nodes_[0].lo[k] < nodes_[0].hi[k];
  if (varied < 2 || is_solved_loop_by_loop(equations_)) return true;
  return std::all_of(nodes_.begin(), nodes_.end(),
                     [](const Node& node) { return node.state == State::divided || node.state == State::regular; });
}

LoopRegion::Inside LoopRegion::inside(const Values& middle, const Values& half) const {
  Inside box;
  for (std::size_t k = 0; k < ranges_.size(); ++k) {
    const auto joint = static_cast<std::size_t>(ranges_[k].joint);
    const double slack = box_slack_share * (nodes_[0].hi[k] - nodes_[0].lo[k]),
                 counts = std::max(0.0, std::fabs(half[joint]) - slack);
    box.at[k] = middle[joint];
    box.lo[k] = middle[joint] - counts;
    box.hi[k] = middle[joint] + counts;
  }
  return box;
}

LoopRegion::Parts LoopRegion::parts_of(const Inside& box) const {
  Parts parts;
  for (std::size_t k = 0; k < ranges_.size(); ++k)
    parts.all_regular = parts.all_regular && nodes_[0].lo[k] <= box.lo[k] && box.hi[k] <= nodes_[0].hi[k];
  for_each_leaf(box.lo, box.hi, [&](int number) {
    const Node& node = nodes_[static_cast<std::size_t>(number)];
    const bool regular = node.state == State::regular;
    parts.any_regular = parts.any_regular || regular;
    parts.all_regular = parts.all_regular && regular;
    if (touches(node, box.at, box.at)) parts.at_middle = &node;
  });
  return parts;
}

std::optional<BoxSolution> LoopRegion::solved(const Values& middle, const Values& half) const {
  const Inside given = inside(middle, half);
  const Parts parts = parts_of(given);
  const Node* const around = parts.at_middle;
  if (!parts.all_regular || !around) return std::nullopt;
  Values swing{};
  for (std::size_t k = 0; k < ranges_.size(); ++k)
    swing[k] = std::fabs(half[static_cast<std::size_t>(ranges_[k].joint)]);
  const DriveBox box = drives(given.at, swing), known = drives(*around);
  const Balls<double> about = around->solution.about(known, box.middle);
  auto found = solve_over(equations_, weights_, box, middles_of(about));
  if (!found) return std::nullopt;
  // It is the region's own if it is at the middle.
  Balls<double> at_middle;
  for (std::size_t i = 0; i < about.size(); ++i) at_middle.emplace_back(found->at[i], found->at_middle[i]);
  return is_within(at_middle, about, around->solution.tube) ? std::move(found) : std::nullopt;
}

/// All pairs ask about one box of joint values in turn, and then about a point in it.
const std::optional<BoxSolution>& LoopRegion::known(const Values& middle, const Values& half) const {
  struct Known {
    std::uint64_t id = 0;
    Values middle{}, half{};
    std::optional<BoxSolution> solution;
  };
  thread_local std::array<Known, 8> all;
  thread_local std::size_t last = 0;
  const auto same = [&](const Values& a, const Values& b) {
    return std::all_of(ranges_.begin(), ranges_.end(), [&](const Range& range) {
      const auto k = static_cast<std::size_t>(range.joint);
      return a[k] == b[k];
    });
  };
  for (const Known& k : all) {
    if (k.id == id_ && same(k.middle, middle) && same(k.half, half)) return k.solution;
  }
  last = (last + 1) % all.size();
  all[last] = {0, middle, half, solved(middle, half)};
  all[last].id = id_;
  return all[last].solution;
}

LoopRegion::Share LoopRegion::share_of(const Values& middle, const Values& half) const {
  const Parts parts = parts_of(inside(middle, half));
  return !parts.any_regular ? Share::none : parts.all_regular ? Share::all : Share::some;
}

std::optional<LoopRegion::Value> LoopRegion::value(std::size_t joint, const Values& middle, const Values& half) const {
  const std::optional<BoxSolution>& u = known(middle, half);
  if (!u) return std::nullopt;
  const LinearForm& form = equations_.joints[joint].value;
  Value sum{Ball<double>::exact(0), Ball<double>::exact(0), {}};
  for (const LinearForm::Term& term : form.unknowns) {
    const Ball<double> factor = term.as<double>();
    const auto i = static_cast<std::size_t>(term.of);
    double radius = u->error[i];
    for (const Range& range : ranges_) {
      const auto of = static_cast<std::size_t>(range.drive), k = static_cast<std::size_t>(range.joint);
      if (u->slope[of].empty()) continue;
      radius += std::fabs(u->slope[of][i] * half[k]);
      sum.slope[k] = sum.slope[k] + Ball<double>(u->slope[of][i], u->slope_error[of][i]) * factor;
    }
    sum.middle = sum.middle + Ball<double>(u->at[i], u->at_middle[i]) * factor;
    sum.range = sum.range + Ball<double>(u->at[i], detail::inflate(radius)) * factor;
  }
  for (const LinearForm::Term& term : form.drives) {
    const auto range = std::find_if(ranges_.begin(), ranges_.end(), [&](const Range& r) { return r.drive == term.of; });
    if (range == ranges_.end()) continue;
    const Ball<double> factor = term.as<double>();
    const auto k = static_cast<std::size_t>(range->joint);
    sum.slope[k] = sum.slope[k] + factor;
    sum.middle = sum.middle + Ball<double>::exact(middle[k]) * factor;
    sum.range = sum.range + Ball<double>(middle[k], std::fabs(half[k])) * factor;
  }
  return sum;
}

bool LoopRegion::depends(std::size_t joint, int on) const {
  const LinearForm& form = equations_.joints[joint].value;
  return std::any_of(ranges_.begin(), ranges_.end(), [&](const Range& range) {
    const auto is_drive = [&](const LinearForm::Term& term) { return term.of == range.drive; };
    return range.joint == on &&
           (!form.unknowns.empty() || std::any_of(form.drives.begin(), form.drives.end(), is_drive));
  });
}

bool LoopRegion::has_straight_way(const Values& to) const {
  Values end{};
  for (std::size_t k = 0; k < ranges_.size(); ++k) end[k] = to[static_cast<std::size_t>(ranges_[k].joint)];
  // Parts of the way by their ends, as shares of it.
  std::vector<std::array<double, 2>> todo{{0, 1}};
  while (!todo.empty()) {
    const auto [from, until] = todo.back();
    todo.pop_back();
    Values lo{}, hi{};
    for (std::size_t k = 0; k < ranges_.size(); ++k) {
      const double rounding = 0x1p-50 * std::fabs(end[k]);
      lo[k] = std::min(from * end[k], until * end[k]) - rounding;
      hi[k] = std::max(from * end[k], until * end[k]) + rounding;
    }
    bool regular = true;
    for_each_leaf(lo, hi, [&](int number) {
      regular = regular && nodes_[static_cast<std::size_t>(number)].state == State::regular;
    });
    if (regular) continue;
    if (until - from < 0x1p-16) return false;
    todo.push_back({from, from + (until - from) / 2});
    todo.push_back({from + (until - from) / 2, until});
  }
  return true;
}

}  // namespace taut::internal
