// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/TurnByWork.h"

#include "document/workpiece/TurnedPartEdit.h"

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

}  // namespace

Result<WorkpieceSnapshot> turnByWork(WorkpieceSnapshot workpiece, const WorkpieceSnapshot& work,
                                     const TurnRequest& request, TurnStatistics& figures, Progress progress) {
  WorkpieceSnapshot turned = sampledAs(std::move(workpiece), work);
  if (!work.part) return turned;
  std::vector<TurningPass> passes;
  for (const auto& pass : work.part->passes) {
    figures.time += pass->times.empty() ? 0.0 : pass->times.back();
    passes.push_back(*pass);
  }
  auto made = withPasses(turned, std::move(passes), request.spacing, progress);
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (made) turned.part = std::move(made);
  if (!turned.lathe) turned.lathe = work.lathe;
  if (!work.crashes) return turned;
  figures.collisions = work.crashes->size();
  addCrashes(turned, *work.crashes);
  return turned;
}

}  // namespace handwheel
