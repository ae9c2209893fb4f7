// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/DocumentFile.h"
#include "document/volume/VolumeSnapshot.h"
#include "tools/volume/DrillOperation.h"
#include "volume/drilling/DrilledTriangles.h"

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace handwheel {

class MemoryNotice;

// The voxels that were made of triangles.
struct MadeVoxels {
  bool isHybrid = false;                                  // made only near the head
  std::size_t blocks = 0, mostBlocks = 0, mostBytes = 0;  // total, and maxima at one time
};

// The result of "handwheel drill".
struct DrillAnswer {
  DocumentFile file;
  std::string refusal;
  Drilled drilled;
  DrillSetup setup;
  double voxel = 0.0;
  std::shared_ptr<const VolumeSnapshot> before;  // content of a part that is a volume
  std::optional<MadeVoxels> made;                // voxels of any other part
  std::optional<DrilledTriangles> joined;        // triangles of the part with the hole, if a mesh is written
  std::string notJoined;                         // reason for writing the surface of all voxels instead
};

// Returns the reason why the hole cannot be cut into the triangles of the part; empty: it can.
std::string notJoinedReason(SubtractionProblem problem);
// Returns thrust and torque of each cycle, as CSV.
std::string drillForces(const Drilled& drilled);
// Returns the figures, as JSON and as text.
nlohmann::ordered_json drillReport(const DrillAnswer& done, const MemoryNotice& notice);
std::string drillText(const DrillAnswer& done);

}  // namespace handwheel
