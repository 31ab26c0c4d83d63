// How one attribute of an element changes in a picture that moves.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace taut::io {

/// Values of one attribute at moments of the loop, which repeats for ever.
class SvgTrack {
 public:
  void add(double moment, const std::string& value) {
    // What stays the same for long needs its first and last moment only.
    if (values_.size() > 1 && values_.back() == value && values_[values_.size() - 2] == value) {
      moments_.back() = moment;
      return;
    }
    moments_.push_back(moment);
    values_.push_back(value);
  }
  bool varies() const {
    return std::any_of(values_.begin(), values_.end(), [this](const std::string& v) { return v != values_[0]; });
  }
  /// The attributes of an <animate> or <animateTransform>, from `name` on.
  std::string text(const std::string& name, double seconds) const {
    std::string times, values;
    for (std::size_t k = 0; k < values_.size(); ++k) {
      times += fmt::format("{}{:.5g}", k ? ";" : "", moments_[k]);
      values += (k ? ";" : "") + values_[k];
    }
    return fmt::format("attributeName=\"{}\" dur=\"{:.3g}s\" repeatCount=\"indefinite\" keyTimes=\"{}\" values=\"{}\"",
                       name, seconds, times, values);
  }

 private:
  std::vector<double> moments_;
  std::vector<std::string> values_;
};

}  // namespace taut::io
