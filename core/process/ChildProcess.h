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
  std::uint64_t cpuSeconds = 0;  // s of processor time, after which SIGXCPU ends the process; 0: unlimited
};

// Options for starting a child process.
struct ChildOptions {
  int input = -1;                     // the descriptor of its stdin; -1: it has nothing to read
  std::size_t mostOutput = 64 << 10;  // bytes of its output that are kept
  // Resource limits; none: the process is not confined. A confined process leaves no core dump, gains no rights, gets
  // no keys of the terminal, and is killed as soon as the thread that started it ends.
  std::optional<ProcessLimits> limits = {};
};

// A child process that runs in parallel and whose output is captured. Unless it is confined it belongs to the process
// group of this program, so that the keys of the terminal reach it, too. It is asked to end when this program ends for
// any reason. It has no open files but its standard streams, and blocks no signals. If memory runs out, the system
// kills it before this program. An object is used by one thread at a time.
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

  // Returns the exit code once the process has ended: 127 if there is no such program, 128 + n if signal n ended it,
  // 255 if the system did not report the code.
  int code() const { return m_code; }
  // Return the beginning of what it wrote to its output, and the last 64 KiB of its stderr.
  const std::string& output() const { return m_output; }
  std::string takeOutput() { return std::move(m_output); }
  bool hasMoreOutput() const { return m_hasMoreOutput; }  // the process wrote more than is kept
  const std::string& errors() const { return m_errors; }

  // Waits until one of the children has written output or ended, a signal arrives, or the time is over.
  static void wait(std::span<const std::unique_ptr<ChildProcess>> children, std::chrono::milliseconds time);

 private:
  ChildProcess(pid_t process, std::array<int, 2> pipes, std::size_t mostOutput);
  void listen();

  pid_t m_process;             // id of the process; 0 once its exit status has been collected
  int m_end;                   // descriptor that becomes readable when the process ends; -1: the system has none
  std::array<int, 2> m_pipes;  // reading ends of the pipes from its stdout and stderr; -1: closed
  std::size_t m_mostOutput;
  bool m_hasMoreOutput = false;
  int m_code = 0;
  std::string m_output, m_errors;
};

}  // namespace handwheel
