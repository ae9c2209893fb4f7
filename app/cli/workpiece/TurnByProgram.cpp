// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/TurnByProgram.h"

#include "document/FileBytes.h"
#include "document/workpiece/ProgramTrial.h"
#include "machining/lathe/LatheJson.h"

namespace handwheel {

namespace {

Result<ProgramSetup> setupOf(const TurnRequest& request, const WorkpieceSnapshot& workpiece,
                             std::vector<ToolPath::Note>& notes) {
  const LatheTools bodies = shippedLatheTools();
  ProgramSetup setup = programSetupFor(workpiece, bodies, request.dialect, request.noseRadius.value_or(0.0));
  setup.skips = request.skips;
  setup.hasIncrements = request.hasIncrements;
  if (request.post) setup.post = *request.post;
  if (request.tools.empty()) return setup;
  const Result<std::string> text = readFileBytes(request.tools);
  if (!text) return text.error();
  Result<ProgramTools> tools = readToolTable(*text, bodies, request.dialect, &notes);
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

std::string collisionSentence(const ProgramCollision& collision, const ToolPath& path) {
  switch (collision.kind) {
    case ProgramCollision::Kind::Contact:
      return std::string("collision: ") + titleOf(collision.moving) + " meets " + titleOf(collision.struck) + ".";
    case ProgramCollision::Kind::Chuck:
      return "collision with the chuck.";
    case ProgramCollision::Kind::SpindleAtRest:
      return isStoppedByChange(path, collision.line)
                 ? "feed into material with the spindle at rest: M6 has stopped it. Write M3 or M4 after M6."
                 : "feed into material with the spindle at rest.";
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
  std::vector<ToolPath::Note> tableNotes;
  const Result<ProgramSetup> setup = setupOf(request, workpiece, tableNotes);
  if (!setup) return setup.error();
  for (const ToolPath::Note& note : tableNotes) {
    const std::string remark = request.tools.string() + ", " + atLine(note.line, note.text);
    remarks.push_back(remark);
    figures.warnings.push_back({0, remark});
  }
  const auto trial = ProgramTrial::run(workpiece, *text, *setup, request.spacing, progress);
  if (!trial) {
    Error error = trial.error();
    error.subject = request.program.string();
    return error;
  }
  const ProgramTrial& tried = **trial;
  figures.collisions = tried.collisionCount();
  figures.time = tried.path().time;
  const std::string source = request.program.string() + ", ";
  for (const auto* notes : {&tried.path().notes, &tried.notes()})
    for (const ToolPath::Note& note : *notes) remarks.push_back(source + atLine(note.line, note.text));
  figures.warnings.insert(figures.warnings.end(), tried.notes().begin(), tried.notes().end());
  for (const ProgramCollision& collision : tried.collisions())
    remarks.push_back(source + atLine(collision.line, collisionSentence(collision, tried.path())));
  if (tried.part()) workpiece.part = tried.part();
  workpiece.programPost = setup->post;
  addCrashes(workpiece, tried.crashes());
  return workpiece;
}

}  // namespace handwheel
