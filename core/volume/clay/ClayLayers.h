// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/clay/ClayLayerChange.h"

#include <string>

namespace handwheel {

// A layer of clay: strokes that can be weakened, turned off and taken away.
struct ClayLayer {
  std::string name;       // UTF-8
  double strength = 1.0;  // 0 to 1, the share of the change that is visible
  bool isOn = true;
  std::shared_ptr<const ClayLayerChange> change;  // never null

  double share() const { return isOn ? strength : 0.0; }
};

// A volume and the layers on it, the lowest first. What is visible is the volume with the share of each layer, added in
// depths. A layer whose share is 1 and that finds below it what it was made on gives its own samples, bit for bit; one
// with a share of 0 changes nothing.
//
// A value; copies share the volumes.
class ClayLayers {
 public:
  static constexpr std::size_t kMostLayers = 256;
  static constexpr std::size_t kLongestName = 1000;  // bytes

  explicit ClayLayers(SparseVolume root) : m_root(std::move(root)) {}
  ClayLayers(SparseVolume root, std::vector<ClayLayer> layers) : m_root(std::move(root)), m_layers(std::move(layers)) {}

  const SparseVolume& root() const { return m_root; }
  const std::vector<ClayLayer>& all() const { return m_layers; }

  // Adds an empty layer on top. visible: visible() of these layers. There must be fewer than kMostLayers.
  void add(std::string name, const SparseVolume& visible);
  void rename(std::size_t layer, std::string name) { m_layers[layer].name = std::move(name); }
  // Blocks of what is visible may be others then: those that the layer changes. strength: 0 to 1.
  void setShare(std::size_t layer, double strength, bool isOn);
  void remove(std::size_t layer);
  // Makes a layer one with that below it, or with the volume: of both what is visible now. The result is on, with a
  // strength of 1; nothing visible changes.
  void mergeDown(std::size_t layer);
  // Whether strokes can go on the topmost layer: it is on, with a strength of 1. There must be one.
  bool canBeSculpted() const { return m_layers.back().share() == 1.0; }
  // Takes into the topmost layer, which can be sculpted, what a stroke has made of visible(). O(blocks that the layer
  // changes, and regions of 64³ voxels that the stroke does).
  void record(const SparseVolume& before, const SparseVolume& after);

  // What is visible of the first layers. On all threads of the arena.
  SparseVolume visible(std::size_t layers) const;
  SparseVolume visible() const { return visible(m_layers.size()); }
  // Makes these blocks of a volume those of visible(). Returns those that are others now. On all threads of the arena.
  std::vector<VoxelIndex> show(const std::vector<VoxelIndex>& blocks, SparseVolume& volume) const;

  // Of what the layers change.
  std::size_t bytes() const;

 private:
  SparseVolume::Content visibleContent(const VoxelIndex& block, std::size_t layers) const;

  SparseVolume m_root;
  std::vector<ClayLayer> m_layers;
};

}  // namespace handwheel
