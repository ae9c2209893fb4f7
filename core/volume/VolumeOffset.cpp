// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeOffset.h"

#include "base/NumberText.h"
#include "proximity/TriangleHierarchy.h"
#include "volume/VolumeBoolean.h"
#include "volume/VolumeErrors.h"
#include "volume/VolumeFilters.h"
#include "volume/VolumeMemory.h"
#include "volume/surface/VolumeToSurface.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>

namespace handwheel {
namespace {

constexpr double kSampleReach = 5.0;  // voxels from the surface that samples say something, and one more
constexpr double kExact = 1.01;       // voxels: depths beside the surface, of which the others follow (redistance())
constexpr double kRounding = 1e-3;    // voxels, of a limit of distances
// Bytes of the triangles of a block, their hierarchy, and what it takes to make it; measured.
constexpr double kBytesOfTriangles = 16'000.0;

// The surface of a volume, for distance queries. In voxels.
class SurfaceOfVolume {
 public:
  static Result<SurfaceOfVolume> of(const SparseVolume& volume, Progress progress) {
    const double bytes = predictedOffsetBytes(static_cast<double>(volume.blockCount()));
    if (const auto error = memoryRefusal(volume.voxel(), bytes)) return *error;
    SurfaceOfVolume made(volume);
    TriangleSoup soup = surfaceOf(volume, progress.part(0.0, 0.4));
    for (Vec3& p : soup.points) p = (p - volume.origin()) / volume.voxel();
    made.m_surface = TriangleHierarchy(soup.points, soup.triangles, progress.part(0.4, 1.0));
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    return made;
  }

  const SparseVolume& volume() const { return *m_volume; }
  // The depth of a voxel, which is known to be no farther from the surface than this.
  double depthAt(const VoxelIndex& voxel, double limit) const {
    const auto nearest = m_surface.nearest(voxel.cast<double>(), limit);
    const double distance = nearest ? std::sqrt(nearest->squaredDistance) : limit;
    return m_volume->sample(voxel) > 0 ? distance : -distance;
  }

 private:
  explicit SurfaceOfVolume(const SparseVolume& volume) : m_volume(&volume) {}

  const SparseVolume* m_volume;
  TriangleHierarchy m_surface;
};

// Moves a surface by a distance in voxels.
class Moving {
 public:
  Moving(const SurfaceOfVolume& surface, double distance)
      : m_surface(surface), m_distance(distance), m_made(surface.volume().origin(), surface.volume().voxel()) {}

  Result<SparseVolume> run(Progress progress) {
    const double voxel = m_made.voxel();
    Box box = m_surface.volume().extent();
    if (box.isEmpty()) return std::move(m_made);
    const double grown = std::max(0.0, m_distance) + kSampleReach;
    box.min().array() -= grown;
    box.max().array() += grown;
    constexpr double kMost = SparseVolume::kMostVoxels - 64;
    if (const double far = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff()); !(far < kMost))
      return Error{VolumeErrors::TooFine,
                   {roundedText(voxel), roundedText(far * voxel), roundedText(far * voxel / kMost)},
                   {},
                   {}};
    if (const auto error = find(box, progress.part(0.0, 0.3))) return *error;
    sample(progress.part(0.3, 0.8));
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    makeDistances(m_made, m_near, DepthWindow::Beside::Kept, progress.part(0.8, 1.0));
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    return std::move(m_made);
  }

 private:
  // A cube of side³ blocks. No corner of it is farther from the surface than the limit plus the distance to the corner.
  struct Node {
    VoxelIndex block;
    int side;
    double limit;
  };

