// Chipmunk 7: both bodies in convex pieces, the fixed ones in a space, which is asked about each moving one.
//
// Debian's library is built with Chipmunk's own checks of its arguments; they are part of the time.
#include <chipmunk/chipmunk.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>

#include "peers/peer.hpp"

namespace taut::bench {
namespace {

/// The first space greets on standard output, where the table is to be.
cpSpace* quiet_space() {
  std::fflush(stdout);
  const int out = dup(STDOUT_FILENO), nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  cpSpace* space = cpSpaceNew();
  std::fflush(stdout);
  dup2(out, STDOUT_FILENO);
  close(out);
  close(nowhere);
  return space;
}

cpShape* polygon(cpBody* body, const Polygon& piece) {
  std::vector<cpVect> vertices;
  for (const Point& p : piece) vertices.push_back(cpv(p.x, p.y));
  return cpPolyShapeNew(body, static_cast<int>(vertices.size()), vertices.data(), cpTransformIdentity, 0);
}

class Chipmunk : public Peer {
 public:
  Chipmunk(const PeerShape& fixed, const PeerShape& moving) : space_(quiet_space()) {
    for (const Polygon& piece : fixed.pieces)
      fixed_.push_back(cpSpaceAddShape(space_, polygon(cpSpaceGetStaticBody(space_), piece)));
    // Shapes without a body stay where cpShapeUpdate puts them.
    for (const Polygon& piece : moving.pieces) moving_.push_back(polygon(nullptr, piece));
  }
  ~Chipmunk() override {
    for (cpShape* shape : fixed_) {
      cpSpaceRemoveShape(space_, shape);
      cpShapeFree(shape);
    }
    for (cpShape* shape : moving_) cpShapeFree(shape);
    cpSpaceFree(space_);
  }
  Chipmunk(const Chipmunk&) = delete;
  Chipmunk& operator=(const Chipmunk&) = delete;

  bool overlap(const RelativePose& pose) override {
    const cpTransform at = cpTransformNew(pose.c, pose.s, -pose.s, pose.c, pose.x, pose.y);
    for (cpShape* shape : moving_) {
      cpShapeUpdate(shape, at);
      if (cpSpaceShapeQuery(space_, shape, nullptr, nullptr)) return true;
    }
    return false;
  }

 private:
  cpSpace* space_;
  std::vector<cpShape*> fixed_, moving_;
};

}  // namespace

std::unique_ptr<Peer> make_chipmunk(const PeerShape& fixed, const PeerShape& moving) {
  return std::make_unique<Chipmunk>(fixed, moving);
}

}  // namespace taut::bench
