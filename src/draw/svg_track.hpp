// How one attribute of an element changes in a picture that moves.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace taut::internal::io {

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
  /// An element that animates a transform; nothing if it stays the same.
  std::string transform(const char* type, double seconds) const {
    return varies() ? fmt::format("<animateTransform type=\"{}\" {}/>", type, text("transform", seconds)) : "";
  }

 private:
  std::vector<double> moments_;
  std::vector<std::string> values_;
};

/// An attribute of a moving picture that is opened by itself: a click pauses it, and the next one goes on.
inline constexpr const char* pauses_on_click =
    "onclick=\"this.animationsPaused()?this.unpauseAnimations():this.pauseAnimations()\"";

/// Shows the last frame alone to those who prefer pictures that rest.
inline constexpr const char* moving_style =
    "<style>.still{display:none}@media (prefers-reduced-motion:reduce){.moving{display:none}.still{display:inline}}"
    "</style>\n";

/// What moving pictures share: a loop of so many frames and a pause at its end, of which the last one shows how the
/// motion ends.
struct SvgLoop {
  double motion, seconds;  ///< of the frames, and of all
  std::size_t frames;

  /// The moment of the loop, 0 to 1, at which a frame is shown.
  double moment(std::size_t frame) const {
    return motion / seconds * static_cast<double>(frame) / static_cast<double>(frames - 1);
  }
  /// For what is shown from the moment at which the motion stops.
  std::string shown_at_the_end() const {
    return fmt::format(
        "<animate attributeName=\"opacity\" dur=\"{:.3g}s\" repeatCount=\"indefinite\" calcMode=\"discrete\" "
        "keyTimes=\"0;{:.5g}\" values=\"0;1\"/>",
        seconds, moment(frames - 1));
  }
  /// The room below a picture for its bar.
  static constexpr double bar_height = 34;
  /// Where in time the picture stands: a bar of that width at that height over the scene's interval, filled up to
  /// `reached`, and in words how it ends.
  std::string bar(bool moving, double margin, double whole, double y, double reached, const char* colour,
                  const std::string& ending) const {
    SvgTrack track;
    track.add(0, "0");
    track.add(moment(frames - 1), fmt::format("{:.2f}", reached));
    track.add(1, fmt::format("{:.2f}", reached));
    return fmt::format(
        "<rect x=\"{0}\" y=\"{1:.2f}\" width=\"{2:.2f}\" height=\"4\" rx=\"2\" fill=\"#e3e3e3\"/>\n"
        "<rect x=\"{0}\" y=\"{1:.2f}\" width=\"{3:.2f}\" height=\"4\" rx=\"2\" fill=\"{4}\">{5}</rect>\n"
        "<text x=\"{6:.2f}\" y=\"22\" text-anchor=\"end\" fill=\"{4}\">{7}{8}</text>\n",
        margin, y, whole, reached, colour, moving ? fmt::format("<animate {}/>", track.text("width", seconds)) : "",
        margin + whole, moving ? shown_at_the_end() : "", ending);
  }
};

}  // namespace taut::internal::io
