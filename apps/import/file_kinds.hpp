// Kinds of files, by the endings of their names.
#pragma once

#include <string>

namespace taut::drawing {

/// ".svg" of "a/b.SVG"; empty if there is none.
std::string ending_of(const std::string& file);

/// What there is to do with a file of another kind than those that are read. Never returns: throws InputError.
[[noreturn]] void refuse_kind(const std::string& file);

/// Is it compressed by gzip, as .svgz is?
bool is_gzip(const std::string& bytes);

/// The text in a file that is compressed by gzip. Throws InputError.
std::string unzipped(const std::string& bytes, const std::string& file);

}  // namespace taut::drawing
