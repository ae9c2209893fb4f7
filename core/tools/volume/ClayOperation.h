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

// Returns the names of the actions, in the order of ClayAction; English, context "Property".
std::span<const char* const> clayActionNames();

// Returns the limits of a tool's radius for the voxels of a volume, mm.
Limits clayRadii(const SparseVolume& volume);

// Returns the initial tool for a part: of a suitable size, with its planes of symmetry through the centre.
ClayBrush usualClayBrush(const VolumeSnapshot& part);

// Returns the tool that the parameters describe. Error: VolumeErrors::ClayRadius.
Result<ClayBrush> clayBrushOf(const OperationValues& values, const VolumeSnapshot& part);

// Returns the part with a layer of this name on top, on and with a strength of 1: the topmost one if it has this name,
// or else a new one. Errors: VolumeErrors::LayerBelow, TooManyLayers.
Result<std::shared_ptr<const VolumeSnapshot>> withLayerOnTop(const std::shared_ptr<const VolumeSnapshot>& part,
                                                             const std::string& name);

// The poses of the hand during a stroke, in order of time.
using HandStroke = std::vector<HandPose>;

struct Sculpted {
  std::shared_ptr<const VolumeSnapshot> part;
  double added = 0.0;             // mm³
  double removed = 0.0;           // mm³
  std::size_t changedBlocks = 0;  // number of changed blocks of the volume and of the mask
  double seconds = 0.0;           // duration of the strokes
};

// Moves a tool along strokes, one after the other, as the simulation of the window does for a hand that it can follow:
// the centre of the tool is at the hand. If there are layers, the topmost one records the strokes. rate: sampled
// positions per second, Hz; the poses themselves are sampled, too. Errors: VolumeErrors::LayerTakesNone, PathTooLong
// (kMostSamples), StrokesTooLong (kMostRadii), TooLarge (once the volume takes more memory than the system has),
// NothingLeft, Cancelled.
Result<Sculpted> sculptAlong(const std::shared_ptr<const VolumeSnapshot>& part, const ClayBrush& brush,
                             const std::vector<HandStroke>& strokes, double rate, Progress progress);

}  // namespace handwheel
