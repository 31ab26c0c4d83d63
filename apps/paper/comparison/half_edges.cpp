#include "comparison/half_edges.hpp"

#include <map>
#include <utility>

namespace taut::paper {

HalfEdges::HalfEdges(const MovingBodies& bodies, const std::vector<std::vector<int>>& around)
    : sides_(2 * bodies.vertices()) {
  std::map<std::pair<int, int>, int> by_ends;
  const auto add = [&](int from, int to) {
    by_ends[{from, to}] = static_cast<int>(origin_.size());
    by_ends[{to, from}] = static_cast<int>(origin_.size()) + 1;
    origin_.insert(origin_.end(), {from, to});
  };
  for (int v = 0; v < bodies.vertices(); ++v) add(v, bodies.next(v));
  for (int v = 0; v < bodies.vertices(); ++v) {
    for (const int w : around[static_cast<std::size_t>(v)])
      if (v < w && !by_ends.count({v, w})) add(v, w);
  }
  next_.assign(origin_.size(), -1);
  previous_.assign(origin_.size(), -1);
  // With a face on the left, the edge after one that comes from w leaves clockwise before it.
  for (int v = 0; v < bodies.vertices(); ++v) {
    const std::vector<int>& ends = around[static_cast<std::size_t>(v)];
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const int before = ends[(k + ends.size() - 1) % ends.size()];
      join(by_ends.at({ends[k], v}), by_ends.at({v, before}));
    }
  }
}

std::size_t HalfEdges::bytes() const {
  return (origin_.capacity() + next_.capacity() + previous_.capacity()) * sizeof(int);
}

void HalfEdges::slide_previous(int h) {
  const int p = previous(h), back = twin(p), q = previous(back);
  join(p, next(h));
  join(q, h);
  join(h, back);
  origin_[static_cast<std::size_t>(back)] = target(h);
}

void HalfEdges::slide_this(int h) {
  const int p = previous(h), back = twin(h), r = previous(p), n = next(back);
  origin_[static_cast<std::size_t>(h)] = origin(p);
  join(r, h);
  join(back, p);
  join(p, n);
}

}  // namespace taut::paper
