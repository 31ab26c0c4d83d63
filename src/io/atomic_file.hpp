// A file that appears whole or not at all.
#pragma once

#include <array>
#include <ostream>
#include <streambuf>
#include <string>

#include "io/platform.hpp"

namespace taut::internal::io {

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
