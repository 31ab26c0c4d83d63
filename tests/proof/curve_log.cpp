#include "proof/curve_log.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "proof/bytes.hpp"
#include "proof/format.hpp"
#include "proof/log_text.hpp"
#include "taut/error.hpp"

namespace taut::testing {
using namespace internal;
namespace {

constexpr std::size_t magic_size = 8;

Polygon ring_of(proof::ByteReader& in) {
  Polygon ring;
  for (std::uint32_t left = in.u32(); left > 0; --left) {
    const double x = in.f64();
    ring.push_back({x, in.f64()});
  }
  return ring;
}

CurveLog::Side side_of(proof::ByteReader& in, const Scene& scene) {
  CurveLog::Side side;
  for (const Body& body : scene.bodies) {
    side.polygons.emplace_back();
    for (const CurvedPart& part : body.curves) {
      Part& read = side.polygons.back().emplace_back();
      read.outline = ring_of(in);
      for (std::size_t k = 0; k < part.holes.size(); ++k) read.holes.push_back(ring_of(in));
    }
  }
  for (std::uint64_t left = in.u64(); left > 0; --left) side.log.push_back(static_cast<char>(in.u8()));
  side.log.resize(side.log.size() - std::min(side.log.size(), checksum_size));
  return side;
}

void put(proof::ByteWriter& out, const Polygon& ring) {
  out.u32(static_cast<std::uint32_t>(ring.size()));
  for (const Point& p : ring) {
    out.f64(p.x);
    out.f64(p.y);
  }
}

void put(proof::ByteWriter& out, const CurveLog::Side& side) {
  for (const std::vector<Part>& parts : side.polygons) {
    for (const Part& part : parts) {
      put(out, part.outline);
      for (const Polygon& hole : part.holes) put(out, hole);
    }
  }
  const std::string log = sealed(side.log);
  out.u64(log.size());
  for (const char c : log) out.u8(static_cast<std::uint8_t>(c));
}

std::size_t place(const Choice& below, std::size_t size) {
  return static_cast<std::size_t>(below(256) * 256 + below(256)) % size;
}

/// A bit, or some bytes that are left out or there twice.
void damage(std::string& bytes, const Choice& below) {
  if (bytes.empty()) return;
  const std::size_t at = place(below, bytes.size()), count = static_cast<std::size_t>(1 + below(32));
  switch (below(4)) {
    case 0:
      bytes.erase(at, count);
      break;
    case 1:
      bytes.insert(at, std::string(bytes, at, count));
      break;
    default:
      bytes[at] = static_cast<char>(bytes[at] ^ (1 << below(8)));
  }
}

/// Nearer to the origin, or farther from it.
void move(Point& p, double by) { p = {p.x * (1 + by), p.y * (1 + by)}; }

void move_corners(proof::PolygonsOfBodies& polygons, const Choice& below) {
  const double by = std::ldexp(below(2) == 0 ? 1 : -1, -2 - below(40));
  const bool all = below(3) == 0;
  for (std::vector<Part>& parts : polygons) {
    for (Part& part : parts) {
      if (!all) {
        move(part.outline[place(below, part.outline.size())], by);
        continue;
      }
      for (Point& p : part.outline) move(p, by);
    }
  }
}

void damage_sides(std::vector<CurveLog::Side>& sides, const Choice& below) {
  switch (below(3)) {
    case 0:
      std::swap(sides.front(), sides.back());
      break;
    case 1:
      sides.push_back(CurveLog::Side(sides.back()));
      if (sides.size() > 2) sides.erase(sides.begin());
      break;
    default:
      if (sides.size() > 1) sides.pop_back();
  }
}

}  // namespace

std::string damaged(CurveLog parts, const Scene& scene, Touch touch, const Choice& below) {
  CurveLog::Side& side = parts.sides[place(below, parts.sides.size())];
  switch (below(5)) {
    case 0:
    case 1:
      move_corners(side.polygons, below);
      name_polygons(side, scene, touch);
      break;
    case 2:
      damage(side.log, below);
      break;
    case 3:
      damage_sides(parts.sides, below);
      break;
    default: {
      std::string bytes = put_together(parts, scene, touch);
      bytes.resize(bytes.size() - checksum_size);
      damage(bytes, below);
      return sealed(bytes);
    }
  }
  return put_together(parts, scene, touch);
}

CurveLog curve_log_of(const Scene& scene, const std::string& log) {
  std::istringstream text(log);
  proof::ByteReader in(text);
  const proof::Header header = proof::read_header(in, scene);
  CurveLog parts;
  for (int k = 0; k <= header.kind; ++k) parts.sides.push_back(side_of(in, scene));
  return parts;
}

std::string put_together(const CurveLog& parts, const Scene& scene, Touch touch) {
  std::ostringstream log;
  proof::ByteWriter out(log);
  const auto kind = static_cast<std::uint8_t>(parts.sides.size() - 1);
  proof::write_header(out, {proof::of_curves, scene_fingerprint(scene, touch), touch, kind});
  for (const CurveLog::Side& side : parts.sides) put(out, side);
  out.close();
  return log.str();
}

bool name_polygons(CurveLog::Side& side, const Scene& scene, Touch touch) {
  try {
    const Fingerprint print = scene_fingerprint(proof::with_polygons(scene, side.polygons), touch);
    if (side.log.size() < magic_size + print.size()) return false;
    std::copy(print.begin(), print.end(), side.log.begin() + magic_size);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace taut::testing
