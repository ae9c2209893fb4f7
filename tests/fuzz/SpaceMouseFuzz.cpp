// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "spacemouse/Reports.h"
#include "spacemouse/SocketRecords.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is a run of reports, each
// with its length before it, and the same bytes as spacenavd's stream.

namespace {

using namespace handwheel;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "SpaceMouseFuzz: %s\n", what);
  std::abort();
}

void judge(const spacemouse::Counts& counts) {
  DeviceState state;
  setPose(counts, state);
  require(state.position.cwiseAbs().maxCoeff() <= spacemouse::kTravel, "beyond full scale");
  require(std::abs(state.orientation.norm() - 1.0) < 1e-9, "no rotation");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> bytes(data, size);
  spacemouse::Reports reports;
  for (std::size_t at = 0; at < size;) {
    const std::size_t length = std::min<std::size_t>(bytes[at] % 65, size - at - 1);
    (void)reports.take(bytes.subspan(at + 1, length));
    judge(reports.counts());
    at += 1 + length;
  }
  spacemouse::SocketRecords records;
  records.take(bytes);
  judge(records.counts());
  return 0;
}
