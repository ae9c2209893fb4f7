// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/program/ProgramErrors.h"
#include "machining/program/ProgramInterpreter.h"

#include <QDebug>
#include <cmath>

namespace handwheel::test {

// A lathe that runs programs in tests. Its machine zero is the zero of the part unless the setup says otherwise.
struct ProgramTrial {
  explicit ProgramTrial(ProgramDialect dialect = ProgramDialect::LinuxCnc) { setup.dialect = dialect; }

  std::vector<ToolMove> movesOf(const std::string& text) const {
    const Result<ToolPath> path = runProgram(text, setup);
    if (!path) qWarning("line %d: %s", int(path.error().position.value), path.error().arguments.back().c_str());
    return path ? path->moves : std::vector<ToolMove>();
  }
  // Returns true if the last move of the program ends at this radius and height, mm.
  bool endsAt(const std::string& text, double r, double z) const {
    const std::vector<ToolMove> moves = movesOf(text);
    if (moves.empty()) return false;
    const ProfilePoint& to = moves.back().to;
    const bool isThere = std::abs(to.x() - r) < 1e-9 && std::abs(to.y() - z) < 1e-9;
    if (!isThere) qWarning("ends at r %g, z %g", to.x(), to.y());
    return isThere;
  }
  // Returns the error of a program as "line: word: reason. advice". The text is empty if the program has no error.
  std::string refusalOf(const std::string& text) const {
    const Result<ToolPath> path = runProgram(text, setup);
    if (path) return {};
    const Error& error = path.error();
    if (error.code != ErrorCode(ProgramError::Refused)) return "another error";
    return std::to_string(error.position.value) + ": " + error.arguments.at(1) + ": " + error.arguments.at(2) + ". " +
           error.arguments.at(3);
  }

  ProgramSetup setup;
};

}  // namespace handwheel::test
