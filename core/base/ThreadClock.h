// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace handwheel {

// Returns the CPU time used by the calling thread, in nanoseconds. Time spent waiting, and time of other programs, does
// not count. A call is a system call and costs a fraction of a microsecond.
std::uint64_t threadCpuNanoseconds();

// A pair of elapsed time and CPU time of the calling thread, in ms.
struct CpuTimes {
  double clock = 0.0;
  double cpu = 0.0;

  static CpuTimes now();  // both times are measured from an arbitrary origin
  CpuTimes operator+(const CpuTimes& other) const { return {clock + other.clock, cpu + other.cpu}; }
  CpuTimes operator-(const CpuTimes& other) const { return {clock - other.clock, cpu - other.cpu}; }
};

// Measures the CPU time of a function on the calling thread, in ms. Work that it passes to other threads is not
// counted.
template <class Work>
double cpuMilliseconds(Work&& work) {
  const std::uint64_t start = threadCpuNanoseconds();
  work();
  return static_cast<double>(threadCpuNanoseconds() - start) * 1e-6;
}

}  // namespace handwheel
