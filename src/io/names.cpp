// How the public enumerations are called in answers and on the command line.
#include "taut/check.hpp"
#include "taut/envelope.hpp"
#include "taut/path.hpp"
#include "taut/separate.hpp"

namespace taut {
using namespace internal;

const char* to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::free:
      return "free";
    case Outcome::contact:
      return "contact";
    case Outcome::overlap_at_start:
      return "overlap_at_start";
    case Outcome::closer_at_start:
      return "closer_at_start";
    case Outcome::untested:
      return "untested";
    case Outcome::locked:
      return "locked";
    case Outcome::undecided:
      break;
  }
  return "undecided";
}

const char* to_string(PathOutcome outcome) {
  switch (outcome) {
    case PathOutcome::path:
      return "path";
    case PathOutcome::none:
      return "none";
    case PathOutcome::untested:
      return "untested";
    case PathOutcome::undecided:
      break;
  }
  return "undecided";
}

const char* to_string(SeparationOutcome outcome) {
  switch (outcome) {
    case SeparationOutcome::free:
      return "free";
    case SeparationOutcome::locked:
      return "locked";
    case SeparationOutcome::overlap_at_start:
      return "overlap_at_start";
    case SeparationOutcome::untested:
      return "untested";
    case SeparationOutcome::undecided:
      break;
  }
  return "undecided";
}

const char* to_string(CellState state) {
  switch (state) {
    case CellState::free:
      return "free";
    case CellState::colliding:
      return "colliding";
    case CellState::undecided:
      break;
  }
  return "undecided";
}

const char* to_string(Touch touch) { return touch == Touch::open ? "open" : "closed"; }

const char* to_string(EngineName engine) { return engine == EngineName::kinetic ? "kinetic" : "spacetime"; }

const char* to_string(EngineChoice engine) {
  switch (engine) {
    case EngineChoice::kinetic:
      return "kinetic";
    case EngineChoice::spacetime:
      return "spacetime";
    case EngineChoice::both:
      return "both";
    case EngineChoice::either:
      return "either";
    default:
      return "usual";
  }
}

const char* to_string(Repair repair) {
  switch (repair) {
    case Repair::convex_flip:
      return "convex_flip";
    case Repair::convex_triangle:
      return "convex_triangle";
    case Repair::reflex_new_face:
      return "reflex_a";
    case Repair::reflex_right:
      return "reflex_b";
    case Repair::reflex_left:
      return "reflex_c";
    default:
      return "collision";
  }
}

}  // namespace taut
