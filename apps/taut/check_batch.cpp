#include "check_batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iostream>
#include <thread>
#include <utility>

#include "answer_file.hpp"
#include "batch.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "io/answer_writer.hpp"
#include "io/json_writer.hpp"
#include "io/platform.hpp"
#include "io/text.hpp"
#include "io/text_file.hpp"
#include "margin_report.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "scene_argument.hpp"
#include "taut/clearance.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::cli {
using namespace internal;

namespace {

/// Files one by one, or their lines, as far as they are the shard's.
class Tasks {
 public:
  explicit Tasks(const CheckBatch& batch) : paths_(batch.paths), lines_(batch.lines), shard_(batch.shard) {
    if (!lines_) return;
    for (const std::string& path : paths_) bytes_ += path == "-" ? NAN : size_of(path);
  }

  std::optional<BatchTask> next() {
    while (const std::optional<BatchTask> task = any()) {
      if (number_++ % shard_.count == shard_.index) return task;
    }
    return std::nullopt;
  }

  /// The part of the input that was read, from 0 to 1; not a number if the input is not only files.
  double share() const {
    return lines_ ? read_ / bytes_ : static_cast<double>(current_) / static_cast<double>(paths_.size());
  }

 private:
  std::optional<BatchTask> any() {
    while (current_ < paths_.size()) {
      if (!lines_) return BatchTask{paths_[current_++], {}};
      if (line_ == 0 && paths_[current_] != "-") {
        if (!is_regular(paths_[current_])) {
          const BatchTask missing{paths_[current_++], {}};  // reading it will say what is wrong
          return missing;
        }
        file_ = std::ifstream(io::path_of(paths_[current_]), std::ios::binary);
      }
      std::istream& in = paths_[current_] == "-" ? std::cin : file_;
      std::string text;
      while (std::getline(in, text)) {
        ++line_;
        read_ += static_cast<double>(text.size()) + 1;
        if (text.find_first_not_of(" \t\r") != text.npos)
          return BatchTask{fmt::format("{}:{}", display_name(paths_[current_]), line_), text};
      }
      ++current_;
      line_ = 0;
    }
    return std::nullopt;
  }

  static double size_of(const std::string& path) {
    if (!is_regular(path)) return 0;
    std::ifstream file(io::path_of(path), std::ios::binary | std::ios::ate);
    return file ? static_cast<double>(file.tellg()) : 0;
  }

  static bool is_regular(const std::string& path) {
    try {
      io::open_regular_file(path);
      return true;
    } catch (const InputError&) {
      return false;
    }
  }

