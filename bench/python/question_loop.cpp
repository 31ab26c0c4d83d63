// Small questions in C++, which bench/python/small.py holds those of the Python package against.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

#include "taut/taut.hpp"

namespace {

/// The median of many runs, in seconds.
template <class Question>
double seconds_of(const Question& question) {
  using Clock = std::chrono::steady_clock;
  for (int k = 0; k < 20; ++k) question();
  std::vector<double> seconds(500);
  for (double& s : seconds) {
    const Clock::time_point start = Clock::now();
    question();
    s = std::chrono::duration<double>(Clock::now() - start).count();
  }
  std::nth_element(seconds.begin(), seconds.begin() + 250, seconds.end());
  return seconds[250];
}

}  // namespace

/// question_loop SCENE: how long check(), clearance() and intervals() of prepared shapes take.
int main(int argc, char** argv) {
  if (argc != 2) return 2;
  taut::Scene scene = taut::read_scene(argv[1]);
  for (taut::Body& body : scene.bodies) {
    if (!body.parts.empty()) continue;
    body.prepared = taut::prepare(body.polygon, body.name);
    body.polygon.clear();
  }
  std::printf("%.9g %.9g %.9g\n", seconds_of([&] { taut::check(scene); }), seconds_of([&] { taut::clearance(scene); }),
              seconds_of([&] { taut::intervals(scene); }));
}
