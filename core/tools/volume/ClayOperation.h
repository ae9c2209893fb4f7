// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "document/Operation.h"
#include "document/volume/VolumeSnapshot.h"
#include "haptics/device/PoseTrajectory.h"
#include "simulation/clay/ClayStroke.h"
#include "tools/ToolProperty.h"

#include <span>

namespace handwheel {

// Returns the operation that sculpts a volume as clay along strokes of the hand.
const Operation& clayOperation();

// Returns the names of the actions, in the order of ClayAction. They are English text, translated in the context
// "Property".
std::span<const char* const> clayActionNames();

// Returns the limits of a tool's radius for a volume, mm; they depend on its voxels.
Limits clayRadii(const SparseVolume& volume);

// Returns the initial tool for a part. It has a suitable size, and planes of symmetry through the centre of the part.
ClayBrush usualClayBrush(const VolumeSnapshot& part);

// Returns the tool that the parameters describe. Error: VolumeErrors::ClayRadius.
Result<ClayBrush> clayBrushOf(const OperationValues& values, const VolumeSnapshot& part);

// Returns the part with a layer of this name on top, which is on and has a strength of 1. It is the topmost layer if
// that has this name, or else a new one. Errors: VolumeErrors::LayerBelow, TooManyLayers.
Result<std::shared_ptr<const VolumeSnapshot>> withLayerOnTop(const std::shared_ptr<const VolumeSnapshot>& part,
                                                             const std::string& name);

// The poses of the hand during a stroke, in chronological order.
using HandStroke = std::vector<HandPose>;

struct Sculpted {
  std::shared_ptr<const VolumeSnapshot> part;
  double added = 0.0;             // mm³
  double removed = 0.0;           // mm³
  std::size_t changedBlocks = 0;  // number of changed blocks of the volume and of the mask
  double seconds = 0.0;           // duration of the strokes
};

// Moves a tool along strokes, one after the other, like the simulation of the window for a slow hand: the centre of the
// tool is at the hand. If there are layers, the topmost one records the strokes. rate: number of sampled positions per
// second; the poses themselves are sampled, too. Errors: VolumeErrors::LayerTakesNone, PathTooLong (more than 10
// million samples), StrokesTooLong (more than a million radii of the tool), TooLarge (if the volume takes more memory
// than the system has), NothingLeft; Cancelled.
Result<Sculpted> sculptAlong(const std::shared_ptr<const VolumeSnapshot>& part, const ClayBrush& brush,
                             const std::vector<HandStroke>& strokes, double rate, Progress progress);

}  // namespace handwheel
