// The distance of bodies over time, as comma-separated values.
#include "io/number_text.hpp"
#include "taut/clearance.hpp"

namespace taut {
using namespace internal;
std::string profile_csv(const Scene& scene, const DistanceProfile& answer) {
  std::string s = "first,second,t,lo,hi,until_lo,until_hi\n";
  for (const DistanceCurve& c : answer.curves) {
    const auto name = [&](std::size_t i) {
      return c.pair ? io::csv_field(scene.bodies[static_cast<std::size_t>((*c.pair)[i])].name) : std::string();
    };
    const std::string pair = name(0) + "," + name(1) + ",";
    for (std::size_t k = 0; k < c.instants.size(); ++k) {
      const DistanceAt& d = c.instants[k];
      s += pair + io::number_text(d.t) + "," + io::number_text(d.lo) + "," + io::number_text(d.hi) + ",";
      if (k < c.stretches.size())
        s += io::number_text(c.stretches[k].lo) + "," + io::number_text(c.stretches[k].hi) + "\n";
      else
        s += ",\n";
    }
  }
  return s;
}

}  // namespace taut
