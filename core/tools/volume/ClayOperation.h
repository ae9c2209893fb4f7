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

// Sculpts a volume as clay along strokes of the hand.
const Operation& clayOperation();

// What the actions are called, in the order of ClayAction; English, context "Property".
std::span<const char* const> clayActionNames();

// The radii that a tool can have in the voxels of a volume, mm.
Limits clayRadii(const SparseVolume& volume);

// The tool as it begins on a part: as large as suits it, its planes of symmetry through the middle.
ClayBrush usualClayBrush(const VolumeSnapshot& part);

// The tool that the parameters describe. Error: VolumeErrors::ClayRadius.
Result<ClayBrush> clayBrushOf(const OperationValues& values, const VolumeSnapshot& part);

// The part with a layer of this name on top, on and with a strength of 1: the topmost one, if it is called so, or a new
// one. Errors: VolumeErrors::LayerBelow, TooManyLayers.
Result<std::shared_ptr<const VolumeSnapshot>> withLayerOnTop(const std::shared_ptr<const VolumeSnapshot>& part,
                                                             const std::string& name);

// Where the hand is in a stroke, by time.
using HandStroke = std::vector<HandPose>;

struct Sculpted {
  std::shared_ptr<const VolumeSnapshot> part;
  double added = 0.0;             // mm³
  double removed = 0.0;           // mm³
  std::size_t changedBlocks = 0;  // of the volume and of the mask
  double seconds = 0.0;           // of the strokes
};

// Leads a tool along strokes, one after the other, as the simulation of the window does with a hand that it keeps up
// with: its middle is where the hand is. They go on the topmost layer where there are layers. rate: places a second,
// Hz. A stroke takes in the poses themselves, too. Errors: VolumeErrors::LayerTakesNone, PathTooLong (kMostPlaces),
// StrokesTooLong (kMostRadii), TooLarge (once the volume takes more memory than the system has), NothingLeft,
// Cancelled.
Result<Sculpted> sculptAlong(const std::shared_ptr<const VolumeSnapshot>& part, const ClayBrush& brush,
                             const std::vector<HandStroke>& strokes, double rate, Progress progress);

}  // namespace handwheel
