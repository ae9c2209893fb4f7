// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/volume/DrillReport.h"

#include "base/NumberText.h"
#include "cli/MemoryNotice.h"

#include <nlohmann/json.hpp>

namespace handwheel {

std::string notJoinedReason(SubtractionProblem problem) {
  switch (problem) {
    case SubtractionProblem::None:
      break;
    case SubtractionProblem::NotClosed:
      return "the part cannot be closed to a manifold";
    case SubtractionProblem::IntersectsItself:
      return "the part intersects itself";
    case SubtractionProblem::TooManyIntersections:
      return "the hole meets too many triangles";
    case SubtractionProblem::Unsound:
      return "the triangles could not be joined soundly";
  }
  return {};
}

std::string drillForces(const Drilled& drilled) {
  std::string text = "t_s,x_mm,y_mm,z_mm,thrust_N,torque_Nmm,fx_N,fy_N,fz_N,removed_mm3\n";
  double removed = 0.0;
  for (const DrillTick& tick : drilled.ticks) {
    removed += tick.removed;
    for (const double x : {tick.time, tick.position.x(), tick.position.y(), tick.position.z(), tick.thrust,
                           tick.torque.norm(), tick.force.x(), tick.force.y(), tick.force.z()})
      text += roundedText(x) + ",";
    text += roundedText(removed) + "\n";
  }
  return text;
}

nlohmann::ordered_json drillReport(const DrillAnswer& done, const MemoryNotice& notice) {
  const Drilled& drilled = done.drilled;
  nlohmann::ordered_json report = {{"removed_mm3", drilled.removed},
                                   {"max_thrust_N", drilled.maxThrust},
                                   {"max_torque_Nmm", drilled.maxTorque},
                                   {"energy_J", drilled.energy},
                                   {"breakthrough_s", nullptr},
                                   {"time_s", drilled.seconds},
                                   {"voxel_mm", done.voxel},
                                   {"material", done.setup.material.id},
                                   {"material_verified", done.setup.material.isVerified},
                                   {"material_source", done.setup.material.source}};
  if (drilled.breakthrough) report["breakthrough_s"] = *drilled.breakthrough;
  if (done.made) {
    report["hybrid"] = done.made->isHybrid;
    report["voxels_made"] = VolumeBlock::kCount * done.made->blocks;
    report["voxels_at_most"] = VolumeBlock::kCount * done.made->mostBlocks;
    report["voxel_MB_at_most"] = static_cast<double>(done.made->mostBytes) / 1e6;
  }
  if (done.joined || !done.notJoined.empty()) report["joined"] = done.joined.has_value();
  if (done.joined) {
    report["triangles"] = done.joined->mesh.liveFaceCount();
    report["kept_triangles"] = done.joined->kept;
    report["closing_triangles"] = done.joined->closing;
  } else if (!done.notJoined.empty()) {
    report["not_joined"] = done.notJoined;
  }
  notice.addTo(report);
  return report;
}

std::string drillText(const DrillAnswer& done) {
  const Drilled& drilled = done.drilled;
  std::string text = "Removed " + roundedText(drilled.removed) + " mm³ in voxels of " + roundedText(done.voxel) +
                     " mm: at most " + roundedText(drilled.maxThrust, 4) + " N and " +
                     roundedText(drilled.maxTorque, 4) + " N·mm, " + roundedText(drilled.energy, 4) + " J.\n";
  if (done.made)
    text += "Voxels were made " + std::string(done.made->isHybrid ? "near the head" : "of all of the part") +
            ": at most " + roundedText(static_cast<double>(done.made->mostBytes) / 1e6, 3) + " MB.\n";
  if (done.joined)
    text += "The hole is in the triangles of the part: " + std::to_string(done.joined->kept) + " of " +
            std::to_string(done.joined->mesh.liveFaceCount()) + " are as they were.\n";
  if (done.joined && done.joined->closing > 0)
    text += "Holes that the part had were closed by " + std::to_string(done.joined->closing) + " triangles before.\n";
  if (!done.notJoined.empty()) text += "The surface of all voxels was written, because " + done.notJoined + ".\n";
  if (drilled.breakthrough) text += "Breakthrough after " + roundedText(*drilled.breakthrough, 5) + " s.\n";
  if (!done.setup.material.isVerified)
    text += "The constants of " + done.setup.material.id + " are not verified: " + done.setup.material.source + ".\n";
  return text;
}

}  // namespace handwheel
