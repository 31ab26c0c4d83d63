// Two bodies over one stretch of time, and the functions whose signs say where a vertex of one is relative to an edge
// of the other.
#pragma once

#include <cstdint>
#include <map>
#include <unordered_map>

#include "support/exact_motion.hpp"
#include "taut/scene.hpp"

namespace taut::testing::exact {

/// Of an edge (a, b) and a vertex v, or an edge f, of the other body; up to a positive factor.
enum class What : std::uint8_t {
  height,  ///< the orientation of a, b and v
  past_a,  ///< how far v is along the edge from a
  past_b,  ///< the same from b: negative before it
  turn,    ///< the cross product of (a, b) and f
  along,   ///< their scalar product
  ray,     ///< of a vertex a: on which side of a certain line through v it is
};

/// A vertex of body 1 - side (for turn and along: the edge that begins there) and an edge of body `side` (for ray: the
/// vertex it begins with).
struct VertexEdge {
  int side = 0, vertex = 0, edge = 0;
  friend bool operator==(const VertexEdge&, const VertexEdge&) = default;
};

struct Function {
  VertexEdge pair;
  What what = What::height;
};

/// Of one side: Z = L + K v - a R is the vertex v of the other body as seen from the vertex a of this one, in this
/// body's frame, times a positive number.
template <class I, int N>
struct FrameOf {
  Series<I, N> kx, ky, lx, ly, r;
};

/// Too much work, or a scene that is beyond the oracle.
struct Beyond {
  std::string why;
};

class MotionSegment {
 public:
  using WideSeries = Series<Wide, 8>;
  using NarrowSeries = Series<Narrow, 4>;

  MotionSegment(const Scene& scene, std::array<BodyMotion, 2> bodies, Poly time, Rational from, Rational to);

  /// Of the parameter u.
  const Rational& from() const { return from_; }
  const Rational& to() const { return to_; }
  Wide time(const Wide& u) const { return time_.series<Wide, 8>(u).c[0]; }

  int size(int body) const { return static_cast<int>(polygons_[static_cast<std::size_t>(body)].size()); }

  /// Taylor coefficients over u.
  WideSeries series(const Function& f, const Wide& u) const;
  /// One of them.
  Wide coefficient(const Function& f, const Wide& u, int k) const;
  FrameOf<Narrow, 4> frame(int side, const Narrow& u) const;
  NarrowSeries series(const Function& f, const FrameOf<Narrow, 4>& frame) const;
  Narrow coefficient(const Function& f, const FrameOf<Narrow, 4>& frame, int k) const;

  /// Is the function zero at all times? `assumed` is set if that is not proved.
  bool identically_zero(const Function& f, bool& assumed) const;
  /// Is it exactly zero at this u? Only if the segment has_formal().
  bool zero_at(const Function& f, const Rational& u) const;
  bool has_formal() const { return has_formal_; }
  /// A polynomial that vanishes wherever the function does, if there is one.
  const std::optional<Curve>& norm(const Function& f) const;
  /// The function as a polynomial, if it is one.
  bool polynomial_of(const Function& f, Poly& p) const;
  /// |b - a| of an edge.
  double length(int side, int edge) const;
  /// How often a frame has been evaluated in multi-precision: the work done.
  std::uint64_t work() const { return work_; }

 private:
  /// The function is the imaginary or the real part of conj(e) (L + K w - R s), or without L and R.
  template <class I>
  struct TermsOf {
    I ex, ey, wx, wy, sx, sy;
    bool whole, imaginary;
  };
  struct FormalFrame {
    Formal k, l, r;
  };
  /// The frames that were asked for. All functions are searched in the same intervals, halved at the same places.
  template <int N>
  struct Cached {
    int side, bits;
    Wide u;
    FrameOf<Wide, N> frame;
  };
  template <int N>
  using Cache = std::unordered_multimap<std::size_t, Cached<N>>;
  static constexpr std::size_t most_cached = 4000;

  template <class I, int N>
  FrameOf<I, N> make_frame(int side, const I& u) const;
  template <class I>
  TermsOf<I> terms(const Function& f) const;
  /// A vertex about its pivot.
  template <class I>
  std::array<I, 2> local(int body, int vertex) const;
  template <int N>
  const FrameOf<Wide, N>& wide_frame(Cache<N>& cache, int side, const Wide& u) const;
  /// The function is its real or imaginary part.
  Formal formal(const Function& f) const;
  /// Zero if and only if the function is.
  Formal formal_part(const Function& f) const;
  const FormalFrame& formal_frame(int side) const;

  std::array<BodyMotion, 2> bodies_;
  std::array<Polygon, 2> polygons_;
  std::array<std::vector<std::array<Narrow, 2>>, 2> narrow_;  // about the pivots
  Curve time_;
  Rational from_, to_;
  Radicands radicands_;
  bool has_formal_;
  mutable std::array<std::optional<FormalFrame>, 2> formal_frames_;
  mutable std::map<std::array<int, 4>, std::optional<Curve>> norms_;
  /// To high order and to low.
  mutable Cache<8> long_frames_;
  mutable Cache<2> short_frames_;
  mutable std::uint64_t work_ = 0;
};

}  // namespace taut::testing::exact
