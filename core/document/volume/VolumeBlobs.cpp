// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/VolumeBlobs.h"

#include "document/volume/VolumeChunks.h"
#include "volume/VolumeSerialization.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace handwheel {
namespace {

constexpr const char *kChunks = "volume/chunks/", *kMaskChunks = "mask/";

// Returns the number of chunks in an object; none if it is malformed, which is added to the damage.
std::optional<std::size_t> countOf(const nlohmann::json& object, const char* name, std::vector<Error>& damage) {
  const std::optional<std::size_t> count = chunkCountOf(object.value("chunks", nlohmann::json()));
  if (!count) damage.push_back({ErrorCode::ElementMalformed, {name, "it is not a number of chunks"}, {}, {}});
  return count;
}

void reportLost(const char* name, std::size_t lost, std::vector<Error>& damage) {
  if (lost == 0) return;
  const std::string text = std::to_string(lost) + " of its chunks are lost, or end early";
  damage.push_back({ErrorCode::ElementMalformed, {name, text}, {}, {}});
}

}  // namespace

void writeVolume(const SparseVolume& volume, Container& container) {
  nlohmann::json& document = (*container.manifest)["document"];
  if (!document.is_object()) document = nlohmann::json::object();
  document.update(gridOf(volume));
  document["chunks"] = writeChunks(volume, kChunks, container);
}

Result<SparseVolume> readVolume(const Container& container, std::vector<Error>& damage, Progress progress) {
  const auto found = container.manifest->find("document");
  if (found == container.manifest->end() || !found->is_object())
    return Error{ErrorCode::ElementMalformed, {"document", "it is missing"}, {}, {}};
  const nlohmann::json voxel = found->value("voxel", nlohmann::json()),
                       origin = found->value("origin", nlohmann::json());
  if (!voxel.is_number() || !(voxel.get<double>() > 1e-9) || !(voxel.get<double>() < 1e9))
    return Error{ErrorCode::ElementMalformed, {"document.voxel", "it is not the size of a voxel"}, {}, {}};
  Vec3 corner = Vec3::Zero();
  bool isPosition = origin.is_array() && origin.size() == 3;
  for (std::size_t k = 0; k < 3 && isPosition; ++k) {
    isPosition = origin[k].is_number() && std::abs(origin[k].get<double>()) < 1e12;
    if (isPosition) corner[static_cast<Eigen::Index>(k)] = origin[k].get<double>();
  }
  if (!isPosition) return Error{ErrorCode::ElementMalformed, {"document.origin", "it is no place"}, {}, {}};

  SparseVolume volume(corner, voxel.get<double>());
  const std::optional<std::size_t> chunks = countOf(*found, "document.chunks", damage);
  const ChunksRead read = readChunks(container, kChunks, chunks, volume, progress);
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  reportLost("volume", read.lost, damage);
  // The limit is that of other arrays of a container: at most 64 times its bytes.
  if (!closeOff(volume, 64 * read.bytes / sizeof(VolumeBlock)))
    return Error{ErrorCode::ElementMalformed, {"volume", "full and empty blocks have no surface between them"}, {}, {}};
  return volume;
}

void writeMask(const ClayMask& mask, Container& container) {
  nlohmann::json written = gridOf(mask.values());
  written["chunks"] = writeChunks(mask.values(), kMaskChunks, container);
  written["inverted"] = mask.isInverted();
  (*container.manifest)["document"]["mask"] = std::move(written);
}

std::shared_ptr<const ClayMask> readMask(const Container& container, const SparseVolume& volume,
                                         std::vector<Error>& damage) {
  const nlohmann::json found = (*container.manifest)["document"].value("mask", nlohmann::json());
  if (found.is_null()) return nullptr;
  const nlohmann::json inverted = found.is_object() ? found.value("inverted", nlohmann::json()) : nlohmann::json();
  if (!inverted.is_boolean()) {
    damage.push_back({ErrorCode::ElementMalformed, {"document.mask", "it is impossible"}, {}, {}});
    return nullptr;
  }
  const nlohmann::json grid = gridOf(volume);
  if (found.value("voxel", nlohmann::json()) != grid["voxel"] ||
      found.value("origin", nlohmann::json()) != grid["origin"])
    return nullptr;
  SparseVolume values(volume.origin(), volume.voxel());
  const std::optional<std::size_t> chunks = countOf(found, "document.mask.chunks", damage);
  reportLost("mask", readChunks(container, kMaskChunks, chunks, values, {}).lost, damage);
  auto mask = std::make_shared<ClayMask>(std::move(values), inverted.get<bool>());
  return mask->isFree() ? nullptr : std::move(mask);
}

}  // namespace handwheel
