// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/volume/VolumeEdit.h"

#include <string>

namespace handwheel {

// A volume after a change of its layers, to become one undo step.
struct LayerStep {
  std::shared_ptr<const VolumeSnapshot> volume;
  std::size_t changedBlocks = 0;  // of what is visible

  // property: as that of VolumeEdit.
  std::unique_ptr<VolumeEdit> edit(std::string property = {}) const {
    return std::make_unique<VolumeEdit>(volume, changedBlocks, std::move(property));
  }
};

// Adds an empty layer on top. There must be fewer than ClayLayers::kMostLayers.
LayerStep withNewLayer(const VolumeSnapshot& before, const std::string& name);
// The others ask for the number of a layer that is there. O(blocks that it changes).
LayerStep withLayerNamed(const VolumeSnapshot& before, std::size_t layer, const std::string& name);
// strength: 0 to 1.
LayerStep withLayerShare(const VolumeSnapshot& before, std::size_t layer, double strength, bool isOn);
LayerStep withoutLayer(const VolumeSnapshot& before, std::size_t layer);
// As ClayLayers::mergeDown(): what is visible stays.
LayerStep withLayerMerged(const VolumeSnapshot& before, std::size_t layer);

// A step of a layer's share that was computed ahead, on any thread: VolumeDocument::prepare().
struct PreparedShare {
  std::shared_ptr<const VolumeSnapshot> of;  // the volume before
  std::size_t layer = 0;
  double strength = 1.0;
  bool isOn = true;
  LayerStep step;
};
PreparedShare prepareShare(std::shared_ptr<const VolumeSnapshot> of, std::size_t layer, double strength, bool isOn);

// Takes what a stroke has made of the visible volume into the topmost layer, which must take strokes. Nothing where
// there are no layers.
void recordStroke(const VolumeSnapshot& before, VolumeSnapshot& after);
// Whether a stroke can change the volume: there is no layer, or the topmost one takes it.
bool takesStrokes(const VolumeSnapshot& volume);

}  // namespace handwheel
