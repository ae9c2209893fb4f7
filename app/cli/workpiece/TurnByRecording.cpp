// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/TurnByRecording.h"

#include "cli/TipTrajectory.h"
#include "document/FileBytes.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "haptics/recording/RecordingCsv.h"
#include "simulation/turning/RecordedPasses.h"

#include <cmath>

namespace handwheel {

namespace {

constexpr const char* kOfTheLathe =
    "This is a recording of the Lathe tool, which does not hold its levers and handwheels: only recordings of the Turn "
    "tool can be turned again. The workpiece itself has the passes of the lathe: give that as the recording.";

// A path is one pass: its distance from the axis and its height above the lower end of the bar.
Result<std::vector<TurningPass>> passAlong(const std::vector<HandPose>& poses, double base) {
  if (poses.size() > TurningPass::kMostPoints)
    return Error{ErrorCode::FileTooLarge,
                 {"lines", std::to_string(poses.size()), std::to_string(TurningPass::kMostPoints)},
                 {},
                 {}};
  TurningPass pass;
  for (const HandPose& pose : poses) {
    pass.path.emplace_back(std::hypot(pose.position.x(), pose.position.y()), pose.position.z() - base);
    pass.times.push_back(pose.time - poses.front().time);
  }
  return std::vector<TurningPass>{std::move(pass)};
}

// Returns the problem of a table that is neither a path nor a whole recording: the missing columns.
std::string missingColumns(std::string_view text, const std::string& problemAsPath) {
  const std::string_view header = text.substr(0, text.find('\n'));
  if (header.find("hip_x") == header.npos && header.find("proxy_x") == header.npos) return problemAsPath;
  std::string names;
  for (const std::string_view name : missingRecordingColumns(text))
    names += (names.empty() ? "" : ", ") + std::string(name);
  return "Of the columns of a recording these are missing: " + names + ".";
}

// problem: a sentence about the file, which is not cut as the arguments of an Error are.
Result<std::vector<TurningPass>> passesIn(std::string_view text, double base, std::string& problem, Progress progress) {
  if (isRecordingCsv(text)) {
    const Result<Recording> recording = recordingFromCsv(text, progress);
    if (!recording) return recording.error();
    auto passes = passesOf(*recording, base);
    if (passes) return std::move(*passes);
    problem = kOfTheLathe;
    return std::vector<TurningPass>();
  }
  const TipTrajectory path = readTipTrajectory(text);
  if (path.problem.empty()) return passAlong(path.poses, base);
  problem = missingColumns(text, path.problem);
  return std::vector<TurningPass>();
}

Result<std::vector<TurningPass>> readPasses(const TurnRequest& request, double base, std::string& problem,
                                            Progress progress) {
  const Result<std::string> text = readFileBytes(request.recording);
  Result<std::vector<TurningPass>> passes =
      text ? passesIn(*text, base, problem, progress) : Result<std::vector<TurningPass>>(text.error());
  if (passes) return passes;
  Error error = passes.error();
  error.subject = request.recording.string();
  return error;
}

// The workpiece after these passes. Error: Cancelled.
Result<WorkpieceSnapshot> turn(WorkpieceSnapshot workpiece, std::vector<TurningPass> passes, const TurnRequest& request,
                               TurnStatistics& figures, Progress progress) {
  const auto share = [&](std::size_t n) { return static_cast<double>(n) / static_cast<double>(passes.size()); };
  for (std::size_t i = 0; i < passes.size(); ++i) {
    figures.time += passes[i].times.empty() ? 0.0 : passes[i].times.back();
    auto turned = withPass(workpiece, std::move(passes[i]), request.spacing, progress.part(share(i), share(i + 1)));
    if (!turned) return Error{ErrorCode::Cancelled, {}, {}, {}};
    if (!turned->passes.empty()) workpiece.part = std::move(turned);  // else it is the bar still
  }
  return workpiece;
}

}  // namespace

Result<WorkpieceSnapshot> turnByRecording(const WorkpieceSnapshot& workpiece, const TurnRequest& request,
                                          TurnStatistics& figures, std::string& unreadable, Progress progress) {
  Result<std::vector<TurningPass>> passes =
      readPasses(request, workpiece.stock.position, unreadable, progress.part(0.0, 0.2));
  if (!passes) return passes.error();
  for (TurningPass& pass : *passes) {
    pass.noseRadius = request.noseRadius.value_or(pass.noseRadius);
    pass.method = request.method.value_or(pass.method);
    pass.resolution = request.resolution.value_or(pass.resolution);
    if (pass.speeds.empty()) pass.speeds.assign(pass.path.size(), request.spindle);
  }
  return turn(workpiece, std::move(passes.value()), request, figures, progress.part(0.2, 1.0));
}

}  // namespace handwheel
