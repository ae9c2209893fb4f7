// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/segment/SegmentToVolume.h"

#include "volume/VolumeFilters.h"
#include "volume/image/ImageToVolume.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace handwheel {
namespace {

// Values for samples whose side of the range contradicts the segment.
class OtherSide {
 public:
  OtherSide(const ValueRange& range, const ValueRange& all) : m_range(range) {
    // A range without ends has no other side.
    if (!std::isfinite(range.least) && !std::isfinite(range.largest)) m_range.largest = all.largest;
    constexpr double kLeast = 1e-4, kOfSingle = 1e-6;
    m_least = kLeast * (all.largest - all.least) + kOfSingle * std::max(std::abs(all.least), std::abs(all.largest)) +
              std::numeric_limits<float>::min();
  }

  const ValueRange& range() const { return m_range; }
  // Reflects a value at the end of the range, at most to the middle of the range.
  float inside(double value) const {
    const double middle = 0.5 * (m_range.least + m_range.largest);  // infinite where there is one end
    if (value < m_range.least) return static_cast<float>(std::min(2.0 * m_range.least - value, middle));
    return static_cast<float>(std::max(2.0 * m_range.largest - value, middle));
  }
  float outside(double value) const {
    const double above = value - m_range.least, below = m_range.largest - value;
    return static_cast<float>(above <= below ? m_range.least - std::max(above, m_least)
                                             : m_range.largest + std::max(below, m_least));
  }

 private:
  ValueRange m_range;
  double m_least;
};

}  // namespace

Result<SparseVolume> volumeOfSegment(const ImageVolume& image, const Segment& segment, std::optional<double> voxel,
                                     Progress progress) {
  if (segment.isByRangeAlone()) return volumeOfImage(image, segment.range(), voxel, progress);
  const ImageGrid& grid = image.grid();
  const bool areLabels = !image.labels().empty();
  const OtherSide other(segment.range(), valuesOf(image));
  std::vector<float> samples(grid.count());
  readSegment(image, segment, [&](const auto& reader) {
    tbb::parallel_for(0, grid.size[2], [&](int z) {
      if (progress.cancelled()) return;
      std::size_t i = reader.indexOf(0, 0, z);
      for (int y = 0; y < grid.size[1]; ++y)
        for (int x = 0; x < grid.size[0]; ++x, ++i) {
          const double value = image.value(i);
          const bool isIn = reader.at(x, y, z),
                     isInRange = value >= other.range().least && value <= other.range().largest;
          samples[i] = areLabels           ? (isIn ? 1.0f : 0.0f)
                       : isIn == isInRange ? static_cast<float>(value)
                       : isIn              ? other.inside(value)
                                           : other.outside(value);
        }
    });
  });
  ImageVolume sided(grid, std::move(samples));
  if (areLabels) sided.setLabels({{1.0}});
  return volumeOfImage(sided, areLabels ? ValueRange{1.0, 1.0} : other.range(), voxel, progress.part(0.1, 1.0));
}

Result<SparseVolume> volumeOfSmoothed(const ImageVolume& image, const Segment& segment, std::optional<double> voxel,
                                      bool isSmoothed, Progress progress) {
  if (!isSmoothed) return volumeOfSegment(image, segment, voxel, progress);
  Result<SparseVolume> volume = volumeOfSegment(image, segment, voxel, progress.part(0.0, 0.7));
  if (!volume) return volume;
  smooth(*volume, progress.part(0.7, 1.0));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (volume->isEmpty()) return nothingInRange(segment.range(), image);
  return volume;
}

double facesOf(const ImageVolume& image, const Segment& segment, const Progress& progress) {
  const ImageGrid& grid = image.grid();
  const std::array<int, 3> size = grid.size;
  Vec3 areas;  // area of a face perpendicular to each axis
  for (int k = 0; k < 3; ++k) areas[k] = grid.steps.col((k + 1) % 3).cross(grid.steps.col((k + 2) % 3)).norm();
  std::vector<double> ofSlices(static_cast<std::size_t>(size[2]), 0.0);
  readSegment(image, segment, [&](const auto& reader) {
    tbb::parallel_for(0, size[2], [&](int z) {
      if (progress.cancelled()) return;
      const auto width = static_cast<std::size_t>(size[0]);
      std::vector<std::uint8_t> row(width), before(width, 0), below(width, 0);
      std::array<std::size_t, 3> faces{0, 0, 0};
      const auto differing = [](const auto& a, const auto& b) {
        return std::inner_product(a.begin(), a.end(), b.begin(), std::size_t{0}, std::plus<>(), std::not_equal_to<>());
      };
      for (int y = 0; y < size[1]; ++y) {
        reader.readRow(y, z, row);
        if (z > 0) reader.readRow(y, z - 1, below);
        for (std::size_t x = 0; x < width; ++x) faces[0] += row[x] != (x > 0 ? row[x - 1] : 0) ? 1 : 0;
        faces[0] += row.back();
        faces[1] += differing(row, before);
        faces[2] += differing(row, below);
        if (z + 1 == size[2]) faces[2] += static_cast<std::size_t>(std::count(row.begin(), row.end(), 1));
        std::swap(row, before);
      }
      faces[1] += static_cast<std::size_t>(std::count(before.begin(), before.end(), 1));
      for (int k = 0; k < 3; ++k)
        ofSlices[static_cast<std::size_t>(z)] += areas[k] * static_cast<double>(faces[static_cast<std::size_t>(k)]);
    });
  });
  return std::accumulate(ofSlices.begin(), ofSlices.end(), 0.0);
}

double predictedBytes(const ImageVolume& image, const Segment& segment, double faces, double voxel) {
  // A surface passes as many cells as it has faces of voxels, with two triangles each and half as many points, and
  // meets 1.5 times as many blocks as those faces cover (measured).
  constexpr double kBlocks = 1.5, kTriangles = 2.0, kTriangle = 12.0 + 0.5 * 24.0, kSide = VolumeBlock::kSize;
  const double voxels = faces / (voxel * voxel);
  const double copied = segment.isByRangeAlone() ? 0.0 : 4.0 * static_cast<double>(image.grid().count());
  return copied + voxels * (kBlocks / (kSide * kSide) * sizeof(VolumeBlock) + kTriangles * kTriangle);
}

}  // namespace handwheel
