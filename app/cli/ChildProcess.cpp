// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/ChildProcess.h"

#include "cli/Interrupt.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string_view>
#include <thread>

extern char** environ;

namespace handwheel {

namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMostKept = 64 << 10;  // bytes of each stream
constexpr int kNotStarted = 127;             // as shells report it

// The end of the pipe that the programs below runChild() hold: a number that shells leave alone, and its name.
constexpr int kLeash = 9;
constexpr const char* kLeashNumber = "9";
constexpr const char* kLeashName = "HANDWHEEL_LEASH";
constexpr auto kTidying = 2s;  // xvfb-run takes up to one to start its display, and only then tidies up
constexpr auto kEnding = 500ms;

std::vector<char*> argumentsOf(const std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));  // exec changes none
  argv.push_back(nullptr);
  return argv;
}

int codeOf(int status) {
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

void closePipe(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

// Signals that come between fork and exec must not be swallowed by the handler that the child has from us until then.
class SignalsHeld {
 public:
  SignalsHeld() {
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all, &m_before);
  }
  ~SignalsHeld() { release(); }
  void release() const { sigprocmask(SIG_SETMASK, &m_before, nullptr); }

 private:
  sigset_t m_before;
};

void forgetHandler(int signal) {
  struct sigaction action {};
  sigaction(signal, nullptr, &action);
  if (action.sa_handler == SIG_IGN) return;  // as nohup wants it
  action = {};
  action.sa_handler = SIG_DFL;
  sigaction(signal, &action, nullptr);
}

// In the child, where only what a signal handler may call is allowed.
[[noreturn]] void become(char* const* argv, pid_t parent, int output, int errors, const SignalsHeld& held) {
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  for (int signal : kEndingSignals) forgetHandler(signal);
  if (getppid() != parent) _exit(127);  // it ended before we could ask to be told
  const int nothing = ::open("/dev/null", O_RDONLY);
  if (nothing < 0 || dup2(nothing, STDIN_FILENO) < 0 || dup2(output, STDOUT_FILENO) < 0 ||
      dup2(errors, STDERR_FILENO) < 0) {
    _exit(127);
  }
  if (nothing != STDIN_FILENO) ::close(nothing);
  held.release();
  execv(argv[0], argv);
  _exit(127);
}

// Where memory runs out the largest program is to be ended by the system, and that is to be the child. Failure is none.
void letGoFirst(pid_t process) {
  const int file = ::open(("/proc/" + std::to_string(process) + "/oom_score_adj").c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return;
  [[maybe_unused]] const auto written = ::write(file, "500", 3);
  ::close(file);
}

// Reads what is there. Of the text's end, or else of its beginning, kMostKept bytes stay.
void takeIn(int& pipe, std::string& text, bool keepsEnd) {
  char block[4096];
  constexpr int kMostBlocks = 32;  // more than a pipe holds, so that one that never stops talking does not keep us
  for (int i = 0; i < kMostBlocks && pipe >= 0; ++i) {
    const ssize_t count = ::read(pipe, block, sizeof block);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EAGAIN) return;
    if (count <= 0) return closePipe(pipe);
    if (keepsEnd || text.size() < kMostKept) text.append(block, static_cast<std::size_t>(count));
    if (keepsEnd && text.size() > kMostKept) text.erase(0, text.size() - kMostKept);
  }
}

// The environment with the number of the leash. Its words must outlive it.
std::vector<char*> environmentWith(const std::string& leash) {
  std::vector<char*> all;
  for (char** entry = environ; *entry; ++entry) all.push_back(*entry);
  all.push_back(const_cast<char*>(leash.c_str()));
  all.push_back(nullptr);
  return all;
}

// In a group of its own, to be ended as a whole; 0: there is no such program.
pid_t spawn(const std::vector<char*>& argv, int leash) {
  const std::string entry = std::string(kLeashName) + "=" + kLeashNumber;
  const std::vector<char*> environment = environmentWith(entry);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, leash, kLeash);
  pid_t child = 0;
  const int error = posix_spawnp(&child, argv[0], &actions, &attributes, argv.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return error == 0 ? child : 0;
}

// After a signal to us the leash closes, and then there is less and less patience.
int waitFor(pid_t child, int& leash) {
  constexpr auto kLook = 10ms;
  int status = 0;
  std::optional<std::chrono::steady_clock::time_point> told;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (wasInterrupted() && !told) {
      closePipe(leash);
      told = std::chrono::steady_clock::now();
    }
    if (told) {
      const auto waited = std::chrono::steady_clock::now() - *told;
      if (waited > kTidying) kill(-child, waited > kTidying + kEnding ? SIGKILL : SIGTERM);
    }
    std::this_thread::sleep_for(kLook);
  }
  return codeOf(status);
}

}  // namespace

