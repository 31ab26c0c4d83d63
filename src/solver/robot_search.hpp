// A robot of one or more links and bodies at rest: a workspace for many short queries.
#pragma once

#include <span>
#include <vector>

#include "solver/map_search.hpp"
#include "spacetime/uniform_pairs.hpp"

namespace taut::internal {

/// The result of a search, in internal terms.
struct RobotFinding {
  Outcome outcome = Outcome::free;
  double lo = 0;  ///< free before this time
  double hi = 0;  ///< a contact by this time
  int link = -1, body = -1, other_link = -1;
};

/// Links move uniformly, with one piece each, relative to their parents. A link whose path leads through free cells of
/// the map meets nothing. Else the map's tree is queried with the box of its path, windows of that are halved as long
/// as this excludes bodies, and one search handles all that remain. Links that may meet are pairs with a motion of
/// their own. Data of a query is kept for the next one.
class RobotSearch {
 public:
  struct Link {
    SharedRings rings;
    Layers z = {};
    int parent = -1;
  };
  /// `bodies` must outlive the search. Throws InputError if a feature is finer than the displacement.
  RobotSearch(const MapBodies& bodies, std::vector<Link> links, Offset offset, bool links_meet);

  std::size_t size() const { return links_.size(); }
  const std::vector<Link>& links() const { return links_; }
  Offset offset() const { return offset_; }
  /// The pairs of links that are tested.
  std::vector<std::array<int, 2>> meeting() const;

  /// Is a robot of one link certainly in free cells of the map all along this line, however it turns? A cheap test; a
  /// negative result has no meaning.
  bool roams_free(Vector from, Vector way) const;
  /// Sets the motions of the links from now on: uniform pieces, scaled.
  void set(std::span<const MotionPiece> own);
  /// Does a link overlap anything at t?
  RobotFinding at(double t);
  /// The first contact in (from, to], provided that there is no overlap at `from`; with `any`, whether there is one.
  RobotFinding along(double from, double to, bool any);
  /// Moves from the current pieces to the next ones, which take over at t in the same pose, up to rounding. Determines
  /// whether there is a contact in between; nothing overlaps before. The links then follow `next`.
  RobotFinding join(std::span<const MotionPiece> next, double t);

 private:
  using Hierarchy = spacetime::Hierarchy;
  /// A part of a link's path, and the bodies that it may meet there: of `nearby`, from first to last. Those of a path
  /// that was not divided yet are not known.
  struct Window {
    double from, to;
    int depth = 0;
    std::size_t first = 0, last = 0;
    double middle() const { return from + (to - from) / 2; }
    Window half(int which) const {
      return which == 0 ? Window{from, middle(), depth + 1, first, last} : Window{middle(), to, depth + 1, first, last};
    }
  };
  /// The motion of a link in the world, and the bodies of the map that it came near to.
  struct LinkState {
    PieceChain chain, before;  ///< the motion, and that before the last joint
    const Hierarchy* tree = nullptr;
    double size = 0, reach = 0;  ///< of the link; from its origin
    std::vector<std::unique_ptr<PairGeometry>> met;
    std::vector<std::vector<Vector>> outlines;  ///< some vertices of each
    std::vector<Window> windows;                ///< of its path
    std::vector<int> nearby;
  };
  /// Two links, relative to the last parent that they share.
  struct LinkPair {
    int p = 0, q = 0;
    std::size_t common = 0;
    PairGeometry geometry;
    PieceChain chain_p, chain_q, before_p, before_q;
  };
  /// The links of a search.
  struct Names {
    int link = -1, other_link = -1;
  };
  std::size_t common_parents(int p, int q) const;
  bool is_free(Vector from, Vector way, double radius) const;
  bool roams_free(std::size_t link, double from, double to) const;
  /// Finds the bodies that meet the link's box in the stretch, among all or among those of a window: `others_`, with
  /// the numbers of the bodies in `near_`.
  bool find_near(std::size_t link, const spacetime::Stretch& s, const Window* among = nullptr);
  void list_others(std::size_t link);
  std::optional<std::size_t> overlapped(const spacetime::UniformSegment& segment, const Hierarchy& mover,
                                        const spacetime::Stretch& instant, const LinkState* with_map);
  bool crosses(std::size_t link, const spacetime::UniformSegment& segment, double t, const Window& window);
  bool narrowed(std::size_t link, const spacetime::UniformSegment& segment, Window& window);
  bool crowded(std::size_t link, const Window& window) const;
  FreeCells::Cell around(const LinkState& link, const spacetime::QAtPose& pose) const;
  void cover(std::size_t link, double from, double to, RobotFinding& best);
  bool blocked(std::size_t link, double from, double to, RobotFinding& best);
  void search_any(double from, double to, RobotFinding& best);
  void search(std::size_t link, const spacetime::UniformSegment& segment, const Window& window, RobotFinding& best);
  void search(const spacetime::UniformSegment& segment, const Hierarchy& mover, Names names, double from, double to,
              RobotFinding& best);
  RobotFinding found(Outcome outcome, double lo, double hi, Names names, std::size_t other) const;
  void find_crossed(std::size_t link, double t);
  void cross(MotionSegment bridge, const Hierarchy& mover, Names names, RobotFinding& best);

  /// Of a body that does not move.
  static inline const PieceChain world_chain{};

  const MapBodies& bodies_;
  const FreeCells& cells_;
  std::vector<Link> links_;
  Offset offset_;
  bool any_ = false;
  std::vector<const Hierarchy*> body_trees_;
  std::vector<LinkState> states_;
  std::vector<LinkPair> pairs_;
  spacetime::UniformPairsSearch uniform_pairs_;
  AxisBox box_;  ///< of the last call of find_near()
  std::vector<int> near_;
  std::vector<int> inside_;  ///< bodies with an outline that may be inside the link
  spacetime::PoseSearch posed_;
  std::size_t crossed_ = 0;  ///< the index in `others_` that crosses() found
  std::vector<spacetime::Other> others_;
};

}  // namespace taut::internal
