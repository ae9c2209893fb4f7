// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/ProfileFromStep.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is what the process that
// reads STEP files answers about a turned part: a hostile file may have taken it over.

using namespace handwheel;

namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "ProfileFromStepFuzz: %s\n", what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto read = profileFromStepAnswer({reinterpret_cast<const char*>(data), size});
  if (!read) {
    for (const std::string& argument : read.error().arguments)
      for (char c : argument) require(c >= ' ' && c <= '~', "an error that a terminal would obey");
    return 0;
  }
  require(read->target.volume() > 0.0 && std::isfinite(read->target.volume()), "the volume");
  require(read->target.segments().size() <= TargetProfile::kMostSegments, "too many segments");
  return 0;
}
