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

// The records of the holes drilled into a volume, the first one first.
using DrilledHoles = std::vector<std::shared_ptr<const DrillRecord>>;

// The value of a volume document.
struct VolumeSnapshot : Snapshot {
  SparseVolume volume;    // with its layers, as it is visible
  VolumeSurface surface;  // of the volume
  // What is protected from dabs, in the grid of the volume; null: nothing.
  std::shared_ptr<const ClayMask> mask;
  // Null: there are none. A change of the volume that is not recorded in them applies them all: it leaves none.
  std::shared_ptr<const ClayLayers> layers;
  std::string source;                // the file that it was made from, UTF-8; empty where there is none
  std::shared_ptr<const Scan> scan;  // that it was made from; null: there is none
  Segment segment;                   // what is chosen of the scan
  DrilledHoles holes;
  // The holes that were drilled in work on an exercise: no undo takes one back. Null: none.
  std::shared_ptr<const TriedHoles> tried;
};

}  // namespace handwheel
