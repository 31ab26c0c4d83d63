// Example scenes, by the families that the field uses. Each is free by construction, with a clear gap, or, with
// `hit`, has a contact; tests sample them. Lengths are in the scene's own unit, angles in radians, and a revolution
// or one stroke takes time 1 unless said otherwise.
#pragma once

#include <cstdint>

#include "taut/scene.hpp"

namespace taut::gen {

/// Two meshing involute spur gears turning in opposite directions at the exact ratio of their teeth.
struct GearOptions {
  int teeth_1 = 17;
  int teeth_2 = 23;
  double module = 1;               ///< pitch diameter / teeth
  double pressure_angle_deg = 20;  ///< degrees
  double backlash = 0.06;          ///< along the pitch circle, in modules
  int flank_points = 6;            ///< vertices per flank
  double turns = 1;                ///< revolutions of the first gear, which takes time 1 for each
  bool hit = false;                ///< one tooth of the second gear is too thick
};
Scene make_gears(const GearOptions& options);

/// A planetary gear, which is a world: the sun drives planets on a carrier inside a ring that stands. The carrier is
/// behind them, so that its pairs are ignored.
struct PlanetaryOptions {
  int sun = 18;           ///< teeth
  int planet = 18;        ///< teeth of each planet; the ring has sun + 2 planet
  int planets = 3;        ///< sun + ring must be a multiple of it
  double module = 1;      ///< pitch diameter / teeth
  double backlash = 0.1;  ///< along the pitch circle, in modules
  int flank_points = 4;   ///< vertices per flank
  double turns = 1;       ///< revolutions of the sun, which takes time 1 for each
  bool hit = false;       ///< one space of the ring is too narrow
};
Scene make_planetary(const PlanetaryOptions& options);

/// Two interlocked combs: the upper one oscillates in the slots of the lower one until time 1, and is pulled out
/// until time 2.
struct CombOptions {
  int teeth = 12;
  int swings = 4;    ///< degree of the oscillation, at most 16
  bool hit = false;  ///< the swing is wider than the play
};
Scene make_combs(const CombOptions& options);

/// A key with a stepped bit slides into its keyway.
struct LockOptions {
  int steps = 10;
  std::uint64_t seed = 1;
  double clearance = 0.05;
  bool hit = false;  ///< the keyway belongs to another key
};
Scene make_lock(const LockOptions& options);

/// Two pieces that meet along a seam with knobs are pulled apart.
struct JigsawOptions {
  int knobs = 3;
  int knob_points = 12;
  double clearance = 0.04;
  bool hit = false;  ///< knobs with a neck, which are caught in their sockets
};
Scene make_jigsaw(const JigsawOptions& options);

/// The paper's Fig. 16: a regular polygon dips into a U-shaped one again and again, on a polynomial path.
struct DipOptions {
  int sides = 64;
  int dips = 4;      ///< at most 8: the path has twice this degree
  bool hit = false;  ///< it dips so deep that it hits the bottom
};
Scene make_dips(const DipOptions& options);

/// The paper's Fig. 17: a toothed rotor turns next to a flat convex chain, so that every tooth crosses the extensions
/// of all edges of the chain.
struct RotorOptions {
  int teeth = 24;
  int chain_edges = 24;
  double turns = 1;
  bool hit = false;  ///< one tooth is too long
};
Scene make_rotor(const RotorOptions& options);

/// A spiral in the groove of another one, screwed out by nearly all that the groove's width allows.
struct SpiralOptions {
  double turns = 2;
  int side_points = 64;  ///< vertices along either side of a spiral
  bool hit = false;      ///< it is screwed too far
};
Scene make_spiral(const SpiralOptions& options);

/// A small ship drives through a serpentine corridor, turning on the spot at the corners.
struct MazeOptions {
  int passes = 12;
  int ship_points = 12;
  std::uint64_t seed = 1;  ///< 0: all passes are equally long
  bool hit = false;        ///< the ship is too long to turn
};
Scene make_maze(const MazeOptions& options);

}  // namespace taut::gen
