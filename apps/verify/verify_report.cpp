#include "verify_report.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iostream>

#include "io/json_text.hpp"
#include "taut/error.hpp"
#include "taut/motions.hpp"
#include "taut/proof.hpp"

namespace taut::cli {
namespace {

std::string vertex_text(const Scene& scene, const Feature& f) {
  return fmt::format("vertex {} of {}", f.index, scene.bodies[static_cast<std::size_t>(f.body)].name);
}

std::string edge_text(const Scene& scene, const Feature& f) {
  const Body& body = scene.bodies[static_cast<std::size_t>(f.body)];
  return fmt::format("edge {}-{} of {}", f.index, (static_cast<std::size_t>(f.index) + 1) % body.polygon.size(),
                     body.name);
}

/// The claim in words: what holds when.
std::string claim(const Scene& scene, const Verified& v) {
  const char* touching = v.touch == Touch::closed ? ", touching included" : "";
  if (v.outcome == Outcome::free) return fmt::format("free on [{}, {}]{}", scene.start, scene.end, touching);
  if (v.outcome == Outcome::undecided) {
    return fmt::format("free on [{}, {}){}; nothing after that", scene.start, v.free_until, touching);
  }
  const Contact& c = *v.contact;
  const auto angle = contact_angle(scene, c);
  const std::string at = angle ? fmt::format(", at an angle within [{}, {}] deg", angle->lo, angle->hi) : "";
  const std::string what = at + ": " + vertex_text(scene, c.vertex) + " meets " + edge_text(scene, c.edge);
  if (c.time.lo == c.time.hi) return fmt::format("contact at the start, t = {}{}", c.time.lo, what);
  return fmt::format("free on [{}, {}){}; contact within [{}, {}]{}", scene.start, c.time.lo, touching, c.time.lo,
                     c.time.hi, what);
}

std::string valid_text(const Scene& scene, const Verified& v) {
  return fmt::format("VALID  {} x {}\n  {}\n  touch {}, {} event{}, scene {:016x}\n", scene.bodies[0].name,
                     scene.bodies[1].name, claim(scene, v), to_string(v.touch), v.events, v.events == 1 ? "" : "s",
                     v.fingerprint);
}

std::string valid_json(const Scene& scene, const Verified& v) {
  return fmt::format(
      "{{\"valid\":true,\"outcome\":\"{}\",\"free_until\":{},\"claim\":{},\"touch\":\"{}\",\"events\":{},"
      "\"scene\":\"{:016x}\"}}\n",
      to_string(v.outcome), io::number_text(v.free_until), io::string_text(claim(scene, v)), to_string(v.touch),
      v.events, v.fingerprint);
}

Verified verify_file(const Scene& scene, const std::string& log) {
  if (log == "-") return verify(scene, std::cin);
  std::ifstream file(log, std::ios::binary);
  if (!file || file.peek() == std::ifstream::traits_type::eof()) {
    throw InputError(log, file ? "the file is empty" : std::string("cannot open the file: ") + std::strerror(errno),
                     "`taut prove` writes proofs");
  }
  return verify(scene, file);
}

}  // namespace

int verify_and_report(const Scene& scene, const std::string& scene_name, const std::string& log, bool json) {
  try {
    const Verified verified = verify_file(scene, log);
    fmt::print("{}", json ? valid_json(scene, verified) : valid_text(scene, verified));
    return 0;
  } catch (const ProofError& error) {
    if (json) {
      fmt::print("{{\"valid\":false,\"reason\":{}}}\n", io::string_text(error.what()));
    } else {
      fmt::print("NOT VALID  {} x {}\n  {}\n", scene.bodies[0].name, scene.bodies[1].name, error.what());
    }
    return 1;
  } catch (const InputError& error) {
    throw error.place() == log ? error : error.within(scene_name);
  }
}

}  // namespace taut::cli