  const std::vector<std::string>& paths_;
  bool lines_;
  Shard shard_;
  std::uint64_t number_ = 0;
  std::size_t current_ = 0;
  std::ifstream file_;
  std::uint64_t line_ = 0;
  double read_ = 0, bytes_ = 0;  ///< of files of lines
};

/// An answer as it is printed, and in words for a report.
struct Answered {
  Outcome outcome;
  std::string json, words;
};

Answered answer_about(const Scene& scene, const CheckBatch& batch) {
  const bool worded = !batch.json || !batch.junit.empty();
  const Touch touch = batch.options.touch;
  if (batch.clearance > 0) {
    const MarginAnswer answer = check_clearance(scene, batch.clearance, batch.options);
    return {answer.outcome, batch.json ? margin_json(scene, batch.clearance, answer, touch) : "",
            worded ? margin_in_words(scene, batch.clearance, answer) : ""};
  }
  const Answer answer = check(scene, batch.options);
  return {answer.outcome, batch.json ? answer_json(scene, answer, touch) : "",
          worded ? report(scene, answer, touch) : ""};
}

/// `shown` is `what` for a terminal.
BatchResult failure(const BatchTask& task, int code, const std::string& what, const std::string& shown, bool json) {
  BatchResult result;
  result.code = code;
  result.err = fmt::format("taut: {}\n", shown);
  // A line for every scene: programs may count on it.
  if (json)
    result.out = fmt::format("{{\"scene\":{},\"error\":{}}}\n", io::string_text(task.place), io::string_text(what));
  result.test = junit_error(task.place, code == exit_internal ? "internal" : "bad_input", what, 0);
  return result;
}

BatchResult answer(const BatchTask& task, const CheckBatch& batch) {
  const auto start = std::chrono::steady_clock::now();
  try {
    ReadLimits limits;
    limits.allow_outside = batch.allow_outside;
    Scene scene = task.text ? parse_scene(*task.text, task.place, io::folder_of(task.place), limits)
                            : load_scene(batch.source_of(task.place));
    if (batch.at_rest) scene.at_rest = *batch.at_rest;
    Answered answered;
    try {
      answered = answer_about(scene, batch);
    } catch (const InputError& error) {
      throw error.within(task.place);
    }
    BatchResult result;
    result.code = exit_code(answered.outcome, batch.allow_untested);
    if (batch.json) {
      result.out = fmt::format("{{\"scene\":{},{}\n", io::string_text(task.place), answered.json.substr(1));
    } else {
      result.out = fmt::format("{}\n{}", io::line_for_terminal(task.place), io::for_terminal(answered.words));
    }
    if (!batch.junit.empty())
      result.test =
          junit_case(task.place, answered.outcome, batch.allow_untested, answered.words, seconds_since(start));
    return result;
  } catch (const InputError& error) {
    return failure(task, exit_bad_input, error.what(), io::for_terminal(error), batch.json);
  } catch (const std::exception& error) {
    const std::string what = fmt::format("internal error in {}: {}", task.place, error.what());
    return failure(task, exit_internal, what, io::for_terminal(what), batch.json);
  }
}

/// A taken-up answer in a report: as JSON, for its scene is not read again.
JunitCase junit_of(const BatchTask& task, const TakenUp& answer, bool allow_untested) {
  if (!answer.outcome)
    return junit_error(task.place, answer.code == exit_internal ? "internal" : "bad_input", answer.text, 0);
  const std::string words = fmt::format("{}\n{}\n", to_string(*answer.outcome), answer.text);
  return junit_case(task.place, *answer.outcome, allow_untested, words, 0);
}

/// What matters most of all that happened.
class WorstCode {
 public:
  void note(int code) { seen_[code] = true; }
  int get() const {
    for (const int code : {exit_internal, exit_bad_input, exit_undecided, exit_contact}) {
      if (seen_[code]) return code;
    }
    return exit_free;
  }

 private:
  bool seen_[exit_internal + 1] = {};
};

/// Where answers go: to standard output, or behind those of a file.
class Output {
 public:
  explicit Output(const CheckBatch& batch) : batch_(batch) {
    if (!batch.resume.empty()) file_.emplace(batch.resume);
  }

  /// Leaves out what the file has answers to, and hands these to `taken`, which says whether to go on.
  void take_up(Tasks& tasks, const std::function<bool(const BatchTask&, const TakenUp&)>& taken) {
    if (!file_) return;
    while ((waiting_ = tasks.next())) {
      const std::optional<TakenUp> answer = file_->next(waiting_->place, batch_);
      if (!answer || !taken(*waiting_, *answer)) return;
    }
    file_->expect_none();
  }

  /// The next task, the one that take_up() came to first. None after a run was stopped: nothing would be asked.
  std::optional<BatchTask> next(Tasks& tasks, bool stopped) {
    if (stopped || !writes_) return std::nullopt;
    if (!waiting_) return tasks.next();
    return std::exchange(waiting_, std::nullopt);
  }

  /// True if it was written: an answer that a signal may have ended is not, where the run can go on.
  bool write(const BatchResult& result, bool stopped) {
    if (file_) {
      incomplete_ = incomplete_ || stopped;
      if (incomplete_ || !(writes_ = writes_ && file_->append(result.out))) return false;
    } else {
      std::fwrite(result.out.data(), 1, result.out.size(), stdout);
    }
    if (!result.err.empty()) {
      std::fflush(stdout);
      std::fwrite(result.err.data(), 1, result.err.size(), stderr);
    }
    return true;
  }

  /// Throws InputError if answers could not be written.
  void expect_written() const {
    if (file_) file_->expect_written();
  }

 private:
  const CheckBatch& batch_;
  std::optional<AnswerFile> file_;
  std::optional<BatchTask> waiting_;
  bool writes_ = true, incomplete_ = false;
};

}  // namespace

