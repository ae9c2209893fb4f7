// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>
#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace handwheel {

// Resource limits of a child process.
struct ProcessLimits {
  std::uint64_t memory = 0;      // bytes of address space; 0: unlimited
  std::uint64_t cpuSeconds = 0;  // when they are over, SIGXCPU ends it
};

// Options of starting a child process.
struct ChildOptions {
  int input = -1;                     // the descriptor of its stdin; -1: there is nothing to read
  std::size_t mostOutput = 64 << 10;  // bytes of its output that are kept
  // Limits to which it is confined. It leaves no core, gains no rights, gets no keys of the terminal, and is killed as
  // soon as the thread that started it ends.
  std::optional<ProcessLimits> limits = {};
};

// A child process that runs in parallel and whose output is captured. Unless it is confined it belongs to our process
// group, so that the terminal's keys reach it too, and is asked to end when we end for any reason. It gets no other
// open files, and blocks no signals. When memory runs out the system kills it before us. One thread at a time.
class ChildProcess {
 public:
  // Starts a program given by its path; any thread. Returns null on failure; errno then has the reason.
  static std::unique_ptr<ChildProcess> start(const std::vector<std::string>& words, const ChildOptions& options = {});
  ~ChildProcess();  // kills it at once
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  // Reads its pending output and returns whether it has ended. Never blocks.
  bool hasEnded();
  void send(int signal);

  // Returns the exit code once it has ended; 127 when there is no such program, 128 + n when signal n ended it, 255
  // when the system did not keep it for us.
  int code() const { return m_code; }
  // Return the beginning of what it wrote to its output, and the last 64 KiB of its stderr.
  const std::string& output() const { return m_output; }
  std::string takeOutput() { return std::move(m_output); }
  bool hasMoreOutput() const { return m_hasMoreOutput; }  // more than is kept
  const std::string& errors() const { return m_errors; }

  // Waits until one of them has written output or ended, a signal arrives, or the time is over.
  static void wait(std::span<const std::unique_ptr<ChildProcess>> children, std::chrono::milliseconds time);

 private:
  ChildProcess(pid_t process, std::array<int, 2> pipes, std::size_t mostOutput);
  void listen();

  pid_t m_process;             // 0 once its exit status has been collected
  int m_end;                   // becomes readable when it ends; -1 where the system does not tell
  std::array<int, 2> m_pipes;  // from its stdout and stderr; -1 once they are closed
  std::size_t m_mostOutput;
  bool m_hasMoreOutput = false;
  int m_code = 0;
  std::string m_output, m_errors;
};

}  // namespace handwheel
