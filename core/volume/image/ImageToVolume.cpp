// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/image/ImageToVolume.h"

#include "base/NumberText.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeFilters.h"
#include "volume/VolumeMemory.h"
#include "volume/image/ImageExtremes.h"
#include "volume/repair/DepthWindow.h"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

constexpr int kBlockSide = VolumeBlock::kSize;

// The positions of a volume's voxels in the samples of an image.
struct Placement {
  Vec3 first;             // the index of voxel (0, 0, 0) in the image
  Eigen::Matrix3d steps;  // step of the index from voxel to voxel
  VoxelIndex low, high;   // blocks that the image meets, both included

  Vec3 indexOf(const VoxelIndex& voxel) const { return first + steps * voxel.cast<double>(); }
};

// A value between samples, and its position.
struct Sampled {
  Vec3 index;
  double value;
  bool isInImage;
  bool isInside;
};

// The value of a label map is 1 in the range and 0 elsewhere, so that the surface lies half way between samples,
// whatever labels are on either side.
template <class Sample>
class Sampler {
 public:
  Sampler(std::span<const Sample> samples, const ImageVolume& image, const ValueRange& range)
      : m_samples(samples), m_size(image.grid().size), m_range(range), m_areLabels(!image.labels().empty()) {
    if (!m_areLabels) return;
    m_labels = range;
    m_range = {0.5, std::numeric_limits<double>::infinity()};
  }

  bool areLabels() const { return m_areLabels; }
  Sampled at(const Vec3& index) const {
    Sampled sampled{index, 0.0, true, false};
    std::size_t base = 0, step[3];
    double share[3];
    std::size_t stride = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const double i = index[static_cast<Eigen::Index>(k)];
      const int last = m_size[k] - 1;
      sampled.isInImage = sampled.isInImage && i >= -0.5 && i < last + 0.5;
      const double held = std::clamp(i, 0.0, static_cast<double>(last));
      const int whole = static_cast<int>(held);
      share[k] = held - whole;
      base += static_cast<std::size_t>(whole) * stride;
      step[k] = whole < last ? stride : 0;
      stride *= static_cast<std::size_t>(m_size[k]);
    }
    const auto row = [&](std::size_t from) {
      const double a = valueOf(m_samples[from]), b = valueOf(m_samples[from + step[0]]);
      return a + share[0] * (b - a);
    };
    const auto plane = [&](std::size_t from) {
      const double a = row(from), b = row(from + step[1]);
      return a + share[1] * (b - a);
    };
    const double a = plane(base), b = plane(base + step[2]);
    sampled.value = a + share[2] * (b - a);
    sampled.isInside = sampled.isInImage && sampled.value >= m_range.least && sampled.value <= m_range.largest;
    return sampled;
  }

  // The end of the range that lies between a value inside and one outside; none where both are inside.
  std::optional<double> endBetween(const Sampled& a, const Sampled& b) const {
    const auto isWithin = [&](const Sampled& s) { return s.value >= m_range.least && s.value <= m_range.largest; };
    if (isWithin(a) == isWithin(b)) return {};
    return (isWithin(a) ? b : a).value < m_range.least ? m_range.least : m_range.largest;
  }
  // Returns the fraction of the segment from a point inside the image to one outside at which the image ends.
  double shareInImage(const Sampled& in, const Sampled& out) const {
    double share = 1.0;
    for (Eigen::Index k = 0; k < 3; ++k) {
      const double from = in.index[k], to = out.index[k], end = m_size[static_cast<std::size_t>(k)] - 0.5;
      if (to < -0.5 || to >= end) share = std::min(share, ((to < from ? -0.5 : end) - from) / (to - from));
    }
    return share;
  }

 private:
  double valueOf(Sample sample) const {
    const auto value = static_cast<double>(sample);
    if (!m_areLabels) return value;
    return value >= m_labels.least && value <= m_labels.largest ? 1.0 : 0.0;
  }

  std::span<const Sample> m_samples;
  std::array<int, 3> m_size;
  ValueRange m_range;
  bool m_areLabels;
  ValueRange m_labels{0.0, 0.0};  // labels in the range
};

// The samples of a block and one around it.
template <class Sample>
class SampledBlock {
 public:
  SampledBlock(const Sampler<Sample>& sampler, const Placement& placement, const VoxelIndex& at) : m_sampler(sampler) {
    for (int z = -1; z <= kBlockSide; ++z)
      for (int y = -1; y <= kBlockSide; ++y)
        for (int x = -1; x <= kBlockSide; ++x)
          m_around[sampleIndex(x, y, z)] = sampler.at(placement.indexOf(kBlockSide * at + VoxelIndex(x, y, z)));
  }

