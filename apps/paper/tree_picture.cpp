#include "tree_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tiling/chain_tree.hpp"

namespace taut::paper {
using namespace internal;
namespace {

double distance(const Point& p, const Point& a, const Point& b) {
  const double ex = b.x - a.x, ey = b.y - a.y;
  const double share = std::clamp(((p.x - a.x) * ex + (p.y - a.y) * ey) / (ex * ex + ey * ey), 0.0, 1.0);
  return std::hypot(p.x - a.x - share * ex, p.y - a.y - share * ey);
}

/// A place inside a face, far from its boundary: the best middle of three of its vertices.
Point place_in(const Tiling& tiling, const TilingFace& face) {
  std::vector<Point> b;
  for (const int v : face.boundary) b.push_back(tiling.vertices[static_cast<std::size_t>(v)].position);
  const auto clearance = [&b](const Point& p) {
    bool inside = false;
    double least = INFINITY;
    for (std::size_t i = 0, j = b.size() - 1; i < b.size(); j = i++) {
      least = std::min(least, distance(p, b[j], b[i]));
      if ((b[i].y > p.y) != (b[j].y > p.y) && p.x < b[j].x + (p.y - b[j].y) / (b[i].y - b[j].y) * (b[i].x - b[j].x))
        inside = !inside;
    }
    return inside ? least : 0;
  };
  Point best{};
  double most = -1;
  for (std::size_t i = 0; i < b.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const Point middle{(b[i].x + b[j].x + b[k].x) / 3, (b[i].y + b[j].y + b[k].y) / 3};
        if (const double c = clearance(middle); c > most) most = c, best = middle;
      }
    }
  }
  return best;
}

}  // namespace

SubtreePicture::SubtreePicture(const Scene&, const Tiling& tiling, int body, int depth, int place) {
  int first = 0, size = 0;
  for (std::size_t i = 0; i < tiling.vertices.size(); ++i) {
    if (tiling.vertices[i].vertex.body != body) continue;
    if (size++ == 0) first = static_cast<int>(i);
  }
  // The numbering of the nodes does not matter here: any root will do.
  const ChainTree tree(static_cast<std::uint32_t>(size), node::p_tree);
  ChainNode top = tree.root();
  for (int level = depth; level > 0; --level) top = (place >> (level - 1)) & 1 ? node::right(top) : node::left(top);
  const auto chain = tree.chain(top);
  const double length = chain.second - chain.first;
  for (std::uint32_t i = chain.first; i <= chain.second; ++i) {
    const std::string letter(1, static_cast<char>('a' + (i - chain.first)));
    letters_.emplace_back(first + static_cast<int>(i) % size, letter);
  }
  int faces = 0;
  const std::function<void(ChainNode, int)> add = [&](ChainNode n, int parent) {
    const auto ends = tree.chain(n);
    Node out{node::depth(n) - depth,
             static_cast<int>(ends.first - chain.first),
             static_cast<int>(ends.second - chain.first),
             ((ends.first + ends.second) / 2.0 - chain.first) / length,
             parent,
             "-"};
    for (const TilingFace& face : tiling.faces) {
      const int from = first + static_cast<int>(ends.first) % size, to = first + static_cast<int>(ends.second) % size;
      if (face.kind != FaceKind::node || face.body != body || face.depth != node::depth(n) || face.chain_from != from ||
          face.chain_to != to)
        continue;
      out.face = std::to_string(++faces);
      face_labels_.emplace_back(place_in(tiling, face), out.face);
    }
    nodes_.push_back(out);
    const int self = static_cast<int>(nodes_.size()) - 1;
    if (tree.is_leaf(n)) return;
    add(node::left(n), self);
    add(node::right(n), self);
  };
  add(top, -1);
}

std::string SubtreePicture::draw(int width) const {
  int deepest = 0;
  for (const Node& n : nodes_) deepest = std::max(deepest, n.depth);
  const double row = 78, margin = 34, height = 40 + row * deepest + 50;
  const auto x = [&](const Node& n) { return margin + n.x * (width - 2 * margin); };
  const auto y = [&](const Node& n) { return 36 + row * n.depth; };
  std::string lines, boxes;
  for (const Node& n : nodes_) {
    if (n.parent >= 0) {
      const Node& p = nodes_[static_cast<std::size_t>(n.parent)];
      lines += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#9aa4ad\"/>\n", x(p), y(p) + 18, x(n),
                           y(n) - 18);
    }
    const std::string ends =
        letters_[static_cast<std::size_t>(n.from)].second + letters_[static_cast<std::size_t>(n.to)].second;
    const bool has_face = n.face != "-";
    boxes += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"34\" height=\"36\" rx=\"5\" fill=\"{}\" stroke=\"#5f6b76\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" fill=\"#222\">{}</text>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" fill=\"#222\" font-weight=\"{}\">{}</text>\n",
        x(n) - 17, y(n) - 18, has_face ? "#bad6ee" : "#ffffff", x(n), y(n) - 4, ends, x(n), y(n) + 13,
        has_face ? "bold" : "normal", n.face);
  }
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1:.0f}\" viewBox=\"0 0 {0} {1:.0f}\" "
             "font-family=\"sans-serif\" font-size=\"13\">\n",
             width, height) +
         lines + boxes + "</svg>\n";
}

}  // namespace taut::paper
