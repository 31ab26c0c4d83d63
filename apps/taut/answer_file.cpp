#include "answer_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string_view>
#include <utility>

#include "commands.hpp"
#include "io/json_writer.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "scene_argument.hpp"

namespace taut::cli {
using namespace internal;
namespace {

constexpr std::size_t bytes_at_once = 1 << 16;

/// The offset behind the last line break.
std::uint64_t end_of_lines(const io::SystemFile& file, std::uint64_t size) {
  std::string text(bytes_at_once, '\0');
  while (size > 0) {
    const std::uint64_t from = size > bytes_at_once ? size - bytes_at_once : 0;
    const std::ptrdiff_t got = file.read_at(from, text.data(), static_cast<std::size_t>(size - from));
    if (got <= 0) return 0;
    const std::size_t found = std::string_view(text.data(), static_cast<std::size_t>(got)).rfind('\n');
    if (found != std::string::npos) return from + found + 1;
    size = from;
  }
  return 0;
}

/// Members of an object of JSON, as far as they are read here.
class Members {
 public:
  Members(const io::JsonDocument& document, std::size_t object) : document_(document), object_(object) {}

  /// The token of a member's value.
  std::optional<std::size_t> find(const std::string& key) const {
    if (document_.at(object_).kind() != io::JsonKind::object) return std::nullopt;
    const std::size_t end = document_.after(object_);
    for (std::size_t t = object_ + 1; t < end; t = document_.after(t + 1)) {
      if (document_.string_at(t) == key) return t + 1;
    }
    return std::nullopt;
  }
  /// A member's value as JSON, or "none".
  std::string text(const std::string& key) const {
    const auto value = find(key);
    return value ? io::value_text(document_, *value) : "none";
  }
  std::optional<std::string> word(const std::string& key) const {
    const auto value = find(key);
    if (!value || document_.at(*value).kind() != io::JsonKind::string) return std::nullopt;
    return document_.string_at(*value);
  }

 private:
  const io::JsonDocument& document_;
  std::size_t object_;
};

/// Nothing if the object is no answer.
std::optional<TakenUp> taken_up(const Members& answer, const std::string& line, bool allow_untested) {
  if (const auto error = answer.word("error"))
    return TakenUp{error->rfind("internal error", 0) == 0 ? exit_internal : exit_bad_input, std::nullopt, *error};
  const auto outcome = answer.word("outcome");
  for (const Outcome known : {Outcome::free, Outcome::contact, Outcome::overlap_at_start, Outcome::closer_at_start,
                              Outcome::undecided, Outcome::untested, Outcome::locked}) {
    if (outcome && *outcome == to_string(known)) return TakenUp{exit_code(known, allow_untested), known, line};
  }
  return std::nullopt;
}

}  // namespace

AnswerFile::AnswerFile(std::string path) : path_(std::move(path)), file_(io::SystemFile::to_append(path_)) {
  if (!file_.is_open()) throw InputError(path_, fmt::format("cannot open it: {}", std::strerror(errno)), "");
  if (file_.kind() != io::FileKind::regular)
    throw InputError(path_, "it is not a regular file", "answers are taken up from a file on a disk");
  if (!file_.lock())
    throw InputError(path_, "another process writes answers into it",
                     "wait for it, or give each shard a file of its own");
  end_ = end_of_lines(file_, file_.size().value_or(0));
  if (!file_.truncate(end_))
    throw InputError(path_, fmt::format("cannot remove half a line at its end: {}", std::strerror(errno)), "");
}

bool AnswerFile::next_line(std::string& line) {
  std::size_t found;
  while ((found = read_.find('\n', seen_)) == std::string::npos) {
    if (position_ >= end_) return false;
    read_.erase(0, seen_);
    seen_ = 0;
    std::string more(static_cast<std::size_t>(std::min<std::uint64_t>(bytes_at_once, end_ - position_)), '\0');
    const std::ptrdiff_t got = file_.read_at(position_, more.data(), more.size());
    if (got <= 0) throw InputError(path_, "cannot read it", "");
    position_ += static_cast<std::uint64_t>(got);
    read_.append(more, 0, static_cast<std::size_t>(got));
  }
  line = read_.substr(seen_, found - seen_);
  seen_ = found + 1;
  ++line_;
  return true;
}

void AnswerFile::refuse(const std::string& problem) const {
  throw InputError(fmt::format("{}:{}", path_, line_), problem,
                   "ask about the same scenes with the same options, or name another file");
}

void AnswerFile::expect_same(const std::string& what, const std::string& found, const std::string& wanted) const {
  if (found == wanted) return;
  refuse(fmt::format("the answer has {}: {}, and should have {}", what, io::excerpt(found), io::excerpt(wanted)));
}

void AnswerFile::expect_options(const io::JsonDocument& document, const CheckBatch& batch) const {
  const Members answer(document, 0);
  const auto scope = answer.find("scope");
  if (!scope) return;
  const Members about(document, *scope);
  const auto number_or_none = [](double option) { return option > 0 ? io::number_text(option) : "none"; };
  expect_same("touch", about.text("touch"), io::string_text(to_string(batch.options.touch)));
  expect_same("fit", about.text("fit"), number_or_none(batch.options.fit));
  if (batch.at_rest)
    expect_same("at_rest", about.text("at_rest"), *batch.at_rest == AtRest::test ? "\"test\"" : "none");
  expect_same("clearance", answer.text("clearance"), number_or_none(batch.clearance));
  expect_same("pairs", answer.find("pairs") ? "all" : "first", batch.options.all_pairs ? "all" : "first");
}

std::optional<TakenUp> AnswerFile::next(const std::string& scene, const CheckBatch& batch) {
  std::string line;
  if (!next_line(line)) return std::nullopt;
  std::optional<io::JsonDocument> document;
  try {
    document = io::parse_json(line, path_, "", io::Quoting::never);
  } catch (const InputError&) {
    refuse("this is no answer of `taut check --json`");
  }
  const Members answer(*document, 0);
  const auto about = answer.word("scene");
  std::optional<TakenUp> found = taken_up(answer, line, batch.allow_untested);
  if (!about || !found) refuse("this is no answer of `taut check --json` about one of several scenes");
  if (*about != scene)
    refuse(fmt::format("the answer is about {}, and should be about {}", io::excerpt(*about), io::excerpt(scene)));
  expect_options(*document, batch);
  return found;
}

void AnswerFile::expect_none() {
  std::string line;
  if (next_line(line)) refuse("there are more answers than scenes");
}

bool AnswerFile::append(const std::string& line) {
  if (error_ == 0 && !file_.write(line.data(), line.size())) error_ = errno;
  return error_ == 0;
}

void AnswerFile::expect_written() const {
  if (error_ == 0) return;
  throw InputError(path_, fmt::format("cannot write an answer: {}", std::strerror(error_)),
                   "the same command goes on behind the last whole line");
}

}  // namespace taut::cli
