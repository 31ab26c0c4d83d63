#include "proof/path_log.hpp"

#include "taut/error.hpp"

namespace taut::internal::proof {
namespace {

void write_feature(ByteWriter& out, const PathFeature& f) {
  out.u32(f.body);
  out.u32(f.vertex);
}

PathFeature read_feature(ByteReader& in) {
  const std::uint32_t body = in.u32();
  return {body, in.u32()};
}

PathCrossing read_crossing(ByteReader& in) {
  const PathFeature first = read_feature(in);
  return {first, read_feature(in), 0, 0};
}

}  // namespace

void write(ByteWriter& out, const PathClaim& claim) {
  out.u8(static_cast<std::uint8_t>(claim.kind));
  switch (claim.kind) {
    case PathNode::halved:
      return out.u8(claim.joint);
    case PathNode::open:
      return;
    case PathNode::crossing:
      write_feature(out, claim.crossings[0].first);
      return write_feature(out, claim.crossings[0].second);
    case PathNode::inside:
      out.u32(claim.body);
      out.u32(claim.other);
      out.f64(claim.point.x);
      return out.f64(claim.point.y);
    case PathNode::near:
      write_feature(out, claim.vertex);
      return write_feature(out, claim.edge);
    case PathNode::conditions:
      out.u8(static_cast<std::uint8_t>(claim.crossings.size()));
      for (const PathCrossing& c : claim.crossings) {
        write_feature(out, c.first);
        write_feature(out, c.second);
        out.u8(c.end);
        out.f64(c.weight);
      }
  }
}

PathClaim read_path_claim(ByteReader& in) {
  PathClaim claim;
  const std::uint8_t kind = in.u8();
  if (kind > static_cast<std::uint8_t>(PathNode::conditions)) throw ProofError("unknown node");
  claim.kind = static_cast<PathNode>(kind);
  switch (claim.kind) {
    case PathNode::halved:
      claim.joint = in.u8();
      break;
    case PathNode::open:
      break;
    case PathNode::crossing:
      claim.crossings.push_back(read_crossing(in));
      break;
    case PathNode::inside:
      claim.body = in.u32();
      claim.other = in.u32();
      claim.point.x = in.f64();
      claim.point.y = in.f64();
      break;
    case PathNode::near:
      claim.vertex = read_feature(in);
      claim.edge = read_feature(in);
      break;
    case PathNode::conditions:
      for (std::uint8_t n = in.u8(); n > 0; --n) {
        claim.crossings.push_back(read_crossing(in));
        claim.crossings.back().end = in.u8();
        claim.crossings.back().weight = in.f64();
      }
  }
  return claim;
}

}  // namespace taut::internal::proof
