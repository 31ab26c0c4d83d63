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
  SegmentBox box;
  std::vector<std::size_t> edges;
};

SegmentBox edge_box(const LineGraph& graph, std::size_t e) {
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
  std::optional<SegmentBox> box;
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
      face.box->include(SegmentBox(a, b));
    else
      face.box = SegmentBox(a, b);
    const auto in = static_cast<std::size_t>(block[static_cast<std::size_t>(faces.edge(h))]);
    face.block = std::max(face.block, blocks[in].box.extent());
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
    const bool loop = face.box->extent() <= size && face.block > size;
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
                       sliver ? 2 * face.area / face.around : face.box->extent(),
                       graph.edges[static_cast<std::size_t>(faces.edge(h))].source});
  }
  return !merges.empty();
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
    if (block.box.extent() > size)
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
      repairs.push_back({Repair::Kind::loop, graph.point(node), block->box.extent(), edge.source});
      for (const std::size_t e : block->edges) alive[e] = false;
      hold(*block);
      more = true;
      return true;
    });
  }
  return repairs.size() > before;
}

}  // namespace taut::drawing
