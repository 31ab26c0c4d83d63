// What a proof log is made of; docs/proof-format.md describes it in full.
#pragma once

#include <cmath>
#include <cstdint>

#include "proof/bytes.hpp"

namespace taut::internal::proof {

inline constexpr char magic[7] = {'t', 'a', 'u', 't', 'p', 'r', 'f'};
/// Follows the magic number: what the log is made of. Version 1 had a checksum of 64 bits for the scene; in version 3
/// the pairs of a window followed from boxes that were not in the log.
/// A log about curves has polygons around them, and within, and logs about these.
inline constexpr char of_tilings = '2', of_separations = '4', of_curves = '5';

/// The second byte after the fingerprint: which polygons the tiling surrounds.
enum class Shapes : std::uint8_t { inwards, outwards };

/// The first byte of a record. An event has the time (f64, of the segment's parameter, within a few units in the last
/// place) and the half-edge that enters the failing corner (u32).
enum class Record : std::uint8_t {
  event,           ///< an edge across the corner comes, none goes
  event_first,     ///< the edge before the corner goes
  event_second,    ///< the edge after the corner goes
  contact_first,   ///< the same, but the edge to go is a body's: the first contact. The log ends.
  contact_second,  ///< likewise
  next_segment,    ///< the segment is over: on to the next one
  free,            ///< no event until the end of the scene. The log ends.
  free_until,      ///< no event before a time (f64, of the segment's parameter). The log ends.
  touching,        ///< the outward shapes overlap at the start, where two edges (u32 each) cross. The log ends.
};

/// What a log of separations says, the second byte after the fingerprint.
enum class Claim : std::uint8_t {
  free,        ///< on the whole interval
  contact,     ///< pair (u32, u32), segment, vertex, edge (u32 each), four times (f64 each), and the pair's separations
  touching,    ///< pair (u32, u32): the shapes displaced outwards overlap at the start, and how (u8, u32, u32)
  free_until,  ///< up to a time (f64)
  fine_contact,  ///< a contact whose first time lies between doubles: the sum of three (f64 each)
};
/// Added to a claim (free, contact, free_until) that is about a clearance, which follows as f64 in the scene's units.
/// That of a contact goes on with the pair (u32, u32), segment, vertex, peer (u32 each), u8 1 if the peer is an edge,
/// an instant of the segment at which they are closer (three f64), and the time up to which all pairs keep the
/// clearance (f64).
inline constexpr std::uint8_t with_clearance = 16;

/// Stands for the origin of a half-edge that is not in use.
inline constexpr std::uint32_t unused = 0xffffffffu;

/// How far from the instant of an event its time in the log may be, on a segment from `start` to `end`. The factor has
/// many digits, so that no time with a few other bits lies at the limit.
inline double nearness(double start, double end) { return 0x1p-40 * 1.618 * (std::fabs(start) + std::fabs(end)); }

// What every log begins with.

struct Header {
  char version = of_tilings;
  Fingerprint fingerprint{};
  Touch touch = Touch::open;
  std::uint8_t kind = 0;  ///< of a log of tilings, its shapes; of separations, its claim
};

/// Throws ProofError unless it is the header of a log about this scene.
Header read_header(ByteReader& in, const Scene& scene);
void write_header(ByteWriter& out, const Header& header);

}  // namespace taut::internal::proof
