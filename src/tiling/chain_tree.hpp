// The binary trees over the edges of P and Q, joined into one; nodes are heap numbers, so that parent, depth and
// lowest common ancestor are bit operations (section 2.1 of the paper).
#pragma once

#include <cstdint>
#include <utility>

namespace taut::internal {

/// A node of the joined tree, as a number in one binary heap numbering:
///
///     1 root (PT) -- 2 (inf_i) -- 4 the tree of P
///                 -- 3 (PT, too) -- 6 the tree of Q, 7 (inf_o)
///
/// The paper's tree hangs T_P and T_Q below the root. The infinite face counts as one of two extra nodes, inf_i
/// between the root and T_P or the leaf inf_o at the root, depending on where it is seen from.
/// As the label of the infinite face itself, 5 is used: it is not a node.
struct ChainNode {
  std::uint32_t code = 0;

  friend bool operator==(ChainNode a, ChainNode b) { return a.code == b.code; }
  friend bool operator!=(ChainNode a, ChainNode b) { return a.code != b.code; }
};

namespace node {

inline constexpr ChainNode none{0};
inline constexpr ChainNode root{1};
inline constexpr ChainNode inner_infinite{2};
inline constexpr ChainNode p_tree{4};
inline constexpr ChainNode infinite_face{5};
inline constexpr ChainNode q_tree{6};
inline constexpr ChainNode outer_infinite{7};

inline int bit_length(std::uint32_t x) { return x == 0 ? 0 : 32 - __builtin_clz(x); }

/// Does the label belong to the tree of P (of Q)?
inline bool in_p(ChainNode n) { return n.code >= 4 && (n.code >> (bit_length(n.code) - 3)) == 4; }
inline bool in_q(ChainNode n) { return n.code >= 4 && n.code != 7 && (n.code >> (bit_length(n.code) - 3)) == 6; }
/// Depth within its own tree, 0 at the root of T_P or T_Q.
inline int depth(ChainNode n) { return bit_length(n.code) - 3; }
inline ChainNode left(ChainNode n) { return {2 * n.code}; }
inline ChainNode right(ChainNode n) { return {2 * n.code + 1}; }
/// Is n the node a or one of its descendants?
inline bool in_subtree(ChainNode n, ChainNode a) {
  const int below = bit_length(n.code) - bit_length(a.code);
  return below >= 0 && (n.code >> below) == a.code;
}

inline std::uint32_t lowest_common_ancestor(std::uint32_t a, std::uint32_t b) {
  const int da = bit_length(a), db = bit_length(b);
  if (da > db) a >>= da - db;
  if (db > da) b >>= db - da;
  return a >> bit_length(a ^ b);
}

/// The node on all three pairwise paths: the deepest of the three lowest common ancestors.
inline ChainNode median(ChainNode a, ChainNode b, ChainNode c) {
  const std::uint32_t ab = lowest_common_ancestor(a.code, b.code);
  const std::uint32_t bc = lowest_common_ancestor(b.code, c.code);
  const std::uint32_t ca = lowest_common_ancestor(c.code, a.code);
  std::uint32_t m = ab > bc ? ab : bc;  // ancestors of one another: the deeper has the larger number
  if (ca > m) m = ca;
  return {m == 3 ? 1u : m};
}

}  // namespace node

/// The shape of one tree: a complete binary tree with n leaves, the last level filled from the left.
class ChainTree {
 public:
  ChainTree(std::uint32_t leaves, ChainNode root) : n_(leaves), root_(root) {
    const int top = node::bit_length(2 * n_ - 1) - 1;
    first_low_ = 1u << top;
    low_leaves_ = 2 * n_ - first_low_;
  }
  std::uint32_t leaves() const { return n_; }
  ChainNode root() const { return root_; }
  /// The leaf of the edge from vertex `edge` (0-based within its polygon) to the next.
  ChainNode leaf(std::uint32_t edge) const {
    return from_heap(edge < low_leaves_ ? first_low_ + edge : n_ + (edge - low_leaves_));
  }
  bool is_leaf(ChainNode n) const { return heap(n) >= n_; }
  /// The node's number in the tree's own heap numbering: 1 the root, n .. 2n-1 the leaves.
  std::uint32_t heap(ChainNode n) const {
    const std::uint32_t level = 1u << node::depth(n);
    return n.code - root_.code * level + level;
  }
  ChainNode from_heap(std::uint32_t k) const {
    const std::uint32_t level = 1u << (node::bit_length(k) - 1);
    return {k - level + root_.code * level};
  }
  /// The chain of node n: from vertex .first to vertex .second of its polygon (.second may equal the number of
  /// vertices, meaning vertex 0 again).
  std::pair<std::uint32_t, std::uint32_t> chain(ChainNode n) const {
    std::uint32_t lo = heap(n), hi = lo;
    while (lo < n_) lo = 2 * lo;
    while (hi < n_) hi = 2 * hi + 1;
    return {edge_of(lo), edge_of(hi) + 1};
  }

 private:
  std::uint32_t edge_of(std::uint32_t heap_leaf) const {
    return heap_leaf >= first_low_ ? heap_leaf - first_low_ : heap_leaf - n_ + low_leaves_;
  }
  std::uint32_t n_;
  ChainNode root_;
  std::uint32_t first_low_ = 1, low_leaves_ = 1;
};

}  // namespace taut::internal
