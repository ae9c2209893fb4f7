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
#include <string>

namespace handwheel {

// The records of the holes drilled into a volume, in order of time.
using DrilledHoles = std::vector<std::shared_ptr<const DrillRecord>>;

// The value of a volume document.
struct VolumeSnapshot : Snapshot {
  SparseVolume volume;    // visible volume, with its layers
  VolumeSurface surface;  // surface of the volume
  // Protection from dabs, in the grid of the volume; null: none.
  std::shared_ptr<const ClayMask> mask;
  // Layers of the volume; null: none. A change of the volume that is not recorded in them merges and removes all of
  // them.
  std::shared_ptr<const ClayLayers> layers;
  std::string source;                // file that the volume was made from, UTF-8; empty: none
  std::shared_ptr<const Scan> scan;  // image that it was made from; null: none
  Segment segment;                   // segment of the scan
  DrilledHoles holes;
  // Holes that were drilled in an exercise; undo does not remove them. Null: none.
  std::shared_ptr<const TriedHoles> tried;
};

}  // namespace handwheel
