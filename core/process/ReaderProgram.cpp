// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "process/ReaderProgram.h"

#include "process/ReaderAnswer.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <new>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace handwheel {

namespace {

using namespace std::chrono_literals;

constexpr int kMisused = 2;
constexpr int kNotAnswered = 1;

bool writeAll(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

// Takes the descriptor of a stream for us alone; output of others to the stream is lost.
int takeStream(int stream) {
  const int own = fcntl(stream, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  const int nothing = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (own >= 0 && nothing >= 0 && dup2(nothing, stream) == stream) return own;
  std::_Exit(kNotAnswered);
}

bool isFile(int descriptor) {
  struct stat status {};
  return fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode);
}

// Maps all bytes of a file. The mapping lasts until the program ends.
std::string_view mapped(int file) {
  struct stat status {};
  if (fstat(file, &status) != 0 || status.st_size == 0) return {};
  const auto size = static_cast<std::size_t>(status.st_size);
  void* const bytes = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
  if (bytes == MAP_FAILED) throw std::bad_alloc();
  return {static_cast<const char*>(bytes), size};
}

// Allocates nothing, so that it goes on at the end of memory.
[[noreturn]] void tellProgress(const JobState& state, int descriptor) {
  constexpr auto kPeriod = 50ms;
  double reported = 0.0;
  for (;; std::this_thread::sleep_for(kPeriod)) {
    const double fraction = state.fraction;
    if (fraction == reported) continue;
    reported = fraction;
    std::array<char, 32> line{};
    const int length = std::snprintf(line.data(), line.size(), "%.4f\n", fraction);
    writeAll(descriptor, {line.data(), static_cast<std::size_t>(length)});
  }
}

// Reports the progress on a thread of its own, which ends with the program.
void startTelling(const JobState& state, int descriptor) {
  try {
    std::thread(tellProgress, std::cref(state), descriptor).detach();
  } catch (const std::system_error&) {  // there is no room for a thread; then there is no progress
  }
}

ReaderAnswer answerTo(const std::function<Result<std::string>()>& read) {
  try {
    Result<std::string> content = read();
    if (content) return {ReaderAnswer::Kind::Content, std::move(content).value()};
    const Error& error = content.error();
    if (error.code != ErrorCode::OutOfMemory)
      return {ReaderAnswer::Kind::Reason, error.arguments.empty() ? std::string() : error.arguments.back()};
  } catch (const std::bad_alloc&) {
  } catch (const std::length_error&) {
  } catch (const std::exception& error) {
    return {ReaderAnswer::Kind::Reason, error.what()};
  }
  return {ReaderAnswer::Kind::OutOfMemory, {}};
}

}  // namespace

void runReaderProgram(int argc, char** argv, const ReadInReader& read) {
  if (argc < 1 || !isFile(STDIN_FILENO)) {
    std::fprintf(stderr, "%s: Handwheel starts this program to read a file for it.\n", argc > 0 ? argv[0] : "reader");
    std::_Exit(kMisused);
  }
  const int output = takeStream(STDOUT_FILENO), errors = takeStream(STDERR_FILENO);
  static JobState state;  // the thread that tells of it goes on until the end
  startTelling(state, errors);
  const std::span<char* const> options(argv + 1, static_cast<std::size_t>(argc - 1));
  const ReaderAnswer answer = answerTo([&] { return read(mapped(STDIN_FILENO), options, Progress(state)); });
  const char kind = static_cast<char>(answer.kind);
  // Ends without the destructors of the library, which may fail after a hostile file.
  std::_Exit(writeAll(output, answer.text) && writeAll(output, {&kind, 1}) ? EXIT_SUCCESS : kNotAnswered);
}

}  // namespace handwheel
