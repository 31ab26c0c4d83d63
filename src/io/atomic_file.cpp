// A reader of the file sees the old text or the new one, never half of it.
#include "io/atomic_file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>
#include <utility>

#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut {
namespace io {
namespace {

/// A device or a pipe must be written to, not replaced.
bool is_device(const std::string& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  return std::filesystem::exists(status) && std::filesystem::is_other(status);
}

std::string temporary_name(const std::string& path) {
  std::random_device random;
  return path + ".tmp" + std::to_string(random());
}

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)), direct_(is_device(path_)), stream_() {
  written_ = direct_ ? path_ : temporary_name(path_);
  errno = 0;
  stream_.open(written_, std::ios::binary);
  if (!stream_) fail();
}

AtomicFile::~AtomicFile() {
  if (done_) return;
  stream_.close();
  if (!direct_) std::remove(written_.c_str());
}

void AtomicFile::commit() {
  errno = 0;
  stream_.close();
  if (!stream_ || (!direct_ && std::rename(written_.c_str(), path_.c_str()) != 0)) fail();
  done_ = true;
}

void AtomicFile::fail() {
  const std::string why = errno ? std::string(": ") + std::strerror(errno) : std::string();
  if (!direct_) std::remove(written_.c_str());
  throw InputError(path_, "cannot write the file" + why,
                   "check that the folder exists and may be written to, and that the disk is not full");
}

}  // namespace io

void write_file(const std::string& path, const std::string& text) {
  io::AtomicFile file(path);
  file.stream().write(text.data(), static_cast<std::streamsize>(text.size()));
  file.commit();
}

}  // namespace taut
