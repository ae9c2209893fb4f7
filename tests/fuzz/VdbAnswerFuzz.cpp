// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/vdb/VdbVolume.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is what the process that
// reads VDB answers: a hostile file may have taken it over. What hostile files do to that process itself, where no
// coverage guides, is in VdbFileFuzz.

using namespace handwheel;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto read = vdbVolumeIn({reinterpret_cast<const char*>(data), size});
  if (!read) return 0;
  const auto again = vdbVolumeIn(bytesOf(*read));
  if (!again || again->volume.material() != read->volume.material() || again->otherGrids != read->otherGrids) {
    std::fprintf(stderr, "VdbAnswerFuzz: what was read does not come back\n");
    std::abort();
  }
  return 0;
}
