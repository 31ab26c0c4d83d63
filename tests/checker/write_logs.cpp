// Writes scenes in which nothing turns, their proof logs, damaged ones, and what verify() says of each, as JSON lines.
// `taut_checker_logs REPOSITORY LOGS`: so many valid logs, and ten damaged ones for each.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <sstream>

#include "proof/log_text.hpp"
#include "support/contact_scene.hpp"
#include "support/random_scenes.hpp"
#include "support/rng.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"
#include "taut/shape.hpp"
#include "taut/validate.hpp"

namespace taut::testing {
using namespace internal;
namespace {

namespace fs = std::filesystem;

constexpr std::size_t few_vertices = 200;

std::size_t vertices_of(const Scene& scene) {
  return polygon_of(scene.bodies[0]).size() + polygon_of(scene.bodies[1]).size();
}

/// Is it a valid scene of translations that is small enough?
bool is_suitable(const Scene& scene) {
  try {
    validate(scene);
  } catch (const InputError&) {
    return false;
  }
  for (const Body& body : scene.bodies) {
    for (const MotionPiece& piece : body.motion.pieces) {
      if (!std::holds_alternative<NoRotation>(piece.rotation)) return false;
    }
  }
  return vertices_of(scene) <= few_vertices;
}

/// Pieces that join exactly are made to join up to rounding, so that something happens on the bridges.
void jolt(Rng& rng, Scene& scene) {
  for (Body& body : scene.bodies) {
    for (MotionPiece& piece : body.motion.pieces) {
      for (Coefficients* c : {&piece.x, &piece.y}) {
        if (!c->empty()) c->front() += rng.real(-1, 1) * 1e-8;
      }
    }
  }
}

/// Two squares that are as close as a jump between two pieces is long: often they meet on a bridge.
Scene jump(Rng& rng) {
  const Polygon square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const double gap = rng.real(0, 2e-8), slope = rng.real(-1e-8, 1e-8), joint = rng.real(0.2, 0.8);
  MotionPiece before, after;
  before.x = {1 + gap, slope};
  before.y = {rng.real(-1.5, 1.5)};
  before.until = joint;
  after.x = {1 + gap + rng.real(-4e-8, 4e-8), slope, rng.real(-1e-8, 1e-8)};
  after.y = {before.y[0] + rng.real(-4e-8, 4e-8)};
  return {0, 1, {Body{"P", square, {}}, Body{"Q", square, Motion{{before, after}}}}};
}

Scene drawn(Rng& rng, std::uint64_t number) {
  if (number % 8 == 5) return jump(rng);
  if (number % 4 == 3) return contact_scene(number).scene;
  SceneOptions options;
  options.grid = rng.chance(0.4);
  options.kinds = {MotionKind::linear, MotionKind::polynomial, MotionKind::pieces};
  Scene scene = random_scene(number, all_families[rng.below(static_cast<int>(std::size(all_families)))], options);
  if (rng.chance(0.4)) jolt(rng, scene);
  return scene;
}

std::string hex(const std::string& bytes) {
  std::string text;
  for (const char c : bytes) text += fmt::format("{:02x}", static_cast<std::uint8_t>(c));
  return text;
}

template <class Ref>
std::string feature(const Ref& f) {
  return fmt::format("[{},{}]", f.body, f.index);
}

std::string verdict(const Scene& scene, const std::string& log) {
  std::istringstream in(log);
  try {
    const Verified v = verify(scene, in);
    std::string text = fmt::format(R"("valid":true,"outcome":"{}","closed":{},"events":{})", to_string(v.outcome),
                                   v.touch == Touch::closed, v.events);
    if (v.outcome == Outcome::undecided) text += fmt::format(R"(,"free_until":{})", v.free_until);
    if (!v.contact) return text;
    return text + fmt::format(R"(,"vertex":{},"edge":{},"t":[{},{}],"joint":{})", feature(v.contact->vertex),
                              feature(v.contact->edge), v.contact->time.lo, v.contact->time.hi,
                              v.contact_at == ContactAt::joint);
  } catch (const ProofError& error) {
    return fmt::format(R"("valid":false,"reason":"{}")", error.what());
  }
}

void print_log(const Scene& scene, const std::string& log, const char* damage) {
  fmt::print("{{\"log\":\"{}\",\"damage\":\"{}\",{}}}\n", hex(log), damage, verdict(scene, log));
}

char changed(Rng& rng, char byte) {
  return static_cast<char>(rng.chance(0.5) ? byte ^ (1 << rng.below(8)) : rng.below(256));
}

/// A record's time by another one, nearby or elsewhere.
void shift_time(Rng& rng, std::string& record) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < 8; ++i) bits |= std::uint64_t{static_cast<std::uint8_t>(record[1 + i])} << (8 * i);
  const double by = rng.real(-1, 1) * std::ldexp(1.0, -rng.below(60));
  bits = std::bit_cast<std::uint64_t>(std::bit_cast<double>(bits) + by);
  for (std::size_t i = 0; i < 8; ++i) record[1 + i] = static_cast<char>(bits >> (8 * i));
}

