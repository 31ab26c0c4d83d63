// Lines of a drawing as a graph in which they meet at nodes only.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "taut/geometry.hpp"

namespace taut::drawing {

/// A chain of straight lines on its way into the graph.
struct Strand {
  std::vector<Point> points;
  bool closed = false;
  std::size_t source = 0;  ///< index of the chain that it comes from
};

/// Nodes in lexicographic order; edges by their nodes, from the smaller one to the larger one. Half-edge 2e runs along
/// edge e, 2e + 1 against it. Neither depends on the order of the strands.
struct LineGraph {
  struct Edge {
    int from = 0, to = 0;
    int winding = 0;         ///< how often strands run along it, less how often against it
    int times = 0;           ///< how often they run along it or against it
    std::size_t source = 0;  ///< the first of the chains that do
  };
  std::vector<Point> nodes;
  std::vector<Edge> edges;
  std::vector<std::vector<int>> walks;  ///< the half-edges along each strand

  int origin(int h) const { return h % 2 == 0 ? edge(h).from : edge(h).to; }
  int target(int h) const { return origin(h ^ 1); }
  const Edge& edge(int h) const { return edges[static_cast<std::size_t>(h / 2)]; }
  const Point& point(int node) const { return nodes[static_cast<std::size_t>(node)]; }
  double length(int h) const;
};

/// The half-edges that leave each node, of the edges that are `alive`.
class Incidence {
 public:
  Incidence(const LineGraph& graph, const std::vector<bool>& alive);
  int degree(int node) const {
    return first_[static_cast<std::size_t>(node + 1)] - first_[static_cast<std::size_t>(node)];
  }
  const int* begin(int node) const { return out_.data() + first_[static_cast<std::size_t>(node)]; }
  const int* end(int node) const { return out_.data() + first_[static_cast<std::size_t>(node + 1)]; }

 private:
  std::vector<int> first_, out_;
};

/// How fine the graph of these strands is: points so near to each other are one node, and nodes within a quarter of it
/// from a line are on that line. It is a 2^-40th of the drawing's size, and exceeds what rounding moves a crossing by.
double node_distance(const std::vector<Strand>& strands);

/// Splits the strands where they cross, touch or overlap. Whether they cross is decided exactly; the place of a
/// crossing is rounded once, and moved to a node within node_distance(), if there is one. Throws InputError with the
/// place `file` if lines cross more than `most` times.
LineGraph split_at_crossings(const std::vector<Strand>& strands, std::size_t most, const std::string& file);

/// The blocks of a graph, of the edges that are alive: two edges are in one block if they are on a common cycle. An
/// edge on no cycle is a block by itself. -1 for the others.
std::vector<int> blocks_of(const LineGraph& graph, const std::vector<bool>& alive);

}  // namespace taut::drawing
