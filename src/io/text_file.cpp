#include "io/text_file.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <random>
#include <utility>

#include "io/platform.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::internal::io {

void require_size(const std::string& text, const std::string& name, std::size_t max_bytes) {
  require_size(text.size(), name, max_bytes);
}

std::string read_text_file(const std::string& path, std::size_t max_bytes) {
  const FilePointer file = open_regular_file(path, max_bytes);
  std::string text;
  char buffer[1 << 16];
  while (std::size_t n = std::fread(buffer, 1, sizeof buffer, file.get())) {
    text.append(buffer, n);
    require_size(text, path, max_bytes);
  }
  if (std::ferror(file.get())) {
    throw InputError(path, std::string("cannot read the file: ") + std::strerror(errno),
                     "give the path of a text file");
  }
  drop_byte_order_mark(text);
  return text;
}

void drop_byte_order_mark(std::string& text) {
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0) text.erase(0, 3);
}

std::string place_in_text(const std::string& text, const std::string& name, std::size_t offset) {
  offset = std::min(offset, text.size());
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(offset);
  const auto line = 1 + std::count(text.begin(), end, '\n');
  const std::size_t newline = offset == 0 ? std::string::npos : text.rfind('\n', offset - 1);
  const std::size_t column = newline == std::string::npos ? offset + 1 : offset - newline;
  return name + ":" + std::to_string(line) + ":" + std::to_string(column);
}

std::string excerpt(const std::string& text, std::size_t length) {
  std::string s = text.substr(0, length);
  if (text.size() > length) {
    // Bytes 10xxxxxx continue a character: drop the character that was cut.
    while (!s.empty() && (static_cast<unsigned char>(text[s.size()]) & 0xC0) == 0x80) s.pop_back();
    s += "...";
  }
  for (char& c : s) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = '?';
  }
  return s;
}

namespace {

[[noreturn]] void fail_to_open(const std::string& path, int error) {
  throw InputError(path, std::string("cannot open the file: ") + std::strerror(error),
                   error == EACCES ? "ask its owner for permission to read it, as `chmod +r` gives" : "check the path");
}

const char* words_for(FileKind kind) {
  switch (kind) {
    case FileKind::regular:
      return "it is a file";
    case FileKind::folder:
      return "it is a folder";
    case FileKind::pipe:
      return "it is a pipe";
    case FileKind::socket:
      return "it is a socket";
    case FileKind::device:
      break;
  }
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
  // Opening a pipe by the standard library would wait for somebody to write to it.
  SystemFile file = SystemFile::to_read(path);
  if (!file.is_open()) fail_to_open(path, errno);
  const std::optional<FileKind> kind = file.kind();
  if (!kind) fail_to_open(path, errno);
  if (*kind != FileKind::regular)
    throw InputError(path, std::string("cannot read the file: ") + words_for(*kind),
                     "give the path of a text file; what comes through a pipe can be read from standard input");
  const std::optional<std::uint64_t> size = file.size();
  if (!size) fail_to_open(path, errno);
  require_size(*size, path, max_bytes);
  std::FILE* stream = file.to_stream();
  if (!stream) fail_to_open(path, errno);
  return {stream, &std::fclose};
}

}  // namespace taut::internal::io

// A reader of the file sees the old text or the new one, never half of it.

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
