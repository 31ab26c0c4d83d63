// A file that appears whole or not at all.
#pragma once

#include <fstream>
#include <string>

namespace taut::internal::io {

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
  [[noreturn]] void fail();

  void keep_mode() const;
  void discard();

  std::string path_, written_;
  bool direct_, done_ = false;
  std::ofstream stream_;
};

/// Removes the temporary files that are there: for a signal handler that is about to end the process.
void remove_unfinished_files();

}  // namespace taut::internal::io
