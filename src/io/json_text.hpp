// Small pieces of JSON to write.
#pragma once

#include <string>
#include <vector>

#include "io/number_text.hpp"
#include "taut/scene.hpp"

namespace taut::internal::io {

/// In quotes, with escapes, also of what a terminal would not show; bytes that are not UTF-8 become U+FFFD.
std::string string_text(const std::string& s);
/// [1,2.5]
std::string array_text(const std::vector<double>& numbers);
/// [x,y]
std::string point_text(const Point& p);
/// A scene's clearances: [{"pair":["a","b"],"margin":0.5},{"pair":["a","*"],"margin":[0.2,0.05],"origin":3}]
std::string clearances_text(const std::vector<PairClearance>& clearances);

}  // namespace taut::internal::io
