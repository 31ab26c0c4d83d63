// A shape that Python holds, read once and used in many scenes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "taut/taut.hpp"

namespace taut_python {

/// Validated parts. One polygon without holes is prepared besides, so that checks do not look at it again.
struct Shape {
  std::vector<taut::Part> parts;
  std::shared_ptr<const taut::internal::PreparedShape> prepared;

  /// Gives a body this shape, in place of what it was.
  void put_into(taut::Body& body) const;
};

/// Throws InputError for rings that are none, naming the shape.
Shape make_shape(std::vector<taut::Part> parts, const std::string& name);

/// Makes shapes of a scene's bodies, where they are one polygon each, and puts them back prepared.
void prepare_bodies(taut::Scene& scene);

}  // namespace taut_python
