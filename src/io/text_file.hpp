// Files: text read from regular ones, and files that appear whole or not at all.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <ostream>
#include <streambuf>
#include <string>

#include "io/platform.hpp"

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

// A file that appears whole or not at all.

/// Bytes of a stream, to a file.
class FileBuffer : public std::streambuf {
 public:
  /// False if the file cannot be created.
  bool open(const std::string& name);
  /// Writes what is left. False if not all could be written.
  bool close();
  /// errno of what failed first; 0 if nothing has.
  int error() const { return error_; }

 protected:
  int_type overflow(int_type next) override;
  int sync() override;

 private:
  bool flush();
  bool note(bool done);

  SystemFile file_;
  int error_ = 0;
  std::array<char, 1 << 14> bytes_;
};

/// Writes to a temporary file next to `path`, which commit() renames; without commit() nothing is left behind. Devices
/// and pipes (/dev/stdout, say) are written to directly. A file that is there already keeps its mode. Throws
/// InputError.
class AtomicFile {
 public:
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  std::ostream& stream() { return stream_; }
  void commit();

 private:
  [[noreturn]] void fail(int error);

  void keep_mode() const;
  void discard();

  std::string path_;
  bool direct_, done_ = false;
  std::string written_;
  FileBuffer buffer_;
  std::ostream stream_;
};

/// Removes the temporary files that are there: for a signal handler that is about to end the process.
void remove_unfinished_files();

}  // namespace taut::internal::io
