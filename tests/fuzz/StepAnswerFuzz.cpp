// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/step/StepAnswer.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is what the process that
// reads STEP files answers: a hostile file may have taken it over. What hostile files do to that process itself, where
// no coverage guides, is in StepHostileTest.

using namespace handwheel;

namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "StepAnswerFuzz: %s\n", what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = meshIn({reinterpret_cast<const char*>(data), size}, {.partial = size % 2 == 1}, Progress());
  if (!file) return 0;
  for (const auto& p : file->soup.points) require(p.allFinite(), "a point is not finite");
  for (const auto& t : file->soup.triangles)
    for (std::uint32_t corner : t) require(corner < file->soup.points.size(), "an index is out of range");
  require(!file->soup.triangles.empty(), "a mesh without triangles");
  require(file->damage.size() <= 2, "too much damage");
  for (const Note& note : file->notes)
    for (const std::string& argument : note.arguments)
      for (char c : argument) require(c >= ' ' && c <= '~', "a note that a terminal would obey");
  return 0;
}
