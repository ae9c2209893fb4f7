// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/RenderingMemory.h"

#include "cli/Messages.h"
#include "process/SystemMemory.h"

#include <sys/mman.h>
#include <unistd.h>
#include <array>
#include <cerrno>
#include <csignal>
#include <string>

namespace handwheel {

namespace {

// Addresses, in bytes, that Mesa's software renderer takes at once for its code, the compiler included, and the stacks
// of its threads: an estimate, judged by where pictures begin to fail under a limit with Debian's Mesa 22.3. So is the
// share of it that becomes memory in use.
constexpr std::size_t kGraphics = 256 << 20;
constexpr std::size_t kGraphicsInUse = kGraphics / 3;
constexpr std::size_t kFace = 3 * 2 * 12 + 12;  // bytes: three corners with position and normal, three indices
constexpr std::size_t kStack = 64 << 10;        // bytes; the crash may be that the stack could not grow

// Prepared in advance, since a crashed program cannot create it.
std::string crashSentence;
alignas(16) std::array<std::byte, kStack> crashStack;

// Calls only functions that a signal handler may call.
bool fits(std::size_t bytes) {
  void* const probe = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (probe != MAP_FAILED) munmap(probe, bytes);
  return probe != MAP_FAILED || errno != ENOMEM;
}

// Calls only functions that a signal handler may call.
void endCrash(int signal) {
  if (!fits(kGraphics)) {
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, crashSentence.data(), crashSentence.size());
    _exit(kExitError);
  }
  ::signal(signal, SIG_DFL);
  raise(signal);
}

}  // namespace

bool isEnoughToDraw(std::size_t faces) {
  return fits(kGraphics + faces * kFace) && systemMemory() > kGraphicsInUse + faces * kFace;
}

void reportCrashes(const std::filesystem::path& file) {
  crashSentence = "handwheel: " + fullSentenceFor({ErrorCode::OutOfMemory, {}, {}, file.string()}) + "\n";
  const stack_t own{crashStack.data(), 0, crashStack.size()};
  sigaltstack(&own, nullptr);
  struct sigaction action {};
  action.sa_handler = endCrash;
  action.sa_flags = SA_ONSTACK | SA_RESETHAND;
  for (int signal : {SIGSEGV, SIGBUS, SIGABRT}) sigaction(signal, &action, nullptr);
}

}  // namespace handwheel