  // Finds the blocks near the new surface, from large cubes to single blocks, and fills the full ones. Returns an error
  // once memory certainly does not suffice.
  std::optional<Error> find(const Box& box, Progress progress) {
    constexpr int kCubes = 8;  // along the longest axis, at first
    int side = 1;
    while (side * VolumeBlock::kSize * kCubes < box.sizes().maxCoeff()) side *= 2;
    const double cube = side * VolumeBlock::kSize;
    const VoxelIndex low = (box.min() / cube).array().floor().cast<int>(),
                     high = (box.max() / cube).array().floor().cast<int>();
    std::vector<Node> nodes;
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x) nodes.push_back({side * VoxelIndex(x, y, z), side, 1e300});
    while (!nodes.empty() && !progress.cancelled()) {
      std::vector<double> depths(nodes.size());
      tbb::parallel_for(std::size_t{0}, nodes.size(), [&](std::size_t i) {
        if (progress.cancelled()) return;
        const Node& node = nodes[i];
        depths[i] = m_surface.depthAt(
            VolumeBlock::kSize * node.block + VoxelIndex::Constant(node.side * VolumeBlock::kSize / 2), node.limit);
      });
      if (const auto error = memoryRefusal(m_made.voxel(), bytesAfter(nodes, depths))) return error;
      nodes = divided(nodes, depths);
      progress.set(nodes.empty() ? 1.0 : 1.0 / nodes.front().side);
    }
    return std::nullopt;
  }

  bool isNear(const Node& node, double before) const {
    return std::abs(before + m_distance) <= farthestIn(node) + kSampleReach;
  }
  static double farthestIn(const Node& node) { return 0.5 * std::sqrt(3.0) * node.side * VolumeBlock::kSize; }

  // Returns the least memory of the result: a cube near the surface has a number of blocks proportional to the square
  // of its side, with samples, windows, and later triangles; full cubes take a pointer for each block.
  double bytesAfter(const std::vector<Node>& nodes, const std::vector<double>& depths) const {
    double bytes = 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double side = nodes[i].side;
      if (isNear(nodes[i], depths[i]))
        bytes += 3.0 * side * side * (sizeof(VolumeBlock) + 64.0);
      else if (depths[i] + m_distance > 0.0)
        bytes += side * side * side * (sizeof(SparseVolume::Block) + 0.25);
    }
    return bytes;
  }

  std::vector<Node> divided(const std::vector<Node>& nodes, const std::vector<double>& depths) {
    std::vector<Node> next;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Node& node = nodes[i];
      const double farthest = farthestIn(node);
      if (!isNear(node, depths[i])) {
        if (depths[i] + m_distance > 0.0) fill(node);
      } else if (node.side == 1) {
        m_near.push_back(node.block);
        m_limits.push_back(std::abs(depths[i]) + farthest + kRounding);
      } else {
        const int half = node.side / 2;
        for (int k = 0; k < 8; ++k)
          next.push_back({node.block + half * VoxelIndex(k & 1, k >> 1 & 1, k >> 2), half,
                          std::abs(depths[i]) + farthest + kRounding});
      }
    }
    return next;
  }

  void fill(const Node& node) {
    for (int z = 0; z < node.side; ++z)
      for (int y = 0; y < node.side; ++y)
        for (int x = 0; x < node.side; ++x) m_made.setContent(node.block + VoxelIndex(x, y, z), {nullptr, true});
  }

  void sample(Progress progress) {
    std::vector<SparseVolume::Content> made(m_near.size());
    std::atomic<std::size_t> done{0};
    tbb::parallel_for(std::size_t{0}, m_near.size(), [&](std::size_t i) {
      if (progress.cancelled()) return;
      auto block = std::make_shared<VolumeBlock>();
      sampleCube(*block, VolumeBlock::kSize * m_near[i], VoxelIndex::Zero(), VolumeBlock::kSize, m_limits[i]);
      made[i] = contentOf(std::move(block));
      progress.set(static_cast<double>(++done) / static_cast<double>(made.size()));
    });
    for (std::size_t i = 0; i < made.size(); ++i) m_made.setContent(m_near[i], std::move(made[i]));
  }

  // Computes depths beside the new surface by subdividing cubes that may contain it; other samples only get their side.
  void sampleCube(VolumeBlock& block, const VoxelIndex& first, const VoxelIndex& in, int side, double limit) const {
    const VoxelIndex middle = in + VoxelIndex::Constant(side / 2);
    const double farthest = std::sqrt(3.0) * (side / 2), before = m_surface.depthAt(first + middle, limit),
                 depth = before + m_distance;
    if (side == 1) {
      block.depths[VolumeBlock::at(in.x(), in.y(), in.z())] = depthSample(depth);
    } else if (std::abs(depth) > kExact + farthest) {
      for (int z = in.z(); z < in.z() + side; ++z)
        for (int y = in.y(); y < in.y() + side; ++y)
          for (int x = in.x(); x < in.x() + side; ++x)
            block.depths[VolumeBlock::at(x, y, z)] = depth > 0.0 ? VolumeBlock::kFull : VolumeBlock::kEmpty;
    } else {
      const int half = side / 2;
      for (int k = 0; k < 8; ++k)
        sampleCube(block, first, in + half * VoxelIndex(k & 1, k >> 1 & 1, k >> 2), half,
                   std::abs(before) + farthest + kRounding);
    }
  }

  const SurfaceOfVolume& m_surface;
  double m_distance;
  SparseVolume m_made;
  std::vector<VoxelIndex> m_near;
  std::vector<double> m_limits;  // limits of the distances in m_near
};

