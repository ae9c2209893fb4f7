// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"

#include <functional>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// The work of a command on its worker thread.
class CommandJob {
 public:
  Progress progress() { return Progress(m_state); }
  // Has a line printed to stdout while the work goes on. Any thread.
  void say(std::string line);

 private:
  friend class JobRun;
  JobState m_state;
  std::mutex m_mutex;  // of the lines
  std::vector<std::string> m_lines;
};

// Runs work on a worker thread and shows its progress. The calling thread draws the progress when stderr is a
// terminal, and watches for signals. A job that does not stop at once after a signal is abandoned together with the
// program (exit code 130), because some library calls cannot be interrupted, but never while it writes a file. Rethrows
// what work throws.
void runInterruptible(std::string_view label, const std::function<void(CommandJob&)>& work);

// Installs handlers for the signals that ask the program to end (kTerminationSignals). To be called first.
void watchSignals();

// Whether one of these signals has arrived.
bool wasInterrupted();

// Makes these signals end the program at once, with a message. Also when one has already arrived. For work that cannot
// be cancelled.
void endWhenInterrupted();

// Ignores these signals from now on. Before a result is written: it is there and the program succeeds, or neither.
void ignoreSignals();

}  // namespace handwheel
