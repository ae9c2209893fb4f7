// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/SupervisedChild.h"

#include "cli/Interrupt.h"
#include "process/ArgumentVector.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <thread>

extern char** environ;

namespace handwheel {

namespace {

using namespace std::chrono_literals;

constexpr int kNoProgram = 127;  // the code of shells for a missing program

// The end of the pipe that the programs below runChild() hold: a number that shells leave alone, and its environment
// variable.
constexpr int kLifeline = 9;
constexpr const char* kLifelineNumber = "9";
constexpr const char* kLifelineName = "HANDWHEEL_LIFELINE";
constexpr auto kTidying = 2s;  // xvfb-run takes up to one to start its display, and only then tidies up
constexpr auto kEnding = 500ms;
constexpr auto kDisplayStart = 5s;  // far more than a display takes that starts

void closeEnd(int& descriptor) {
  if (descriptor >= 0) ::close(descriptor);
  descriptor = -1;
}

// The environment with the number of the lifeline. Its words must outlive it.
std::vector<char*> environmentWith(const std::string& lifeline) {
  std::vector<char*> all;
  for (char** entry = environ; *entry; ++entry) all.push_back(*entry);
  all.push_back(const_cast<char*>(lifeline.c_str()));
  all.push_back(nullptr);
  return all;
}

// Starts the program in a process group of its own, to be ended as a whole; 0: there is no such program.
pid_t spawn(const std::vector<char*>& argv, int lifeline) {
  const std::string entry = std::string(kLifelineName) + "=" + kLifelineNumber;
  const std::vector<char*> environment = environmentWith(entry);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, lifeline, kLifeline);
  pid_t child = 0;
  const int error = posix_spawnp(&child, argv[0], &actions, &attributes, argv.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return error == 0 ? child : 0;
}

std::string firstLineOf(const std::string& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

// Repeats the signal of the display. xvfb-run waits for ever if that signal comes before it begins to wait, as happens
// on busy machines: it then has one child, the display, and continues when the signal comes again.
void wakeDisplayRunner(pid_t runner) {
  const std::string number = std::to_string(runner);
  std::string children = firstLineOf("/proc/" + number + "/task/" + number + "/children");
  while (children.ends_with(' ')) children.pop_back();
  if (children.empty() || children.find(' ') != std::string::npos) return;
  if (firstLineOf("/proc/" + children + "/comm") == "Xvfb") kill(runner, SIGUSR1);
}

// Waits for the child. After a signal to us the lifeline closes, and then the waiting time is limited more and more.
int waitFor(pid_t child, int& lifeline) {
  constexpr auto kLook = 10ms;
  int status = 0;
  const auto begin = std::chrono::steady_clock::now();
  int wakings = 0;
  std::optional<std::chrono::steady_clock::time_point> askedToEnd;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (wasInterrupted() && !askedToEnd) {
      closeEnd(lifeline);
      askedToEnd = std::chrono::steady_clock::now();
    }
    if (askedToEnd) {
      const auto waited = std::chrono::steady_clock::now() - *askedToEnd;
      if (waited > kTidying) kill(-child, waited > kTidying + kEnding ? SIGKILL : SIGTERM);
    }
    if (std::chrono::steady_clock::now() - begin > (wakings + 1) * kDisplayStart) {
      wakeDisplayRunner(child);
      ++wakings;
    }
    std::this_thread::sleep_for(kLook);
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace

std::string ownProgram() {
  std::error_code ignored;
  return std::filesystem::read_symlink("/proc/self/exe", ignored).string();
}

int runChild(const std::vector<std::string>& words) {
  const std::vector<char*> argv = argumentVector(words);
  std::array<int, 2> lifeline{-1, -1};  // the child's end, ours
  if (pipe2(lifeline.data(), O_CLOEXEC) != 0) return kNoProgram;
  const pid_t child = spawn(argv, lifeline[0]);
  closeEnd(lifeline[0]);
  const int code = child == 0 ? kNoProgram : waitFor(child, lifeline[1]);
  closeEnd(lifeline[1]);
  return code;
}

void endWithParent() {
  const char* number = std::getenv(kLifelineName);
  if (!number || std::string_view(number) != kLifelineNumber) return;
  unsetenv(kLifelineName);
  struct stat status {};
  if (fstat(kLifeline, &status) != 0 || !S_ISFIFO(status.st_mode)) return;
  fcntl(kLifeline, F_SETFD, FD_CLOEXEC);
  fcntl(kLifeline, F_SETSIG, SIGTERM);
  fcntl(kLifeline, F_SETOWN, getpid());
  fcntl(kLifeline, F_SETFL, O_ASYNC | O_NONBLOCK);
  pollfd end{kLifeline, 0, 0};
  if (::poll(&end, 1, 0) == 1 && (end.revents & POLLHUP) != 0) raise(SIGTERM);  // it had closed before
}

}  // namespace handwheel
