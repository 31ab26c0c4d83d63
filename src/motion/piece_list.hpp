// The pieces of a motion in little memory, shared by all who follow it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "taut/motion.hpp"

namespace taut::internal {

/// Pieces of a valid motion in order of time. A MotionPiece with its polynomials takes some 260 bytes, and there may be
/// a hundred thousand of them, which engines, proofs and worlds follow one after the other: so what is kept is their
/// numbers, in a row, and a piece is made when it is asked for. Copies share the numbers, which do not change any more.
class PieceList {
 public:
  /// None.
  PieceList() = default;
  PieceList(const std::vector<MotionPiece>& pieces);
  /// As pieces_between() defines them, in coordinates multiplied by 2^exponent.
  static PieceList between(const Motion& motion, double start, double end, int exponent = 0);

  /// These after another piece, which holds until t.
  PieceList after(MotionPiece piece, double t) const;

  std::size_t size() const { return packed_ ? packed_->places.size() : 0; }
  bool empty() const { return size() == 0; }
  MotionPiece operator[](std::size_t k) const;
  /// The coefficients of the x coordinate of piece k, or of y.
  std::span<const double> way(std::size_t k, bool of_y) const;
  /// Until when piece k holds.
  double until(std::size_t k) const { return packed_->places[k].until; }
  /// The number of the piece that holds at t; the last one later, too.
  std::size_t number_at(double t) const;
  /// That piece.
  MotionPiece at(double t) const { return (*this)[number_at(t)]; }
  /// Are the pieces given by the same coefficients, and change at the same times?
  friend bool same_pieces(const PieceList& a, const PieceList& b);
  /// Of two pieces, the first or the next ones, is the motion the same (see same_motion())?
  bool same_at(std::size_t a, std::size_t b) const;
  /// Does the body rest at its own coordinates all the time?
  bool rests() const;
  /// How fast a piece turns that does nothing else, in radians per unit of time.
  struct Rates {
    double begin;  ///< when the piece begins; -infinity for the first one
    double turn, orbit;
  };
  /// Of the piece that holds right before `end`; nothing if it does not just rest, or turn uniformly.
  std::optional<Rates> last_rates(double end) const;
  /// Does it follow a joint of a mechanism?
  bool follows_joint() const;

 private:
  struct Place {
    double until = std::numeric_limits<double>::infinity();
    std::uint64_t first = 0;    ///< of its numbers
    std::uint8_t x = 0, y = 0;  ///< how many coefficients there are
    std::uint8_t a = 0, b = 0;  ///< of the rotation's polynomials
    std::uint8_t orbit = 0;
    std::uint8_t form = 0;  ///< its index in Rotation
    bool pivot = false;     ///< not (0, 0)
    bool origin = false;    ///< not 0
  };
  struct Packed {
    std::vector<Place> places;
    std::vector<double> numbers;
    std::vector<JointFollower> joints;  ///< of pieces that follow one, in order

    void add(const MotionPiece& piece);
    void trim();
  };
  explicit PieceList(std::shared_ptr<const Packed> packed) : packed_(std::move(packed)) {}

  std::shared_ptr<const Packed> packed_;
};

bool same_pieces(const PieceList& a, const PieceList& b);

/// The pieces of a body's motion after those of its parents, the outermost first.
using MotionChain = std::vector<PieceList>;

/// How many motions the two chains both begin with.
std::size_t count_common(const MotionChain& a, const MotionChain& b);
/// Those after the first `count`; one that rests where there are none.
MotionChain without_first(const MotionChain& chain, std::size_t count);
/// The piece of each motion that holds at that time; one that rests where there are none.
std::vector<MotionPiece> pieces_at(const MotionChain& motions, double t);

/// Follows a chain of motions in order of time: between(pieces, from, to) for each stretch of [start, end] in which
/// every motion follows one piece, and at_joint(before, after, t) where one of them passes to another. The chain is not
/// empty.
template <class Between, class AtJoint>
void follow(const MotionChain& motions, double start, double end, const Between& between, const AtJoint& at_joint) {
  std::vector<MotionPiece> before;
  for (double t = start;;) {
    std::vector<MotionPiece> now;
    double until = end;
    for (const PieceList& motion : motions) {
      now.push_back(motion.at(t));
      until = std::min(until, now.back().until);
    }
    if (!before.empty()) at_joint(before, now, t);
    between(now, t, until);
    if (until >= end) return;
    before = std::move(now);
    t = until;
  }
}

}  // namespace taut::internal
