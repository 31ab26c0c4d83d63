// Numbers, heights and fields of tables as text, and text that other people wrote, made safe for a terminal.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "taut/error.hpp"
#include "taut/geometry.hpp"

namespace taut::internal::io {

// Numbers, heights, and fields of tables as text.

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

/// "1 cell", "2 cells". Without `many`, that is `one` and an s.
std::string counted(std::size_t n, const std::string& one, const std::string& many = "");

/// "z 0..3", "z 3.." where there is no upper end, or "all layers".
std::string heights_text(const Layers& z);

// Text that other people wrote, on its way to a terminal, which would obey parts of it instead of showing them.

/// The character of UTF-8 that begins at `at`, which moves past it; nothing, and `at` moves by one byte, if there is
/// none.
std::optional<char32_t> next_character(const std::string& text, std::size_t& at);

/// Does it do something to a terminal, or to the direction or the lines of what is written, instead of being seen?
bool is_hidden(char32_t character);

/// The text with hidden characters written as \u001b, and bytes that are not UTF-8 as \xff. Line breaks are kept.
std::string for_terminal(const std::string& text);
/// The same with line breaks written as \u000a, for what stands within a line: names of files, say.
std::string line_for_terminal(const std::string& text);
/// The message of an error: only the line break before its hint is one.
std::string for_terminal(const InputError& error);

}  // namespace taut::internal::io
