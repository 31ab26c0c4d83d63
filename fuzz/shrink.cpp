#include "shrink.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <utility>
#include <vector>

#include "motion/rotation_forms.hpp"
#include "taut/io.hpp"

namespace taut::fuzz {
using namespace internal;
namespace {

std::vector<Coefficients*> polynomials(Scene& scene) {
  std::vector<Coefficients*> all;
  for (Body& body : scene.bodies) {
    for (MotionPiece& piece : body.motion.pieces) {
      all.push_back(&piece.x);
      all.push_back(&piece.y);
      for_each_polynomial(piece.rotation, [&](Coefficients& c) { all.push_back(&c); });
    }
  }
  return all;
}

/// Every number that may be rounded, vertices first.
std::vector<double*> numbers(Scene& scene) {
  std::vector<double*> all;
  for (Body& body : scene.bodies) {
    for (Point& v : body.polygon) {
      all.push_back(&v.x);
      all.push_back(&v.y);
    }
    for (MotionPiece& piece : body.motion.pieces) {
      if (std::isfinite(piece.until)) all.push_back(&piece.until);
      all.push_back(&piece.origin);
    }
  }
  for (Coefficients* c : polynomials(scene)) {
    for (double& x : *c) all.push_back(&x);
  }
  all.push_back(&scene.start);
  all.push_back(&scene.end);
  return all;
}

double rounded(double x, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*e", digits - 1, x);
  return std::strtod(text, nullptr);
}

class Shrinker {
 public:
  Shrinker(Scene scene, const StillFails& still_fails, int max_tries)
      : best_(std::move(scene)), still_fails_(still_fails), tries_(max_tries) {}

  Scene run() {
    do {
      progress_ = false;
      time();
      pieces();
      motions();
      degrees();
      vertices();
      origin();
      digits();
    } while (progress_ && tries_ > 0);
    return best_;
  }

 private:
  /// Keeps the scene that `change` makes of the best one, if it fails. False also where `change` changes nothing.
  template <class Change>
  bool attempt(const Change& change) {
    if (tries_ <= 0) return false;
    Scene candidate = best_;
    change(candidate);
    if (write_scene(candidate) == write_scene(best_)) return false;
    --tries_;
    if (!still_fails_(candidate)) return false;
    best_ = std::move(candidate);
    progress_ = true;
    return true;
  }

  void time() {
    for (const double part : {0.5, 0.75, 0.875}) {
      while (attempt([part](Scene& s) { s.end = s.start + (s.end - s.start) * part; })) {
      }
      while (attempt([part](Scene& s) { s.start = s.end - (s.end - s.start) * part; })) {
      }
    }
    // Half an interval for ever is no progress.
    progress_ = false;
  }

  void pieces() {
    for (std::size_t b = 0; b < best_.bodies.size(); ++b) {
      for (std::size_t k = 0; best_.bodies[b].motion.pieces.size() > 1 && k < best_.bodies[b].motion.pieces.size();) {
        if (!drop_piece(b, k)) ++k;
      }
    }
  }

  /// Without the piece: its time goes to its neighbour, or is cut off.
  bool drop_piece(std::size_t b, std::size_t k) {
    const auto without = [b, k](Scene& s) -> MotionPiece {
      auto& pieces = s.bodies[b].motion.pieces;
      const MotionPiece piece = pieces[k];
      pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(k));
      return piece;
    };
    return attempt([&](Scene& s) { without(s); }) || attempt([&](Scene& s) {
             const MotionPiece piece = without(s);
             if (k > 0) s.bodies[b].motion.pieces[k - 1].until = piece.until;
           }) ||
           (k == 0 && attempt([&](Scene& s) { s.start = std::max(s.start, without(s).until); })) ||
           (k > 0 && attempt([&](Scene& s) {
              without(s);
              s.end = std::min(s.end, s.bodies[b].motion.pieces[k - 1].until);
            }));
  }

