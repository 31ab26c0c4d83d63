// Files that can be read to their end: not pipes, which may never have one, nor devices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

namespace taut::internal::io {

using FilePointer = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// The file, opened to be read. Throws InputError unless it is a regular file, or a link to one, of at most so many
/// bytes; never waits.
FilePointer open_regular_file(const std::string& path, std::size_t max_bytes = SIZE_MAX);

/// Refuses what is larger than a limit. Throws InputError.
void require_size(std::uintmax_t bytes, const std::string& name, std::size_t max_bytes);

}  // namespace taut::internal::io
