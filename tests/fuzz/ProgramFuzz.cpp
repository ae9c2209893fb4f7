// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramInterpreter.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is a lathe program; its
// first byte chooses dialect and nose.

namespace {

using namespace handwheel;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "ProgramFuzz: %s\n", what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  ProgramSetup setup;
  setup.dialect = data[0] % 2 == 0 ? ProgramDialect::LinuxCnc : ProgramDialect::Fanuc;
  setup.standard = {data[0] / 2 % 3 * 0.4, outsideOrientation(setup.dialect), {0, 0}};
  setup.mostBlocks = 5'000;
  setup.mostMoves = 5'000;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const Result<ToolPath> path = runProgram(text, setup);
  if (!path) return 0;
  require(std::isfinite(path->time) && path->time >= 0.0, "a time that is none");
  require(path->moves.size() <= setup.mostMoves, "too many moves");
  for (const ToolMove& move : path->moves)
    require(move.from.allFinite() && move.to.allFinite() && move.centre.allFinite(), "a place that is not finite");
  return 0;
}
