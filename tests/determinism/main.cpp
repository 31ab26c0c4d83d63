// The same scene gives the same bytes of `check --json`, `trace` and `prove`, and of questions about times and
// distances, whoever compiled taut, for what machine.
//
// Computes them through the library, as the commands do, for every scene of the repository and for those of
// scenes.txt, in both touch modes, and compares a hash of each with hashes.txt. Nothing is left out: elapsed time is
// only in the answer if it is asked for, and the version of taut is in none of them.
//
// scenes.txt has scenes of the soak (`./dev soak --print N`), one a line. They are kept as text because the generators
// call the C library's sin, cos and exp, whose last bits differ from one machine to the next.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "io/answer_writer.hpp"
#include "proof/bytes.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/intervals.hpp"
#include "taut/io.hpp"
#include "taut/proof.hpp"
#include "taut/swept.hpp"

namespace taut::determinism {
using namespace internal;
namespace {

namespace fs = std::filesystem;

std::string hash_text(const std::string& bytes) {
  proof::Checksum sum;
  for (const char c : bytes) sum.add(static_cast<std::uint8_t>(c));
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(sum.value()));
  return text;
}

class LinesTracer : public Tracer {
 public:
  explicit LinesTracer(const Scene& scene) : writer_(scene) {}
  void on_event(const TraceEvent& event) override { lines += writer_.line(event) + '\n'; }
  std::string lines;

 private:
  io::TraceWriter writer_;
};

/// The region that the first body that moves passes over, coarsely.
std::string first_region(const Scene& scene) {
  const auto moves = [](const Body& body) { return !body.motion.pieces.empty(); };
  const auto mover = std::find_if(scene.bodies.begin(), scene.bodies.end(), moves);
  if (mover == scene.bodies.end() || mover->polygon.empty()) return "";
  SweptOptions coarse;
  for (const Point& p : mover->polygon)
    coarse.tolerance = std::max({coarse.tolerance, std::fabs(p.x) / 32, std::fabs(p.y) / 32});
  const auto body = static_cast<BodyId>(mover - scene.bodies.begin());
  return swept_json(scene, body, swept(scene, body, coarse)) + '\n';
}

/// When bodies overlap; and of scenes for which that does not take seconds how far from each other they are, which is
/// the same for both ways of touching, and the region of a body.
std::string questions(const Scene& scene, Touch touch, bool distances) {
  std::string answers;
  try {
    CheckOptions options;
    options.touch = touch;
    answers = intervals_json(scene, intervals(scene, options), touch) + '\n';
    if (!distances || touch == Touch::closed) return answers;
    ClearanceOptions least;
    least.relative = 1e-6;
    answers += clearance_json(scene, clearance(scene, least)) + '\n';
    ProfileOptions profile;
    profile.instants = 5;
    profile.relative = 1e-6;
    profile.halvings = 10;
    answers += profile_json(scene, distance_profile(scene, profile)) + '\n';
    answers += first_region(scene);
  } catch (const InputError& error) {
    answers += error.what();
  }
  return answers;
}

/// "ANSWERS TRACE PROOF QUESTIONS TOUCH": hashes of the answers of both engines and of both in turn, of the trace, of
/// the proof, and of the questions.
std::string examine(const Scene& scene, Touch touch, bool distances) {
  LinesTracer trace(scene);
  std::ostringstream proof;
  std::string answers;
  CheckOptions options;
  options.touch = touch;
  try {
    for (const EngineChoice engine : {EngineChoice::spacetime, EngineChoice::either}) {
      options.engine = engine;
      answers += answer_json(scene, check(scene, options), touch) + '\n';
    }
    options.engine = EngineChoice::kinetic;
    options.tracer = &trace;
    const std::string kinetic = answer_json(scene, prove(scene, proof, options), touch) + '\n';
    answers += kinetic;
    trace.lines += kinetic;
  } catch (const InputError& error) {
    answers += error.what();
  }
  return hash_text(answers) + ' ' + hash_text(trace.lines) + ' ' + hash_text(proof.str()) + ' ' +
         hash_text(questions(scene, touch, distances)) + ' ' + to_string(touch);
}

std::vector<std::string> lines_of(const fs::path& file) {
  std::ifstream in(file);
  if (!in) throw InputError(file.string(), "cannot open the file", "the argument is the root of the repository");
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line[0] != '#') lines.push_back(line);
  }
  return lines;
}

