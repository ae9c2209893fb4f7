// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Snapshot.h"
#include "document/volume/Scan.h"
#include "volume/SparseVolume.h"
#include "volume/clay/ClayLayers.h"
#include "volume/clay/ClayMask.h"
#include "volume/drilling/DrillTries.h"
#include "volume/segment/Segment.h"
#include "volume/surface/VolumeSurface.h"

#include <memory>
#include <optional>
#include <string>

namespace handwheel {

// The records of the holes drilled into a volume, in chronological order.
using DrilledHoles = std::vector<std::shared_ptr<const DrillRecord>>;

// The content of a volume document.
struct VolumeSnapshot : Snapshot {
  SparseVolume volume;    // visible volume, including its layers
  VolumeSurface surface;  // surface of the volume
  // Mask that protects voxels from brush strokes, in the grid of the volume; null: nothing is protected.
  std::shared_ptr<const ClayMask> mask;
  // Layers of the volume; null: none. A change of the volume that is not recorded in the layers merges all of them into
  // it and removes them.
  std::shared_ptr<const ClayLayers> layers;
  std::string source;                // file from which the volume was made, UTF-8; empty: none
  std::shared_ptr<const Scan> scan;  // image from which the volume was made; null: none
  Segment segment;                   // segment of the scan
  // Segment that the volume was made from, whatever was done to the volume since; none: an unknown earlier one.
  std::optional<Segment> madeFrom = Segment();
  DrilledHoles holes;
  // Holes that were drilled in an exercise; null: none. Undo does not remove them.
  std::shared_ptr<const TriedHoles> tried;

  // Returns true if the segment of the scan was changed after the volume was made from it.
  bool isOlderThanSegment() const { return scan && madeFrom != segment; }
};

}  // namespace handwheel
