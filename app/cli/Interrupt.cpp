// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Interrupt.h"

#include "base/JobClock.h"
#include "cli/Messages.h"
#include "cli/ProgressBar.h"
#include "document/AtomicFile.h"
#include "process/TerminationSignals.h"

#include <sys/mman.h>
#include <unistd.h>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace handwheel {

namespace {

using namespace std::chrono_literals;

constexpr auto kPoll = 20ms;
constexpr auto kGrace = 150ms;  // with the rest of a poll and the exit still within 250 ms

std::atomic<bool> signalled{false};
static_assert(std::atomic<bool>::is_always_lock_free, "written by a signal handler");

void noteSignal(int) {
  signalled = true;
}

// Addresses reserved while a job runs, so that there is memory left for the words about its result.
class Reserve {
 public:
  Reserve() : m_begin(mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {}
  ~Reserve() {
    if (m_begin != MAP_FAILED) munmap(m_begin, kSize);
  }
  Reserve(const Reserve&) = delete;
  Reserve& operator=(const Reserve&) = delete;

 private:
  static constexpr std::size_t kSize = 4 << 20;  // bytes; more than malloc() takes at once for small pieces
  void* m_begin;
};

// Ends the program. Calls only functions that a signal handler may call.
void endAtOnce(int) {
  static constexpr std::string_view kMessage = "handwheel: Cancelled.\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, kMessage.data(), kMessage.size());
  std::_Exit(kExitInterrupted);
}

// Installs a handler. A program started with a signal ignored (nohup, a background job of a plain shell) keeps ignoring
// it.
void watch(int signal, void (*handler)(int)) {
  struct sigaction previous {};
  sigaction(signal, nullptr, &previous);
  if (previous.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void CommandJob::say(std::string line) {
  const std::lock_guard lock(m_mutex);
  m_lines.push_back(std::move(line));
}

class JobRun {
 public:
  explicit JobRun(const std::function<void(CommandJob&)>& work) : m_thread([this, &work] { run(work); }) {}
  ~JobRun() { m_thread.join(); }

  bool waitFor(std::chrono::milliseconds time) {
    std::unique_lock lock(m_mutex);
    return m_changed.wait_for(lock, time, [this] { return m_done; });
  }
  void cancel() { m_job.m_state.cancelled = true; }
  const JobState& state() const { return m_job.m_state; }
  std::exception_ptr failure() const { return m_failure; }
  std::vector<std::string> takeLines() {
    const std::lock_guard lock(m_job.m_mutex);
    return std::exchange(m_job.m_lines, {});
  }

 private:
  void run(const std::function<void(CommandJob&)>& work) {
    try {
      work(m_job);
    } catch (...) {
      m_failure = std::current_exception();
    }
    const std::lock_guard lock(m_mutex);
    m_done = true;
    m_changed.notify_all();
  }

  CommandJob m_job;
  std::mutex m_mutex;
  std::condition_variable m_changed;
  bool m_done = false;
  std::exception_ptr m_failure;
  std::thread m_thread;  // last: it uses the others
};

void watchSignals() {
  for (int signal : kTerminationSignals) watch(signal, noteSignal);
}

bool wasInterrupted() {
  return signalled;
}

void endWhenInterrupted() {
  for (int signal : kTerminationSignals) watch(signal, endAtOnce);
  if (signalled) endAtOnce(0);
}

void ignoreSignals() {
  for (int signal : kTerminationSignals) watch(signal, SIG_IGN);
}

void runInterruptible(std::string_view label, const std::function<void(CommandJob&)>& work) {
  std::exception_ptr failure;
  const Reserve reserve;
  {
    ProgressBar bar(label);
    JobRun run(work);
    JobClock clock;
    const auto printLines = [&] {
      for (const std::string& line : run.takeLines()) {
        bar.clear();
        print(line + "\n");
      }
    };
    while (!run.waitFor(kPoll)) {
      printLines();
      bar.show(run.state().fraction, clock.seconds(run.state()));
      if (!signalled) continue;
      run.cancel();
      if (run.waitFor(kGrace) || isWritingFile()) continue;
      bar.clear();
      complain("Cancelled.");
      std::_Exit(kExitInterrupted);
    }
    printLines();
    failure = run.failure();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace handwheel
