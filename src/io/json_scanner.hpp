// Everyday JSON, read quickly: what large scenes consist of.
//
// A parser that hands over one character and one token at a time takes most of the time in which a polygon of a million
// vertices is read. This reads what nearly all scenes are, ASCII without escapes, and leaves everything else, errors
// among it, to that parser.
#pragma once

#include "io/json_document.hpp"

namespace taut::internal::io {

/// Makes the tokens of the document's text as parse_json() does. If the text is no JSON, not plain, or nested more than
/// `deepest` deep, returns false, and the tokens and strings are meaningless.
bool scan_plain_json(JsonDocument& document, std::size_t deepest);

}  // namespace taut::internal::io
