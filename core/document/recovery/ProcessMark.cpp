// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/recovery/ProcessMark.h"

#include <sys/stat.h>
#include <unistd.h>
#include <cstdint>
#include <fstream>
#include <optional>
#include <sstream>

namespace handwheel {

namespace {

constexpr std::uint64_t kExiting = 0x4;           // PF_EXITING of the kernel, in the flags of a process
constexpr std::uint64_t kKilled = 1u << (9 - 1);  // SIGKILL in a mask of signals

// Where process numbers mean the same: this start of this computer, and this container. Empty: not known.
std::string placeOfProcesses() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string boot;
  file >> boot;
  struct stat space {};
  if (boot.empty() || ::stat("/proc/self/ns/pid", &space) != 0) return {};
  return boot + ' ' + std::to_string(space.st_ino);
}

struct ProcessState {
  char letter = 0;          // 'R', 'S', 'D', 'Z', …
  std::uint64_t flags = 0;  // PF_… of the kernel
  std::string begun;        // in ticks since the computer was started
};

// None: there is no such process, or it may not be looked at.
std::optional<ProcessState> stateOf(const std::string& process) {
  std::ifstream file("/proc/" + process + "/stat");
  std::string line;
  if (!std::getline(file, line)) return {};
  // The second field is the name in brackets, which may hold anything.
  const std::size_t name = line.rfind(')');
  if (name == line.npos) return {};
  std::istringstream fields(line.substr(name + 1));
  ProcessState state;
  std::string skipped;
  fields >> state.letter;
  for (int field = 4; field < 9; ++field) fields >> skipped;
  fields >> state.flags;
  for (int field = 10; field < 22; ++field) fields >> skipped;
  fields >> state.begun;
  return fields ? std::optional(state) : std::nullopt;
}

// Whether it is written to a core, or a signal that nobody can catch waits for it: it runs no more code of its own.
bool isBeingKilled(const std::string& process) {
  std::ifstream file("/proc/" + process + "/status");
  std::string key;
  while (file >> key) {
    std::uint64_t value = 0;
    const bool isOfSignals = key == "SigPnd:" || key == "ShdPnd:", isOfCore = key == "CoreDumping:";
    if ((isOfSignals || isOfCore) && file >> std::hex >> value && (isOfCore ? value : value & kKilled) != 0)
      return true;
    file.ignore(1 << 20, '\n');
  }
  return false;
}

}  // namespace

std::string ownProcessMark() {
  const std::string place = placeOfProcesses(), process = std::to_string(::getpid());
  const std::optional<ProcessState> state = stateOf(process);
  return place.empty() || !state ? std::string() : place + ' ' + process + ' ' + state->begun;
}

bool isProcessOver(const std::string& mark) {
  const std::string place = placeOfProcesses();
  if (place.empty() || !mark.starts_with(place + ' ')) return false;
  std::istringstream fields(mark.substr(place.size()));
  std::uint64_t process = 0;
  std::string begun;
  if (!(fields >> process >> begun) || process == 0) return false;
  const std::string number = std::to_string(process);
  const std::optional<ProcessState> state = stateOf(number);
  // Where even our own process cannot be looked at, nothing is known of others.
  if (!state)
    return stateOf(std::to_string(::getpid())).has_value() && ::access(("/proc/" + number).c_str(), F_OK) != 0;
  if (state->begun != begun) return true;  // another one got its number
  return state->letter == 'Z' || state->letter == 'X' || (state->flags & kExiting) != 0 || isBeingKilled(number);
}

}  // namespace handwheel
