#include "peers/peer.hpp"

namespace taut::bench {

const std::vector<PeerEntry>& peers() {
  static const std::vector<PeerEntry> all{
      {"Box2D", make_box2d},   {"Box2D with skin", make_box2d_skin}, {"FCL", make_fcl},
      {"Bullet", make_bullet}, {"Chipmunk", make_chipmunk},
  };
  return all;
}

}  // namespace taut::bench
