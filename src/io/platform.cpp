// What platforms share: the ownership of an open file.
#include "io/platform.hpp"

#include <utility>

namespace taut::internal::io {

SystemFile::~SystemFile() {
  if (is_open()) close();
}

SystemFile::SystemFile(SystemFile&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

SystemFile& SystemFile::operator=(SystemFile&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

}  // namespace taut::internal::io