const char* damage_records(Rng& rng, std::vector<std::string>& records) {
  const auto at = static_cast<std::size_t>(rng.below(static_cast<int>(records.size())));
  std::string& record = records[at];
  const auto place = records.begin() + static_cast<std::ptrdiff_t>(at);
  switch (rng.below(8)) {
    case 0:
      records.erase(place);
      return "dropped";
    case 1:
      if (at > 0) std::swap(record, records[at - 1]);
      return "swapped";
    case 2:
      records.insert(place, std::string(record));
      return "repeated";
    case 3:
      records.resize(at);
      records.push_back(std::string(1, 6));
      return "claims the rest";
    case 4:
      if (record.size() >= 9) shift_time(rng, record);
      return "shifted";
    case 5:
      record[0] = static_cast<char>(rng.below(9));
      return "other kind";
    case 6:
      if (record.size() == 13) record[9] = static_cast<char>(record[9] + rng.below(9) - 4);
      return "other corner";
    default: {
      char& byte = record[static_cast<std::size_t>(rng.below(static_cast<int>(record.size())))];
      byte = changed(rng, byte);
      return "byte";
    }
  }
}

/// The other touch mode, with its fingerprint, or the other shapes.
void change_claim(Rng& rng, const Scene& scene, LogParts& parts) {
  char& touch = parts.header[40];
  touch = rng.chance(0.5) ? 1 : 0;
  parts.header[41] = rng.chance(0.5) ? 1 : 0;
  const Fingerprint id = scene_fingerprint(scene, touch ? Touch::closed : Touch::open);
  std::copy(id.begin(), id.end(), parts.header.begin() + 8);
}

void print_damaged(Rng& rng, const Scene& scene, const std::string& log) {
  LogParts parts = take_apart(log, static_cast<std::uint32_t>(vertices_of(scene)));
  const int kind = rng.below(10);
  if (kind > 2) {
    const char* const damage = damage_records(rng, parts.records);
    return print_log(scene, put_together(parts), damage);
  }
  std::string bytes = log.substr(0, log.size() - 8);
  if (kind == 0) {
    bytes.resize(static_cast<std::size_t>(rng.below(static_cast<int>(bytes.size()))));
    return print_log(scene, rng.chance(0.5) ? sealed(bytes) : bytes, "truncated");
  }
  if (kind == 1) {
    std::string whole = log;
    char& byte = whole[static_cast<std::size_t>(rng.below(static_cast<int>(whole.size())))];
    byte = changed(rng, byte);
    return print_log(scene, whole, "byte, not sealed");
  }
  if (rng.chance(0.2)) {
    change_claim(rng, scene, parts);
    return print_log(scene, put_together(parts), "other claim");
  }
  // After the fingerprint: it would hide everything else.
  char& byte = parts.header[40 + static_cast<std::size_t>(rng.below(static_cast<int>(parts.header.size()) - 40))];
  byte = changed(rng, byte);
  print_log(scene, put_together(parts), "tiling");
}

/// The scene, its log, and damaged ones; true if there is one.
bool print_scene(Rng& rng, const Scene& scene, Touch touch, int damaged) {
  if (!is_suitable(scene)) return false;
  Proved proved;
  try {
    proved = prove_in_memory(scene, touch, rng.chance(0.1) ? static_cast<std::uint64_t>(rng.below(20)) : UINT64_MAX);
  } catch (const InputError&) {
    return false;
  }
  if (proved.answer.outcome == Outcome::overlap_at_start || proved.log.size() < 60) return false;
  std::string text = write_scene(scene);
  std::replace(text.begin(), text.end(), '\n', ' ');
  fmt::print("{{\"scene\":{}}}\n", text);
  print_log(scene, proved.log, "");
  for (int k = 0; k < damaged; ++k) print_damaged(rng, scene, proved.log);
  return true;
}

int run(const fs::path& root, int logs) {
  Rng rng(20);
  int written = 0;
  for (const char* folder : {"examples", "tests/corpus"}) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(root / folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) {
      if (file.extension() != ".json" || file.stem().extension() == ".answer") continue;
      for (const Touch touch : {Touch::open, Touch::closed}) {
        written += print_scene(rng, read_scene(file.string()), touch, 10);
      }
    }
  }
  for (std::uint64_t number = 0; written < logs; ++number) {
    const Touch touch = rng.chance(0.5) ? Touch::closed : Touch::open;
    written += print_scene(rng, drawn(rng, number), touch, 10);
  }
  return 0;
}

}  // namespace
}  // namespace taut::testing

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  return taut::testing::run(argv[1], std::atoi(argv[2]));
}
