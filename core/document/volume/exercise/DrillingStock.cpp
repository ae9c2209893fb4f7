// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/exercise/DrillingStock.h"

#include "base/JsonFields.h"
#include "base/JsonText.h"
#include "document/Container.h"
#include "volume/VolumeSerialization.h"
#include "volume/surface/DownsampledVolume.h"
#include "volume/surface/VolumeToSurface.h"

#include <QByteArray>
#include <QtEndian>
#include <mutex>
#include <utility>

namespace handwheel {

namespace {

// The surface of the volume, so that the exercise shows the same part as its work; a large volume is downsampled until
// a window can rotate it smoothly.
std::shared_ptr<const TriangleSoup> shownSurface(const SparseVolume& volume) {
  constexpr std::size_t kMostBlocks = 8'000;  // with a hundred triangles each, as surfaces go through them
  SparseVolume shown = volume;
  while (shown.blockCount() > kMostBlocks) shown = downsampledVolume(shown);
  return std::make_shared<const TriangleSoup>(surfaceOf(shown));
}

}  // namespace

struct DrillingStock::Shown {
  std::once_flag isMade;
  std::shared_ptr<const TriangleSoup> surface;
};

DrillingStock::DrillingStock(SparseVolume volume, std::shared_ptr<const nlohmann::json> json)
    : m_volume(std::move(volume)), m_json(std::move(json)), m_shown(std::make_shared<Shown>()) {}

std::shared_ptr<const TriangleSoup> DrillingStock::shown() const {
  std::call_once(m_shown->isMade, [this] { m_shown->surface = shownSurface(m_volume); });
  return m_shown->surface;
}

std::size_t stockBytes(const SparseVolume& volume) {
  constexpr std::size_t kRegionHead = 70;  // numbers before the samples of a region
  return sizeof(std::int16_t) * (kRegionHead * regionsOf(volume).size() + VolumeBlock::kCount * volume.blockCount());
}

DrillingStock stockOf(const SparseVolume& volume) {
  std::vector<std::int16_t> numbers;
  for (const VoxelIndex& region : regionsOf(volume)) appendRegion(volume, region, numbers);
  const QByteArray data = qCompress(QByteArray::fromStdString(toBlob(numbers)), 6).toBase64();
  nlohmann::json json = {{"voxel", volume.voxel()},
                         {"origin", {volume.origin().x(), volume.origin().y(), volume.origin().z()}},
                         {"data", data.toStdString()}};
  return {volume, std::make_shared<const nlohmann::json>(std::move(json))};
}

Result<DrillingStock> stockFrom(const nlohmann::json& json) {
  const Error malformed{ErrorCode::ElementMalformed, {"stock", "it is not a volume"}, {}, {}};
  double voxel = 0.0;
  JsonFieldReader{json}("voxel", voxel);
  const std::vector<double> origin = numbersAt(json, "origin", 3);
  const QByteArray packed = QByteArray::fromBase64(QByteArray::fromStdString(stringAt(json, "data")));
  constexpr qsizetype kHead = 4;  // the unpacked size, in front of what zlib made
  if (!(voxel > 1e-9 && voxel < 1e9) || origin.size() != 3 || packed.size() < kHead) return malformed;
  // Checked before unpacking: zlib data unpack to at most 1032 times their size.
  const auto size = qFromBigEndian<std::uint32_t>(packed.constData());
  if (size > kLargestStock || size / 1032 > static_cast<std::uint64_t>(packed.size())) return malformed;
  SparseVolume volume({origin[0], origin[1], origin[2]}, voxel);
  const std::vector<std::int16_t> numbers = fromBlob<std::int16_t>(qUncompress(packed).toStdString());
  if (!volume.origin().allFinite() || volume.origin().norm() > 1e12 || numbers.empty() ||
      !readRegions(numbers, volume) || !closeOff(volume, numbers.size()))
    return malformed;
  return DrillingStock(std::move(volume), std::make_shared<const nlohmann::json>(json));
}

}  // namespace handwheel
