// Any bytes are a scene or an InputError, and a scene survives being written and read. Small worlds among them are
// answered and proved, in both touch modes.
#include <algorithm>
#include <cmath>
#include <sstream>

#include "io/text.hpp"
#include "numeric/budget.hpp"
#include "require.hpp"
#include "scene/validate_scene.hpp"
#include "taut/check.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"
#include "taut/validate.hpp"

using namespace taut;
using namespace taut::internal;

namespace {

bool same(double a, double b) { return a == b && std::signbit(a) == std::signbit(b); }

bool same(const Polygon& a, const Polygon& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (!same(a[k].x, b[k].x) || !same(a[k].y, b[k].y)) return false;
  }
  return true;
}

bool same(const std::vector<Part>& a, const std::vector<Part>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same(a[i].outline, b[i].outline) || a[i].holes.size() != b[i].holes.size()) return false;
    for (std::size_t k = 0; k < a[i].holes.size(); ++k) {
      if (!same(a[i].holes[k], b[i].holes[k])) return false;
    }
  }
  return true;
}

bool same(const PairClearance& a, const PairClearance& b) {
  return a.pair == b.pair && same(a.margin.origin, b.margin.origin) &&
         std::equal(a.margin.coefficients.begin(), a.margin.coefficients.end(), b.margin.coefficients.begin(),
                    b.margin.coefficients.end(), [](double x, double y) { return same(x, y); });
}

bool same(const Scene& a, const Scene& b) {
  if (a.ignore != b.ignore || a.at_rest != b.at_rest) return false;
  if (!std::equal(a.clearances.begin(), a.clearances.end(), b.clearances.begin(), b.clearances.end(),
                  [](const PairClearance& x, const PairClearance& y) { return same(x, y); }))
    return false;
  if (!same(a.start, b.start) || !same(a.end, b.end) || a.bodies.size() != b.bodies.size()) return false;
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    const Body &p = a.bodies[i], &q = b.bodies[i];
    if (p.name != q.name || p.relative_to != q.relative_to) return false;
    if (!same(p.polygon, q.polygon) || !same(p.parts, q.parts)) return false;
    if (p.motion.pieces.size() != q.motion.pieces.size()) return false;
    for (std::size_t k = 0; k < p.motion.pieces.size(); ++k) {
      if (p.motion.pieces[k].pivot != q.motion.pieces[k].pivot) return false;
    }
  }
  return true;
}

std::size_t vertices_of(const Scene& scene) {
  std::size_t n = 0;
  for (const Body& body : scene.bodies) {
    n += body.polygon.size();
    for (const Part& part : body.parts) n += part.outline.size();
  }
  return n;
}

/// What a log proves is what check() says, and who overlaps has touched. Limits leave anything open.
void examine_world(const Scene& scene) {
  CheckOptions options;
  options.limits.max_seconds = 1;
  Answer answers[2];
  for (const Touch touch : {Touch::open, Touch::closed}) {
    options.touch = touch;
    const Answer answer = answers[touch == Touch::closed] = check(scene, options);
    std::stringstream log;
    const Answer proved = prove(scene, log, options);
    if (answer.outcome == Outcome::undecided || proved.outcome == Outcome::undecided) continue;
    fuzz::require(proved.outcome == answer.outcome, "prove() has another outcome");
    // There is no log of these.
    if (answer.outcome == Outcome::overlap_at_start || answer.outcome == Outcome::untested) continue;
    const Budget scope(Limits{4});
    try {
      fuzz::require(verify(scene, log).outcome == answer.outcome, "the log proves something else");
    } catch (const ProofError& error) {
      fuzz::finding(std::string("a log is rejected: ") + error.what());
    } catch (const Interrupted&) {
    }
  }
  const bool meet = answers[0].outcome == Outcome::contact;
  fuzz::require(!meet || answers[1].outcome != Outcome::free, "bodies overlap without touching");
  if (meet && answers[1].contact)
    fuzz::require(answers[1].contact->time.lo <= answers[0].contact->time.hi, "bodies overlap before they touch");
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
    const Budget scope(Limits{patience});
    validate(again);
    if (!is_ring_pair(again) && vertices_of(again) <= 200) examine_world(again);
  } catch (const InputError& error) {
    fuzz::require(!error.problem().empty(), "an error that says nothing");
  } catch (const Interrupted&) {
    fuzz::finding("validation does not end");
  }
  return 0;
}
