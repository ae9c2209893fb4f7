// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/voxels/VolumeRepairChange.h"

#include "document/ThinNotes.h"
#include "mesh/search/LargestDistance.h"
#include "tools/mesh/ScriptLine.h"
#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/repair/DefectFixChanges.h"
#include "tools/mesh/voxels/VolumeRepairOperation.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeMemory.h"
#include "volume/repair/TriangleWalls.h"
#include "volume/repair/VolumeRepair.h"

#include <QtGlobal>
#include <algorithm>
#include <optional>

namespace handwheel {
namespace {

// Returns the reason for errors whose sentences say less.
const char* reasonOf(const Error& error) {
  if (error.code == VolumeErrors::NothingInside)
    return QT_TRANSLATE_NOOP(
        "Tool", "the surface encloses nothing, even with its holes closed: set a wall thickness to make walls of it");
  return QT_TRANSLATE_NOOP("Tool", "there are no triangles, or they have coordinates that are not numbers");
}

bool hasFigures(const Error& error) {
  return !error.arguments.empty() && error.code != ErrorCode::NumberNotFinite;
}

// Refuses what takes more memory than was agreed to.
Result<VolumeRepair> agreedRepair(const TriangleSoup& surface, const VolumeRepairOptions& options,
                                  const VolumeRepairParameters& parameters, Progress progress) {
  Box box;
  for (const Vec3& p : surface.points) box.extend(p);
  if (!box.isEmpty() && box.sizes().allFinite()) {
    const double bytes = predictedRepairBytes(surfaceArea(surface), box.sizes(), options);
    if (const auto error = consentRefusal(options.voxel, bytes, parameters.isAgreed)) return *error;
  }
  return repairByVolume(surface, options, progress);
}

}  // namespace

double voxelFor(const VolumeRepairParameters& parameters, double usual) {
  constexpr double kAcrossWalls = 4.0;  // voxels; less than two lose a wall
  if (parameters.voxel > 0.0) return parameters.voxel;
  return parameters.wall > 0.0 ? std::min(usual, parameters.wall / kAcrossWalls) : usual;
}

MeshChange volumeRepairChange(const VolumeRepairParameters& parameters, NumberType numbers) {
  OperationValues values(volumeRepairOperation());
  if (parameters.voxel > 0.0) values.setValid("voxel", parameters.voxel);
  values.setValid("close-gaps", parameters.gaps);
  values.setValid("wall", parameters.wall);
  setNumbers(values, numbers);
  if (parameters.isAgreed) values.setValid("yes", true);
  const auto distance = std::make_shared<std::optional<double>>();
  const auto outcome = std::make_shared<VolumeOutcome>();
  MeshChange change =
      explainedChange(volumeRepairOperation().title, [=](HalfEdgeMesh& mesh, Progress progress) -> const char* {
        const TriangleSoup surface = mesh.compact().soup;
        const VolumeRepairOptions options{
            .voxel = voxelFor(parameters, usualVoxel(surface)), .gaps = parameters.gaps, .numbers = numbers};
        *outcome = {};
        Result<VolumeRepair> repair = agreedRepair(parameters.wall > 0.0 ? wallsOf(surface, parameters.wall) : surface,
                                                   options, parameters, progress.part(0.0, 0.9));
        if (!repair && repair.error().code == ErrorCode::Cancelled) return nullptr;
        if (!repair && hasFigures(repair.error())) outcome->error = repair.error();
        if (!repair) return reasonOf(repair.error());
        outcome->hasLostWalls = repair->keptDistance > options.voxel || repair->walls.isChanged();
        outcome->notes = notesOnThinParts(repair->walls, repair->gaps);
        *distance = largestDistance(repair->mesh, mesh, progress.part(0.9, 1.0));
        if (progress.cancelled()) return nullptr;
        mesh = std::move(repair->mesh);
        return nullptr;
      });
  change.distance = distance;
  change.volume = outcome;
  return asFix(std::move(change), ScriptLineWriter("by-volume").options(values).text());
}

}  // namespace handwheel
