// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "cli/Arguments.h"
#include "cli/Input.h"
#include "mesh/defects/MeshReport.h"
#include "mesh/measure/Deviation.h"
#include "volume/repair/VolumeRepair.h"

#include <filesystem>
#include <optional>

namespace handwheel {

class MemoryNotice;

// The parameters of the repair of one file by the volume that it encloses.
struct VolumeRepairRequest {
  std::filesystem::path input, output;
  ReadOptions read;
  std::optional<double> voxel;  // mm
  double gaps = 0.0;            // mm; gaps that a ball of this radius cannot enter are filled; 0: none
  double wall = 0.0;            // thickness of walls made of the triangles, mm; 0: the triangles enclose the volume
  FidelityValues values;
};

// The result of a repair by volume.
struct RepairedByVolume {
  VolumeRepair repair;
  double voxel = 0.0;   // mm
  Deviation deviation;  // deviation of the result from the input
  MeshReport after;
};

// Returns true if the mesh is free of defects, and no material was lost with walls that the voxels do not resolve.
bool isSound(const RepairedByVolume& repaired);

// Returns the options of 'repair' by volume.
std::vector<OptionSpec> volumeRepairOptions();

// Parses the arguments of a repair by volume. Options of other repairs are not examined. Returns an error as a
// sentence, or an empty string.
std::string readVolumeRequest(const Arguments& arguments, VolumeRepairRequest& request);

// Repairs the input and writes nothing. Errors: the errors of repairByVolume(), deviation() and MemoryNotice::begin();
// Unsupported if the output is a document and the input is not a mesh.
Result<RepairedByVolume> repairInputByVolume(const Input& input, const VolumeRepairRequest& request,
                                             MemoryNotice& notice, Progress progress);

// Writes the result in the format of the output. Errors: the errors of writeMesh() and exportMesh().
Status writeRepairedByVolume(const Input& input, const RepairedByVolume& repaired, const VolumeRepairRequest& request,
                             Progress progress);

// Repairs one file by the volume that it encloses. Returns the exit code.
int runRepairByVolume(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
