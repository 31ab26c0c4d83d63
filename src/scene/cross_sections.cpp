#include "scene/cross_sections.hpp"

#include <algorithm>

namespace taut::internal {

std::vector<Layers> layers_of_parts(const Body& body) {
  std::vector<Layers> all;
  for (const Part& part : body.parts) all.push_back(part.z.value_or(body.z));
  for (const CurvedPart& part : body.curves) all.push_back(part.z.value_or(body.z));
  if (all.empty()) all.push_back(body.z);
  return all;
}

std::vector<CrossSection> cross_sections_of(const Body& body) {
  const std::vector<Layers> parts = layers_of_parts(body);
  if (std::all_of(parts.begin(), parts.end(), [&](const Layers& z) { return z == parts[0]; })) {
    CrossSection all{parts[0], {}};
    for (std::size_t k = 0; k < parts.size(); ++k) all.parts.push_back(k);
    return {all};
  }
  std::vector<double> ends;
  for (const Layers& z : parts) ends.insert(ends.end(), {z.lo, z.hi});
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<CrossSection> sections;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    CrossSection section{{ends[i], ends[i + 1]}, {}};
    for (std::size_t k = 0; k < parts.size(); ++k) {
      if (parts[k].meet(section.z)) section.parts.push_back(k);
    }
    if (section.parts.empty()) continue;
    const bool goes_on = !sections.empty() && sections.back().z.hi == section.z.lo;
    if (goes_on && sections.back().parts == section.parts) {
      sections.back().z.hi = section.z.hi;
    } else {
      sections.push_back(std::move(section));
    }
  }
  return sections;
}

bool share_layers(const Body& a, const Body& b) {
  const std::vector<Layers> of_a = layers_of_parts(a), of_b = layers_of_parts(b);
  return std::any_of(of_a.begin(), of_a.end(), [&](const Layers& x) {
    return std::any_of(of_b.begin(), of_b.end(), [&](const Layers& y) { return x.meet(y); });
  });
}

}  // namespace taut::internal
