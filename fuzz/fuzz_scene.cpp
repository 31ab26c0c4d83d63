// Any bytes are a scene or an InputError, and a scene survives being written and read.
#include <cmath>

#include "base/interruption.hpp"
#include "io/terminal_text.hpp"
#include "require.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/validate.hpp"

using namespace taut;

namespace {

bool same(double a, double b) { return a == b && std::signbit(a) == std::signbit(b); }

bool same(const Scene& a, const Scene& b) {
  if (!same(a.start, b.start) || !same(a.end, b.end) || a.bodies.size() != b.bodies.size()) return false;
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    const Body &p = a.bodies[i], &q = b.bodies[i];
    if (p.name != q.name || p.polygon.size() != q.polygon.size()) return false;
    if (p.motion.pieces.size() != q.motion.pieces.size()) return false;
    for (std::size_t k = 0; k < p.motion.pieces.size(); ++k) {
      if (p.motion.pieces[k].pivot != q.motion.pieces[k].pivot) return false;
    }
    for (std::size_t k = 0; k < p.polygon.size(); ++k) {
      if (!same(p.polygon[k].x, q.polygon[k].x) || !same(p.polygon[k].y, q.polygon[k].y)) return false;
    }
  }
  return true;
}

/// For validation, in seconds: under the sanitizers, and beside other work. What has no end takes any time.
constexpr double patience = 30;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  // Outlines in files of their own have a target of their own; here they would be the machine's files, as would
  // keyframes.
  for (const char* key : {"wkt", "geojson", "csv"}) {
    if (text.find(key) != std::string::npos) return 0;
  }
  try {
    const Scene scene = parse_scene(text);
    const std::string written = write_scene(scene);
    fuzz::require(io::for_terminal(written) == written, "a scene is written with control characters");
    const Scene again = parse_scene(written);
    fuzz::require(same(scene, again), "the scene that was written is another one");
    fuzz::require(write_scene(again) == written, "a scene that was read is written differently");
    const InterruptionScope scope(nullptr, patience);
    validate(again);
  } catch (const InputError& error) {
    fuzz::require(!error.problem().empty(), "an error that says nothing");
  } catch (const Interrupted&) {
    fuzz::finding("validation does not end");
  }
  return 0;
}
