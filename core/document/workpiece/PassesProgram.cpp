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

Result<PassesProgram> passesProgram(const WorkpieceSnapshot& workpiece, ProgramDialect dialect,
                                    const PassProgram& how) {
  if (!workpiece.part || workpiece.part->passes.empty()) return Error{WorkpieceError::NoPasses, {}, {}, {}};
  std::vector<TurningPass> passes;
  for (const auto& pass : workpiece.part->passes) {
    if (!isProgrammable(*pass)) return Error{WorkpieceError::OtherTools, {std::to_string(passes.size() + 1)}, {}, {}};
    passes.push_back(*pass);
  }
  PassesProgram program;
  std::vector<std::string> comments;
  for (const PassTool& tool : toolsOf(passes)) {
    comments.push_back(descriptionOf(tool, dialect));
    program.tools[tool.number] = {tool.noseRadius, tool.orientationIn(dialect), {0.0, 0.0}, tool.tool};
  }
  const StockCylinder& stock = workpiece.stock;
  const double zero = programZero(workpiece) - stock.position;
  const auto moves = movesOf(passes, stock, zero, how);
  program.text = programText(moves, dialect, "recorded passes", comments);
  return program;
}

}  // namespace handwheel
