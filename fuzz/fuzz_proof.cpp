// Whatever bytes a proof log has, what the verifier accepts is true.
//
// The first byte chooses a scene with known answers, the second how the rest is read: as a log; as the records after a
// true tiling; or as a list of changes to a true log, of a tiling or of separations. Of a scene with curves it is what
// is wrong with a true log about curves. Checksum and, but for the first reading, the header are set right: otherwise
// no input would get far.
#include <array>
#include <sstream>
#include <vector>

#include "bytes.hpp"
#include "numeric/budget.hpp"
#include "proof/curve_log.hpp"
#include "proof/log_text.hpp"
#include "proof/truth.hpp"
#include "require.hpp"
#include "taut/io.hpp"

using namespace taut;
using namespace taut::internal;
using testing::LogParts;

namespace {

struct Specimen {
  Scene scene;
  testing::Truth truth;
  std::array<LogParts, 2> logs;             ///< for open, closed
  std::array<std::string, 2> separations;   ///< without their checksums
  std::array<testing::CurveLog, 2> curves;  ///< in place of the others, if it has curves
};

std::string separations_of(const Scene& scene, Touch touch) {
  CheckOptions options;
  options.touch = touch;
  options.engine = EngineChoice::spacetime;
  std::ostringstream log;
  prove(scene, log, options);
  return log.str().substr(0, log.str().size() - 8);
}

/// A contact, a pass, a start in contact, turns, and a motion in pieces, all with few events.
const char* const scenes[] = {
    R"({"name":"b","polygon":[[1,5],[3,5],[2,6]],"motion":{"y":[0,-0.5]}})",
    R"({"name":"b","polygon":[[1,5],[3,5],[2,3]],"motion":{"x":[-6,1.5],"y":[0,0,-0.05]}})",
    R"({"name":"b","polygon":[[1,2],[3,2],[2,6]],"motion":{"x":[0,0.5]}})",
    R"({"name":"b","polygon":[[-1,-1],[1,-1],[1,1],[0,0.5],[-1,1]],"motion":{"x":[-4,1],"y":[3.5],"rotation":{"angle":[0,1]}}})",
    R"({"name":"b","polygon":[[-1,-1],[1,-1],[1,1],[-1,1]],"motion":{"x":[-4,1],"y":[3],"rotation":{"half_angle_tangent":[0,0.5]}}})",
    R"({"name":"b","polygon":[[-1,0],[1,0],[0,1]],"motion":[{"x":[-3,1],"y":[4],"until":4},{"x":[5,-1],"y":[6,-0.5]}]})"};

/// A disc, and what passes above it, meets it, or turns in it.
const char* const curved_scenes[] = {
    R"({"name":"a","polygon":{"path":"M1 0 A1 1 0 0 1 -1 0 A1 1 0 0 1 1 0 Z"}},
       {"name":"b","polygon":[[-0.1,0],[0.1,0],[0.1,0.2],[-0.1,0.2]],"motion":{"x":[-5,1],"y":[1.5]}})",
    R"({"name":"a","polygon":{"path":"M1 0 A1 1 0 0 1 -1 0 A1 1 0 0 1 1 0 Z"}},
       {"name":"b","polygon":[[-0.1,0],[0.1,0],[0.1,0.2],[-0.1,0.2]],"motion":{"x":[-5,1],"y":[0.7]}})",
    R"({"name":"a","polygon":{"path":"M3 0 A3 3 0 0 1 -3 0 A3 3 0 0 1 3 0 Z M2 0 A2 2 0 0 0 -2 0 A2 2 0 0 0 2 0 Z"}},
       {"name":"b","polygon":{"path":"M0.5 0 Q0.5 1 -0.5 0 Z"},"motion":{"x":[0,0.1],"rotation":{"angle":[0,0.5]}}})"};

const char* const anvil = R"({"name":"a","polygon":[[0,0],[4,0],[4,2],[3,1],[2,2],[1,1],[0,1]]})";

Scene scene_of(const std::string& bodies) {
  return parse_scene(R"({"format":"taut-scene/1","time":[0,10],"bodies":[)" + bodies + "]}");
}

Specimen curved_specimen(const char* bodies) {
  const Scene scene = scene_of(bodies);
  Specimen s{scene, testing::Truth(scene), {}, {}, {}};
  for (const Touch touch : {Touch::open, Touch::closed})
    s.curves[touch == Touch::closed ? 1 : 0] = testing::curve_log_of(scene, testing::prove_in_memory(scene, touch).log);
  return s;
}

