// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/cycles/CycleProgram.h"

#include "base/NumberText.h"
#include "machining/program/ProgramErrors.h"
#include "machining/program/ProgramInterpreter.h"
#include "machining/program/ProgramSimulation.h"
#include "machining/program/ProgramWriter.h"
#include "machining/program/cycles/BoreCuts.h"
#include "machining/program/cycles/FaceCuts.h"
#include "machining/target/TargetDeviation.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kGouge = 0.005;  // mm, largest cut into the target

// Returns the comments for the head of the program.
std::vector<std::string> commentsOf(const ProgramTools& tools) {
  std::vector<std::string> comments;
  for (const auto& [number, tool] : tools)
    if (tool.body) comments.push_back("T" + std::to_string(number) + ": " + tool.body->designation);
  return comments;
}

CycleRest restOf(const CycleTask& task, const TurnedProfile& part, const TargetDeviation::Extreme& most) {
  if (most.distance <= 0.0) return {};
  const auto last = static_cast<double>(part.size() - 1);
  const double sample = std::round((most.at.y() - task.base) / part.spacing());
  const auto i = static_cast<std::size_t>(std::clamp(sample, 0.0, last));
  return {most.distance, most.at.y() - task.base - part.length() + task.allowance, most.at.x() < part.radius(i)};
}

Result<CycleRest> checkCycles(const std::string& text, const CycleTask& task, const ProgramSetup& setup,
                              Progress progress) {
  const Result<ToolPath> path = runProgram(text, setup, progress.part(0.0, 0.3));
  if (!path) return path.error();
  ProgramSimulation simulation(task.part, *path, setup);
  if (!simulation.run(progress.part(0.3, 0.8))) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (simulation.collisionCount() > 0)
    return Error{ProgramError::CyclesCollide, {std::to_string(simulation.collisions().front().line)}, {}, {}};
  const TurnedProfile& part = simulation.part();
  const TargetProfile& target = task.target;
  const TargetDeviation deviation =
      deviationFrom(target, part, task.base, progress.part(0.8, 1.0), rangeOfTarget(target, part, task.base));
  for (std::size_t i = 0; i < part.size(); ++i) {
    const double z = part.z(i) + task.base;
    const bool isInside = z > target.lowerEnd() + part.spacing() && z < target.upperEnd() - part.spacing();
    // The cycles are not responsible for earlier cuts that are too deep.
    const bool isCut = part.radius(i) < task.part.radius(i);
    const bool isBored = part.inner(i) > task.part.inner(i);
    const double outer = isCut ? deviation.outer[i] : 0.0, inner = isBored ? deviation.inner[i] : 0.0;
    const double least = std::min(outer, inner);
    if (isInside && least < -kGouge)
      return Error{ProgramError::CyclesGouge,
                   {roundedText(-least, 3), roundedText(z - task.base - part.length() + task.allowance, 4)},
                   {},
                   {}};
  }
  return restOf(task, part, deviation.largestOver);
}

}  // namespace

Result<CycleProgram> cycleProgram(const CycleTask& task, ProgramDialect dialect, const CycleSettings& settings,
                                  Progress progress) {
  CycleProgram program;
  for (const int tool : {settings.roughTool, settings.finishTool})
    program.tools[tool] = {settings.nose, outsideOrientation(dialect), {0.0, 0.0}};
  const EndStock end = EndStock::of(task.part, task.base, task.target.upperEnd());
  Result<std::vector<ToolMove>> faced = faceCuts(end, 0.5 * task.stock.diameter, settings);
  if (!faced) return faced.error();
  std::vector<ToolMove> moves = std::move(faced.value());
  const double below = task.target.lowerEnd() - task.base;
  if (settings.drill > 0.0) {
    const Result<BoreTools> tools = boreTools(task.target, settings.drill, task.tools);
    if (!tools) return tools.error();
    program.tools[settings.drillTool] = programToolOf(tools->drill, dialect);
    if (tools->bar) program.tools[settings.boreTool] = programToolOf(tools->bar, dialect);
    const Result<std::vector<ToolMove>> bored = drillAndBore(task.target, *tools, settings, below);
    if (!bored) return bored.error();
    moves.insert(moves.end(), bored->begin(), bored->end());
  }
  CycleSettings limited = settings;
  limited.room = std::min(settings.room, below - task.grip);
  const Result<std::vector<ToolMove>> turned = roughAndFinish(task.target, 0.5 * task.stock.diameter, limited);
  if (!turned) return turned.error();
  moves.insert(moves.end(), turned->begin(), turned->end());
  const double front = task.target.upperEnd() - (task.base + task.part.length() - task.allowance);
  for (ToolMove& move : moves)
    for (ProfilePoint* each : {&move.from, &move.to, &move.centre}) each->y() += front;
  setSpins(moves, program.tools, settings.post);
  program.text = programText(moves, dialect, "rough and finish", commentsOf(program.tools));
  ProgramSetup setup = usualSetup(dialect, task.stock, task.grip, settings.nose, task.allowance);
  setup.tools = program.tools;
  setup.lathe = task.lathe;
  const Result<CycleRest> rest = checkCycles(program.text, task, setup, progress);
  if (!rest) return rest.error();
  program.rest = *rest;
  program.drill = settings.drill;
  return program;
}

Result<CycleProgram> cycleProgramWithDrill(const CycleTask& task, ProgramDialect dialect, CycleSettings settings,
                                           Progress progress) {
  settings.drill = 0.0;
  if (!hasBore(task.target)) return cycleProgram(task, dialect, settings, progress);
  std::optional<Error> first;
  for (const double drill : drillsFor(task.target, task.tools)) {
    settings.drill = drill;
    Result<CycleProgram> program = cycleProgram(task, dialect, settings, progress);
    if (program || program.error().code == ErrorCode::Cancelled) return program;
    if (!first) first = program.error();
  }
  return first ? *first : whyNoDrill(task.target, task.tools).value_or(Error{});
}

}  // namespace handwheel