  // The depths beside the surface: the lesser distance from where the range ends and where the image does. Others are
  // at the limit.
  SparseVolume::Content content() const {
    const bool isInside = m_around.front().isInside;
    if (std::all_of(m_around.begin(), m_around.end(), [&](const Sampled& s) { return s.isInside == isInside; }))
      return {nullptr, isInside};
    auto block = std::make_shared<VolumeBlock>();
    for (int i = 0; i < static_cast<int>(VolumeBlock::kCount); ++i) {
      const std::size_t here = sampleIndex(i & 7, i >> 3 & 7, i >> 6);
      const double depth =
          isBeside(here) ? std::min({toRange(here), toBorder(here), DepthWindow::kLimit}) : DepthWindow::kLimit;
      block->depths[static_cast<std::size_t>(i)] = depthSample(m_around[here].isInside ? depth : -depth);
    }
    return contentOf(std::move(block));
  }

 private:
  static constexpr std::size_t kAround = kBlockSide + 2;
  static constexpr std::array<std::size_t, 3> kSteps{1, kAround, kAround* kAround};
  static constexpr double kBeyond = 1e9, kLeast = 1e-4;  // voxels; the least is about a unit of samples

  static std::size_t sampleIndex(int x, int y, int z) {
    return static_cast<std::size_t>(z + 1) * kSteps[2] + static_cast<std::size_t>(y + 1) * kSteps[1] +
           static_cast<std::size_t>(x + 1);
  }

  bool isBeside(std::size_t here) const {
    return std::any_of(kSteps.begin(), kSteps.end(), [&](std::size_t step) {
      return m_around[here - step].isInside != m_around[here].isInside ||
             m_around[here + step].isInside != m_around[here].isInside;
    });
  }

  // By how the values grow: to a neighbour on the other side, or from one to the other. Exact where that is linear. The
  // values of labels are steps, so their surface is where each pair of neighbours puts it: half way.
  double toRange(std::size_t here) const {
    const Sampled& own = m_around[here];
    std::optional<double> end;
    double squares = 0.0, most = 0.0;
    for (const std::size_t step : kSteps) {
      const Sampled &before = m_around[here - step], &after = m_around[here + step];
      double steepest = 0.0;
      for (const Sampled* other : {&before, &after}) {
        if (!own.isInImage || !other->isInImage) continue;
        const std::optional<double> between = m_sampler.endBetween(own, *other);
        if (!between) continue;
        end = between;
        steepest = std::max(steepest, std::abs(other->value - own.value));
      }
      if (steepest == 0.0) steepest = 0.5 * std::abs(after.value - before.value);
      squares += steepest * steepest;
      most = std::max(most, steepest);
    }
    const double growth = m_sampler.areLabels() ? most : std::sqrt(squares);
    return end ? std::max(kLeast, std::abs(own.value - *end) / growth) : kBeyond;
  }

  double toBorder(std::size_t here) const {
    const Sampled& own = m_around[here];
    double least = kBeyond;
    for (const std::size_t step : kSteps)
      for (const std::size_t to : {here - step, here + step}) {
        const Sampled& other = m_around[to];
        if (other.isInside == own.isInside || other.isInImage == own.isInImage) continue;
        const double share =
            own.isInImage ? m_sampler.shareInImage(own, other) : 1.0 - m_sampler.shareInImage(other, own);
        least = std::min(least, std::max(share, kLeast));
      }
    return least;
  }

  const Sampler<Sample>& m_sampler;
  std::array<Sampled, kAround * kAround * kAround> m_around;
};

// The corners of the image by the centres of its samples, or half a step further out; mm.
Box boxOf(const ImageGrid& grid, double beyond) {
  Box box;
  for (int k = 0; k < 8; ++k) {
    Vec3 corner;
    for (int axis = 0; axis < 3; ++axis)
      corner[axis] = (k >> axis & 1) != 0 ? grid.size[static_cast<std::size_t>(axis)] - 1 + beyond : -beyond;
    box.extend(grid.position(corner));
  }
  return box;
}

Placement placementOf(const ImageGrid& grid, const SparseVolume& volume) {
  const Eigen::Matrix3d inverse = grid.steps.inverse();
  const Box box = boxOf(grid, 0.5);
  const auto blockAt = [&](const Vec3& p, double further) -> VoxelIndex {
    return (((p - volume.origin()).array() / volume.voxel() + further) / kBlockSide).floor().cast<int>();
  };
  return {inverse * (volume.origin() - grid.origin), volume.voxel() * inverse, blockAt(box.min(), -1.0),
          blockAt(box.max(), 1.0)};
}

enum class Side { Outside, Inside, Both };

