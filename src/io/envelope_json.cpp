// The answer of envelope(), as JSON.
#include "io/answer_json.hpp"
#include "io/json_text.hpp"
#include "io/number_text.hpp"
#include "taut/io.hpp"

namespace taut {
using namespace internal;
namespace {

std::string joints_text(const Linkage& linkage) {
  std::string s = "[";
  for (const Joint& joint : linkage.joints)
    s += (s.size() > 1 ? ",{\"name\":" : "{\"name\":") + io::string_text(joint.name) +
         ",\"range\":" + io::array_text({joint.lo, joint.hi}) + "}";
  return s + "]";
}

std::string envelope_witness_text(const Linkage& linkage, const EnvelopeWitness& witness) {
  std::string s = "{\"values\":{";
  for (std::size_t k = 0; k < linkage.joints.size(); ++k)
    s += (k ? "," : "") + io::string_text(linkage.joints[k].name) + ":" + io::number_text(witness.values[k]);
  return s + "},\"pair\":" + io::pair_names_json(linkage.scene, witness.pair) + "}";
}

std::string values_text(const Linkage& linkage, const std::array<double, max_joints>& values) {
  std::string s = "[";
  for (std::size_t k = 0; k < linkage.joints.size(); ++k) s += (k ? "," : "") + io::number_text(values[k]);
  return s + "]";
}

std::string cells_text(const Linkage& linkage, const std::vector<EnvelopeCell>& cells) {
  std::string s = "[";
  for (const EnvelopeCell& cell : cells) {
    s += (s.size() > 1 ? ",{\"state\":\"" : "{\"state\":\"") + std::string(to_string(cell.state)) +
         "\",\"lo\":" + values_text(linkage, cell.lo) + ",\"hi\":" + values_text(linkage, cell.hi);
    if (cell.state != CellState::free) s += ",\"pair\":" + io::pair_names_json(linkage.scene, cell.pair);
    s += "}";
  }
  return s + "]";
}

}  // namespace

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

std::string envelope_json(const Linkage& linkage, const Envelope& answer, double tolerance, bool cells) {
  std::string s = io::verdict_json(linkage.scene, to_string(answer.outcome)) + ",\"joints\":" + joints_text(linkage);
  s += ",\"witness\":" + (answer.witness ? envelope_witness_text(linkage, *answer.witness) : std::string("null"));
  s += ",\"free\":" + io::number_text(answer.free) + ",\"colliding\":" + io::number_text(answer.colliding) +
       ",\"undecided\":" + io::number_text(answer.undecided) + ",\"tolerance\":" + io::number_text(tolerance);
  if (!answer.reason.empty()) s += ",\"reason\":" + io::string_text(answer.reason);
  if (cells) s += ",\"cells\":" + cells_text(linkage, answer.cells);
  return s + io::coverage_json(answer.coverage) + "}";
}

}  // namespace taut