  void motions() {
    for (std::size_t b = 0; b < best_.bodies.size(); ++b) {
      attempt([b](Scene& s) { s.bodies[b].motion = {}; });
      for (std::size_t k = 0; k < best_.bodies[b].motion.pieces.size(); ++k) {
        attempt([b, k](Scene& s) { s.bodies[b].motion.pieces[k].rotation = NoRotation{}; });
      }
      attempt([b](Scene& s) {
        for (MotionPiece& piece : s.bodies[b].motion.pieces) piece.rotation = NoRotation{};
      });
      attempt([b](Scene& s) {
        if (!s.bodies[b].motion.pieces.empty()) s.bodies[b].motion.pieces.back().until = INFINITY;
      });
    }
  }

  void degrees() {
    const std::size_t count = polynomials(best_).size();
    for (std::size_t i = 0; i < count; ++i) {
      if (i >= polynomials(best_).size()) return;
      while (attempt([i](Scene& s) {
        Coefficients& c = *polynomials(s)[i];
        if (!c.empty()) c.pop_back();
      })) {
      }
      for (std::size_t k = 0; k < polynomials(best_)[i]->size(); ++k) {
        attempt([i, k](Scene& s) { (*polynomials(s)[i])[k] = 0; });
      }
    }
  }

  /// Chunks of vertices, large ones first.
  void vertices() {
    for (std::size_t b = 0; b < best_.bodies.size(); ++b) {
      for (std::size_t chunk = best_.bodies[b].polygon.size() / 2; chunk > 0; chunk /= 2) {
        for (std::size_t at = 0; at < best_.bodies[b].polygon.size();) {
          const std::size_t n = best_.bodies[b].polygon.size(), count = std::min(chunk, n - at);
          const bool gone = n >= count + 3 && attempt([b, at, count](Scene& s) {
                              const auto first = s.bodies[b].polygon.begin() + static_cast<std::ptrdiff_t>(at);
                              s.bodies[b].polygon.erase(first, first + static_cast<std::ptrdiff_t>(count));
                            });
          if (!gone) at += chunk;
        }
      }
    }
  }

  void origin() {
    const Point first = best_.bodies[0].polygon[0];
    attempt([first](Scene& s) {
      for (Body& body : s.bodies) {
        if (!body.motion.pieces.empty()) continue;
        for (Point& v : body.polygon) v = {v.x - first.x, v.y - first.y};
      }
      for (Body& body : s.bodies) {
        for (MotionPiece& piece : body.motion.pieces) {
          piece.x.resize(std::max<std::size_t>(1, piece.x.size()));
          piece.y.resize(std::max<std::size_t>(1, piece.y.size()));
          piece.x[0] -= first.x;
          piece.y[0] -= first.y;
        }
      }
    });
    // The start at 0 needs other coefficients, and is left alone.
  }

  /// All numbers at once, then each, with as few digits as will do.
  void digits() {
    for (int d = 1; d < 17; ++d) {
      if (attempt([d](Scene& s) {
            for (double* x : numbers(s)) *x = rounded(*x, d);
          }))
        break;
    }
    for (std::size_t i = 0; i < numbers(best_).size(); ++i) {
      const double x = *numbers(best_)[i];
      std::vector<double> simpler = {0, std::floor(x), std::ceil(x)};
      for (int d = 1; d < 16; ++d) {
        // To the nearest, and to the numbers on either side of it.
        const double unit = std::pow(10, std::floor(std::log10(std::fabs(x))) + 1 - d);
        for (const double y : {x, x - unit, x + unit}) simpler.push_back(rounded(y, d));
      }
      for (const double y : simpler) {
        if (length(y) < length(x) && attempt([i, y](Scene& s) { *numbers(s)[i] = y; })) break;
      }
    }
  }

  /// Of a number as text.
  static std::size_t length(double x) {
    Scene scene;
    scene.start = x;
    return write_scene(scene).size();
  }

  Scene best_;
  const StillFails& still_fails_;
  int tries_;
  bool progress_ = false;
};

}  // namespace

Scene shrunk(Scene scene, const StillFails& still_fails, int max_tries) {
  return Shrinker(std::move(scene), still_fails, max_tries).run();
}

}  // namespace taut::fuzz
