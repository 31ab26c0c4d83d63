// What a valid log about curves proves, and why: docs/separation-logs.md.
#include "proof/verify_separations.hpp"

#include <algorithm>
#include <sstream>
#include <string>

#include "proof/curved_scene.hpp"
#include "taut/error.hpp"

namespace taut::internal::proof {
namespace {

class CurvesVerifier {
 public:
  CurvesVerifier(const Scene& scene, std::istream& log)
      : scene_(scene), bodies_(scene), in_(log), header_(read_header(in_, scene)) {}

  Verified run() {
    if (header_.kind > 1) throw ProofError("the log's header makes no sense");
    result_.kind = ProofKind::curves;
    result_.touch = header_.touch;
    result_.fingerprint = header_.fingerprint;
    const Verified around = part_of_log(Bodies::around);
    result_.clearance = around.clearance;
    result_.free_until = around.free_until;
    result_.outcome = around.outcome == Outcome::free ? Outcome::free : Outcome::undecided;
    if (header_.kind == 1) meeting(part_of_log(Bodies::within));
    in_.close();
    return result_;
  }

 private:
  /// Polygons, and what is proved about them.
  Verified part_of_log(Bodies side) {
    const char* const where = side == Bodies::around ? "polygons around the bodies: " : "polygons within the bodies: ";
    try {
      const PolygonsOfBodies polygons = read_polygons();
      const std::string log = read_log();
      bodies_.require(polygons, side);
      std::istringstream in(log);
      const Verified verified = verify(with_polygons(scene_, polygons), in);
      if (verified.touch != header_.touch) throw ProofError("their log is about another touch mode");
      result_.events += verified.events;
      result_.separations += verified.separations;
      result_.coverage = verified.coverage;
      return verified;
    } catch (const InputError& error) {
      throw ProofError(where + std::string(error.what()));
    } catch (const ProofError& error) {
      throw ProofError(where + std::string(error.what()));
    }
  }

  PolygonsOfBodies read_polygons() {
    PolygonsOfBodies polygons(scene_.bodies.size());
    for (std::size_t i = 0; i < polygons.size(); ++i) {
      for (const CurvedPart& part : scene_.bodies[i].curves) {
        Part& read = polygons[i].emplace_back();
        read.outline = read_ring();
        for (std::size_t k = 0; k < part.holes.size(); ++k) read.holes.push_back(read_ring());
      }
    }
    return polygons;
  }
  Polygon read_ring() {
    Polygon ring;
    for (std::uint32_t left = in_.u32(); left > 0; --left) {
      const double x = in_.f64();
      ring.push_back({x, in_.f64()});
    }
    result_.segments += ring.size();
    return ring;
  }
  std::string read_log() {
    std::string log;
    for (std::uint64_t left = in_.u64(); left > 0; --left) log.push_back(static_cast<char>(in_.u8()));
    return log;
  }

  /// Polygons within the bodies come together, so the bodies do: not after that, and not before those around them.
  void meeting(const Verified& within) {
    if (within.outcome != Outcome::contact || within.clearance != result_.clearance || result_.outcome == Outcome::free)
      throw ProofError("polygons within the bodies do not do what those around them leave open");
    result_.outcome = Outcome::contact;
    result_.contact_at = within.contact_at;
    if (within.contact) {
      Contact contact = *within.contact;
      bodies_.name(contact.vertex);
      bodies_.name(contact.edge);
      bracket(contact.time);
      result_.contact = contact;
    }
    if (within.closer) {
      ProvedCloseness closer = *within.closer;
      bodies_.name(closer.features.vertex);
      if (closer.features.edge) bodies_.name(*closer.features.edge);
      if (closer.features.other) bodies_.name(*closer.features.other);
      bracket(closer.time);
      result_.closer = closer;
    }
  }
  void bracket(TimeInterval& time) const {
    if (!(result_.free_until <= time.hi)) throw ProofError("free beyond the contact");
    time.lo = result_.free_until;
  }

  const Scene& scene_;
  CurvedBodies bodies_;
  ByteReader in_;
  Header header_;
  Verified result_;
};

}  // namespace

Verified verify_curves(const Scene& scene, std::istream& log) { return CurvesVerifier(scene, log).run(); }

}  // namespace taut::internal::proof
