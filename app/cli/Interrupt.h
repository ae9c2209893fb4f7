// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"

#include <functional>
#include <string_view>

namespace handwheel {

// The piece of work that a command does on its own thread.
class Job {
 public:
  Progress progress() { return Progress(m_state); }
  // From here on files change: an interrupted job is waited for, not abandoned. It still looks at the cancel flag.
  void startWriting() { m_isWriting = true; }

 private:
  friend class JobRun;
  JobState m_state;
  std::atomic<bool> m_isWriting{false};
};

// Runs work on a thread of its own; this one shows its progress when stderr is a terminal and looks for signals. A job
// that does not stop at once after a signal is abandoned together with the program (exit code 130), because some
// library calls cannot be interrupted. Passes on what work throws.
void runInterruptible(std::string_view label, const std::function<void(Job&)>& work);

// Takes SIGINT and SIGTERM from now on. To be called first.
void watchSignals();

// One of them came.
bool wasInterrupted();

}  // namespace handwheel
