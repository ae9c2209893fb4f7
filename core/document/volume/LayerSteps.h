// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/VolumeEdit.h"

#include <string>

namespace handwheel {

// A volume after a change of its layers, to become one undo step.
struct LayerStep {
  std::shared_ptr<const VolumeSnapshot> volume;
  std::size_t changedBlocks = 0;  // number of changed blocks of the visible volume

  // property: see VolumeEdit.
  std::unique_ptr<VolumeEdit> edit(std::string property = {}) const {
    return std::make_unique<VolumeEdit>(volume, changedBlocks, std::move(property));
  }
};

// Adds an empty layer on top. There must be fewer than ClayLayers::kMostLayers.
LayerStep withNewLayer(const VolumeSnapshot& before, const std::string& name);
// The following functions take the index of an existing layer. O(blocks that it changes).
LayerStep withLayerNamed(const VolumeSnapshot& before, std::size_t layer, const std::string& name);
// strength: 0 to 1.
LayerStep withLayerShare(const VolumeSnapshot& before, std::size_t layer, double strength, bool isOn);
LayerStep withoutLayer(const VolumeSnapshot& before, std::size_t layer);
// Merges a layer with the one below, as ClayLayers::mergeDown(); the visible volume does not change.
LayerStep withLayerMerged(const VolumeSnapshot& before, std::size_t layer);

// A change of a layer's share that was computed in advance, on any thread, for VolumeDocument::prepare().
struct PreparedShare {
  std::shared_ptr<const VolumeSnapshot> of;  // volume before the change
  std::size_t layer = 0;
  double strength = 1.0;
  bool isOn = true;
  LayerStep step;
};
PreparedShare prepareShare(std::shared_ptr<const VolumeSnapshot> of, std::size_t layer, double strength, bool isOn);

// Records the change of the visible volume by a stroke in the topmost layer, which must accept strokes. Does nothing if
// there are no layers.
void recordStroke(const VolumeSnapshot& before, VolumeSnapshot& after);
// Returns true if a stroke can change the volume: there is no layer, or the topmost one accepts strokes.
bool takesStrokes(const VolumeSnapshot& volume);

}  // namespace handwheel
