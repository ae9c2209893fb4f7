// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "process/ChildProcess.h"

#include "process/ArgumentVector.h"
#include "process/TerminationSignals.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <string_view>

namespace handwheel {

namespace {

constexpr std::size_t kMostErrors = 64 << 10;  // bytes of stderr that are kept
constexpr int kNotStarted = 127;               // the code that shells report
constexpr int kUnknownCode = 255;

int codeOf(int status) {
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

void closeDescriptor(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

// Signals that come between vfork and exec must not be swallowed by the handler that the child has from us until then.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &m_before);
  }
  ~SignalsHeld() { pthread_sigmask(SIG_SETMASK, &m_before, nullptr); }
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;

 private:
  sigset_t m_before;
};

// The data that the child needs from us until it has become another program.
struct ChildStart {
  char* const* argv;
  pid_t parent;
  int input, output, errors;
  std::optional<ProcessLimits> limits;
};

// From here on to execv() only functions that a signal handler may call are allowed: another thread may hold any lock.
// And only the stack may be written, as the memory is ours.

bool lowerLimit(decltype(RLIMIT_AS) resource, rlim_t soft, rlim_t hard) {
  rlimit limit{};
  if (getrlimit(resource, &limit) != 0) return false;
  limit = {std::min(soft, limit.rlim_max), std::min(hard, limit.rlim_max)};
  return setrlimit(resource, &limit) == 0;
}

bool confine(const ProcessLimits& limits) {
  // A limit of one byte is the only one that also keeps a program from being fed with the core (core(5)).
  bool isDone = setpgid(0, 0) == 0 && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 && lowerLimit(RLIMIT_CORE, 1, 1);
  if (limits.memory != 0) isDone = isDone && lowerLimit(RLIMIT_AS, limits.memory, limits.memory);
  if (limits.cpuSeconds != 0) isDone = isDone && lowerLimit(RLIMIT_CPU, limits.cpuSeconds, limits.cpuSeconds + 1);
  struct sigaction byDefault {};
  byDefault.sa_handler = SIG_DFL;
  for (int signal : {SIGPIPE, SIGXCPU, SIGCHLD}) sigaction(signal, &byDefault, nullptr);
  return isDone;
}

void forgetHandler(int signal) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  if (action.sa_handler == SIG_IGN) return;  // nohup requires this
  action = {};
  action.sa_handler = SIG_DFL;
  sigaction(signal, &action, nullptr);
}

// Sets the standard streams, and closes all other files. The descriptors are moved up first: one may have the number
// that another is to get.
bool placeStreams(const ChildStart& start) {
  const int input = start.input < 0 ? ::open("/dev/null", O_RDONLY) : start.input;
  int streams[] = {input, start.output, start.errors};
  for (int& stream : streams) {
    stream = fcntl(stream, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
    if (stream < 0) return false;
  }
  for (int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (dup2(streams[descriptor], descriptor) < 0) return false;
  }
  // For descriptors of libraries that did not ask for it, too. With kernels before 5.11 only those that we asked for
  // are closed.
  close_range(STDERR_FILENO + 1, ~0U, CLOSE_RANGE_CLOEXEC);
  return true;
}

[[noreturn]] void become(const ChildStart& start) {
  prctl(PR_SET_PDEATHSIG, start.limits ? SIGKILL : SIGTERM);
  for (int signal : kTerminationSignals) forgetHandler(signal);
  if (getppid() != start.parent) _exit(kNotStarted);  // it ended before we could ask for the signal
  if (!placeStreams(start) || (start.limits && !confine(*start.limits))) _exit(kNotStarted);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  execv(start.argv[0], start.argv);
  _exit(kNotStarted);
}

// Starts the child like vfork(), without copying page tables, which takes a tenth of a second at 4 GB and makes other
// threads wait, the servo loop among them. Returns when the child is another program; -1 on failure.
pid_t startChild(const ChildStart& start) {
  const SignalsHeld held;
  const pid_t process = vfork();  // NOLINT(clang-analyzer-security.insecureAPI.vfork): see above
  if (process == 0) become(start);
  return process;
}

// Makes the child the first program that the system ends when memory runs out, although it is not the largest. A
// failure is ignored.
void letGoFirst(pid_t process) {
  const int file = ::open(("/proc/" + std::to_string(process) + "/oom_score_adj").c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return;
  [[maybe_unused]] const auto written = ::write(file, "500", 3);
  ::close(file);
}

// Passes the available bytes on.
template <class Take>
void takeIn(int& pipe, const Take& take) {
  char block[4096];
  constexpr int kMostBlocks = 32;  // more than a pipe holds, so that one that never stops talking does not keep us
  for (int i = 0; i < kMostBlocks && pipe >= 0; ++i) {
    const ssize_t count = ::read(pipe, block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EAGAIN) return;
    if (count <= 0) return closeDescriptor(pipe);
    take(std::string_view(block, static_cast<std::size_t>(count)));
  }
}

}  // namespace

std::unique_ptr<ChildProcess> ChildProcess::start(const std::vector<std::string>& words, const ChildOptions& options) {
  const std::vector<char*> argv = argumentVector(words);
  std::array<int, 2> output{-1, -1}, errors{-1, -1};  // reading end, writing end
  const auto closeAll = [&] {
    const int reason = errno;
    for (int* pipe : {&output[0], &output[1], &errors[0], &errors[1]}) closeDescriptor(*pipe);
    errno = reason;
  };
  if (pipe2(output.data(), O_CLOEXEC) != 0 || pipe2(errors.data(), O_CLOEXEC) != 0) {
    closeAll();
    return nullptr;
  }
  const ChildStart start{argv.data(), getpid(), options.input, output[1], errors[1], options.limits};
  const pid_t process = startChild(start);
  if (process < 0) {
    closeAll();
    return nullptr;
  }
  letGoFirst(process);
  closeDescriptor(output[1]);
  closeDescriptor(errors[1]);
  for (int pipe : {output[0], errors[0]}) fcntl(pipe, F_SETFL, O_NONBLOCK);
  return std::unique_ptr<ChildProcess>(new ChildProcess(process, {output[0], errors[0]}, options.mostOutput));
}

ChildProcess::ChildProcess(pid_t process, std::array<int, 2> pipes, std::size_t mostOutput)
    : m_process(process),
      m_end(static_cast<int>(::syscall(SYS_pidfd_open, process, 0))),
      m_pipes(pipes),
      m_mostOutput(mostOutput) {}

ChildProcess::~ChildProcess() {
  if (m_process != 0) {
    kill(m_process, SIGKILL);
    while (waitpid(m_process, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  for (int& pipe : m_pipes) closeDescriptor(pipe);
  closeDescriptor(m_end);
}

bool ChildProcess::hasEnded() {
  listen();
  if (m_process == 0) return true;
  int status = 0;
  const pid_t ended = waitpid(m_process, &status, WNOHANG);
  if (ended == 0 || (ended < 0 && errno == EINTR)) return false;
  m_process = 0;
  closeDescriptor(m_end);
  m_code = ended > 0 ? codeOf(status) : kUnknownCode;
  listen();  // for output written in between
  return true;
}

void ChildProcess::send(int signal) {
  if (m_process != 0) kill(m_process, signal);
}

void ChildProcess::listen() {
  takeIn(m_pipes[0], [this](std::string_view block) {
    const std::string_view kept = block.substr(0, m_mostOutput - m_output.size());
    m_output.append(kept);
    m_hasMoreOutput = m_hasMoreOutput || kept.size() < block.size();
  });
  takeIn(m_pipes[1], [this](std::string_view block) {
    m_errors.append(block);
    if (m_errors.size() > kMostErrors) m_errors.erase(0, m_errors.size() - kMostErrors);
  });
}

void ChildProcess::wait(std::span<const std::unique_ptr<ChildProcess>> children, std::chrono::milliseconds time) {
  std::vector<pollfd> events;
  for (const auto& child : children) {
    for (int descriptor : {child->m_pipes[0], child->m_pipes[1], child->m_end})
      events.push_back({descriptor, POLLIN, 0});  // poll() passes over those below zero
  }
  ::poll(events.data(), events.size(), static_cast<int>(time.count()));
}

}  // namespace handwheel
