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

// The voxels that were made from the triangles of a part.
struct MadeVoxels {
  bool isHybrid = false;                                  // true if voxels were made only near the drill head
  std::size_t blocks = 0, mostBlocks = 0, mostBytes = 0;  // all blocks made; the most blocks and bytes at one time
};

// The result of "handwheel drill".
struct DrillAnswer {
  DocumentFile file;
  std::string refusal;
  Drilled drilled;
  DrillSetup setup;
  double voxel = 0.0;
  std::shared_ptr<const VolumeSnapshot> before;  // content of the part, if it is a volume
  std::optional<MadeVoxels> made;                // voxels of any other part
  std::optional<DrilledTriangles> joined;        // triangles of the part with the hole, if a mesh was written
  std::string notJoined;                         // reason why the surface of all voxels was written instead
};

// Returns the reason why the hole cannot be cut into the triangles of the part. The text is empty if it can.
std::string notJoinedReason(SubtractionProblem problem);
// Returns the thrust and the torque of each cycle, as CSV.
std::string drillForces(const Drilled& drilled);
// Return the figures of a drilled hole, as JSON and as text.
nlohmann::ordered_json drillReport(const DrillAnswer& done, const MemoryNotice& notice);
std::string drillText(const DrillAnswer& done);

}  // namespace handwheel
