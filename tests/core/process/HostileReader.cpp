// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "process/IsolatedReader.h"
#include "process/ReaderProgram.h"

#include <sys/resource.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <vector>

// A reader with the behaviour of its first option: known and conceivable behaviours of readers of hostile files. The
// second option, if any, is a mark by which tests find its process.

using namespace handwheel;

namespace {

using namespace std::chrono_literals;

volatile unsigned sink = 0;
volatile bool isEndless = true;  // unknown to the compiler

std::string contentOf(const char* file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Error failure(const std::string& reason) {
  return {ErrorCode::LibraryFailed, {"", reason}, {}, {}};
}

// The recursion is neither a tail call nor without its frame.
int recurse(int depth) {
  volatile char frame[4096] = {};
  frame[0] = static_cast<char>(depth);
  if (isEndless) sink = frame[0] + recurse(depth + 1);
  return sink + frame[0];
}

Result<std::string> allocate() {
  std::vector<std::unique_ptr<char[]>> all;
  for (;;) {
    constexpr std::size_t kBlock = 16 << 20;
    all.push_back(std::make_unique<char[]>(kBlock));  // zeroed, so that the memory is really used
  }
}

void work() {
  while (isEndless) sink = sink + 1;
}

void sleepForever() {
  while (isEndless) std::this_thread::sleep_for(1h);
}

// Returns the numbers of the open files, from the system's list.
std::string openFiles() {
  std::string all;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
    std::error_code error;
    const auto target = std::filesystem::read_symlink(entry.path(), error);
    all += entry.path().filename().string() + " " + target.string() + "\n";
  }
  return all;
}

std::string limits() {
  std::ostringstream text;
  for (const auto& [name, resource] : {std::pair{"core", RLIMIT_CORE}, {"cpu", RLIMIT_CPU}, {"memory", RLIMIT_AS}}) {
    rlimit limit{};
    getrlimit(resource, &limit);
    text << name << " " << limit.rlim_cur << "\n";
  }
  return text.str();
}

Result<std::string> report(Progress progress) {
  for (double fraction : {0.25, 0.5, 0.75}) {
    progress.set(fraction);
    std::this_thread::sleep_for(150ms);
  }
  return std::string("reported");
}

// Reads with a reader of its own, which does not end: this process is to be killed.
Result<std::string> beParent(const char* program, const char* mark) {
  return readIsolated({program, "a library", {}}, {"sleep", mark}, "bytes");
}

Result<std::string> misbehave(std::string_view bytes, std::span<char* const> options, Progress progress,
                              const char* program) {
  const std::string how = options.empty() ? "" : options[0];
  const std::map<std::string, std::function<Result<std::string>()>> all{
      {"echo", [&] { return std::string(bytes); }},
      {"refuse", [] { return failure("it is not what it says"); }},
      {"babble", [] { return failure(std::string(100'000, 'x')); }},
      {"throw", [] { return throw std::runtime_error("an exception of the library"), failure({}); }},
      {"say", [] { return std::puts("chatter"), std::fflush(stdout), std::string("content"); }},
      {"allocate", allocate},
      {"work", [] { return work(), failure({}); }},
      {"sleep", [] { return sleepForever(), failure({}); }},
      {"recurse", [] { return std::signal(SIGSEGV, SIG_DFL), std::to_string(recurse(0)); }},  // no sanitizer's handler
      {"abort", []() -> Result<std::string> { std::abort(); }},
      {"kill", [] { return ::kill(getpid(), SIGKILL), failure({}); }},
      {"exit", []() -> Result<std::string> { std::_Exit(0); }},
      {"files", [] { return openFiles(); }},
      {"limits", [] { return limits(); }},
      {"status", [] { return contentOf("/proc/self/status"); }},
      {"report", [&] { return report(progress); }},
      {"parent", [&] { return beParent(program, options[1]); }},
      {"large", [] { return std::string(std::size_t{64} << 20, 'x'); }},
  };
  const auto found = all.find(how);
  return found == all.end() ? failure("no such behaviour") : found->second();
}

// Breaks the agreement between readers and program in some manner.
void disagree(const std::string& how) {
  const std::string garbage(4096, '\xff');
  if (how == "garbage") std::_Exit(::write(STDOUT_FILENO, garbage.data(), garbage.size()) > 0 ? 0 : 1);
  while (how == "flood" && ::write(STDOUT_FILENO, garbage.data(), garbage.size()) > 0) {
  }
  while (how == "complain" && ::write(STDERR_FILENO, garbage.data(), garbage.size()) > 0) {
  }
  if (how == "close") {
    for (int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::close(stream);
    sleepForever();
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) disagree(argv[1]);
  runReaderProgram(argc, argv, [&](std::string_view bytes, std::span<char* const> options, Progress progress) {
    return misbehave(bytes, options, progress, argv[0]);
  });
}
