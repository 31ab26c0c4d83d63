// Vectors of the plane in doubles, multiplied as complex numbers: a turn is a product.
#pragma once

#include <cmath>

namespace taut::internal {

/// A point or a direction; products are those of complex numbers.
struct Vector {
  double x = 0, y = 0;
};
inline Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
inline Vector operator-(Vector a) { return {-a.x, -a.y}; }
inline Vector operator*(Vector a, Vector b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }
inline Vector conj(Vector a) { return {a.x, -a.y}; }
/// By +90 degrees.
inline Vector turned(Vector a) { return {-a.y, a.x}; }
inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
inline double l1_norm(Vector a) { return std::fabs(a.x) + std::fabs(a.y); }

}  // namespace taut::internal
