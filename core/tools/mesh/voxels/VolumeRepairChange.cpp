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
#include "volume/repair/VolumeRepair.h"

#include <QtGlobal>
#include <optional>

namespace handwheel {
namespace {

const char* reasonOf(const Error& error) {
  if (error.code == VolumeErrors::NothingInside)
    return QT_TRANSLATE_NOOP("Tool", "the surface encloses nothing, even with its holes closed");
  if (error.code == VolumeErrors::NoVoxelInside)
    return QT_TRANSLATE_NOOP("Tool", "the part is thinner than the voxels: choose smaller ones");
  if (error.code == VolumeErrors::TooLarge)
    return QT_TRANSLATE_NOOP("Tool", "the voxels need more memory than there is left: choose larger ones");
  if (error.code == VolumeErrors::TooFine)
    return QT_TRANSLATE_NOOP("Tool", "the voxels are too small for a part of this size: choose larger ones");
  return QT_TRANSLATE_NOOP("Tool", "there are no triangles, or they have coordinates that are not numbers");
}

}  // namespace

MeshChange volumeRepairChange(double voxel, double gaps, NumberType numbers) {
  OperationValues values(volumeRepairOperation());
  if (voxel > 0.0) values.setValid("voxel", voxel);
  values.setValid("close-gaps", gaps);
  setNumbers(values, numbers);
  const auto distance = std::make_shared<std::optional<double>>();
  MeshChange change =
      explainedChange(volumeRepairOperation().title, [=](HalfEdgeMesh& mesh, Progress progress) -> const char* {
        const TriangleSoup surface = mesh.compact().soup;
        const VolumeRepairOptions options{
            .voxel = voxel > 0.0 ? voxel : usualVoxel(surface), .gaps = gaps, .numbers = numbers};
        Result<VolumeRepair> repair = repairByVolume(surface, options, progress.part(0.0, 0.9));
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
