// A reader of the file sees the old text or the new one, never half of it.
#include "io/atomic_file.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <random>
#include <utility>

#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::internal::io {
namespace {

std::string temporary_name(const std::string& path) {
  std::random_device random;
  return path + ".tmp" + std::to_string(random());
}

/// The name to write to.
std::string written_name(const std::string& path, bool direct) {
  if (path.find('\0') != std::string::npos) throw InputError(path, "the name of a file has a NUL in it");
  return direct ? path : temporary_name(path);
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
    if (const char* name = place.load()) remove_open_file(name);
  }
}

bool FileBuffer::open(const std::string& name) {
  file_ = SystemFile::to_write(name);
  setp(bytes_.data(), bytes_.data() + bytes_.size());
  return note(file_.is_open());
}

/// Keeps the first error.
bool FileBuffer::note(bool done) {
  if (!done && error_ == 0) error_ = errno != 0 ? errno : EIO;
  return done;
}

bool FileBuffer::flush() {
  const auto count = static_cast<std::size_t>(pptr() - pbase());
  setp(pbase(), epptr());
  return error_ == 0 && note(file_.write(pbase(), count));
}

FileBuffer::int_type FileBuffer::overflow(int_type next) {
  if (!flush()) return traits_type::eof();
  return traits_type::eq_int_type(next, traits_type::eof()) ? traits_type::not_eof(next)
                                                            : sputc(traits_type::to_char_type(next));
}

int FileBuffer::sync() { return flush() ? 0 : -1; }

bool FileBuffer::close() {
  if (!file_.is_open()) return error_ == 0;
  const bool written = flush();
  return note(file_.close()) && written;
}

AtomicFile::AtomicFile(std::string path)
    : path_(std::move(path)), direct_(is_device(path_)), written_(written_name(path_, direct_)), stream_(&buffer_) {
  if (!direct_) note_unfinished(written_.c_str());
  if (!buffer_.open(written_)) fail(buffer_.error());
  if (!direct_) keep_mode();
}

/// Before anything is written: what only its owner may read is never anything else.
void AtomicFile::keep_mode() const {
  std::error_code error;
  const auto old = std::filesystem::status(path_of(path_), error);
  if (error || !std::filesystem::is_regular_file(old)) return;
  std::filesystem::permissions(path_of(written_), old.permissions(), error);
}

void AtomicFile::discard() {
  if (direct_) return;
  remove_open_file(written_.c_str());
  forget_unfinished(written_.c_str());
}

AtomicFile::~AtomicFile() {
  if (done_) return;
  buffer_.close();
  discard();
}

void AtomicFile::commit() {
  if (!buffer_.close() || !stream_) fail(buffer_.error());
  if (!direct_ && !replace_file(written_, path_)) fail(errno);
  if (!direct_) forget_unfinished(written_.c_str());
  done_ = true;
}

void AtomicFile::fail(int error) {
  const std::string why = error != 0 ? std::string(": ") + std::strerror(error) : std::string();
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
