// A number of the library as one of another kind, by its doubles alone.
#pragma once

namespace taut::testing {

/// The sum of doubles that a number of any precision is.
template <class To, class Real>
To sum_of_doubles(Real x) {
  To sum = 0;
  while (x != 0) {
    const double d = static_cast<double>(x);
    sum += To(d);
    x -= d;
  }
  return sum;
}

}  // namespace taut::testing
