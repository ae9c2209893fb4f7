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
  bool isHybrid = false;                                  // near the head only
  std::size_t blocks = 0, mostBlocks = 0, mostBytes = 0;  // in all, and at once
};

// What "handwheel drill" has done.
struct DrillAnswer {
  DocumentFile file;
  std::string refusal;
  Drilled drilled;
  DrillSetup setup;
  double voxel = 0.0;
  std::shared_ptr<const VolumeSnapshot> before;  // of a part that is a volume
  std::optional<MadeVoxels> made;                // of any other
  std::optional<DrilledTriangles> joined;        // the triangles of the part with the hole, where a mesh is written
  std::string notJoined;                         // why it is the surface of all voxels
};

// Why the hole is not in the triangles of the part; empty where nothing hinders it.
std::string notJoinedReason(SubtractionProblem problem);
// Thrust and torque of each cycle, as CSV.
std::string drillForces(const Drilled& drilled);
// The figures, as JSON and in words.
nlohmann::ordered_json drillReport(const DrillAnswer& done, const MemoryNotice& notice);
std::string drillText(const DrillAnswer& done);

}  // namespace handwheel
