// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/DrawingWriter.h"
#include "machining/target/DxfReader.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is the file.

using namespace handwheel;

namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "DxfFuzz: %s\n", what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto drawing = readDxf({reinterpret_cast<const char*>(data), size});
  if (!drawing) return 0;
  require(!drawing->curves.empty() && drawing->curves.size() <= TargetProfile::kMostSegments, "how many curves");
  const auto target = targetIn(*drawing);
  if (!target) return 0;
  require(target->volume() > 0.0 && std::isfinite(target->volume()), "the volume");
  require(std::isfinite(target->distance({1.0, 2.0})), "the distance");
  (void)target->extentAt(0.5 * (target->lowerEnd() + target->upperEnd()));
  require(!dxfOf(*target).empty(), "nothing is written");
  return 0;
}