std::string ownProgram() {
  std::error_code ignored;
  return std::filesystem::read_symlink("/proc/self/exe", ignored).string();
}

int runChild(const std::vector<std::string>& words) {
  const std::vector<char*> argv = argumentsOf(words);
  std::array<int, 2> leash{-1, -1};  // the child's end, ours
  if (pipe2(leash.data(), O_CLOEXEC) != 0) return kNotStarted;
  const pid_t child = spawn(argv, leash[0]);
  closePipe(leash[0]);
  const int code = child == 0 ? kNotStarted : waitFor(child, leash[1]);
  closePipe(leash[1]);
  return code;
}

void endWithParent() {
  const char* number = std::getenv(kLeashName);
  if (!number || std::string_view(number) != kLeashNumber) return;
  unsetenv(kLeashName);
  struct stat status {};
  if (fstat(kLeash, &status) != 0 || !S_ISFIFO(status.st_mode)) return;
  fcntl(kLeash, F_SETFD, FD_CLOEXEC);
  fcntl(kLeash, F_SETSIG, SIGTERM);
  fcntl(kLeash, F_SETOWN, getpid());
  fcntl(kLeash, F_SETFL, O_ASYNC | O_NONBLOCK);
  pollfd end{kLeash, 0, 0};
  if (::poll(&end, 1, 0) == 1 && (end.revents & POLLHUP) != 0) raise(SIGTERM);  // it had closed before
}

std::unique_ptr<ChildProcess> ChildProcess::start(const std::vector<std::string>& words) {
  const std::vector<char*> argv = argumentsOf(words);
  std::array<int, 2> output{-1, -1}, errors{-1, -1};  // reading end, writing end
  const auto closeAll = [&] {
    for (int* pipe : {&output[0], &output[1], &errors[0], &errors[1]}) closePipe(*pipe);
  };
  if (pipe2(output.data(), O_CLOEXEC) != 0 || pipe2(errors.data(), O_CLOEXEC) != 0) {
    closeAll();
    return nullptr;
  }
  const pid_t parent = getpid();
  pid_t process = 0;
  {
    const SignalsHeld held;
    process = fork();
    if (process == 0) become(argv.data(), parent, output[1], errors[1], held);
  }
  if (process < 0) {
    closeAll();
    return nullptr;
  }
  letGoFirst(process);
  closePipe(output[1]);
  closePipe(errors[1]);
  for (int pipe : {output[0], errors[0]}) fcntl(pipe, F_SETFL, O_NONBLOCK);
  return std::unique_ptr<ChildProcess>(new ChildProcess(process, {output[0], errors[0]}));
}

ChildProcess::~ChildProcess() {
  if (m_process != 0) {
    kill(m_process, SIGKILL);
    waitpid(m_process, nullptr, 0);
  }
  for (int& pipe : m_pipes) closePipe(pipe);
}

bool ChildProcess::hasEnded() {
  listen();
  if (m_process == 0) return true;
  int status = 0;
  if (waitpid(m_process, &status, WNOHANG) == 0) return false;
  m_process = 0;
  m_code = codeOf(status);
  listen();  // what it said in between
  return true;
}

void ChildProcess::send(int signal) {
  if (m_process != 0) kill(m_process, signal);
}

void ChildProcess::listen() {
  takeIn(m_pipes[0], m_output, false);
  takeIn(m_pipes[1], m_errors, true);
}

void ChildProcess::wait(std::span<const std::unique_ptr<ChildProcess>> children, std::chrono::milliseconds time) {
  std::vector<pollfd> pipes;
  for (const auto& child : children) {
    for (int pipe : child->m_pipes) pipes.push_back({pipe, POLLIN, 0});  // poll() passes over those below zero
  }
  ::poll(pipes.data(), pipes.size(), static_cast<int>(time.count()));
}

}  // namespace handwheel