std::optional<Error> refusalOfLength(const char* name, double length, double least) {
  constexpr double kMost = 1e9;  // mm
  if (length >= least && length <= kMost) return std::nullopt;
  return Error{
      ErrorCode::ValueOutOfRange, {name, shortestText(length), shortestText(least), shortestText(kMost)}, {}, {}};
}

// Offsets the surface by a distance and back, mm. Losses at edges by sampling twice are restored from the volume
// itself.
Result<SparseVolume> thereAndBack(const SparseVolume& volume, double distance, Progress progress) {
  const Result<SparseVolume> there = movedSurface(volume, distance, progress.part(0.0, 0.45));
  if (!there) return there;
  const Result<SparseVolume> back = movedSurface(*there, -distance, progress.part(0.45, 0.9));
  if (!back) return back;
  const VolumeBoolean how = distance > 0.0 ? VolumeBoolean::Unite : VolumeBoolean::Intersect;
  return combined(volume, *back, how, progress.part(0.9, 1.0));
}

}  // namespace

Result<SparseVolume> movedSurface(const SparseVolume& volume, double distance, Progress progress) {
  if (const auto error = refusalOfLength("distance", distance, -1e9)) return *error;
  const Result<SurfaceOfVolume> surface = SurfaceOfVolume::of(volume, progress.part(0.0, 0.3));
  if (!surface) return surface.error();
  return Moving(*surface, distance / volume.voxel()).run(progress.part(0.3, 1.0));
}

Result<SparseVolume> shellOf(const SparseVolume& volume, double wall, WallSide side, Progress progress) {
  if (const auto error = refusalOfLength("wall", wall, 0.0)) return *error;
  constexpr double kLeast = 2.0;  // voxels, so that no wall has holes between samples
  if (wall < kLeast * volume.voxel())
    return Error{VolumeErrors::WallTooThin,
                 {roundedText(wall), roundedText(volume.voxel()), roundedText(wall / kLeast)},
                 {},
                 {}};
  const double half = 0.5 * wall / volume.voxel(), whole = 2.0 * half;
  const double out = side == WallSide::Outside ? whole : side == WallSide::Middle ? half : 0.0, in = whole - out;
  const Result<SurfaceOfVolume> surface = SurfaceOfVolume::of(volume, progress.part(0.0, 0.2));
  if (!surface) return surface.error();
  SparseVolume outer = volume, inner = volume;
  for (auto [moved, distance, from] : {std::tuple{&outer, out, 0.2}, std::tuple{&inner, -in, 0.5}}) {
    if (distance == 0.0) continue;
    Result<SparseVolume> made = Moving(*surface, distance).run(progress.part(from, from + 0.3));
    if (!made) return made;
    *moved = std::move(*made);
  }
  return combined(outer, inner, VolumeBoolean::Subtract, progress.part(0.8, 1.0));
}

double predictedOffsetBytes(double blocks) {
  return kBytesOfTriangles * blocks;
}

Result<SparseVolume> withoutGaps(const SparseVolume& volume, double radius, Progress progress) {
  if (const auto error = refusalOfLength("radius", radius, 0.0)) return *error;
  return thereAndBack(volume, radius, progress);
}

Result<SparseVolume> withoutThinParts(const SparseVolume& volume, double radius, Progress progress) {
  if (const auto error = refusalOfLength("radius", radius, 0.0)) return *error;
  return thereAndBack(volume, -radius, progress);
}

}  // namespace handwheel
