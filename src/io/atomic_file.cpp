// A reader of the file sees the old text or the new one, never half of it.
#include "io/atomic_file.hpp"

#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <random>
#include <utility>

#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::internal::io {
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

/// The names of temporary files, for a signal handler: more than are ever there at once.
std::array<std::atomic<const char*>, 16> unfinished{};

void note_unfinished(const char* name) {
  for (std::atomic<const char*>& place : unfinished) {
    const char* none = nullptr;
    if (place.compare_exchange_strong(none, name)) return;
  }
}

void forget_unfinished(const char* name) {
  for (std::atomic<const char*>& place : unfinished) {
    const char* mine = name;
    if (place.compare_exchange_strong(mine, nullptr)) return;
  }
}

}  // namespace

void remove_unfinished_files() {
  for (const std::atomic<const char*>& place : unfinished) {
    if (const char* name = place.load()) ::unlink(name);
  }
}

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)), direct_(is_device(path_)), stream_() {
  if (path_.find('\0') != std::string::npos) throw InputError(path_, "the name of a file has a NUL in it");
  written_ = direct_ ? path_ : temporary_name(path_);
  if (!direct_) note_unfinished(written_.c_str());
  errno = 0;
  stream_.open(written_, std::ios::binary);
  if (!stream_) fail();
  if (!direct_) keep_mode();
}

/// Before anything is written: what only its owner may read is never anything else.
void AtomicFile::keep_mode() const {
  std::error_code error;
  const auto old = std::filesystem::status(path_, error);
  if (error || !std::filesystem::is_regular_file(old)) return;
  std::filesystem::permissions(written_, old.permissions(), error);
}

void AtomicFile::discard() {
  if (direct_) return;
  std::remove(written_.c_str());
  forget_unfinished(written_.c_str());
}

AtomicFile::~AtomicFile() {
  if (done_) return;
  stream_.close();
  discard();
}

void AtomicFile::commit() {
  errno = 0;
  stream_.close();
  if (!stream_ || (!direct_ && std::rename(written_.c_str(), path_.c_str()) != 0)) fail();
  if (!direct_) forget_unfinished(written_.c_str());
  done_ = true;
}

void AtomicFile::fail() {
  const std::string why = errno ? std::string(": ") + std::strerror(errno) : std::string();
  discard();
  throw InputError(path_, "cannot write the file" + why,
                   "check that the folder exists and may be written to, and that the disk is not full");
}

}  // namespace taut::internal::io

namespace taut {
using namespace internal;

void write_file(const std::string& path, const std::string& text) {
  io::AtomicFile file(path);
  file.stream().write(text.data(), static_cast<std::streamsize>(text.size()));
  file.commit();
}

}  // namespace taut
