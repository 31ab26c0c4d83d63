// Reading files: regular ones only, and text from them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

namespace taut::internal::io {

/// The whole file, but for a byte order mark. Throws InputError if it cannot be read or has more than `max_bytes`
/// bytes.
std::string read_text_file(const std::string& path, std::size_t max_bytes);

/// Drops the mark by which some programs say that a text is UTF-8.
void drop_byte_order_mark(std::string& text);

/// Throws InputError if `text` has more than `max_bytes` bytes.
void require_size(const std::string& text, const std::string& name, std::size_t max_bytes);

/// "name:line:column" of a byte offset; lines and columns count from 1, columns are bytes.
std::string place_in_text(const std::string& text, const std::string& name, std::size_t offset);

/// `text` cut to about `length` bytes, not inside a UTF-8 sequence, control characters replaced, for messages.
std::string excerpt(const std::string& text, std::size_t length = 40);

using FilePointer = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// The file, opened to be read. Throws InputError unless it is a regular file, or a link to one, of at most so many
/// bytes; never waits.
FilePointer open_regular_file(const std::string& path, std::size_t max_bytes = SIZE_MAX);

/// Refuses what is larger than a limit. Throws InputError.
void require_size(std::uintmax_t bytes, const std::string& name, std::size_t max_bytes);

}  // namespace taut::internal::io