std::vector<Specimen> make_specimens() {
  std::vector<Specimen> all;
  for (const char* body : scenes) {
    const Scene scene = scene_of(std::string(anvil) + "," + body);
    const auto vertices = static_cast<std::uint32_t>(scene.bodies[0].polygon.size() + scene.bodies[1].polygon.size());
    Specimen s{scene, testing::Truth(scene), {}, {}, {}};
    for (const Touch touch : {Touch::open, Touch::closed}) {
      const std::size_t mode = touch == Touch::closed ? 1 : 0;
      s.logs[mode] = testing::take_apart(testing::prove_in_memory(scene, touch).log, vertices);
      s.separations[mode] = separations_of(scene, touch);
    }
    all.push_back(std::move(s));
  }
  for (const char* bodies : curved_scenes) all.push_back(curved_specimen(bodies));
  return all;
}

/// A place in a text, or its end.
std::size_t place(fuzz::Bytes& bytes, std::size_t size) { return bytes.u16() % (size + 1); }

void change_bytes(fuzz::Bytes& bytes, std::string& text) {
  const std::size_t at = place(bytes, text.size()), count = bytes.u8();
  switch (bytes.below(4)) {
    case 0:
      if (at < text.size()) text[at] = static_cast<char>(text[at] ^ 1 << bytes.below(8));
      break;
    case 1:
      if (at < text.size()) text[at] = static_cast<char>(bytes.u8());
      break;
    case 2:
      text.erase(at, count);
      break;
    default:
      text.insert(at, text, place(bytes, text.size()), count);
      break;
  }
}

/// Moves, removes, repeats or damages a record, or takes one from another log.
void change_records(fuzz::Bytes& bytes, std::vector<std::string>& records, const LogParts& other) {
  if (records.empty()) return;
  const std::size_t at = bytes.u8() % records.size(), to = bytes.u8() % records.size();
  switch (bytes.below(6)) {
    case 0:
      records.erase(records.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 1:
      std::swap(records[at], records[to]);
      break;
    case 2:
      records.insert(records.begin() + static_cast<std::ptrdiff_t>(to), std::string(records[at]));
      break;
    case 3:
      if (!other.records.empty()) records[at] = other.records[to % other.records.size()];
      break;
    case 4:
      change_bytes(bytes, records[at]);
      break;
    default:
      records[at][0] = static_cast<char>(bytes.below(10));
      break;
  }
}

std::string log_of(fuzz::Bytes& bytes, const Specimen& specimen) {
  const int touch = bytes.below(2);
  if (const testing::CurveLog& curves = specimen.curves[static_cast<std::size_t>(touch)]; !curves.sides.empty())
    return testing::damaged(curves, specimen.scene, touch == 1 ? Touch::closed : Touch::open,
                            [&](int n) { return bytes.below(n); });
  LogParts parts = specimen.logs[static_cast<std::size_t>(touch)];
  const LogParts& other = specimen.logs[static_cast<std::size_t>(1 - touch)];
  switch (bytes.below(5)) {
    case 4: {
      std::string log = specimen.separations[static_cast<std::size_t>(touch)];
      while (!bytes.empty()) change_bytes(bytes, log);
      return testing::sealed(log);
    }
    case 0:
      return bytes.below(2) ? bytes.rest() : testing::sealed(bytes.rest());
    case 1:
      return testing::sealed(parts.header + bytes.rest());
    default:
      while (!bytes.empty()) {
        if (bytes.below(4) == 0) {
          change_bytes(bytes, parts.header);
        } else {
          change_records(bytes, parts.records, other);
        }
      }
      return put_together(parts);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::vector<Specimen> specimens = make_specimens();
  fuzz::Bytes bytes(data, size);
  const Specimen& specimen = specimens[bytes.u8() % specimens.size()];
  std::istringstream log(log_of(bytes, specimen));
  try {
    const Budget scope(Limits{5});
    const std::string wrong = specimen.truth.refutation(verify(specimen.scene, log));
    fuzz::require(wrong.empty(), "a proof of what is not so: " + wrong);
  } catch (const ProofError&) {
  } catch (const Interrupted&) {
    fuzz::finding("verification takes more than 5 seconds");
  }
  return 0;
}
