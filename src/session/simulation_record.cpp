#include "session/simulation_record.hpp"

#include <algorithm>

namespace taut::internal {

void MotionRecord::begin(const Scene& scene, const std::vector<bool>& removed) {
  current_ = scene;
  current_.bodies.clear();
  places_.clear();
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    places_.push_back(removed[k] ? -1 : static_cast<int>(current_.bodies.size()));
    if (!removed[k]) current_.bodies.push_back(scene.bodies[k]);
  }
  const auto is_there = [&](const std::string& name) {
    return name == "*" || std::any_of(current_.bodies.begin(), current_.bodies.end(),
                                      [&](const Body& body) { return body.name == name; });
  };
  const auto is_gone = [&](const std::array<std::string, 2>& pair) { return !is_there(pair[0]) || !is_there(pair[1]); };
  std::erase_if(current_.ignore, is_gone);
  std::erase_if(current_.clearances, [&](const PairClearance& entry) { return is_gone(entry.pair); });
}

/// In place, as there may be many pieces. One that would begin at t or later is replaced.
void MotionRecord::change(BodyId body, const Motion& motion, double t) {
  Motion& own = current_.bodies[static_cast<std::size_t>(places_[static_cast<std::size_t>(body)])].motion;
  if (!(t > current_.start)) {
    own = motion;
    return;
  }
  std::vector<MotionPiece>& pieces = own.pieces;
  if (pieces.empty()) pieces.emplace_back();
  while (pieces.size() > 1 && pieces[pieces.size() - 2].until >= t) pieces.pop_back();
  pieces.back().until = t;
  if (motion.pieces.empty()) pieces.emplace_back();
  for (const MotionPiece& piece : motion.pieces) {
    if (piece.until > t) pieces.push_back(piece);
  }
}

void MotionRecord::end(double t) {
  if (t > current_.start) ended_ = scenes(t);
}

std::vector<Scene> MotionRecord::scenes(double t) const {
  std::vector<Scene> all = ended_;
  all.push_back(current_);
  all.back().end = t;
  if (!(t > current_.start)) return all;
  // What begins at t, and the jump to it, has not been done.
  for (Body& body : all.back().bodies) {
    std::vector<MotionPiece>& pieces = body.motion.pieces;
    while (pieces.size() > 1 && pieces[pieces.size() - 2].until >= t) pieces.pop_back();
  }
  return all;
}

}  // namespace taut::internal
