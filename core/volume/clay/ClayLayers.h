// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/clay/ClayLayerChange.h"

#include <string>

namespace handwheel {

// A layer of clay: strokes that can be weakened, turned off and removed together.
struct ClayLayer {
  std::string name;       // UTF-8
  double strength = 1.0;  // fraction of the change that is visible, 0 to 1
  bool isOn = true;
  std::shared_ptr<const ClayLayerChange> change;  // never null

  double share() const { return isOn ? strength : 0.0; }
};

// A volume and the layers on it, the lowest first. The visible volume is the root plus the visible fraction (share) of
// each layer's change, added to the depths. If the blocks below a layer are those on which it was made, a share
// of 1 reproduces the samples of its strokes exactly. A layer with a share of 0 changes nothing.
//
// A value type; copies share the volumes.
class ClayLayers {
 public:
  static constexpr std::size_t kMostLayers = 256;
  static constexpr std::size_t kLongestName = 1000;  // bytes

  explicit ClayLayers(SparseVolume root) : m_root(std::move(root)) {}
  ClayLayers(SparseVolume root, std::vector<ClayLayer> layers) : m_root(std::move(root)), m_layers(std::move(layers)) {}

  const SparseVolume& root() const { return m_root; }
  const std::vector<ClayLayer>& all() const { return m_layers; }

  // Adds an empty layer on top. visible: the current visible(). There must be fewer than kMostLayers layers.
  void add(std::string name, const SparseVolume& visible);
  void rename(std::size_t layer, std::string name) { m_layers[layer].name = std::move(name); }
  // Sets the strength (0 to 1) of a layer and turns it on or off. This may change visible() in the blocks that the
  // layer changes.
  void setShare(std::size_t layer, double strength, bool isOn);
  void remove(std::size_t layer);
  // Merges the visible part of a layer with that of the layer below, or with the root. The resulting layer is on and
  // has a strength of 1; the visible volume does not change.
  void mergeDown(std::size_t layer);
  // Returns true if the topmost layer accepts strokes: it must be on and have a strength of 1. There must be a layer.
  bool canBeSculpted() const { return m_layers.back().share() == 1.0; }
  // Records the change of visible() by a stroke in the topmost layer, which must accept strokes. O(blocks that the
  // layer changes + regions of 64³ voxels that the stroke changes).
  void record(const SparseVolume& before, const SparseVolume& after);

  // Returns the visible volume of the root and the lowest `layers` layers. Runs on all threads of the arena.
  SparseVolume visible(std::size_t layers) const;
  SparseVolume visible() const { return visible(m_layers.size()); }
  // Sets these blocks of a volume to those of visible(). Returns the blocks that changed. Runs on all threads of the
  // arena.
  std::vector<VoxelIndex> show(const std::vector<VoxelIndex>& blocks, SparseVolume& volume) const;

  // Returns the memory of the layers' changes, bytes.
  std::size_t bytes() const;

 private:
  SparseVolume::Content visibleContent(const VoxelIndex& block, std::size_t layers) const;

  SparseVolume m_root;
  std::vector<ClayLayer> m_layers;
};

}  // namespace handwheel
