// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace handwheel {

// CPU time that the calling thread has used so far, in nanoseconds: waiting and other programs do not count. One call
// costs a fraction of a microsecond (a system call).
std::uint64_t threadCpuNanoseconds();

// A time in ms: by the clock, and of the calling thread's CPU.
struct Spent {
  double clock = 0.0;
  double cpu = 0.0;

  static Spent now();  // since some moment in the past
  Spent operator+(const Spent& other) const { return {clock + other.clock, cpu + other.cpu}; }
  Spent operator-(const Spent& other) const { return {clock - other.clock, cpu - other.cpu}; }
};

// CPU time, in ms, that a piece of work takes on the calling thread. What it hands to other threads is not counted.
template <class Work>
double cpuMilliseconds(Work&& work) {
  const std::uint64_t start = threadCpuNanoseconds();
  work();
  return static_cast<double>(threadCpuNanoseconds() - start) * 1e-6;
}

}  // namespace handwheel
