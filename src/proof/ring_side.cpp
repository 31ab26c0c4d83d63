#include "proof/ring_side.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "numeric/budget.hpp"
#include "proof/edge_ranges.hpp"
#include "taut/proof.hpp"

namespace taut::internal::proof {
namespace {

/// Of halving a piece of a curve.
constexpr int deepest_piece = 60;
/// In units of checkpoint(): a piece next to some edges.
constexpr std::uint64_t work_of_piece = 50;

/// Where the signs are those of one side, and not all of them zero: that side. Else 0.
template <class Sign>
int common_side(int count, const Sign& sign) {
  int side = 0;
  for (int i = 0; i < count; ++i) {
    const CertainSign s = sign(i);
    if (!s || *s * side < 0) return 0;
    if (*s != 0) side = *s;
  }
  return side;
}

/// Is there a line, as S2 wants it, between the piece's hull and the edge from a to b?
bool are_separated(const CurvePiece& piece, const CurvePoint& a, const CurvePoint& b) {
  if (common_side(piece.size, [&](int i) { return side_of(a, b, piece.point(i)); }) != 0) return true;
  for (int i = 0; i < piece.size; ++i) {
    for (int k = i + 1; k < piece.size; ++k) {
      const CurvePoint &p = piece.point(i), &q = piece.point(k);
      const int side =
          common_side(piece.size, [&](int j) { return j == i || j == k ? 0 : side_of(p, q, piece.point(j)); });
      if (side == 0) continue;
      const CertainSign at_a = side_of(p, q, a), at_b = side_of(p, q, b);
      if (at_a && at_b && *at_a * side <= 0 && *at_b * side <= 0) return true;
    }
  }
  return false;
}

bool has_inside(const CurvePiece& piece) {
  for (int k = 2; k < piece.size; ++k) {
    for (int j = 1; j < k; ++j) {
      const CertainSign side = side_of(piece.point(0), piece.point(j), piece.point(k));
      if (side && *side != 0) return true;
    }
  }
  // Of four points, the first one may be another one of them.
  const CertainSign side = piece.size == 4 ? side_of(piece.point(1), piece.point(2), piece.point(3)) : 0;
  return side && *side != 0;
}

/// Points inside of the hull, if that has an inside: means of all points with positive weights.
std::array<CurvePoint, 2> points_inside(const CurvePiece& piece) {
  const CurvePoint ends = middle_of(piece.begin(), piece.end());
  const CurvePoint rest = piece.size == 4 ? middle_of(piece.point(1), piece.point(2)) : piece.point(1);
  const CurvePoint middle = middle_of(ends, rest);
  return {middle, middle_of(middle, middle_of(piece.begin(), middle))};
}

/// The test of one ring.
class SideTest {
 public:
  SideTest(const Polygon& polygon, RingSide side, const std::string& name) : edges_(polygon), side_(side), name_(name) {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const Point &a = edges_.begin(e), &b = edges_.end(e);
      known_edges_[{a.x, a.y}].push_back(b);
      known_edges_[{b.x, b.y}].push_back(a);
    }
    if (side_ == RingSide::around) find_centres();
  }

  std::vector<NamedChord> run(const std::vector<CurvePiece>& curve) {
    for (const CurvePiece& piece : curve) resolve(piece, 0);
    if (side_ == RingSide::around) require_winding();
    return std::move(chords_);
  }

 private:
  struct Centre {
    CurvePoint z;
    std::optional<int> winding = 0;
  };

  void resolve(const CurvePiece& piece, int depth) {
    checkpoint(work_of_piece);
    if (piece.is_line() ? is_edge(piece) : is_clear(piece)) return take(piece);
    if (piece.is_line() || depth == deepest_piece) fail(piece);
    for (const CurvePiece& half : halves_of(piece)) resolve(half, depth + 1);
  }

  /// S1. The ends of straight segments are doubles.
  bool is_edge(const CurvePiece& piece) const {
    const Point a = piece.begin().rounded(), b = piece.end().rounded();
    const auto from = known_edges_.find({a.x, a.y});
    return from != known_edges_.end() && std::find(from->second.begin(), from->second.end(), b) != from->second.end();
  }

  /// S2.
  bool is_clear(const CurvePiece& piece) const {
    const auto extent = [&](auto member) {
      return extent_of(piece.control.data(), piece.size,
                       [&](const CurvePoint& p) -> const CurveNumber& { return p.*member; });
    };
    const bool apart = edges_.all_near(extent(&CurvePoint::x), extent(&CurvePoint::y), [&](std::uint32_t e) {
      return are_separated(piece, CurvePoint::of(edges_.begin(e)), CurvePoint::of(edges_.end(e)));
    });
    if (!apart || !has_inside(piece)) return false;
    for (const CurvePoint& z : points_inside(piece)) {
      if (const auto inside = edges_.contains(z)) return *inside == (side_ == RingSide::within);
    }
    return false;
  }

  void take(const CurvePiece& piece) {
    chords_.push_back({piece.segment, piece.from, piece.to, piece.begin().rounded(), piece.end().rounded()});
    for (Centre& centre : centres_) {
      const auto passed = passage(piece.begin(), piece.end(), centre.z);
      centre.winding = passed && centre.winding ? std::optional<int>(*centre.winding + *passed) : std::nullopt;
    }
  }

  /// A few points inside of the polygon. One of its ears has such a one.
  void find_centres() {
    constexpr std::size_t enough = 3;
    const std::size_t n = edges_.size();
    for (std::size_t k = 0; k < n && centres_.size() < enough; ++k) {
      const CurvePoint a = CurvePoint::of(edges_.begin(k)), b = CurvePoint::of(edges_.end(k));
      const CurvePoint c = CurvePoint::of(edges_.end(k + 1 == n ? 0 : k + 1));
      const CurvePoint z = middle_of(middle_of(a, b), middle_of(b, c));
      if (edges_.contains(z).value_or(false)) centres_.push_back({z});
    }
  }

  void require_winding() const {
    for (const Centre& centre : centres_) {
      if (centre.winding) {
        if (*centre.winding != 0) return;
        throw ProofError(name_ + ": the curve does not go around its polygon");
      }
    }
    throw ProofError(name_ + ": whether the curve goes around its polygon is not known");
  }

  [[noreturn]] void fail(const CurvePiece& piece) const {
    const char* const wanted = side_ == RingSide::within ? " is not shown to lie within the polygon around it"
                                                         : " is not shown to lie outside of the polygon within";
    throw ProofError(name_ + ": segment " + std::to_string(piece.segment) + wanted);
  }

  EdgeSlabs edges_;
  RingSide side_;
  const std::string& name_;
  std::map<std::pair<double, double>, std::vector<Point>> known_edges_;
  std::vector<Centre> centres_;
  std::vector<NamedChord> chords_;
};

}  // namespace

std::vector<NamedChord> require_side(const std::vector<CurvePiece>& curve, const Polygon& polygon, RingSide side,
                                     const std::string& name) {
  if (polygon.size() < 3) throw ProofError(name + ": a polygon of fewer than three vertices");
  return SideTest(polygon, side, name).run(curve);
}

}  // namespace taut::internal::proof
