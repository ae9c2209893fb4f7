// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/exercise/StockText.h"

#include "base/JsonFields.h"
#include "base/JsonText.h"
#include "document/Container.h"
#include "volume/VolumeRegions.h"
#include "volume/VolumeResampling.h"
#include "volume/surface/VolumeToSurface.h"

#include <QByteArray>
#include <QtEndian>
#include <algorithm>

namespace handwheel {

namespace {

// In voxels by which a teacher sees where to plan the path, and which cost no more than a frame or two of the window.
std::shared_ptr<const TriangleSoup> shownSurface(const SparseVolume& volume) {
  constexpr double kMostAcross = 96.0;
  constexpr int kRegion = 64;
  Eigen::AlignedBox3i regions;
  for (const VoxelIndex& region : regionsOf(volume)) regions.extend(region);
  const double across = regions.isEmpty() ? 0.0 : kRegion * (regions.sizes().maxCoeff() + 1);
  const double voxel = volume.voxel() * std::max(1.0, across / kMostAcross);
  const Result<SparseVolume> coarse = resampled(volume, volume.origin(), voxel);
  return std::make_shared<const TriangleSoup>(coarse ? surfaceOf(*coarse) : TriangleSoup());
}

}  // namespace

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
  return {volume, std::make_shared<const nlohmann::json>(std::move(json)), shownSurface(volume)};
}

Result<DrillingStock> stockFrom(const nlohmann::json& json) {
  const Error malformed{ErrorCode::ElementMalformed, {"stock", "it is not a volume"}, {}, {}};
  double voxel = 0.0;
  JsonFieldReader{json}("voxel", voxel);
  const std::vector<double> origin = numbersAt(json, "origin", 3);
  const QByteArray packed = QByteArray::fromBase64(QByteArray::fromStdString(stringAt(json, "data")));
  constexpr qsizetype kHead = 4;  // the unpacked size, in front of what zlib made
  if (!(voxel > 1e-9 && voxel < 1e9) || origin.size() != 3 || packed.size() < kHead) return malformed;
  // Before it is trusted: no data of zlib unpack to more than 1032 times their size.
  const auto size = qFromBigEndian<std::uint32_t>(packed.constData());
  if (size > kLargestStock || size / 1032 > static_cast<std::uint64_t>(packed.size())) return malformed;
  SparseVolume volume({origin[0], origin[1], origin[2]}, voxel);
  const std::vector<std::int16_t> numbers = fromBlob<std::int16_t>(qUncompress(packed).toStdString());
  if (!volume.origin().allFinite() || volume.origin().norm() > 1e12 || numbers.empty() ||
      !readRegions(numbers, volume) || !closeOff(volume, numbers.size()))
    return malformed;
  auto shown = shownSurface(volume);
  return DrillingStock{std::move(volume), std::make_shared<const nlohmann::json>(json), std::move(shown)};
}

}  // namespace handwheel
