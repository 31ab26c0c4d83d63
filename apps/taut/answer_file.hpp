// Answers in a file, taken up again where a run was ended.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "check_batch.hpp"
#include "io/platform.hpp"

namespace taut::cli {

/// A file of answers of `taut check --json`, one on a line, in the order of the scenes. So what is there is the answers
/// to the first of them, and a run that was killed at any instant goes on behind these: half a line at the end is
/// removed. While it is open no other process opens it so.
class AnswerFile {
 public:
  /// Opens the file, or begins one. Throws InputError if it is no regular file, or another process has it.
  explicit AnswerFile(std::string path);

  /// Is there a next answer? Then `scene` must be what it is about, and it must have been asked with the options of the
  /// batch, as far as answers say them; throws InputError otherwise. Its exit code is in `code`.
  bool has(const std::string& scene, const CheckBatch& batch, int& code);
  /// Throws InputError if answers are left: there are more than there are scenes.
  void expect_none();

  /// A whole line. False if it could not be written; nothing is written after that.
  bool append(const std::string& line);
  /// Throws InputError if an answer could not be written.
  void expect_written() const;

 private:
  bool next_line(std::string& line);
  void expect_same(const std::string& what, const std::string& found, const std::string& wanted) const;
  [[noreturn]] void refuse(const std::string& problem) const;

  std::string path_;
  internal::io::SystemFile file_;
  std::string read_;                      ///< what was read last
  std::size_t seen_ = 0;                  ///< how much of it was read
  std::uint64_t position_ = 0, end_ = 0;  ///< of what is read next, and of the whole lines
  std::uint64_t line_ = 0;
  int error_ = 0;  ///< errno of what was not written
};

}  // namespace taut::cli
