// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/target/files/Drawing.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

// Invariants of a drawing that was read from any file.
namespace handwheel::fuzz {

inline void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "DrawingFuzz: %s\n", what);
  std::abort();
}

// Checks a drawing. written: writes the profile to a file again.
template <class Written>
void checkDrawing(const Result<Drawing>& drawing, Written written) {
  if (!drawing) return;
  require(!drawing->curves.empty() && drawing->curves.size() <= TargetProfile::kMostSegments, "how many curves");
  const auto target = targetIn(*drawing);
  if (!target) return;
  require(target->volume() > 0.0 && std::isfinite(target->volume()), "the volume");
  require(std::isfinite(target->distance({1.0, 2.0})), "the distance");
  (void)target->extentAt(0.5 * (target->lowerEnd() + target->upperEnd()));
  require(!written(*target).empty(), "nothing is written");
}

}  // namespace handwheel::fuzz
