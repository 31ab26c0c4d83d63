// The loop in C++ that check_many() of the Python package is compared with: bench/python/compare.py runs both.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "stopwatch.hpp"
#include "taut/taut.hpp"

namespace {

constexpr std::size_t columns = 4;  // t, x, y, angle in degrees

std::vector<double> numbers_in(const char* path) {
  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const auto* first = reinterpret_cast<const double*>(bytes.data());
  return {first, first + bytes.size() / sizeof(double)};
}

/// What somebody writes who asks about one body in many motions.
double sum_of_times(taut::Scene& scene, const std::vector<double>& numbers, std::size_t count) {
  double sum = 0;
  for (std::size_t i = 0; i + count * columns <= numbers.size(); i += count * columns) {
    std::vector<taut::Keyframe> keyframes;
    for (const double* k = &numbers[i]; k != &numbers[i] + count * columns; k += columns)
      keyframes.push_back({k[0], k[1], k[2], k[3]});
    scene.bodies.back().motion = taut::from_keyframes(keyframes);
    const taut::Answer answer = taut::check(scene);
    if (answer.contact) sum += answer.contact->time.lo;
  }
  return sum;
}

}  // namespace

/// check_loop SCENE KEYFRAMES COUNT: the last body of the scene moves by rows of so many keyframes each, which are
/// doubles in a file. Prints the processor time in seconds, and the sum of the times of contact.
int main(int argc, char** argv) {
  if (argc != 4) return 2;
  taut::Scene scene = taut::read_scene(argv[1]);
  for (taut::Body& body : scene.bodies) {
    body.prepared = taut::prepare(body.polygon, body.name);
    body.polygon.clear();
  }
  const std::vector<double> numbers = numbers_in(argv[2]);
  const taut::bench::Stopwatch watch;
  const double sum = sum_of_times(scene, numbers, std::strtoul(argv[3], nullptr, 10));
  std::printf("%.17g %.17g\n", watch.seconds(), sum);
}
