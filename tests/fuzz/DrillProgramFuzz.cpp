// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/drilling/DrillProgram.h"

#include <cmath>
#include <cstdint>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is the program: whatever it
// is, a path is finite and its time goes on.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace handwheel;
  const auto program = readDrillProgram({reinterpret_cast<const char*>(data), size});
  if (!program) return 0;
  if (program->waypoints.empty() || program->waypoints.size() > DrillProgram::kMostWaypoints) std::abort();
  double last = 0.0;
  for (const auto& [time, tip] : program->waypoints) {
    if (!(time >= last) || !std::isfinite(time) || !tip.allFinite()) std::abort();
    last = time;
  }
  return 0;
}
