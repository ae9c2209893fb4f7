// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramInterpreter.h"
#include "machining/program/ProgramSimulation.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

// Entry for libFuzzer; StandaloneFuzzer.cpp drives it where that is not at hand. The input is a lathe program; its
// first byte chooses dialect, nose and tools. What it does is simulated on a small bar.

namespace {

using namespace handwheel;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "ProgramFuzz: %s\n", what);
  std::abort();
}

constexpr std::size_t kMostSimulated = 500;  // moves: so that an input takes milliseconds

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  ProgramSetup setup;
  setup.dialect = data[0] % 2 == 0 ? ProgramDialect::LinuxCnc : ProgramDialect::Fanuc;
  setup.standard = {data[0] / 2 % 3 * 0.4, outsideOrientation(setup.dialect), {0, 0}};
  if (data[0] / 6 % 2 == 1) setup.tools = {{1, {0.8, 2, {1, 10}}}, {2, {0.0, 7, {0, 5}}}, {3, {0.4, 3, {-2, 3}}}};
  setup.hasIncrements = data[0] / 12 % 2 == 1;
  setup.skips = data[0] / 24 % 2 == 1 ? 1u << 2 | 1u << 4 : 0u;
  setup.mostBlocks = 5'000;
  setup.mostMoves = 5'000;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  const Result<ToolPath> path = runProgram(text, setup);
  if (!path) return 0;
  require(std::isfinite(path->time) && path->time >= 0.0, "a time that is none");
  require(path->moves.size() <= setup.mostMoves, "too many moves");
  for (const ToolMove& move : path->moves)
    require(move.from.allFinite() && move.to.allFinite() && move.centre.allFinite(), "a place that is not finite");
  if (path->moves.size() > kMostSimulated) return 0;
  const TurnedProfile bar({20.0, 30.0, 0.0}, 0.1);
  ProgramSimulation simulation(bar, *path, setup);
  require(simulation.run({}), "it was cancelled");
  const TurnedProfile& part = simulation.part();
  for (std::size_t i = 0; i < part.size(); ++i)
    require(part.inner(i) >= 0.0 && part.inner(i) <= part.radius(i) && part.radius(i) <= 10.0, "a radius");
  TurnedProfile again = bar;
  std::uint32_t number = 0;
  for (const TurningPass& pass : simulation.takePasses()) {
    require(pass.path.size() == pass.times.size() && pass.times.front() == 0.0, "the times of a pass");
    cut(again, std::make_shared<const TurningPass>(pass), number++);
  }
  constexpr double kSame = 1e-6;  // mm
  for (std::size_t i = 0; i < again.size(); ++i) {
    const bool isEmpty = again.radius(i) - again.inner(i) <= kSame && part.radius(i) - part.inner(i) <= kSame;
    const bool isSame =
        std::abs(again.radius(i) - part.radius(i)) <= kSame && std::abs(again.inner(i) - part.inner(i)) <= kSame;
    require(isEmpty || isSame, "the passes give another part");
  }
  return 0;
}
