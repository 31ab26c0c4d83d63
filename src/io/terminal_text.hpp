// Text that other people wrote, on its way to a terminal, which would obey parts of it instead of showing them.
#pragma once

#include <optional>
#include <string>

#include "taut/error.hpp"

namespace taut::internal::io {

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
