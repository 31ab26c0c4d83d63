#include "proof/format.hpp"

#include "proof/curved_scene.hpp"
#include "scene/validate_scene.hpp"

namespace taut::internal::proof {
namespace {

char shown(char version) { return version >= '0' && version <= '9' ? version : '?'; }

}  // namespace

Header read_header(ByteReader& in, const Scene& scene) {
  for (const char c : magic) {
    const std::uint8_t byte = in.u8();
    if (byte == '{' && c == magic[0])
      throw ProofError("this is not a proof log of taut; if it is an exact one, taut-verified checks it");
    if (byte != static_cast<std::uint8_t>(c)) throw ProofError("this is not a proof log of taut");
  }
  Header header;
  header.version = static_cast<char>(in.u8());
  if (header.version != of_tilings && header.version != of_separations && header.version != of_curves)
    throw ProofError("the log is of version " + std::string(1, shown(header.version)) +
                     " of the format, and this program checks versions 2, 4 and 5: prove again");
  if ((header.version == of_curves) != any_curves(scene))
    throw ProofError(header.version == of_curves ? "the log is about curves, and the scene has none"
                                                 : "the log is about polygons, and the scene has curves");
  if (header.version == of_tilings && !is_ring_pair(scene))
    throw ProofError("the log is of a tiling around two polygons, and the scene is another one");
  for (std::uint8_t& byte : header.fingerprint) byte = in.u8();
  const std::uint8_t touch = in.u8();
  header.kind = in.u8();
  if (touch > 1) throw ProofError("the log's header makes no sense");
  header.touch = touch ? Touch::closed : Touch::open;
  if (header.fingerprint != scene_fingerprint(scene, header.touch))
    throw ProofError("the log belongs to another scene, or to another touch mode");
  return header;
}

void write_header(ByteWriter& out, const Header& header) {
  for (const char c : magic) out.u8(static_cast<std::uint8_t>(c));
  out.u8(static_cast<std::uint8_t>(header.version));
  for (const std::uint8_t byte : header.fingerprint) out.u8(byte);
  out.u8(header.touch == Touch::closed ? 1 : 0);
  out.u8(header.kind);
}

}  // namespace taut::internal::proof
