// Answers in a file, taken up again where a run was ended.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "check_batch.hpp"
#include "io/json_document.hpp"
#include "io/platform.hpp"
#include "taut/check.hpp"

namespace taut::cli {

/// An answer that is there already.
struct TakenUp {
  int code = 0;                    ///< its exit code
  std::optional<Outcome> outcome;  ///< none: the scene could not be answered
  std::string text;                ///< the answer as it is in the file, or the error
};

/// A file of answers of `taut check --json`, one on a line, in the order of the scenes. So what is there is the answers
/// to the first of them, and a run that was killed at any instant goes on behind these: half a line at the end is
/// removed. While it is open no other process opens it so.
class AnswerFile {
 public:
  /// Opens the file, or begins one. Throws InputError if it is no regular file, or another process has it.
  explicit AnswerFile(std::string path);

  /// The next answer, if there is one. Then `scene` must be what it is about, and it must have been asked with the
  /// options of the batch, as far as answers say them; throws InputError otherwise.
  std::optional<TakenUp> next(const std::string& scene, const CheckBatch& batch);
  /// Throws InputError if answers are left: there are more than there are scenes.
  void expect_none();

  /// A whole line. False if it could not be written; nothing is written after that.
  bool append(const std::string& line);
  /// Throws InputError if an answer could not be written.
  void expect_written() const;

 private:
  bool next_line(std::string& line);
  void expect_options(const internal::io::JsonDocument& document, const CheckBatch& batch) const;
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
