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

// The program that is running, for starting it again.
std::string ownProgram();

// Runs a program found along PATH, with our output and our stderr, and waits for it. It holds the end of a pipe that
// closes when a signal comes or we end, however that comes; this program ends then, also below others such as xvfb-run,
// which so tidy up behind it. Those that do not are ended. Returns its exit code, 127 when there is no such program,
// 128 + n when signal n ended it.
int runChild(const std::vector<std::string>& words);

// In a program that runChild() of another started, even by way of others: its end comes as SIGTERM from now on. To be
// called after watchSignals(). Does nothing in others.
void endWithParent();

// A program that runs beside us and whose words we keep. It belongs to our process group, so that the terminal's keys
// reach it too; it is told to end when we end, however that comes. Where memory runs out the system ends it before us.
class ChildProcess {
 public:
  // The program by its path. Null: errno says why.
  static std::unique_ptr<ChildProcess> start(const std::vector<std::string>& words);
  ~ChildProcess();  // ends it at once
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Takes in what it has said, and says whether it has ended. Never waits.
  bool hasEnded();
  void send(int signal);

  // Once it has ended, as runChild() gives it.
  int code() const { return m_code; }
  // The first 64 KiB that it wrote to its output, the last 64 KiB of its stderr.
  const std::string& output() const { return m_output; }
  const std::string& errors() const { return m_errors; }

  // Returns when one of them has something to say, a signal comes, or the time is over.
  static void wait(std::span<const std::unique_ptr<ChildProcess>> children, std::chrono::milliseconds time);

 private:
  ChildProcess(pid_t process, std::array<int, 2> pipes) : m_process(process), m_pipes(pipes) {}
  void listen();

  pid_t m_process;             // 0 once it has been waited for
  std::array<int, 2> m_pipes;  // from its output and its stderr; -1 where they have ended
  int m_code = 0;
  std::string m_output, m_errors;
};

}  // namespace handwheel
