// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "process/IsolatedReader.h"

#include "process/ChildProcess.h"
#include "process/ReaderAnswer.h"
#include "process/SystemMemory.h"

#include <dlfcn.h>
#include <sys/mman.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>

namespace handwheel {

namespace {

using namespace std::chrono_literals;

constexpr auto kPoll = 20ms;  // largest delay of a cancel
constexpr double kMemoryShare = 0.5;
// Bytes that libraries take before they have read anything: Open CASCADE 0.3 GB.
constexpr std::uint64_t kLeastMemory = std::uint64_t{1} << 30;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kIsSanitized = true;
#elif defined(__has_feature)
constexpr bool kIsSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool kIsSanitized = false;
#endif

Error cancelledReading() {
  return {ErrorCode::Cancelled, {}, {}, {}};
}

Error outOfMemory() {
  return {ErrorCode::OutOfMemory, {}, {}, {}};
}

// A file without a name, which is gone with the last process that holds it.
class UnnamedFile {
 public:
  UnnamedFile() : m_descriptor(memfd_create("handwheel", MFD_CLOEXEC)) {}
  ~UnnamedFile() {
    if (m_descriptor >= 0) ::close(m_descriptor);
  }
  UnnamedFile(const UnnamedFile&) = delete;
  UnnamedFile& operator=(const UnnamedFile&) = delete;

  int descriptor() const { return m_descriptor; }

  // Errors: OutOfMemory, Cancelled.
  Status fill(std::string_view bytes, Progress progress) const {
    constexpr std::size_t kBlock = std::size_t{4} << 20;
    while (!bytes.empty()) {
      if (progress.cancelled()) return cancelledReading();
      const ssize_t count = ::write(m_descriptor, bytes.data(), std::min(bytes.size(), kBlock));
      if (count < 0 && errno == EINTR) continue;
      if (count <= 0) return outOfMemory();
      bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return ::lseek(m_descriptor, 0, SEEK_SET) == 0 ? Status(Done{}) : Status(outOfMemory());
  }

 private:
  int m_descriptor;
};

// Sets the progress to the share of the work that it last reported, a number on a line of its own.
void showProgress(std::string_view lines, Progress progress) {
  lines = lines.substr(0, lines.rfind('\n'));
  const std::string_view last = lines.substr(lines.rfind('\n') + 1);
  double fraction = 0.0;
  const auto [end, error] = std::from_chars(last.data(), last.data() + last.size(), fraction);
  if (error == std::errc() && end == last.data() + last.size() && fraction >= 0.0 && fraction <= 1.0)
    progress.set(fraction);
}

std::string reasonOf(int code, const ReaderLimits& limits) {
  constexpr int kSignal = 128;  // codes of signals begin here
  if (code == 127) return "its process cannot be started";
  if (code == kSignal + SIGXCPU) return "it took longer than " + std::to_string(limits.cpu.count()) + " s";
  if (code == kSignal + SIGKILL) return "the system ended it; it may have run out of memory";
  return code > kSignal ? "it crashed on this file" : "its answer is not valid";
}

Result<std::string> conclude(ChildProcess& child, const IsolatedReader& reader) {
  const auto failed = [&](const std::string& reason) {
    return Error{ErrorCode::LibraryFailed, {reader.library, reason}, {}, {}};
  };
  if (child.code() != 0) return failed(reasonOf(child.code(), reader.limits));
  if (child.hasMoreOutput()) return failed("its answer is too large");
  std::optional<ReaderAnswer> answer = answerOf(child.takeOutput());
  if (!answer) return failed("its answer is not valid");
  switch (answer->kind) {
    case ReaderAnswer::Kind::Content:
      return std::move(answer->text);
    case ReaderAnswer::Kind::Reason:
      return failed(answer->text);
    case ReaderAnswer::Kind::OutOfMemory:
      return outOfMemory();
  }
  return failed("its answer is not valid");
}

}  // namespace

std::uint64_t ReaderLimits::memoryForReader() {
  if (kIsSanitized) return 0;
  const auto share = static_cast<std::uint64_t>(kMemoryShare * static_cast<double>(systemMemory()));
  return std::max(kLeastMemory, share);
}

std::string readerProgram(const std::string& name) {
  if (const char* const folder = std::getenv("HANDWHEEL_READERS")) return std::string(folder) + "/" + name;
  Dl_info library{};
  if (::dladdr(reinterpret_cast<const void*>(&readerProgram), &library) == 0 || !library.dli_fname) return name;
  return (std::filesystem::path(library.dli_fname).parent_path() / "readers" / name).string();
}

Result<std::string> readIsolated(const IsolatedReader& reader, const std::vector<std::string>& options,
                                 std::string_view bytes, Progress progress) {
  const UnnamedFile input;
  if (input.descriptor() < 0) return outOfMemory();
  if (const Status filled = input.fill(bytes, progress); !filled) return filled.error();
  std::vector<std::string> words{reader.program};
  words.insert(words.end(), options.begin(), options.end());
  const ReaderLimits& limits = reader.limits;
  const auto start = std::chrono::steady_clock::now();
  const auto child =
      ChildProcess::start(words, {input.descriptor(), limits.mostOutput,
                                  ProcessLimits{limits.memory, static_cast<std::uint64_t>(limits.cpu.count())}});
  if (!child) return Error{ErrorCode::LibraryFailed, {reader.library, "its process cannot be started"}, {}, {}};
  while (!child->hasEnded()) {
    if (progress.cancelled()) return cancelledReading();
    if (child->hasMoreOutput())
      return Error{ErrorCode::LibraryFailed, {reader.library, "its answer is too large"}, {}, {}};
    if (std::chrono::steady_clock::now() - start > limits.wall)
      return Error{ErrorCode::LibraryFailed,
                   {reader.library, "it took longer than " + std::to_string(limits.wall.count()) + " s"},
                   {},
                   {}};
    showProgress(child->errors(), progress);
    ChildProcess::wait(std::span(&child, 1), kPoll);
  }
  if (progress.cancelled()) return cancelledReading();
  return conclude(*child, reader);
}

}  // namespace handwheel
