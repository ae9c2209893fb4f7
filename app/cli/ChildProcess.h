// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>
#include <array>
#include <chrono>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace handwheel {

// Path of the running executable, for starting it again.
std::string ownProgram();

// Runs a program found along PATH and waits for it. It shares our stdout and stderr. It holds the end of a pipe that
// closes when a signal arrives or this process ends, for whatever reason; a program that called endWithParent() then
// ends, also when it runs below others such as xvfb-run, which can thus clean up after it. Those that do not end are
// killed. Returns its exit code, 127 when there is no such program, 128 + n when signal n ended it.
int runChild(const std::vector<std::string>& words);

// Makes the end of the parent process arrive as SIGTERM from now on. For a program that runChild() of another one
// started, even indirectly; does nothing in others. To be called after watchSignals().
void endWithParent();

// A child process that runs in parallel and whose output is captured. It belongs to our process group, so that the
// terminal's keys reach it too; it is asked to end when we end, however that comes. When memory runs out the system
// kills it before us.
class ChildProcess {
 public:
  // Starts a program given by its path. Returns null on failure; errno then has the reason.
  static std::unique_ptr<ChildProcess> start(const std::vector<std::string>& words);
  ~ChildProcess();  // kills it at once
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Reads its pending output and returns whether it has ended. Never blocks.
  bool hasEnded();
  void send(int signal);

  // The exit code once it has ended, as runChild() returns it.
  int code() const { return m_code; }
  // The first 64 KiB that it wrote to its output, the last 64 KiB of its stderr.
  const std::string& output() const { return m_output; }
  const std::string& errors() const { return m_errors; }

  // Waits until one of them has written output, a signal arrives, or the time is over.
  static void wait(std::span<const std::unique_ptr<ChildProcess>> children, std::chrono::milliseconds time);

 private:
  ChildProcess(pid_t process, std::array<int, 2> pipes) : m_process(process), m_pipes(pipes) {}
  void listen();

  pid_t m_process;             // 0 once its exit status has been collected
  std::array<int, 2> m_pipes;  // from its stdout and stderr; -1 once they are closed
  int m_code = 0;
  std::string m_output, m_errors;
};

}  // namespace handwheel