Shard shard_of(const std::string& text) {
  Shard shard;
  char beyond = 0;
  unsigned long long index = 0, count = 0;
  if (std::sscanf(text.c_str(), "%12llu/%12llu%c", &index, &count, &beyond) != 2 || index < 1 || index > count ||
      text.find_first_not_of("0123456789/") != text.npos)
    throw InputError("--shard", fmt::format("{} is no shard", io::string_text(io::excerpt(text))),
                     "write I/N: of every N scenes the I-th, where I is from 1 to N");
  shard.index = index - 1;
  shard.count = count;
  return shard;
}

namespace {

void require_answerable(const CheckBatch& batch) {
  if (!batch.resume.empty() && !batch.json)
    throw InputError("--resume", "answers are taken up line by line, and a report has several", "add --json");
  if (batch.junit == "-") throw InputError("--junit", "standard output has the answers", "name a file for the report");
}

/// The report, unless the run was stopped: it would lack scenes.
void write_junit(const CheckBatch& batch, const JunitReport& junit, bool stopped) {
  if (batch.junit.empty()) return;
  if (stopped) {
    fmt::print(stderr, "taut: {}\n", not_written("JUnit report", batch.junit));
  } else {
    write_file(batch.junit, junit.text());
  }
}

/// The line on the terminal: of all scenes, those that were taken up among them.
class BatchProgress {
 public:
  explicit BatchProgress(const Tasks& tasks) : tasks_(tasks) {}

  void count(std::uint64_t scenes) {
    ProgressMeter& meter = line_.meter();
    meter.set("scenes", scenes, 0);
    const double share = tasks_.share();
    if (std::isnan(share)) return;
    meter.share = share;
    if (share > taken_up_) meter.seconds_left = seconds_since(begun_) * (1 - share) / (share - taken_up_);
  }
  /// From here on scenes take longer.
  void took_up() {
    begun_ = std::chrono::steady_clock::now();
    taken_up_ = tasks_.share();
  }

 private:
  const Tasks& tasks_;
  ProgressLine line_;
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  double taken_up_ = 0;
};

}  // namespace

int check_batch(const CheckBatch& batch) {
  require_answerable(batch);
  CheckBatch shared = batch;
  shared.options.limits.stop = stop_on_signals();
  const std::atomic<bool>& stop = *shared.options.limits.stop;
  const unsigned threads = batch.threads > 0 ? batch.threads : std::max(1u, std::thread::hardware_concurrency());
  Tasks tasks(batch);
  Output output(batch);
  WorstCode worst;
  JunitReport junit(batch.clearance > 0 ? fmt::format("taut check --clearance {}", batch.clearance) : "taut check");
  std::uint64_t scenes = 0, taken_up = 0;
  // Answers that scroll by say as much.
  std::optional<BatchProgress> progress;
  if (!batch.resume.empty() || !io::is_terminal(stdout)) progress.emplace(tasks);
  output.take_up(tasks, [&](const BatchTask& task, const TakenUp& answer) {
    worst.note(answer.code);
    if (!batch.junit.empty()) junit.add(junit_of(task, answer, batch.allow_untested));
    ++taken_up;
    if (progress) progress->count(taken_up);
    return !stop;
  });
  if (progress) progress->took_up();
  const auto start = std::chrono::steady_clock::now();
  run_batch(
      threads, [&] { return output.next(tasks, stop); }, [&](const BatchTask& task) { return answer(task, shared); },
      [&](const BatchResult& result) {
        if (output.write(result, stop)) ++scenes;
        if (progress) progress->count(taken_up + scenes);
        worst.note(result.code);
        if (!batch.junit.empty()) junit.add(result.test);
      });
  progress.reset();
  output.expect_written();
  write_junit(batch, junit, stop);
  if (stop) {
    fmt::print(stderr, "taut: stopped; {}\n",
               batch.resume.empty()
                   ? fmt::format("{} scenes were answered", scenes)
                   : "the same command goes on behind the last answer in " + io::line_for_terminal(batch.resume));
    worst.note(exit_undecided);
  }
  if (batch.timing) {
    const double seconds = seconds_since(start);
    fmt::print(stderr, "{} scenes in {}, {:.0f} a second, {} thread{}\n", scenes, seconds_text(seconds),
               static_cast<double>(scenes) / seconds, threads, threads == 1 ? "" : "s");
  }
  return worst.get();
}

}  // namespace taut::cli
