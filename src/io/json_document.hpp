// A JSON text as a flat list of tokens that remember where they stood.
//
// A polygon of a million vertices is two million numbers in a million small arrays: nlohmann's tree would take a
// hundred bytes for each, and would forget the lines. A scanner of plain JSON makes this list (scan_json(), below), or
// its SAX interface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "taut/error.hpp"

namespace taut::internal::io {

enum class JsonKind : std::uint8_t { null, boolean, number, string, array, object };

/// "null", "true or false", "a number", "a string", "an array", "an object".
const char* to_string(JsonKind kind);

struct JsonToken {
  std::uint64_t kind_and_offset = 0;
  union {
    double number = 0;
    std::uint64_t link;  ///< string: index into JsonDocument::strings; array, object: the token after the last inside
  };

  JsonKind kind() const { return static_cast<JsonKind>(kind_and_offset & 7); }
  std::size_t offset() const { return static_cast<std::size_t>(kind_and_offset >> 3); }
};

/// The members of an object alternate: a string token (the key), then the value.
struct JsonDocument {
  std::string name;  ///< of the file, for messages
  std::string text;
  std::vector<JsonToken> tokens;
  std::vector<std::string> strings;

  const JsonToken& at(std::size_t token) const { return tokens[token]; }
  const std::string& string_at(std::size_t token) const { return strings[static_cast<std::size_t>(at(token).link)]; }
  /// The token that follows the value that starts at `token`.
  std::size_t after(std::size_t token) const {
    const JsonToken& t = at(token);
    const bool container = t.kind() == JsonKind::array || t.kind() == JsonKind::object;
    return container ? static_cast<std::size_t>(t.link) : token + 1;
  }
  /// An error about the value that starts at `token`: "file:line:column: path: problem".
  InputError error(std::size_t token, const std::string& path, const std::string& problem,
                   const std::string& hint) const;
  /// Throws unless the value is of this kind; `shape` says in a hint what is wanted instead.
  void require(std::size_t token, JsonKind kind, const std::string& path, const std::string& shape) const;
};

/// The value that starts at `token` as JSON on one line: numbers as they were written, strings with escapes of what a
/// terminal would not show.
std::string value_text(const JsonDocument& document, std::size_t token);

/// May errors quote the text? Not that of a file which a scene names: the scene would be a way to read any file.
enum class Quoting : std::uint8_t { allowed, never };

/// Throws InputError with line and column if the text is not JSON. `example` is the hint for an empty file.
JsonDocument parse_json(std::string text, const std::string& name, const std::string& example,
                        Quoting quoting = Quoting::allowed);
/// The same for the text of a document without tokens, whatever JSON it is, by a parser that says what is wrong.
void parse_any_json(JsonDocument& document, Quoting quoting);

// Everyday JSON, read quickly: what large scenes consist of.
//
// A parser that hands over one character and one token at a time takes most of the time in which a polygon of a million
// vertices is read. This reads what nearly all scenes are, ASCII without escapes, and leaves everything else, errors
// among it, to that parser.

/// Makes the tokens of the document's text as parse_json() does. If the text is no JSON, not plain, or nested more than
/// `deepest` deep, returns false, and the tokens and strings are meaningless.
bool scan_plain_json(JsonDocument& document, std::size_t deepest);

}  // namespace taut::internal::io
