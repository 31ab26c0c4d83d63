// Files that can be read to their end: not pipes, which may never have one, nor devices.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

namespace taut::io {

using FilePointer = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// The file, opened to be read. Throws InputError unless it is a regular file, or a link to one; never waits.
FilePointer open_regular_file(const std::string& path);

}  // namespace taut::io
