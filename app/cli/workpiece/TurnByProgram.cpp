// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/TurnByProgram.h"

#include "document/FileBytes.h"
#include "document/workpiece/ProgramTrial.h"
#include "machining/force/WorkMaterials.h"
#include "machining/lathe/LatheJson.h"

namespace handwheel {

namespace {

Result<ProgramSetup> setupOf(const TurnRequest& request, const WorkpieceSnapshot& workpiece) {
  const LatheTools bodies = shippedLatheTools();
  ProgramSetup setup = programSetupFor(workpiece, bodies, request.dialect, request.noseRadius.value_or(0.0));
  setup.skips = request.skips;
  setup.hasIncrements = request.hasIncrements;
  if (request.post) setup.post = *request.post;
  if (request.tools.empty()) return setup;
  const Result<std::string> text = readFileBytes(request.tools);
  if (!text) return text.error();
  Result<ProgramTools> tools = readToolTable(*text, bodies, request.dialect);
  if (!tools) {
    Error error = tools.error();
    error.subject = request.tools.string();
    return error;
  }
  setup.tools = std::move(tools.value());
  return setup;
}

// Line 0: the text concerns the whole program.
std::string atLine(std::uint32_t line, const std::string& text) {
  return line == 0 ? text : "line " + std::to_string(line) + ": " + text;
}

std::string collisionSentence(const ProgramCollision& collision) {
  switch (collision.kind) {
    case ProgramCollision::Kind::Contact:
      return std::string("collision: ") + titleOf(collision.moving) + " meets " + titleOf(collision.struck) + ".";
    case ProgramCollision::Kind::Chuck:
      return "collision with the chuck.";
    case ProgramCollision::Kind::SpindleAtRest:
      return "feed into material with the spindle at rest.";
    default:
      return "rapid move through material.";
  }
}

}  // namespace

Result<WorkpieceSnapshot> turnByProgram(WorkpieceSnapshot workpiece, const TurnRequest& request,
                                        TurnStatistics& figures, std::vector<std::string>& remarks, Progress progress) {
  const Result<std::string> text = readFileBytes(request.program);
  if (!text) {
    Error error = text.error();
    error.subject = request.program.string();
    return error;
  }
  const Result<ProgramSetup> setup = setupOf(request, workpiece);
  if (!setup) return setup.error();
  CuttingEdge edge;
  if (request.noseRadius) edge.noseRadius = request.noseRadius;
  const std::unique_ptr<CuttingForceModel> model = kienzleModel(request.material, edge);
  const auto trial = ProgramTrial::run(workpiece, *text, *setup, request.spacing, model.get(), progress);
  if (!trial) {
    Error error = trial.error();
    error.subject = request.program.string();
    return error;
  }
  const ProgramTrial& tried = **trial;
  figures.force = tried.peaks().force;
  figures.power = tried.peaks().power;
  figures.drilling = tried.peaks().drilling;
  figures.collisions = tried.collisionCount();
  figures.time = tried.path().time;
  for (const ToolPath::Note& note : tried.path().notes) remarks.push_back(atLine(note.line, note.text));
  for (const ToolPath::Note& note : tried.notes()) remarks.push_back(atLine(note.line, note.text));
  figures.warnings = tried.notes();
  for (const ProgramCollision& collision : tried.collisions())
    remarks.push_back(atLine(collision.line, collisionSentence(collision)));
  if (tried.part()) workpiece.part = tried.part();
  workpiece.programPost = setup->post;
  addCrashes(workpiece, tried.crashes());
  return workpiece;
}

}  // namespace handwheel
