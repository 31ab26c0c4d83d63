// A motion as the pieces it is made of, and whether they are well defined and join up.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geometry/axis_box.hpp"
#include "taut/scene.hpp"

namespace taut::internal {

/// The pieces of a motion that matter on [start, end], at least one; the last one's `until` is infinite.
/// Their polynomials have no zeros at the end, and
/// where all of them are constant, the origin is 0.
std::vector<MotionPiece> given_pieces_between(const Motion& motion, double start, double end);

/// Calls visit(piece) for each of them, cut where a cosine reaches 1 or -1; the last one's `until` is infinite.
void for_each_piece_between(const Motion& motion, double start, double end,
                            const std::function<void(MotionPiece&&)>& visit);
/// All of these.
std::vector<MotionPiece> pieces_between(const Motion& motion, double start, double end);

/// The piece that holds at t.
const MotionPiece& piece_at(const std::vector<MotionPiece>& pieces, double t);

/// Does the body move, as far as the polynomials show it? Those of a piece that varies have an origin.
bool varies(const MotionPiece& piece);

/// The same motion in coordinates multiplied by 2^exponent (exact).
MotionPiece scaled(MotionPiece piece, int exponent);

/// Pieces are equal if the same coefficients about the same origin give them; `until` does not count. The same function
/// in powers of the times since two origins counts as two motions, with a bridge between them.
bool same_motion(const MotionPiece& a, const MotionPiece& b);

/// Throws InputError unless the motion is well defined on [start, end] (pieces in order and covering the interval,
/// degrees within max_degree, directions that do not vanish, cosines within [-1, 1]) and its pieces join up to
/// joint_room() for every point within the bounds of the polygon.
void validate_motion(const Motion& motion, const std::string& body, const AxisBox& polygon, double start, double end,
                     double extent);

/// The largest distance between where two pieces put a corner of the polygon's bounds at time t.
double joint_gap(const MotionPiece& before, const MotionPiece& after, const AxisBox& polygon, double t);

/// How far such a corner may jump: a share of the scene's extent, and what the rounding of the pieces' coefficients
/// amounts to, which is the larger of the two for a small body that is far from the origin.
double joint_room(const MotionPiece& before, const MotionPiece& after, const AxisBox& polygon, double t, double extent);

/// The share of the extent.
inline constexpr double joint_tolerance = 1e-6;
/// The share of the magnitudes that are added up: a few units in the last place.
inline constexpr double joint_rounding = 0x1p-50;

}  // namespace taut::internal
