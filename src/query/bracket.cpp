#include "query/bracket.hpp"

namespace taut::internal {

CurvedWorld::Halvings Marks::times(int halvings) && {
  for (auto& body : halvings_) {
    for (auto& part : body) {
      for (auto& ring : part) {
        for (int& mark : ring) mark *= halvings;
      }
    }
  }
  return std::move(halvings_);
}

bool CurvedRun::refine_beyond_limit(Marks marks) {
  const std::size_t count = marks.count();
  return count > 0 && world_.refine(std::move(marks).times(count > 64 ? 1 : count > 24 ? 2 : 4));
}

bool CurvedRun::refine(Marks marks, int halvings) {
  return marks.count() > 0 && !at_limit() && world_.refine(std::move(marks).times(halvings));
}

}  // namespace taut::internal
