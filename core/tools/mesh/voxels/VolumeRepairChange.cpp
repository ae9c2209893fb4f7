// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/voxels/VolumeRepairChange.h"

#include "mesh/measure/Deviation.h"
#include "tools/mesh/StepText.h"
#include "tools/mesh/operations/FillOperation.h"
#include "tools/mesh/repair/FixParts.h"
#include "tools/mesh/voxels/VolumeRepairOperation.h"
#include "volume/SurfaceToVolume.h"
#include "volume/VolumeErrors.h"
#include "volume/repair/TriangleWalls.h"
#include "volume/repair/VolumeRepair.h"

#include <QtGlobal>
#include <algorithm>
#include <optional>

namespace handwheel {
namespace {

const char* reasonOf(const Error& error) {
  if (error.code == VolumeErrors::NothingInside)
    return QT_TRANSLATE_NOOP(
        "Tool", "the surface encloses nothing, even with its holes closed: set a wall thickness to make walls of it");
  if (error.code == VolumeErrors::NoVoxelInside)
    return QT_TRANSLATE_NOOP("Tool", "the part is thinner than the voxels: choose smaller ones");
  if (error.code == VolumeErrors::TooLarge)
    return QT_TRANSLATE_NOOP("Tool", "the voxels need more memory than there is left: choose larger ones");
  if (error.code == VolumeErrors::TooFine)
    return QT_TRANSLATE_NOOP("Tool", "the voxels are too small for a part of this size: choose larger ones");
  return QT_TRANSLATE_NOOP("Tool", "there are no triangles, or they have coordinates that are not numbers");
}

}  // namespace

double voxelFor(const VolumeRepairWish& wish, double usual) {
  constexpr double kAcrossWalls = 4.0;  // voxels; less than two lose a wall
  if (wish.voxel > 0.0) return wish.voxel;
  return wish.wall > 0.0 ? std::min(usual, wish.wall / kAcrossWalls) : usual;
}

MeshChange volumeRepairChange(const VolumeRepairWish& wish, NumberType numbers) {
  OperationValues values(volumeRepairOperation());
  if (wish.voxel > 0.0) values.setValid("voxel", wish.voxel);
  values.setValid("close-gaps", wish.gaps);
  values.setValid("wall", wish.wall);
  setNumbers(values, numbers);
  const auto distance = std::make_shared<std::optional<double>>();
  MeshChange change =
      explainedChange(volumeRepairOperation().title, [=](HalfEdgeMesh& mesh, Progress progress) -> const char* {
        const TriangleSoup surface = mesh.compact().soup;
        const VolumeRepairOptions options{
            .voxel = voxelFor(wish, usualVoxel(surface)), .gaps = wish.gaps, .numbers = numbers};
        Result<VolumeRepair> repair =
            repairByVolume(wish.wall > 0.0 ? wallsOf(surface, wish.wall) : surface, options, progress.part(0.0, 0.9));
        if (!repair) return repair.error().code == ErrorCode::Cancelled ? nullptr : reasonOf(repair.error());
        *distance = largestDistance(repair->mesh, mesh, progress.part(0.9, 1.0));
        if (progress.cancelled()) return nullptr;
        mesh = std::move(repair->mesh);
        return nullptr;
      });
  change.distance = distance;
  return asFix(std::move(change), StepWriter("by-volume").options(values).text());
}

}  // namespace handwheel
