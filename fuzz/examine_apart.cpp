#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <stdexcept>

#include "examine.hpp"

namespace taut::fuzz {
namespace {

/// What a process may say before its verdict; more is cut off.
constexpr std::size_t max_output = std::size_t{1} << 20;

struct Output {
  std::string text;
  bool in_time = true;
};

Output read_until(int fd, double seconds) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point deadline =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  Output out;
  char buffer[4096];
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd p{fd, POLLIN, 0};
    if (left <= 0 || poll(&p, 1, static_cast<int>(left)) == 0) {
      out.in_time = false;
      return out;
    }
    const ssize_t n = read(fd, buffer, sizeof buffer);
    if (n <= 0) return out;
    if (out.text.size() < max_output) out.text.append(buffer, static_cast<std::size_t>(n));
  }
}

void write_all(int fd, const std::string& text) {
  for (std::size_t at = 0; at < text.size();) {
    const ssize_t n = write(fd, text.data() + at, text.size() - at);
    if (n <= 0) return;
    at += static_cast<std::size_t>(n);
  }
}

/// The line of a sanitizer's report that says what happened, without addresses.
std::string crash_line(const std::string& text, int status) {
  for (const char* mark : {"runtime error: ", "ERROR: AddressSanitizer: ", "Assertion ", "terminate called"}) {
    const std::size_t at = text.find(mark);
    if (at == std::string::npos) continue;
    const std::string line = text.substr(at, text.find('\n', at) - at);
    return line.substr(0, line.find(" on address"));
  }
  return WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                             : "exit code " + std::to_string(WEXITSTATUS(status));
}

/// Marks where the verdict begins, after whatever else was printed.
const char* const verdict_mark = "\n--verdict--\n";

[[noreturn]] void child(int fd, const std::function<Finding(std::string&)>& look) {
  dup2(fd, STDERR_FILENO);
  std::string report;
  const Finding found = look(report);
  const char kind = static_cast<char>('a' + static_cast<int>(found.kind));
  write_all(fd, report + verdict_mark + kind + found.message);
  _exit(0);
}

}  // namespace

Finding in_process_apart(const std::function<Finding(std::string&)>& look, double seconds, std::string* report) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error("no pipe");
  const pid_t pid = fork();
  if (pid < 0) throw std::runtime_error("no process");
  if (pid == 0) {
    close(ends[0]);
    child(ends[1], look);
  }
  close(ends[1]);
  const Output out = read_until(ends[0], seconds);
  close(ends[0]);
  if (!out.in_time) kill(pid, SIGKILL);
  int status = 0;
  waitpid(pid, &status, 0);
  const std::size_t mark = out.text.rfind(verdict_mark);
  Finding found;
  if (!out.in_time) {
    found = {FindingKind::hang, "no answer in time"};
  } else if (mark == std::string::npos || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
    found = {FindingKind::crash, crash_line(out.text, status)};
  } else {
    const std::string verdict = out.text.substr(mark + std::string(verdict_mark).size());
    found = {static_cast<FindingKind>(verdict[0] - 'a'), verdict.substr(1)};
  }
  if (report) {
    *report = out.text.substr(0, mark);
    if (mark == std::string::npos) *report += found.signature() + '\n';
  }
  return found;
}

}  // namespace taut::fuzz
