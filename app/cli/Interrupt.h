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
  // Prints a line to stdout while the work continues. May be called on any thread.
  void say(std::string line);

 private:
  friend class JobRun;
  JobState m_state;
  std::mutex m_mutex;  // protects m_lines
  std::vector<std::string> m_lines;
};

// Runs work on a worker thread and shows its progress. The calling thread draws the progress if stderr is a terminal,
// and watches for signals. If the work does not stop soon after a signal, the program ends with exit code 130, because
// some library calls cannot be interrupted; but never while it writes a file. Rethrows the exceptions of the work.
void runInterruptible(std::string_view label, const std::function<void(CommandJob&)>& work);

// Installs handlers for the signals that ask the program to end (kTerminationSignals). Must be called before the other
// functions in this header.
void watchSignals();

// Returns true if one of kTerminationSignals has arrived.
bool wasInterrupted();

// Makes kTerminationSignals end the program at once, with a message. Ends the program if one has already arrived. Meant
// for work that cannot be cancelled.
void endWhenInterrupted();

// Ignores kTerminationSignals from now on. Must be called before a result is written, so that the program either writes
// the result and succeeds, or does neither.
void ignoreSignals();

}  // namespace handwheel
