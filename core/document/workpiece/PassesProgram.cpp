// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/PassesProgram.h"

#include "document/workpiece/WorkpieceErrors.h"

namespace handwheel {

namespace {

double noseOf(const TurningPass& pass) {
  return pass.tool ? pass.tool->noseRadius : pass.noseRadius;
}

bool isTurned(const TurningPass& pass) {
  return !pass.tool || pass.tool->kind == LatheToolKind::RightTurning;
}

}  // namespace

Result<PassesProgram> passesProgram(const WorkpieceSnapshot& workpiece, ProgramDialect dialect,
                                    const PassProgram& how) {
  if (!workpiece.part || workpiece.part->passes.empty()) return Error{WorkpieceError::NoPasses, {}, {}, {}};
  const double nose = noseOf(*workpiece.part->passes.front());
  std::vector<TurningPass> passes;
  for (const auto& pass : workpiece.part->passes) {
    if (pass->side == TurningSide::Bore) return Error{WorkpieceError::BoredPasses, {}, {}, {}};
    if (!isTurned(*pass) || noseOf(*pass) != nose)
      return Error{WorkpieceError::OtherTools, {std::to_string(passes.size() + 1)}, {}, {}};
    passes.push_back(*pass);
  }
  const StockCylinder& stock = workpiece.stock;
  const auto moves = movesOf(passes, 0.5 * stock.diameter, stock.length, how);
  return PassesProgram{programText(moves, dialect, "recorded passes"), nose};
}

}  // namespace handwheel