// Classifies a block and its neighbourhood: inside, outside, or near the surface.
Side sideOf(const VoxelIndex& block, const Placement& placement, const ImageExtremes& extremes, const ImageGrid& grid,
            const ValueRange& range) {
  constexpr double kHalf = 0.5 * (kBlockSide + 1);
  const Vec3 middle = placement.first +
                      placement.steps * (Vec3::Constant(0.5 * (kBlockSide - 1)) + (kBlockSide * block).cast<double>());
  const Vec3 reach = kHalf * placement.steps.cwiseAbs().rowwise().sum();
  const Vec3 low = middle - reach, high = middle + reach;
  const Vec3 end = Vec3(grid.size[0], grid.size[1], grid.size[2]).array() - 0.5;
  if ((high.array() < -0.5).any() || (low.array() >= end.array()).any()) return Side::Outside;
  const ValueRange values = extremes.within(low, high);
  if (values.largest < range.least || values.least > range.largest) return Side::Outside;
  const bool isWithin = (low.array() >= -0.5).all() && (high.array() < end.array()).all();
  return isWithin && values.least >= range.least && values.largest <= range.largest ? Side::Inside : Side::Both;
}

// Marks the full blocks, and returns those that the surface may pass.
std::vector<VoxelIndex> sorted(SparseVolume& volume, const Placement& placement, const ImageVolume& image,
                               const ValueRange& range, const Progress& progress) {
  struct Layer {
    std::vector<VoxelIndex> full, both;
  };
  const ImageExtremes extremes(image);
  std::vector<Layer> layers(static_cast<std::size_t>(placement.high.z() - placement.low.z() + 1));
  tbb::parallel_for(std::size_t{0}, layers.size(), [&](std::size_t i) {
    const int z = placement.low.z() + static_cast<int>(i);
    for (int y = placement.low.y(); y <= placement.high.y() && !progress.cancelled(); ++y)
      for (int x = placement.low.x(); x <= placement.high.x(); ++x) {
        const Side side = sideOf({x, y, z}, placement, extremes, image.grid(), range);
        if (side == Side::Inside) layers[i].full.emplace_back(x, y, z);
        if (side == Side::Both) layers[i].both.emplace_back(x, y, z);
      }
  });
  std::vector<VoxelIndex> both;
  for (const Layer& layer : layers) {
    for (const VoxelIndex& at : layer.full) volume.setContent(at, {nullptr, true});
    both.insert(both.end(), layer.both.begin(), layer.both.end());
  }
  return both;
}

// Returns an error if there is not enough memory for the blocks and their neighbours.
std::optional<Error> tooLarge(std::size_t blocks, double voxel) {
  return memoryRefusal(voxel, 2.0 * static_cast<double>(blocks) * (sizeof(VolumeBlock) + 64));
}

}  // namespace

double usualVoxel(const ImageGrid& grid) {
  return grid.spacing().minCoeff();
}

Result<SparseVolume> volumeOfImage(const ImageVolume& image, const ValueRange& range, std::optional<double> voxel,
                                   Progress progress) {
  const double edge = voxel.value_or(usualVoxel(image.grid()));
  if (!(edge > 0.0) || !std::isfinite(edge))
    return Error{ErrorCode::ValueOutOfRange, {"voxel", shortestText(edge), "0", "1e300"}, {}, {}};
  const Vec3 sizes = boxOf(image.grid(), 0.5).sizes();
  // Each block is visited once.
  constexpr double kMostBlocks = 1 << 25, kMost = SparseVolume::kMostVoxels / 2;
  const double least = std::max(std::cbrt(sizes.prod() / kMostBlocks) / kBlockSide, sizes.maxCoeff() / kMost);
  if (edge < least)
    return Error{VolumeErrors::TooFine,
                 {shortestText(edge), roundedText(sizes.maxCoeff()), roundedText(1.1 * least, 2)},
                 {},
                 {}};

  SparseVolume volume(boxOf(image.grid(), 0.0).min(), edge);
  const Placement placement = placementOf(image.grid(), volume);
  const std::vector<VoxelIndex> blocks = sorted(volume, placement, image, range, progress);
  if (const auto error = tooLarge(blocks.size(), edge)) return *error;
  std::vector<SparseVolume::Content> contents(blocks.size());
  std::atomic<std::size_t> done{0};
  image.visitSamples([&](auto samples) {
    const Sampler sampler(samples, image, range);
    tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t i) {
      if (progress.cancelled()) return;
      contents[i] = SampledBlock(sampler, placement, blocks[i]).content();
      progress.set(0.7 * static_cast<double>(++done) / static_cast<double>(blocks.size()));
    });
  });
  for (std::size_t i = 0; i < blocks.size(); ++i) volume.setContent(blocks[i], std::move(contents[i]));
  makeDistances(volume, volume.blocks(), DepthWindow::Beside::Kept, progress.part(0.7, 1.0));
  if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
  if (volume.isEmpty()) return nothingInRange(range, image);
  return volume;
}

Error nothingInRange(const ValueRange& range, const ImageVolume& image) {
  const ValueRange all = valuesOf(image);
  return {VolumeErrors::NothingInRange,
          {roundedText(range.least), roundedText(range.largest), roundedText(all.least), roundedText(all.largest)},
          {},
          {}};
}

}  // namespace handwheel
