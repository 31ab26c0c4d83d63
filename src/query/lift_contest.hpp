// Which pairs of features have the greatest lift, over a window of time?
#pragma once

#include <optional>
#include <vector>

#include "query/lift_functions.hpp"
#include "taut/check.hpp"
#include "taut/follow.hpp"

namespace taut::internal {

/// `carried`: the pairs have the greatest lift at all instants of the window, and no other pair has it. `low`: no pair
/// reaches 0. `open`: only these pairs may have it.
struct LiftVerdict {
  FollowState state = FollowState::open;
  LiftRange lift = {};
  std::vector<LiftPair> pairs = {};
  bool hopeless = false;  ///< of `open`: parts of the window would not be decided either
};

struct LiftChange {
  bool once = false, jumps = false;
};

/// Lifts above `reach` do not count.
class LiftContest {
 public:
  LiftContest(const std::vector<LiftCouple>& couples, const Point& u, double reach, Touch touch);

  /// The couples' segments have changed.
  void begin() { identities_.begin(); }
  /// Does an edge of the follower, or of the couple's other body, never face the other one? Sides along the direction
  /// do not: bodies slide along these.
  bool never_faces(std::uint32_t couple, bool of_follower, std::uint32_t edge) const;
  /// Is a vertex at no edge that may face the other one?
  bool is_away(std::uint32_t couple, bool of_follower, std::uint32_t vertex) const;
  /// Over a window of time, by doubles or, where these do not distinguish lifts, with more digits.
  LiftVerdict decide(const TimeInterval& time, const std::vector<LiftPair>& candidates);
  /// Right before the window, the pairs `before` are the greatest ones, right after it `after`, and in it none but
  /// `among`.
  LiftChange change(const TimeInterval& time, const std::vector<LiftPair>& before, const std::vector<LiftPair>& among,
                    const std::vector<LiftPair>& after);

 private:
  enum class Over : unsigned char { no, maybe, never_known, yes };
  template <class Real>
  struct Contestant {
    LiftPair pair;
    Over over;
    WindowJet<Real> lift;
    LiftRange range;
  };

  template <class Real>
  LiftVerdict decide_by(LiftWindow<Real>& window, const TimeInterval& time, const std::vector<LiftPair>& candidates);
  /// Is the vertex over the edge, at all instants of the window?
  template <class Real>
  Over over(LiftWindow<Real>& window, const LiftPair& pair);
  template <class Real>
  Over over_level_end(LiftWindow<Real>& window, const LiftPair& pair, int end);
  /// May the pair be as high as the leader?
  template <class Real>
  bool challenges(const Contestant<Real>& leader, const Contestant<Real>& other, double radius, LiftVerdict& verdict);

  /// A pair that may be the greatest one in a change. If its vertex is not over its edge all the time, it comes over
  /// it, or leaves it, at one instant: where two vertices are above each other.
  struct Changing {
    LiftPair pair;
    WindowJet<double> lift;
    LiftRange range;
    int comes = 0;  ///< 1: it is over the edge from that instant on, -1: until then, 0: all the time
  };
  std::optional<Changing> changing(const LiftPair& pair, std::optional<VertexCouple>& border);
  bool leads(const std::vector<LiftPair>& leaders, const std::vector<Changing>& all, bool after);
  bool pass(const std::vector<LiftPair>& before, const std::vector<LiftPair>& after);
  static LiftRange range_of(const std::vector<LiftPair>& some, const std::vector<Changing>& all);
  bool same_vertices(const VertexCouple& a, const VertexCouple& b) const;

  const std::vector<LiftCouple>& couples_;
  double reach_;
  Touch touch_;
  LiftIdentities identities_;
  LiftWindow<double> window_;
  LiftWindow<Real320> precise_;
};

}  // namespace taut::internal
