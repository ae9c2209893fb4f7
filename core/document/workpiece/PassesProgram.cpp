// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/PassesProgram.h"

#include "document/workpiece/WorkpieceErrors.h"
#include "document/workpiece/target/TargetPosition.h"

namespace handwheel {

double recordedSpindle(const WorkpieceSnapshot& workpiece) {
  MeanSpindle mean;
  if (workpiece.part)
    for (const auto& pass : workpiece.part->passes) mean.add(*pass);
  return mean.speed();
}

std::string textOf(const LeftOutPass& pass) {
  const std::string tool = pass.tool ? ", " + pass.tool->designation : "";
  return "Pass " + std::to_string(pass.number) + tool + ": " + sentenceOf(pass.reason);
}

Result<PassesProgram> passesProgram(const WorkpieceSnapshot& workpiece, ProgramDialect dialect,
                                    const PassProgram& how) {
  if (!workpiece.part || workpiece.part->passes.empty()) return Error{WorkpieceError::NoPasses, {}, {}, {}};
  PassesProgram program;
  std::vector<TurningPass> passes;
  for (std::size_t i = 0; i < workpiece.part->passes.size(); ++i) {
    const TurningPass& pass = *workpiece.part->passes[i];
    if (const auto refusal = refusalToProgram(pass))
      program.leftOut.push_back({i + 1, pass.tool, *refusal});
    else
      passes.push_back(pass);
  }
  if (passes.empty()) return Error{WorkpieceError::OtherTools, {}, {}, {}};
  std::vector<std::string> comments;
  for (const PassTool& tool : toolsOf(passes)) {
    comments.push_back(descriptionOf(tool, dialect));
    program.tools[tool.number] = {tool.noseRadius, tool.orientationIn(dialect), {0.0, 0.0}, tool.tool};
  }
  for (const LeftOutPass& pass : program.leftOut) comments.push_back("left out: " + textOf(pass));
  const StockCylinder& stock = workpiece.stock;
  const double zero = programZero(workpiece) - stock.position;
  auto moves = movesOf(passes, stock, zero, how);
  setSpins(moves, program.tools, how.post);
  program.text = programText(moves, dialect, "recorded passes", comments);
  return program;
}

}  // namespace handwheel
