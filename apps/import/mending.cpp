#include "import/mending.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "geometry/segment_strips.hpp"
#include "import/faces.hpp"

namespace taut::drawing {
using namespace internal;

namespace {

struct BlockFacts {
  AxisBox box;
  std::vector<std::size_t> edges;
};

AxisBox edge_box(const LineGraph& graph, std::size_t e) {
  return {graph.point(graph.edges[e].from), graph.point(graph.edges[e].to)};
}

std::vector<BlockFacts> facts_of_blocks(const LineGraph& graph, const std::vector<int>& block) {
  std::vector<BlockFacts> facts;
  for (std::size_t e = 0; e < block.size(); ++e) {
    if (block[e] < 0) continue;
    const auto b = static_cast<std::size_t>(block[e]);
    if (facts.size() <= b) facts.resize(b + 1);
    if (facts[b].edges.empty()) facts[b].box = edge_box(graph, e);
    facts[b].box.include(edge_box(graph, e));
    facts[b].edges.push_back(e);
  }
  return facts;
}

struct FaceFacts {
  double area = 0, around = 0;
  std::optional<AxisBox> box;
  double block = 0;  ///< the extent of the largest block at it
};

/// Of each face; the areas of the bounded ones are positive.
std::vector<FaceFacts> facts_of_faces(const LineGraph& graph, const std::vector<bool>& alive, const FaceMap& faces) {
  const Subdivision& map = faces.map;
  const std::vector<int> block = blocks_of(graph, alive);
  const std::vector<BlockFacts> blocks = facts_of_blocks(graph, block);
  std::vector<FaceFacts> facts(static_cast<std::size_t>(map.faces()));
  const std::vector<double> areas = areas_of_faces(faces);
  for (std::size_t f = 0; f < facts.size(); ++f) facts[f].area = areas[f];
  for (int h = 0; h < map.half_edges(); ++h) {
    const Point &a = map.point(map.origin(h)), &b = map.point(map.target(h));
    FaceFacts& face = facts[static_cast<std::size_t>(map.face(h))];
    face.around += std::hypot(b.x - a.x, b.y - a.y);
    if (face.box)
      face.box->include(AxisBox(a, b));
    else
      face.box = AxisBox(a, b);
    const auto in = static_cast<std::size_t>(block[static_cast<std::size_t>(faces.edge(h))]);
    face.block = std::max(face.block, blocks[in].box.longest());
  }
  return facts;
}

/// Which faces become one with which others; no face is part of two such pairs.
std::map<int, int> merges_of(const LineGraph& graph, const FaceMap& faces, const std::set<int>& small) {
  std::map<int, std::map<int, double>> beside;
  for (int h = 0; h < faces.map.half_edges(); ++h)
    if (small.count(faces.map.face(h)))
      beside[faces.map.face(h)][faces.map.face(h ^ 1)] += graph.length(2 * faces.edge(h));
  std::map<int, int> merges;
  std::set<int> changed;
  for (const auto& [face, sides] : beside) {
    const auto longest =
        std::max_element(sides.begin(), sides.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    if (changed.count(face) || changed.count(longest->first)) continue;
    changed.insert(face);
    if (small.count(longest->first)) changed.insert(longest->first);
    merges[face] = longest->first;
  }
  return merges;
}

}  // namespace

bool dissolve_small_faces(const LineGraph& graph, std::vector<bool>& alive, const FaceMap& faces, double join,
                          double size, std::vector<Repair>& repairs) {
  if (faces.map.half_edges() == 0) return false;
  const std::vector<FaceFacts> facts = facts_of_faces(graph, alive, faces);
  const auto is_sliver = [join](const FaceFacts& face) { return 4 * face.area <= join * face.around; };
  std::set<int> small;
  for (int f = 1; f < faces.map.faces(); ++f) {
    const FaceFacts& face = facts[static_cast<std::size_t>(f)];
    const bool loop = face.box->longest() <= size && face.block > size;
    if (loop || (join > 0 && is_sliver(face))) small.insert(f);
  }
  const std::map<int, int> merges = merges_of(graph, faces, small);
  std::set<int> reported;
  for (int h = 0; h < faces.map.half_edges(); ++h) {
    const auto merge = merges.find(faces.map.face(h));
    if (merge == merges.end() || merge->second != faces.map.face(h ^ 1)) continue;
    alive[static_cast<std::size_t>(faces.edge(h))] = false;
    if (!reported.insert(merge->first).second) continue;
    const FaceFacts& face = facts[static_cast<std::size_t>(merge->first)];
    const bool sliver = is_sliver(face);
    repairs.push_back({sliver ? Repair::Kind::sliver : Repair::Kind::loop, faces.map.point(faces.map.origin(h)),
                       sliver ? 2 * face.area / face.around : face.box->longest(),
                       graph.edges[static_cast<std::size_t>(faces.edge(h))].source});
  }
  return !merges.empty();
}

namespace {

/// The half-edges of a block that is one simple cycle, in order; empty if it is something else.
std::vector<int> cycle_of(const LineGraph& graph, const Incidence& all, const std::vector<int>& block,
                          const std::vector<std::size_t>& edges) {
  const int number = block[edges.front()];
  std::vector<int> cycle;
  int h = static_cast<int>(2 * edges.front());
  do {
    cycle.push_back(h);
    const int there = graph.target(h);
    int onward = -1, count = 0;
    for (const int* out = all.begin(there); out != all.end(there); ++out) {
      if (block[static_cast<std::size_t>(*out / 2)] != number) continue;
      ++count;
      if (*out != (h ^ 1)) onward = *out;
    }
    if (count != 2) return {};
    h = onward;
  } while (h != cycle.front() && cycle.size() <= edges.size());
  return cycle.size() == edges.size() ? cycle : std::vector<int>();
}

double twice_area_of(const LineGraph& graph, const std::vector<int>& cycle) {
  const Point& o = graph.point(graph.target(cycle.front()));
  double twice = 0;
  for (const int h : cycle) {
    const Point &a = graph.point(graph.target(h ^ 1)), &b = graph.point(graph.target(h));
    twice += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
  }
  return std::fabs(twice);
}

/// Positions in the cycle of the nodes where other lines go on, or else of those farthest from there; in order. None if
/// there are more than two.
std::vector<std::size_t> ends_of(const LineGraph& graph, const Incidence& all, const std::vector<int>& cycle) {
  std::vector<std::size_t> ends;
  for (std::size_t k = 0; k < cycle.size(); ++k)
    if (all.degree(graph.target(cycle[k])) > 2) ends.push_back(k);
  if (ends.size() > 2) return {};
  const auto farthest = [&](std::size_t from) {
    const Point& p = graph.point(graph.target(cycle[from]));
    const auto distance = [&](int h) {
      const Point& q = graph.point(graph.target(h));
      return std::hypot(q.x - p.x, q.y - p.y);
    };
    const auto most =
        std::max_element(cycle.begin(), cycle.end(), [&](int g, int h) { return distance(g) < distance(h); });
    return static_cast<std::size_t>(most - cycle.begin());
  };
  if (ends.empty()) ends.push_back(farthest(0));
  if (ends.size() == 1) ends.push_back(farthest(ends[0]));
  std::sort(ends.begin(), ends.end());
  return ends;
}

/// Of the two ways from end to end.
std::vector<int> longer_copy(const LineGraph& graph, const std::vector<int>& cycle,
                             const std::vector<std::size_t>& ends) {
  std::vector<int> copies[2];
  double lengths[2] = {0, 0};
  for (std::size_t k = 0; k < cycle.size(); ++k) {
    const std::size_t copy = ends[0] < k && k <= ends[1] ? 0 : 1;
    copies[copy].push_back(cycle[k]);
    lengths[copy] += graph.length(cycle[k]);
  }
  return copies[lengths[0] > lengths[1] ? 0 : 1];
}

}  // namespace

void thin_doubled_lines(const LineGraph& graph, std::vector<bool>& alive, double join, double size,
                        std::vector<Repair>& repairs) {
  if (!(join > 0)) return;
  const Incidence all(graph, alive);
  const std::vector<int> block_of = blocks_of(graph, alive);
  for (const BlockFacts& block : facts_of_blocks(graph, block_of)) {
    if (block.edges.size() < 2 || block.box.longest() <= std::max(join, size)) continue;
    const std::vector<int> cycle = cycle_of(graph, all, block_of, block.edges);
    double around = 0;
    for (const int h : cycle) around += graph.length(h);
    if (cycle.empty() || 2 * twice_area_of(graph, cycle) > join * around) continue;
    const std::vector<std::size_t> ends = ends_of(graph, all, cycle);
    if (ends.empty() || ends[0] == ends[1]) continue;
    const std::vector<int> copy = longer_copy(graph, cycle, ends);
    for (const int h : copy) alive[static_cast<std::size_t>(h / 2)] = false;
    repairs.push_back({Repair::Kind::sliver, graph.point(graph.target(copy.front())),
                       twice_area_of(graph, cycle) / around,
                       graph.edges[static_cast<std::size_t>(copy.front() / 2)].source});
  }
}

void cut_spikes(const LineGraph& graph, std::vector<bool>& alive, std::vector<Repair>& repairs) {
  const Incidence all(graph, alive);
  const std::size_t nodes = graph.nodes.size();
  std::vector<int> degree(nodes), ends;
  for (int node = 0; node < static_cast<int>(nodes); ++node) {
    degree[static_cast<std::size_t>(node)] = all.degree(node);
    if (all.degree(node) == 1) ends.push_back(node);
  }
  std::vector<bool> hanging(alive.size(), false);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (const int* h = all.begin(ends[i]); h != all.end(ends[i]); ++h) {
      const auto e = static_cast<std::size_t>(*h / 2);
      if (!alive[e]) continue;
      alive[e] = false;
      hanging[e] = true;
      if (--degree[static_cast<std::size_t>(graph.target(*h))] == 1) ends.push_back(graph.target(*h));
    }
  }
  const Incidence spikes(graph, hanging);
  std::vector<bool> seen(nodes, false);
  for (int first = 0; first < static_cast<int>(nodes); ++first) {
    if (seen[static_cast<std::size_t>(first)] || spikes.degree(first) == 0) continue;
    std::vector<int> tree{first};
    seen[static_cast<std::size_t>(first)] = true;
    AxisBox box(graph.point(first), graph.point(first));
    int root = first;
    for (std::size_t i = 0; i < tree.size(); ++i) {
      box.include(AxisBox(graph.point(tree[i]), graph.point(tree[i])));
      if (spikes.degree(tree[i]) < all.degree(tree[i])) root = tree[i];
      for (const int* h = spikes.begin(tree[i]); h != spikes.end(tree[i]); ++h) {
        const int there = graph.target(*h);
        if (seen[static_cast<std::size_t>(there)]) continue;
        seen[static_cast<std::size_t>(there)] = true;
        tree.push_back(there);
      }
    }
    repairs.push_back({Repair::Kind::spike, graph.point(root), box.longest(), graph.edge(*spikes.begin(first)).source});
  }
}

bool cut_loops(const LineGraph& graph, std::vector<bool>& alive, double size, std::vector<Repair>& repairs) {
  if (!(size > 0)) return false;
  const std::vector<BlockFacts> blocks = facts_of_blocks(graph, blocks_of(graph, alive));
  // Of the larger blocks and the loops that hang on them, and on each other.
  std::vector<bool> held(graph.nodes.size(), false);
  const auto hold = [&](const BlockFacts& block) {
    for (const std::size_t e : block.edges)
      for (const int node : {graph.edges[e].from, graph.edges[e].to}) held[static_cast<std::size_t>(node)] = true;
  };
  std::vector<const BlockFacts*> small;
  for (const BlockFacts& block : blocks) {
    if (block.box.longest() > size)
      hold(block);
    else if (!block.edges.empty())
      small.push_back(&block);
  }
  const std::size_t before = repairs.size();
  for (bool more = true; more;) {
    more = false;
    std::erase_if(small, [&](const BlockFacts* block) {
      const auto at = std::find_if(block->edges.begin(), block->edges.end(), [&](std::size_t e) {
        return held[static_cast<std::size_t>(graph.edges[e].from)] || held[static_cast<std::size_t>(graph.edges[e].to)];
      });
      if (at == block->edges.end()) return false;
      const LineGraph::Edge& edge = graph.edges[*at];
      const int node = held[static_cast<std::size_t>(edge.from)] ? edge.from : edge.to;
      repairs.push_back({Repair::Kind::loop, graph.point(node), block->box.longest(), edge.source});
      for (const std::size_t e : block->edges) alive[e] = false;
      hold(*block);
      more = true;
      return true;
    });
  }
  return repairs.size() > before;
}

}  // namespace taut::drawing
