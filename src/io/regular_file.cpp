#include "io/regular_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "taut/error.hpp"

namespace taut::internal::io {
namespace {

[[noreturn]] void fail_to_open(const std::string& path, int error) {
  throw InputError(path, std::string("cannot open the file: ") + std::strerror(error),
                   error == EACCES ? "ask its owner for permission to read it, as `chmod +r` gives" : "check the path");
}

const char* kind_of(mode_t mode) {
  if (S_ISDIR(mode)) return "it is a folder";
  if (S_ISFIFO(mode)) return "it is a pipe";
  if (S_ISSOCK(mode)) return "it is a socket";
  return "it is a device";
}

}  // namespace

void require_size(std::uintmax_t bytes, const std::string& name, std::size_t max_bytes) {
  if (bytes > max_bytes)
    throw InputError(name, "the file is larger than the limit of " + std::to_string(max_bytes) + " bytes",
                     "simplify the outline, or raise ReadLimits::max_bytes");
}

FilePointer open_regular_file(const std::string& path, std::size_t max_bytes) {
  // What follows a NUL would be lost.
  if (path.find('\0') != std::string::npos) fail_to_open(path, EINVAL);
  // Opening a pipe would wait for somebody to write to it.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  if (descriptor < 0) fail_to_open(path, errno);
  struct stat status {};
  const bool known = ::fstat(descriptor, &status) == 0;
  if (known && !S_ISREG(status.st_mode)) {
    ::close(descriptor);
    throw InputError(path, std::string("cannot read the file: ") + kind_of(status.st_mode),
                     "give the path of a text file; what comes through a pipe can be read from standard input");
  }
  if (known && static_cast<std::uintmax_t>(status.st_size) > max_bytes) {
    ::close(descriptor);
    require_size(static_cast<std::uintmax_t>(status.st_size), path, max_bytes);
  }
  std::FILE* file = known ? ::fdopen(descriptor, "rb") : nullptr;
  if (!file) {
    const int error = errno;
    ::close(descriptor);
    fail_to_open(path, error);
  }
  return {file, &std::fclose};
}

}  // namespace taut::internal::io
