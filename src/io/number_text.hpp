// Numbers, heights, and fields of tables as text.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "taut/geometry.hpp"

namespace taut::internal::io {

/// The shortest decimal that reads back as the same double, as JSON. `value` must be finite.
std::string number_text(double value);

/// The instant with `usual` significant digits. Where the time from start to end is short compared with its distance
/// from time 0, there are more: as many as distinguish the instants in it as well as `usual` digits do near 0.
std::string instant_text(double t, double start, double end, int usual);

/// Reads a decimal number that starts at `*position` and moves `*position` behind it. Empty (and nothing moves) if
/// there is none. The result may be infinite if the decimal is too large.
std::optional<double> scan_number(const std::string& text, std::size_t* position);

/// A field of comma-separated values: in quotes where it has to be.
std::string csv_field(const std::string& text);

/// "z 0..3", "z 3.." where there is no upper end, or "all layers".
std::string heights_text(const Layers& z);

}  // namespace taut::internal::io
