// What a proof shows, as JSON.
#include "io/answer_json.hpp"
#include "io/json_text.hpp"
#include "taut/io.hpp"

namespace taut {
using namespace internal;
namespace {

const char* name_of(ContactAt at) {
  return at == ContactAt::start ? "start" : at == ContactAt::joint ? "joint" : "motion";
}

}  // namespace

std::string verified_json(const Scene& scene, const Verified& v) {
  std::string s = std::string("{\"valid\":true,\"outcome\":\"") + to_string(v.outcome) +
                  "\",\"free_until\":" + io::number_text(v.free_until);
  if (v.contact) s += io::contact_json(scene, *v.contact) + ",\"contact_at\":\"" + name_of(v.contact_at) + "\"";
  if (v.clearance > 0) s += io::proved_clearance_json(scene, v);
  s += std::string(",\"touch\":\"") + to_string(v.touch) + "\",\"events\":" + std::to_string(v.events) +
       ",\"separations\":" + std::to_string(v.separations);
  if (v.kind == ProofKind::curves) s += ",\"segments\":" + std::to_string(v.segments);
  return s + io::coverage_json(v.coverage) + ",\"scene_sha256\":\"" + to_hex(v.fingerprint) + "\"}";
}

std::string unverified_json(bool refuted, const std::string& reason) {
  return std::string("{\"valid\":") + (refuted ? "false" : "null") + ",\"reason\":" + io::string_text(reason) + "}";
}

}  // namespace taut
