// States of OMPL's spaces as numbers. Needs OMPL (libompl-dev); the library itself does not.
#pragma once

#include <ompl/base/StateSpace.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/base/spaces/SE2StateSpace.h>
#include <ompl/base/spaces/SO2StateSpace.h>

#include <cmath>
#include <vector>

#include "taut/error.hpp"

namespace taut::for_ompl {

namespace ob = ::ompl::base;

inline constexpr double pi = 3.14159265358979323846;

/// The coordinates of a space in order, compounds taken apart: real ones, and angles of SO2, which wrap. The space must
/// stay where it is.
class StateReader {
 public:
  /// Throws InputError for spaces of anything else.
  explicit StateReader(const ob::StateSpace& space) : space_(&space) { find_angles(space); }

  /// How many coordinates there are.
  std::size_t size() const { return wraps_.size(); }
  /// Is it an angle of SO2?
  bool wraps(std::size_t coordinate) const { return wraps_[coordinate]; }

  /// All coordinates of a state of the space.
  void read(const ob::State* state, std::vector<double>& out) const {
    out.clear();
    read(*space_, state, out);
  }
  /// Where a coordinate ends if it starts at `from` and OMPL interpolates to `to`: angles go the short way round, which
  /// rounds once where they pass pi.
  double end(std::size_t coordinate, double from, double to) const {
    const double way = to - from;
    if (!wraps_[coordinate] || std::fabs(way) <= pi) return to;
    return from + (way > 0 ? way - 2 * pi : way + 2 * pi);
  }

 private:
  void find_angles(const ob::StateSpace& space) {
    if (space.isCompound()) {
      const auto& compound = *space.as<ob::CompoundStateSpace>();
      for (unsigned i = 0; i < compound.getSubspaceCount(); ++i) find_angles(*compound.getSubspace(i));
    } else if (space.getType() == ob::STATE_SPACE_REAL_VECTOR) {
      wraps_.insert(wraps_.end(), space.getDimension(), false);
    } else if (space.getType() == ob::STATE_SPACE_SO2) {
      wraps_.push_back(true);
    } else {
      throw InputError(space.getName(), "the state space is not made of real coordinates and planar angles",
                       "use SE2, Dubins, Reeds-Shepp, R^n, SO2, or a compound of these");
    }
  }
  static void read(const ob::StateSpace& space, const ob::State* state, std::vector<double>& out) {
    if (space.isCompound()) {
      const auto& compound = *space.as<ob::CompoundStateSpace>();
      const auto* states = state->as<ob::CompoundState>();
      for (unsigned i = 0; i < compound.getSubspaceCount(); ++i)
        read(*compound.getSubspace(i), states->components[i], out);
    } else if (space.getType() == ob::STATE_SPACE_REAL_VECTOR) {
      const double* values = state->as<ob::RealVectorStateSpace::StateType>()->values;
      out.insert(out.end(), values, values + space.getDimension());
    } else {
      out.push_back(state->as<ob::SO2StateSpace::StateType>()->value);
    }
  }

  const ob::StateSpace* space_;
  std::vector<bool> wraps_;
};

}  // namespace taut::for_ompl
