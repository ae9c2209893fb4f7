// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/LayerSteps.h"

namespace handwheel {
namespace {

// Returns the volume with other layers, which may change these visible blocks.
LayerStep stepTo(const VolumeSnapshot& before, ClayLayers layers, const std::vector<VoxelIndex>& blocks) {
  auto after = std::make_shared<VolumeSnapshot>(before);
  const std::vector<VoxelIndex> changed = layers.show(blocks, after->volume);
  if (!changed.empty()) after->surface.update(after->volume, changed);
  after->layers = layers.all().empty() ? nullptr : std::make_shared<const ClayLayers>(std::move(layers));
  return {std::move(after), changed.size()};
}

std::vector<VoxelIndex> blocksOf(const VolumeSnapshot& volume, std::size_t layer) {
  return volume.layers->all()[layer].change->blocks();
}

}  // namespace

LayerStep withNewLayer(const VolumeSnapshot& before, const std::string& name) {
  ClayLayers layers = before.layers ? *before.layers : ClayLayers(before.volume);
  layers.add(name, before.volume);
  return stepTo(before, std::move(layers), {});
}

LayerStep withLayerNamed(const VolumeSnapshot& before, std::size_t layer, const std::string& name) {
  ClayLayers layers = *before.layers;
  layers.rename(layer, name);
  return stepTo(before, std::move(layers), {});
}

LayerStep withLayerShare(const VolumeSnapshot& before, std::size_t layer, double strength, bool isOn) {
  ClayLayers layers = *before.layers;
  layers.setShare(layer, strength, isOn);
  return stepTo(before, std::move(layers), blocksOf(before, layer));
}

LayerStep withoutLayer(const VolumeSnapshot& before, std::size_t layer) {
  ClayLayers layers = *before.layers;
  layers.remove(layer);
  return stepTo(before, std::move(layers), blocksOf(before, layer));
}

LayerStep withLayerMerged(const VolumeSnapshot& before, std::size_t layer) {
  ClayLayers layers = *before.layers;
  layers.mergeDown(layer);
  return stepTo(before, std::move(layers), {});
}

PreparedShare prepareShare(std::shared_ptr<const VolumeSnapshot> of, std::size_t layer, double strength, bool isOn) {
  LayerStep step = withLayerShare(*of, layer, strength, isOn);
  return {std::move(of), layer, strength, isOn, std::move(step)};
}

void recordStroke(const VolumeSnapshot& before, VolumeSnapshot& after) {
  if (!before.layers) return;
  ClayLayers layers = *before.layers;
  layers.record(before.volume, after.volume);
  after.layers = std::make_shared<const ClayLayers>(std::move(layers));
}

bool takesStrokes(const VolumeSnapshot& volume) {
  return !volume.layers || volume.layers->canBeSculpted();
}

}  // namespace handwheel
