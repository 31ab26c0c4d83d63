// Writes scenes, logs of separations about them, damaged ones, and what verify() says of each, as JSON lines.
// `taut_checker_separations REPOSITORY LOGS`: so many valid logs, and ten damaged ones for each.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iterator>
#include <sstream>

#include "proof/log_text.hpp"
#include "support/closed_linkage.hpp"
#include "support/large_world.hpp"
#include "support/layered.hpp"
#include "support/made_world.hpp"
#include "support/random_scenes.hpp"
#include "support/rng.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/motions.hpp"
#include "taut/proof.hpp"
#include "taut/shape.hpp"

namespace taut::testing {
using namespace internal;
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_vertices = 150, most_bytes = 2500, most_bytes_of_loops = 16000, claim_byte = 41;

std::size_t vertices_in(const Scene& scene) {
  std::size_t count = 0;
  for (const Body& body : scene.bodies) {
    count += body.parts.empty() ? polygon_of(body).size() : 0;
    for (const Part& part : body.parts) {
      count += part.outline.size();
      for (const Polygon& hole : part.holes) count += hole.size();
    }
  }
  return count;
}

/// Small bodies that all go through the same place, some of them turning: everything may meet everything.
Scene crowd(Rng& rng) {
  Scene scene;
  scene.end = 1;
  const int bodies = rng.between(13, 18);
  for (int i = 0; i < bodies; ++i) {
    const double angle = 6.283185307179586 * i / bodies, size = rng.real(0.05, 0.3), off = rng.real(-3, 3);
    const double x = std::cos(angle), y = std::sin(angle);
    MotionPiece piece;
    piece.x = {10 * x - off * y, -20 * x};
    piece.y = {10 * y + off * x, -20 * y};
    if (rng.chance(0.5)) piece.rotation = AngleRotation{{0, rng.real(-3, 3)}};
    const Polygon square{{-size, -size}, {size, -size}, {size, size}, {-size, size}};
    scene.bodies.push_back({"b" + std::to_string(i), square, rng.chance(0.9) ? Motion{{piece}} : Motion{}});
    if (!scene.bodies.back().motion.pieces.empty()) continue;
    for (Point& p : scene.bodies.back().polygon) p = {p.x + 8 * x, p.y + 8 * y};
  }
  return scene;
}

Polygon blade(Rng& rng) {
  const double length = rng.real(0.5, 2), width = rng.real(0.1, 0.5);
  return {{-0.2, -width}, {length, -width / 2}, {length, width / 2}, {-0.2, width}};
}

/// Blades that swing to where the cosine of their angle is 1 or -1 and back, or begin or end there, or stop for a
/// while.
Scene swinging(Rng& rng) {
  Scene scene;
  scene.start = -1;
  scene.end = 1;
  const int bodies = rng.between(2, 4);
  for (int i = 0; i < bodies; ++i) {
    const double h = rng.between(-45, 45) / 64.0, k = rng.between(5, 16) / 16.0;
    Coefficients cosine;
    switch (rng.below(6)) {
      case 0:  // touches 1 at h
        cosine = {1 - k * h * h, 2 * k * h, -k};
        break;
      case 1:  // comes to 1 at the end, with infinite speed
        cosine = {0.5, 0.5};
        break;
      case 2:  // at 1 at both ends
        cosine = {0, 0, 1};
        break;
      case 3:  // comes near 1
        cosine = {1 - k * h * h - std::exp2(rng.real(-48, -4)), 2 * k * h, -k};
        break;
      case 4:  // from -1 to 1 and back between
        cosine = {0, -3, 0, 4};
        break;
      default:  // touches -1 at 0 to order four
        cosine = {-1, 0, 0, 0, k};
    }
    MotionPiece piece;
    piece.x = {2.0 * i + rng.real(-0.3, 0.3), rng.real(-0.4, 0.4)};
    piece.y = {rng.real(-1, 1), rng.real(-0.4, 0.4)};
    piece.rotation = CosineRotation{cosine};
    scene.bodies.push_back({"b" + std::to_string(i), blade(rng), {{piece}}});
    if (i > 0 && rng.chance(0.2)) scene.bodies.back().relative_to = "b0";
  }
  return scene;
}

/// Blades about pivots, or on another one's frame, at multiples of one rate: after a while they only repeat themselves.
Scene repeating(Rng& rng) {
  Scene scene;
  scene.start = rng.chance(0.5) ? 0 : rng.real(-3, 3);
  const double rate = (16 + rng.below(80)) / 32.0;
  scene.end = scene.start + rng.real(0.5, rng.chance(0.5) ? 4 : 2000) * 6.283185307179586 / rate;
  const int n = 2 + rng.below(3);
  for (int i = 0; i < n; ++i) {
    MotionPiece piece, before;
    piece.rotation = AngleRotation{{rng.real(0, 6), (rng.below(7) - 3) * rate}};
    piece.pivot = {0.125 * rng.below(5), 0};
    piece.x = {1.5 * i + rng.real(0, 1)};
    if (rng.chance(0.2)) piece.orbit = {{1, 1}, {0, rate}};
    std::vector<MotionPiece> pieces{piece};
    if (rng.chance(0.2)) {
      before = piece;
      before.until = scene.start + 0.25;
      pieces.insert(pieces.begin(), before);
    }
    scene.bodies.push_back({"b" + std::to_string(i), blade(rng), {pieces}});
    if (i > 0 && rng.chance(0.2)) scene.bodies.back().relative_to = "b0";
  }
  return scene;
}

/// Linkages of one or two loops, some with a drive that begins elsewhere than in the drawn pose, or turns back.
Scene linked(Rng& rng) {
  Scene scene = ClosedLinkage(rng, 1 + rng.below(2)).scene();
  std::vector<taut::Drive::Piece>& pieces = scene.mechanism->drives[0].pieces;
  const auto [t0, v0, t1, v1] = *pieces[0].line;
  if (rng.chance(0.3)) {
    pieces[0].line = {t0, v1 / 8, t1, v1};
  } else if (rng.chance(0.4)) {
    const double middle = t0 + (t1 - t0) / 4;
    pieces = {{middle, std::array<double, 4>{t0, v0, middle, v1 / 4}, {}},
              {INFINITY, std::array<double, 4>{middle, v1 / 4, t1, v0}, {}}};
  }
  // Off their joints, where all of them lie on each other.
  for (Body& body : scene.bodies) {
    const double x = rng.real(-6, 6), y = rng.real(-6, 6), size = rng.real(1, 3);
    const Point at = body.polygon[0];
    for (Point& p : body.polygon) p = {at.x + x + size * (p.x - at.x), at.y + y + size * (p.y - at.y)};
  }
  if (rng.chance(0.3)) scene.bodies.back().z = {0, 1};
  return scene;
}

Scene drawn_world(Rng& rng, std::uint64_t number) {
  if (number % 8 == 4) return linked(rng);
  if (number % 8 == 7) return crowd(rng);
  if (number % 8 == 5) return swinging(rng);
  if (number % 8 == 1) return repeating(rng);
  // Some with pairs at rest, too: those are tested at the start, and have entries in a log. Some on layers.
  const auto perhaps_at_rest = [&](Scene scene) {
    if (rng.chance(0.4)) scene.at_rest = AtRest::test;
    return rng.chance(0.3) ? on_layers(std::move(scene), number) : scene;
  };
  if (number % 4 == 2) return perhaps_at_rest(scene_of(large_world(number).world));
  if (number % 4 == 3) {
    SceneOptions options;
    options.grid = rng.chance(0.4);
    return random_scene(number, all_families[rng.below(static_cast<int>(std::size(all_families)))], options);
  }
  return perhaps_at_rest(scene_of(random_world(number)));
}

std::string in_hex(const std::string& bytes) {
  std::string text;
  for (const char c : bytes) text += fmt::format("{:02x}", static_cast<std::uint8_t>(c));
  return text;
}

template <class Ref>
std::string feature_of(const Ref& f) {
  return fmt::format("[{},{},{},{}]", f.body, f.part, f.ring, f.index);
}

std::string said_of(const Scene& scene, const std::string& log) {
  std::istringstream in(log);
  try {
    const Verified v = verify(scene, in);
    std::string text = fmt::format(R"("valid":true,"outcome":"{}","closed":{},"separations":{},"free_until":{})",
                                   to_string(v.outcome), v.touch == Touch::closed, v.separations, v.free_until);
    if (v.contact && v.contact_at != ContactAt::start)
      text += fmt::format(R"(,"vertex":{},"edge":{},"t":[{},{}])", feature_of(v.contact->vertex),
                          feature_of(v.contact->edge), v.contact->time.lo, v.contact->time.hi);
    if (v.closer) text += fmt::format(R"(,"vertex":{})", feature_of(v.closer->features.vertex));
    return text;
  } catch (const ProofError& error) {
    std::string reason = error.what();
    std::erase_if(reason, [](char c) { return c == '"' || c == '\\' || c == '\n'; });
    return fmt::format(R"("valid":false,"reason":"{}")", reason);
  }
}

void print_line(const Scene& scene, const std::string& log, const char* damage) {
  fmt::print("{{\"log\":\"{}\",\"damage\":\"{}\",{}}}\n", in_hex(log), damage, said_of(scene, log));
}

/// Four bytes that are a single of a plausible size, if there are any: the side of a box.
bool change_box(Rng& rng, std::string& bytes) {
  for (int tries = bytes.size() < 50 ? 60 : 0; tries < 60; ++tries) {
    const auto at = static_cast<std::size_t>(rng.between(42, static_cast<int>(bytes.size()) - 4));
    float side;
    std::memcpy(&side, bytes.data() + at, sizeof side);
    if (!(std::fabs(side) > 0x1p-6f && std::fabs(side) < 64)) continue;
    side *= static_cast<float>(rng.real(0.5, 1.2));
    std::memcpy(bytes.data() + at, &side, sizeof side);
    return true;
  }
  return false;
}

/// All but the checksum; returns what was done.
const char* damage(Rng& rng, const Scene& scene, std::string& bytes) {
  const auto any = [&](int from) {
    return static_cast<std::size_t>(rng.between(from, static_cast<int>(bytes.size()) - 1));
  };
  const std::size_t at = any(42), other = any(42), end = std::min(bytes.size(), at + 1 + any(0) % 24);
  switch (rng.below(10)) {
    case 0:
      bytes.resize(any(0));
      return "truncated";
    case 1:
      std::swap(bytes[at], bytes[other]);
      return "swapped";
    case 2:
      bytes.erase(at, end - at);
      return "missing";
    case 3:
      bytes.insert(other, bytes.substr(at, end - at));
      return "twice";
    case 4:
      return change_box(rng, bytes) ? "box" : "nothing";
    case 5:
      bytes[claim_byte] = static_cast<char>(rng.below(4) + (rng.chance(0.3) ? 16 : 0));
      return "claim";
    case 6: {
      bytes[40] = static_cast<char>(1 - bytes[40]);
      const Fingerprint id = scene_fingerprint(scene, bytes[40] ? Touch::closed : Touch::open);
      std::copy(id.begin(), id.end(), bytes.begin() + 8);
      return "touch";
    }
    case 7:
      bytes[at] = static_cast<char>(rng.below(5));
      return "step";
    default:
      bytes[at] = static_cast<char>(rng.chance(0.5) ? bytes[at] ^ (1 << rng.below(8)) : rng.below(256));
      return "byte";
  }
}

std::string number_of(double x) { return fmt::format("{}", x); }

/// A motion written in degrees.
std::string motion_text(Rng& rng, int i) {
  const auto real = [&rng](double most) { return number_of(rng.real(-most, most)); };
  const auto angle = [&] { return rng.chance(0.4) ? number_of(90 * rng.between(-3, 3)) : real(200); };
  const double x = 3.0 * i;
  if (rng.chance(0.2))
    return fmt::format(R"({{"sweep":{{"pivot":[{},{}],"from_deg":{},"to_deg":{}}}}})", number_of(x), real(1), angle(),
                       angle());
  if (rng.chance(0.2))
    return fmt::format(R"({{"velocity":[{},{}],"spin_deg":{},"pivot":[{},{}]}})", real(1), real(1), angle(), real(1),
                       real(1));
  std::string keys;
  for (int k = 0, n = rng.between(1, 4); k < n; ++k) {
    const std::string t = number_of(0.1 + 0.3 * k);
    if (k > 0) keys += ",";
    if (k > 0 && rng.chance(0.4)) {
      keys += fmt::format(R"({{"t":{},"{}":{{"center":[{},{}],"deg":{}}}}})", t, rng.chance(0.5) ? "turn" : "arc",
                          number_of(x), real(1), rng.chance(0.1) ? "0" : angle());
    } else {
      keys += fmt::format(R"({{"t":{},"x":{},"y":{},"angle_deg":{}}})", t, number_of(x + rng.real(-1, 1)), real(1),
                          rng.chance(0.3) ? "30" : angle());
    }
  }
  return fmt::format(R"({{"keyframes":[{}],"pivot":[{},{}]}})", keys, real(0.5), real(0.5));
}

/// A scene as people write it.
std::string written_world(Rng& rng) {
  std::string bodies;
  for (int i = 0, n = rng.between(2, 4); i < n; ++i) {
    const std::string w = number_of(rng.real(0.2, 1.2));
    bodies += fmt::format(R"({}{{"name":"b{}","polygon":[[0,0],[{},0],[{},{}],[0,{}]],"motion":{}}})", i ? "," : "", i,
                          w, w, w, w, motion_text(rng, i));
  }
  return fmt::format(R"({{"format":"taut-scene/1","time":[0,1],"bodies":[{}]}})", bodies);
}

/// The scene, its log, and damaged ones; true if there is one. `text`: as it was written, if it was.
bool print_world(Rng& rng, const Scene& scene, Touch touch, double clearance, std::string text = {}) {
  std::ostringstream out;
  CheckOptions options;
  options.touch = touch;
  options.engine = EngineChoice::spacetime;
  options.limits.max_seconds = 20;
  try {
    if (vertices_in(scene) > most_vertices) return false;
    if (clearance > 0) {
      prove_clearance(scene, clearance, out, options);
    } else {
      prove(scene, out, options);
    }
  } catch (const InputError&) {
    return false;
  }
  const std::string log = out.str();
  if (log.size() < 52 || log.size() > (scene.mechanism ? most_bytes_of_loops : most_bytes)) return false;
  if (text.empty()) text = write_scene(scene);
  std::replace(text.begin(), text.end(), '\n', ' ');
  fmt::print("{{\"scene\":{}}}\n", text);
  print_line(scene, log, "");
  for (int k = 0; k < 10; ++k) {
    std::string bytes = log.substr(0, log.size() - 8);
    const char* const what = damage(rng, scene, bytes);
    print_line(scene, rng.chance(0.03) ? bytes + log.substr(log.size() - 8) : sealed(bytes), what);
  }
  return true;
}

/// A clearance of about the size that tells something; 0 for none.
double drawn_clearance(Rng& rng, const Scene& scene) {
  if (rng.chance(0.75)) return 0;
  try {
    const Clearance least = clearance(scene);
    return least.nearest && least.nearest->hi > 0 ? least.nearest->hi * rng.real(0.7, 1.3) : 0;
  } catch (const InputError&) {
    return 0;
  }
}

int write_all(const fs::path& root, int logs) {
  Rng rng(21);
  int written = 0;
  const auto print = [&](const Scene& given, Touch touch) {
    try {
      const Scene scene = assembled(given);
      written += print_world(rng, scene, touch, drawn_clearance(rng, scene));
    } catch (const InputError&) {
      // A linkage that is drawn at a dead point, or locks before its drive begins.
    }
  };
  for (const fs::path& folder : {root / "tests/corpus/mechanisms", root / "examples/mechanisms",
                                 root / "../shared/worlds", root / "examples/worlds"}) {
    if (!fs::exists(folder)) continue;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
      if (file.extension() != ".json" || file.stem().extension() == ".answer" || 2 * written > logs) continue;
      for (const Touch touch : {Touch::open, Touch::closed}) print(read_scene(file.string()), touch);
    }
  }
  // As close as the clearance at the start, to the last bit.
  for (const double speed : {1.0, -1.0}) {
    Scene close;
    close.end = 1;
    close.bodies = {{"a", {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {}},
                    {"b", {{2, -0.5}, {4, -0.5}, {4, 0.5}, {2, 0.5}}, from_velocity({speed, 0})}};
    written += print_world(rng, close, Touch::closed, 1);
  }
  for (std::uint64_t number = 1; written < logs; ++number) {
    const Touch touch = rng.chance(0.5) ? Touch::closed : Touch::open;
    if (number % 8 == 6) {
      const std::string text = written_world(rng);
      const Scene scene = parse_scene(text);
      written += print_world(rng, scene, touch, drawn_clearance(rng, scene), text);
    } else {
      print(drawn_world(rng, number), touch);
    }
  }
  return 0;
}

}  // namespace
}  // namespace taut::testing

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  return taut::testing::write_all(argv[1], std::atoi(argv[2]));
}