/// The scenes of a folder, by name.
std::vector<std::string> scene_files(const fs::path& root, const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(root / folder)) {
    const fs::path& path = entry.path();
    if (path.extension() == ".json" && path.stem().extension() != ".answer")
      names.push_back(folder + "/" + path.filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

void for_each_scene(const fs::path& root, const std::function<void(const std::string&, const Scene&)>& visit) {
  for (const char* folder : {"examples", "examples/continents", "examples/worlds", "tests/corpus"}) {
    for (const std::string& name : scene_files(root, folder)) visit(name, read_scene((root / name).string()));
  }
  int number = 0;
  for (const std::string& line : lines_of(root / "tests/determinism/scenes.txt")) {
    const std::string name = "scenes.txt:" + std::to_string(++number);
    visit(name, parse_scene(line, name));
  }
}

/// The first line that differs, in words; empty if none does.
std::string first_difference(const std::vector<std::string>& expected, const std::vector<std::string>& found) {
  const auto [e, f] = std::mismatch(expected.begin(), expected.end(), found.begin(), found.end());
  if (e == expected.end() && f == found.end()) return {};
  if (e == expected.end()) return "not expected: " + *f;
  if (f == found.end()) return "missing: " + *e;
  return "expected " + *e + "\nfound    " + *f;
}

int run(const fs::path& root, bool update) {
  std::vector<std::string> found;
  for_each_scene(root, [&found](const std::string& name, const Scene& scene) {
    // Those of the corpus are there because they are hard.
    const bool distances = !name.starts_with("tests/corpus");
    for (const Touch touch : {Touch::open, Touch::closed}) {
      found.push_back(examine(scene, touch, distances) + ' ' + name);
    }
  });
  std::string all;
  for (const std::string& line : found) all += line + '\n';
  found.push_back("all " + hash_text(all));
  for (const std::string& line : found) std::printf("%s\n", line.c_str());
  const fs::path file = root / "tests/determinism/hashes.txt";
  if (update) {
    write_file(file.string(), "# answers, trace, proof, questions, touch, scene: ./dev determinism --update\n" + all +
                                  found.back() + '\n');
    return 0;
  }
  const std::string difference = first_difference(lines_of(file), found);
  if (difference.empty()) return 0;
  std::fprintf(stderr,
               "the first of the lines (hashes of answers, trace, proof and questions, touch, scene) that differ:\n%s\n"
               "If the change of answers is meant, on every platform: ./dev determinism --update\n",
               difference.c_str());
  return 1;
}

/// What the last of a scene's hashes is of.
int show(const fs::path& root, const std::string& wanted) {
  for_each_scene(root, [&wanted](const std::string& name, const Scene& scene) {
    if (name == wanted) std::fputs(questions(scene, Touch::open, true).c_str(), stdout);
  });
  return 0;
}

}  // namespace
}  // namespace taut::determinism

int main(int argc, char** argv) {
  const bool update = argc == 3 && std::string(argv[2]) == "--update";
  const bool show = argc == 4 && std::string(argv[2]) == "--show";
  if (argc < 2 || (argc > 2 && !update && !show)) {
    std::fprintf(stderr, "usage: taut_determinism REPOSITORY [--update | --show SCENE]\n");
    return 2;
  }
  try {
    if (show) return taut::determinism::show(argv[1], argv[3]);
    return taut::determinism::run(argv[1], update);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
