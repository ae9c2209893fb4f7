// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"

#include <array>
#include <csignal>
#include <functional>
#include <string_view>

namespace handwheel {

// The piece of work that a command does on its own thread.
class Job {
 public:
  Progress progress() { return Progress(m_state); }

 private:
  friend class JobRun;
  JobState m_state;
};

// Runs work on a thread of its own; this one shows its progress when stderr is a terminal and looks for signals. A job
// that does not stop at once after a signal is abandoned together with the program (exit code 130), because some
// library calls cannot be interrupted, but never while it writes a file. Passes on what work throws.
void runInterruptible(std::string_view label, const std::function<void(Job&)>& work);

// What asks the program to end: a key, the system, a terminal that is gone.
inline constexpr std::array kEndingSignals{SIGINT, SIGTERM, SIGHUP};

// Takes these signals from now on. To be called first.
void watchSignals();

// One of them came.
bool wasInterrupted();

// From now on one of them ends the program at once, which says so; also if it came already. For what cannot be
// cancelled.
void endWhenInterrupted();

}  // namespace handwheel
