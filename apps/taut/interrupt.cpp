#include "interrupt.hpp"

#include <csignal>

#include "io/text_file.hpp"

namespace taut::cli {
using namespace internal;
namespace {

std::atomic<bool> stop{false};
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may touch nothing else");
static_assert(std::atomic<const char*>::is_always_lock_free, "nor may what it calls");

extern "C" void end_on_signal(int signal) {
  io::remove_unfinished_files();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

extern "C" void stop_on_signal(int signal) {
  stop.store(true, std::memory_order_relaxed);
  std::signal(signal, end_on_signal);
}

/// What was ignored (in the background of a shell script, or by nohup) stays ignored.
void handle(int signal, void (*handler)(int)) {
  if (std::signal(signal, handler) == SIG_IGN) std::signal(signal, SIG_IGN);
}

}  // namespace

void clean_up_on_signals() {
  for (const int signal : {SIGINT, SIGTERM}) handle(signal, end_on_signal);
#ifdef _WIN32
  handle(SIGBREAK, end_on_signal);  // Ctrl-Break, and a console that is closed
#else
  for (const int signal : {SIGHUP, SIGQUIT}) handle(signal, end_on_signal);
#endif
}

const std::atomic<bool>* stop_on_signals() {
  for (const int signal : {SIGINT, SIGTERM}) handle(signal, stop_on_signal);
  return &stop;
}

}  // namespace taut::cli
