// A reader of the file sees the old text or the new one, never half of it.
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>

#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut {

namespace {

std::string temporary_name(const std::string& path) {
  std::random_device random;
  return path + ".tmp" + std::to_string(random());
}

}  // namespace

void write_file(const std::string& path, const std::string& text) {
  // A device or a pipe (/dev/stdout, say) must be written to, not replaced.
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  const bool direct = std::filesystem::exists(status) && std::filesystem::is_other(status);
  const std::string temporary = direct ? path : temporary_name(path);
  const auto fail = [&path](const char* what, int error) {
    throw InputError(path, std::string(what) + ": " + std::strerror(error),
                     "check that the folder exists and may be written to, and that the disk is not full");
  };
  std::FILE* file = std::fopen(temporary.c_str(), direct ? "wb" : "wbx");
  if (!file) fail("cannot write the file", errno);
  errno = 0;
  bool good = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  int error = errno;
  if (std::fclose(file) != 0 && good) {
    good = false;
    error = errno;
  }
  if (good && !direct && std::rename(temporary.c_str(), path.c_str()) != 0) {
    good = false;
    error = errno;
  }
  if (!good) {
    if (!direct) std::remove(temporary.c_str());
    fail("cannot write the file", error);
  }
}

}  // namespace taut
