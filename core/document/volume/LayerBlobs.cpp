// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/LayerBlobs.h"

#include "document/volume/VolumeChunks.h"
#include "volume/VolumeDifference.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace handwheel {
namespace {

using Json = nlohmann::json;

constexpr const char* kLayersFolder = "document/layers/";

std::string layerFolder(std::size_t layer, const char* what) {
  return kLayersFolder + std::to_string(layer) + "/" + what + "/";
}

std::string rootFolder() {
  return std::string(kLayersFolder) + "root/";
}

std::vector<VoxelIndex> blocksOfAll(const std::vector<ClayLayer>& layers) {
  std::vector<VoxelIndex> blocks;
  for (const ClayLayer& layer : layers)
    blocks.insert(blocks.end(), layer.change->blocks().begin(), layer.change->blocks().end());
  std::sort(blocks.begin(), blocks.end(), isBlockBefore);
  blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
  return blocks;
}

// Returns a hash of the blocks (FNV-1a), to detect that they were changed after the layers were saved.
std::string fingerprintOf(const SparseVolume& volume, const std::vector<VoxelIndex>& blocks) {
  std::uint64_t hash = 14695981039346656037u;
  const auto take = [&](std::uint64_t number) { hash = (hash ^ number) * 1099511628211u; };
  for (const VoxelIndex& block : blocks) {
    const SparseVolume::View view = volume.view(block);
    take(view.block ? 2 : view.isFull ? 1 : 0);
    if (!view.block) continue;
    for (const std::int16_t depth : view.block->depths) take(static_cast<std::uint16_t>(depth));
  }
  return std::to_string(hash);
}

// Shares blocks that equal those of another volume with it, to save memory.
void shareBlocks(SparseVolume& volume, const std::vector<VoxelIndex>& blocks, const SparseVolume& other) {
  for (const VoxelIndex& block : blocks)
    if (isSameContent(volume.view(block), other.view(block))) volume.setContent(block, other.content(block));
}

// Reads the blocks of a folder that an object of the manifest counts. False where they are not all there.
bool readBlocks(const Container& container, const Json& object, const char* count, const std::string& folder,
                SparseVolume& volume, std::size_t& bytes) {
  const std::optional<std::size_t> chunks = chunkCountOf(object.value(count, Json()));
  if (!chunks || *chunks > container.blobs.size()) return false;
  const ChunksRead read = readChunks(container, folder, chunks, volume, {});
  bytes += read.bytes;
  return read.lost == 0;
}

// Returns the layer that an object of the manifest describes; none if it is malformed.
std::optional<ClayLayer> readLayer(const Container& container, const Json& object, std::size_t number,
                                   const SparseVolume& visible) {
  if (!object.is_object()) return std::nullopt;
  const Json name = object.value("name", Json()), strength = object.value("strength", Json()),
             isOn = object.value("on", Json());
  if (!name.is_string() || !strength.is_number() || !isOn.is_boolean()) return std::nullopt;
  ClayLayer layer{name.get<std::string>(), strength.get<double>(), isOn.get<bool>(), nullptr};
  if (layer.name.size() > ClayLayers::kLongestName || !(layer.strength >= 0.0 && layer.strength <= 1.0))
    return std::nullopt;
  SparseVolume base(visible.origin(), visible.voxel()), top = base;
  std::size_t bytes = 0;
  if (!readBlocks(container, object, "base_chunks", layerFolder(number, "base"), base, bytes)) return std::nullopt;
  if (!readBlocks(container, object, "top_chunks", layerFolder(number, "top"), top, bytes)) return std::nullopt;
  const std::vector<VoxelIndex> blocks = differingBlocks(base, top);
  // The limit is that of other arrays of a container: at most 64 times its bytes. Distances take four times that when
  // they are computed.
  if (blocks.size() > 64 * bytes / sizeof(VolumeBlock)) return std::nullopt;
  shareBlocks(top, blocks, visible);
  layer.change = std::make_shared<const ClayLayerChange>(base, top);
  return layer;
}

// Returns null and sets the problem if they are malformed.
std::shared_ptr<const ClayLayers> layersIn(const Container& container, const Json& found, const SparseVolume& visible,
                                           std::string& problem) {
  const Json layers = found.is_object() ? found.value("stack", Json()) : Json();
  if (!layers.is_array() || layers.empty() || layers.size() > ClayLayers::kMostLayers) return nullptr;
  if (found.value("voxel", Json()) != gridOf(visible)["voxel"] ||
      found.value("origin", Json()) != gridOf(visible)["origin"])
    return nullptr;
  std::vector<ClayLayer> read;
  for (const Json& object : layers) {
    std::optional<ClayLayer> layer = readLayer(container, object, read.size(), visible);
    if (!layer) return nullptr;
    read.push_back(std::move(*layer));
  }
  SparseVolume below(visible.origin(), visible.voxel());
  std::size_t bytes = 0;
  if (!readBlocks(container, found, "root_chunks", rootFolder(), below, bytes)) return nullptr;
  const std::vector<VoxelIndex> blocks = blocksOfAll(read);
  if (found.value("visible", Json()) != fingerprintOf(visible, blocks)) {
    problem = "the volume was changed without them";
    return nullptr;
  }
  SparseVolume root = visible;
  for (const VoxelIndex& block : blocks) root.setContent(block, below.content(block));
  return std::make_shared<const ClayLayers>(std::move(root), std::move(read));
}

}  // namespace

void writeLayers(const ClayLayers& layers, const SparseVolume& visible, Container& container) {
  const std::vector<VoxelIndex> blocks = blocksOfAll(layers.all());
  Json written = gridOf(visible);
  written["root_chunks"] = writeChunks(onlyBlocks(layers.root(), blocks), rootFolder(), container);
  written["visible"] = fingerprintOf(visible, blocks);
  written["stack"] = Json::array();
  for (std::size_t i = 0; i < layers.all().size(); ++i) {
    const ClayLayer& layer = layers.all()[i];
    const auto write = [&](const SparseVolume& volume, const char* what) {
      return writeChunks(volume, layerFolder(i, what), container);
    };
    written["stack"].push_back({{"name", layer.name},
                                {"strength", layer.strength},
                                {"on", layer.isOn},
                                {"base_chunks", write(layer.change->base(), "base")},
                                {"top_chunks", write(layer.change->top(), "top")}});
  }
  (*container.manifest)["document"]["layers"] = std::move(written);
}

std::shared_ptr<const ClayLayers> readLayers(const Container& container, const SparseVolume& visible,
                                             std::vector<Error>& damage) {
  const Json found = (*container.manifest)["document"].value("layers", Json());
  if (found.is_null()) return nullptr;
  std::string problem = "it is impossible";
  std::shared_ptr<const ClayLayers> layers = layersIn(container, found, visible, problem);
  if (!layers) damage.push_back({ErrorCode::ElementMalformed, {"document.layers", problem}, {}, {}});
  return layers;
}

}  // namespace handwheel
