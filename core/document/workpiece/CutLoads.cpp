// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/CutLoads.h"

#include "machining/force/CutWarnings.h"
#include "machining/force/CuttingFeel.h"
#include "machining/force/KienzleModel.h"
#include "machining/lathe/LatheMaterial.h"
#include "machining/lathe/LatheTool.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

// The chip of a thread is given across the edge that cuts, not along the feed.
CuttingEdge cuttingEdgeOf(const TurningPass& pass) {
  CuttingEdge edge = edgeOf(pass);
  if (pass.thread) edge.approach = kUsualApproach;
  return edge;
}

}  // namespace

std::vector<CutLoad> cutLoads(const TurningReview& review, TurningReview::Passes passes, const WorkMaterial& material,
                              double wear) {
  std::vector<CutLoad> loads;
  std::unique_ptr<CuttingForceModel> model;
  CuttingEdge edge;  // the edge of the model
  for (const CutMoment& moment : review.moments()) {
    const TurningPass& pass = *passes[moment.pass];
    if (pass.tool && pass.tool->isAbrasive()) continue;
    if (!model || edge != cuttingEdgeOf(pass)) model = kienzleModel(material, edge = cuttingEdgeOf(pass));
    const CutConditions cut{moment.depth, moment.chip, moment.speed};
    const CutForces forces = worn(moment.isDrilling ? model->onDrill(cut) : model->at(cut), wear);
    const CutConditions asked{moment.depth, moment.chip, moment.asked};
    CutLoad load{moment.time, forces.norm(), motorPower(cuttingPower(forces, asked), SpindleDrive().efficiency)};
    if (moment.isDrilling) {
      load.thrust = forces.feed;
      load.torque = cuttingTorque(forces, 2.0 * moment.radius);
      load.drill = 2.0 * (pass.tool ? pass.tool->reach() : pass.noseRadius);
    }
    loads.push_back(load);
  }
  return loads;
}

std::optional<LoadPeaks> loadPeaks(const WorkpieceSnapshot& workpiece, const TurnedPart* before,
                                   const WorkMaterial& material, const ReviewedLathe& lathe, Progress progress) {
  LoadPeaks peaks;
  if (!workpiece.part) return peaks;
  const TurnedPart& now = *workpiece.part;
  const TurnedProfile from = before ? before->profile : TurnedProfile::barOf(workpiece.stock, now.profile.size());
  std::vector<TurningPasses::Pass> passes;
  for (std::size_t i = before ? before->passes.size() : 0; i < now.passes.size(); ++i) passes.push_back(now.passes[i]);
  const auto review = TurningReview::make(from, passes, lathe, progress, before ? before->threads() : nullptr);
  if (!review) return std::nullopt;
  const double efficiency = SpindleDrive().efficiency;
  for (const CutLoad& load : cutLoads(*review, passes, material)) {
    peaks.force = std::max(peaks.force, load.force);
    peaks.power = std::max(peaks.power, load.power);
    if (!(load.drill > 0.0)) continue;
    if (load.torque >= peaks.drilling.torque) peaks.drilling.diameter = load.drill;
    peaks.drilling.thrust = std::max(peaks.drilling.thrust, load.thrust);
    peaks.drilling.torque = std::max(peaks.drilling.torque, load.torque);
    peaks.drilling.power = std::max(peaks.drilling.power, load.power * efficiency);
  }
  return peaks;
}

}  // namespace handwheel
