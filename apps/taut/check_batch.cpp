#include "check_batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iostream>
#include <thread>

#include "batch.hpp"
#include "commands.hpp"
#include "interrupt.hpp"
#include "io/json_text.hpp"
#include "io/regular_file.hpp"
#include "io/terminal_text.hpp"
#include "io/text_file.hpp"
#include "report.hpp"
#include "scene_argument.hpp"
#include "taut/error.hpp"
#include "taut/io.hpp"

namespace taut::cli {

namespace {

/// Files one by one, or their lines.
class Tasks {
 public:
  Tasks(const std::vector<std::string>& paths, bool lines) : paths_(paths), lines_(lines) {}

  std::optional<BatchTask> next() {
    while (current_ < paths_.size()) {
      if (!lines_) return BatchTask{paths_[current_++], {}};
      if (line_ == 0 && paths_[current_] != "-") {
        if (!is_regular(paths_[current_])) {
          const BatchTask missing{paths_[current_++], {}};  // reading it will say what is wrong
          return missing;
        }
        file_ = std::ifstream(paths_[current_]);
      }
      std::istream& in = paths_[current_] == "-" ? std::cin : file_;
      std::string text;
      while (std::getline(in, text)) {
        ++line_;
        if (text.find_first_not_of(" \t\r") != text.npos)
          return BatchTask{fmt::format("{}:{}", display_name(paths_[current_]), line_), text};
      }
      ++current_;
      line_ = 0;
    }
    return std::nullopt;
  }

 private:
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
  std::size_t current_ = 0;
  std::ifstream file_;
  std::uint64_t line_ = 0;
};

/// `shown` is `what` for a terminal.
BatchResult failure(const BatchTask& task, int code, const std::string& what, const std::string& shown, bool json) {
  BatchResult result;
  result.code = code;
  result.err = fmt::format("taut: {}\n", shown);
  // A line for every scene: programs may count on it.
  if (json)
    result.out = fmt::format("{{\"scene\":{},\"error\":{}}}\n", io::string_text(task.place), io::string_text(what));
  return result;
}

BatchResult answer(const BatchTask& task, const CheckBatch& batch) {
  try {
    ReadLimits limits;
    limits.allow_outside = batch.allow_outside;
    const Scene scene = task.text ? parse_scene(*task.text, task.place, io::folder_of(task.place), limits)
                                  : load_scene({task.place, batch.allow_outside});
    Answer answer;
    try {
      answer = check(scene, batch.options);
    } catch (const InputError& error) {
      throw error.within(task.place);
    }
    BatchResult result;
    result.code = exit_code(answer.outcome);
    if (batch.json) {
      const std::string object = answer_json(scene, answer, batch.options.touch);
      result.out = fmt::format("{{\"scene\":{},{}\n", io::string_text(task.place), object.substr(1));
    } else {
      result.out = fmt::format("{}\n{}", io::line_for_terminal(task.place),
                               io::for_terminal(report(scene, answer, batch.options.touch)));
    }
    return result;
  } catch (const InputError& error) {
    return failure(task, exit_bad_input, error.what(), io::for_terminal(error), batch.json);
  } catch (const std::exception& error) {
    const std::string what = fmt::format("internal error in {}: {}", task.place, error.what());
    return failure(task, exit_internal, what, io::for_terminal(what), batch.json);
  }
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

}  // namespace

int check_batch(const CheckBatch& batch) {
  CheckBatch shared = batch;
  shared.options.stop = stop_on_signals();
  const unsigned threads = batch.threads > 0 ? batch.threads : std::max(1u, std::thread::hardware_concurrency());
  const auto start = std::chrono::steady_clock::now();
  Tasks tasks(batch.paths, batch.lines);
  WorstCode worst;
  std::uint64_t scenes = 0;
  run_batch(
      threads, [&] { return tasks.next(); }, [&](const BatchTask& task) { return answer(task, shared); },
      [&](const BatchResult& result) {
        std::fwrite(result.out.data(), 1, result.out.size(), stdout);
        if (!result.err.empty()) {
          std::fflush(stdout);
          std::fwrite(result.err.data(), 1, result.err.size(), stderr);
        }
        worst.note(result.code);
        ++scenes;
      });
  if (batch.timing) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    fmt::print(stderr, "{} scenes in {}, {:.0f} a second, {} thread{}\n", scenes, seconds_text(seconds),
               static_cast<double>(scenes) / seconds, threads, threads == 1 ? "" : "s");
  }
  return worst.get();
}

}  // namespace taut::cli
