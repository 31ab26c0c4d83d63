#include "scene/cross_sections.hpp"

#include <algorithm>

namespace taut::internal {

std::vector<Layers> layers_of_parts(const Body& body) {
  std::vector<Layers> all;
  for_each_layers(body, [&](const Layers& z) { all.push_back(z); });
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
  bool share = false;
  for_each_layers(a,
                  [&](const Layers& x) { for_each_layers(b, [&](const Layers& y) { share = share || x.meet(y); }); });
  return share;
}

}  // namespace taut::internal
