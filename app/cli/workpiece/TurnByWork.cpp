// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/TurnByWork.h"

#include "document/workpiece/TurnedPartEdit.h"
#include "machining/force/WorkMaterials.h"

#include <algorithm>

namespace handwheel {

namespace {

// The bar before the first pass, with its samples where those of the work are: of another number they would see
// something else.
WorkpieceSnapshot sampledAs(WorkpieceSnapshot workpiece, const WorkpieceSnapshot& work) {
  if (workpiece.part || !work.part || workpiece.stock.length != work.stock.length) return workpiece;
  const TurnedProfile bar = TurnedProfile::barOf(workpiece.stock, work.part->profile.size());
  TurnedPart part = TurnedPart::of(bar, {}, workpiece.chord);
  part.finish = SurfaceFinish(bar.size());
  workpiece.part = std::make_shared<const TurnedPart>(std::move(part));
  return workpiece;
}

// Adds the peaks of one pass. Threads and abrasives are not of Kienzle's law. False: cancelled.
bool addPeaks(TurnStatistics& figures, const TurnedProfile& profile, const TurningPass& pass,
              const TurnRequest& request, Progress progress) {
  if (pass.thread || (pass.tool && pass.tool->isAbrasive())) return true;
  CuttingEdge edge;
  edge.noseRadius = pass.noseRadius;
  const std::unique_ptr<CuttingForceModel> model = kienzleModel(request.material, edge);
  const double speed = pass.speeds.empty() ? request.spindle : pass.speeds.front();
  const std::optional<ForcePeaks> peaks = forcePeaks(profile, {&pass, 1}, {speed, 0.0}, *model, progress);
  if (!peaks) return false;
  figures.force = std::max(figures.force, peaks->force);
  figures.power = std::max(figures.power, peaks->power);
  return true;
}

}  // namespace

Result<WorkpieceSnapshot> turnByWork(WorkpieceSnapshot workpiece, const WorkpieceSnapshot& work,
                                     const TurnRequest& request, TurnStatistics& figures, Progress progress) {
  WorkpieceSnapshot turned = sampledAs(std::move(workpiece), work);
  if (!work.part) return turned;
  std::vector<TurningPass> passes;
  TurnedProfile profile = partOf(turned, request.spacing).profile;
  for (const auto& pass : work.part->passes) {
    const auto share = [&](std::size_t n) {
      return 0.7 * static_cast<double>(n) / static_cast<double>(work.part->passes.size());
    };
    const Progress part = progress.part(share(passes.size()), share(passes.size() + 1));
    if (!addPeaks(figures, profile, *pass, request, part)) return Error{ErrorCode::Cancelled, {}, {}, {}};
    if (!pass->thread) cut(profile, *pass, part);
    figures.time += pass->times.empty() ? 0.0 : pass->times.back();
    passes.push_back(*pass);
  }
  auto made = withPasses(turned, std::move(passes), request.spacing, progress.part(0.7, 1.0));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (made) turned.part = std::move(made);
  if (!turned.lathe) turned.lathe = work.lathe;
  if (!work.crashes) return turned;
  figures.collisions = work.crashes->size();
  addCrashes(turned, *work.crashes);
  return turned;
}

}  // namespace handwheel
