// Libraries that others use for collisions, behind one small interface.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "peers/convex_pieces.hpp"
#include "taut/geometry.hpp"

namespace taut::bench {

/// A polygon as the libraries take it: counterclockwise, about the origin, in metres.
struct PeerShape {
  Polygon outline;
  std::vector<Triangle> triangles;  ///< of `outline`
  std::vector<Polygon> pieces;      ///< convex, at most 8 vertices
  double radius = 0;                ///< of a circle around the origin that contains it
};

/// Where the second shape is, seen from the first one: its point (u, v) is at (x + u c - v s, y + u s + v c).
struct RelativePose {
  double x = 0, y = 0, c = 1, s = 0;
};

/// A library that holds the shapes of a pair.
class Peer {
 public:
  virtual ~Peer() = default;
  /// Do the shapes overlap at this pose?
  virtual bool overlap(const RelativePose& pose) = 0;
  /// Whether the library has a continuous test for such a pair.
  virtual bool casts() const { return false; }
  /// The share of the straight way from one pose to the other, not turning, after which the shapes meet, if they do.
  virtual std::optional<double> cast(const RelativePose& from, const RelativePose& to) {
    static_cast<void>(from), static_cast<void>(to);
    return std::nullopt;
  }
};

struct PeerEntry {
  const char* name;
  /// The shapes outlive the peer.
  std::unique_ptr<Peer> (*make)(const PeerShape& fixed, const PeerShape& moving);
};

/// All that are built in, in the order of the table's columns.
const std::vector<PeerEntry>& peers();

std::unique_ptr<Peer> make_box2d(const PeerShape& fixed, const PeerShape& moving);
/// Box2D with the skin that its shapes have by default.
std::unique_ptr<Peer> make_box2d_skin(const PeerShape& fixed, const PeerShape& moving);
std::unique_ptr<Peer> make_fcl(const PeerShape& fixed, const PeerShape& moving);
std::unique_ptr<Peer> make_bullet(const PeerShape& fixed, const PeerShape& moving);
std::unique_ptr<Peer> make_chipmunk(const PeerShape& fixed, const PeerShape& moving);

}  // namespace taut::bench
