// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/CycleProgram.h"

#include "base/NumberText.h"
#include "machining/program/ProgramErrors.h"
#include "machining/program/ProgramInterpreter.h"
#include "machining/program/ProgramSimulation.h"
#include "machining/program/ProgramWriter.h"
#include "machining/target/TargetDeviation.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr double kGouge = 0.005;  // mm, of the target that cycles may cut into

Status checkCycles(const std::string& text, const CycleTask& task, const ProgramSetup& setup, Progress progress) {
  const Result<ToolPath> path = runProgram(text, setup, progress.part(0.0, 0.3));
  if (!path) return path.error();
  ProgramSimulation simulation(task.part, *path, setup);
  if (!simulation.run(progress.part(0.3, 0.8))) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (simulation.collisionCount() > 0)
    return Error{ProgramError::CyclesCollide, {std::to_string(simulation.collisions().front().line)}, {}, {}};
  const TurnedProfile& part = simulation.part();
  const TargetProfile& target = task.target;
  const TargetDeviation deviation = deviationFrom(target, part, task.base, progress.part(0.8, 1.0));
  for (std::size_t i = 0; i < part.size(); ++i) {
    const double z = part.z(i) + task.base;
    const bool isInside = z > target.lowerEnd() + part.spacing() && z < target.upperEnd() - part.spacing();
    // What a cut before has taken too much is not the fault of the cycles.
    const bool isCut = part.radius(i) < task.part.radius(i);
    if (isInside && isCut && deviation.outer[i] < -kGouge)
      return Error{ProgramError::CyclesGouge,
                   {roundedText(-deviation.outer[i], 3), roundedText(z - task.base - part.length(), 4)},
                   {},
                   {}};
  }
  return Done{};
}

}  // namespace

Result<std::string> cycleProgram(const CycleTask& task, ProgramDialect dialect, const CycleSettings& settings,
                                 Progress progress) {
  CycleSettings limited = settings;
  limited.room = std::min(settings.room, task.target.lowerEnd() - task.base - task.grip);
  Result<std::vector<ToolMove>> moves = roughAndFinish(task.target, 0.5 * task.stock.diameter, limited);
  if (!moves) return moves.error();
  const double front = task.target.upperEnd() - (task.base + task.part.length());
  for (ToolMove& move : moves.value())
    for (ProfilePoint* each : {&move.from, &move.to, &move.centre}) each->y() += front;
  std::string text = programText(*moves, dialect, "rough and finish");
  const Status problem = checkCycles(text, task, usualSetup(dialect, task.stock, task.grip, settings.nose), progress);
  if (!problem) return problem.error();
  return text;
}

}  // namespace handwheel
