// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/VolumeEdit.h"

#include <string>

namespace handwheel {

// A volume after a change of its layers, for one undo step. The functions that change a layer take the index of an
// existing one, and cost O(blocks that the layer changes).
struct LayerStep {
  std::shared_ptr<const VolumeSnapshot> volume;
  std::size_t changedBlocks = 0;  // number of changed blocks of the visible volume

  // Returns the edit for the step. property: see VolumeEdit.
  std::unique_ptr<VolumeEdit> edit(std::string property = {}) const {
    return std::make_unique<VolumeEdit>(volume, changedBlocks, std::move(property));
  }
};

// Adds an empty layer on top. The volume must have fewer than ClayLayers::kMostLayers layers.
LayerStep withNewLayer(const VolumeSnapshot& before, const std::string& name);
// Renames a layer.
LayerStep withLayerNamed(const VolumeSnapshot& before, std::size_t layer, const std::string& name);
// Sets the strength of a layer, 0 to 1, and turns it on or off.
LayerStep withLayerShare(const VolumeSnapshot& before, std::size_t layer, double strength, bool isOn);
LayerStep withoutLayer(const VolumeSnapshot& before, std::size_t layer);
// Merges a layer with the one below by ClayLayers::mergeDown(). The visible volume does not change.
LayerStep withLayerMerged(const VolumeSnapshot& before, std::size_t layer);

// A change of a layer's share, which is its strength and whether it is on, for VolumeDocument::prepare(). It is
// computed in advance by prepareShare(), on any thread.
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
// Returns true if strokes can change the volume: it has no layers, or its topmost layer accepts strokes.
bool takesStrokes(const VolumeSnapshot& volume);

}  // namespace handwheel
