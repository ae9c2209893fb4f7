// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "volume/VolumeSampler.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace handwheel {
namespace {

double mix(double a, double b, double t) {
  return a + t * (b - a);
}

// The eight samples around a point, and the interpolation weights between them.
struct SampledCell {
  std::array<double, 8> corners;  // stored values
  Vec3 share;

  SampledCell(const VolumeSampler& sampler, const Vec3& at) {
    const VoxelIndex base = at.array().floor().cast<int>();
    share = at - base.cast<double>();
    const std::array<std::int16_t, 8> samples = sampler.samplesFrom(base);
    for (std::size_t k = 0; k < 8; ++k) corners[k] = samples[k];
  }

  // Voxels.
  double depth() const {
    return kVoxel * mix(mix(alongX(0), alongX(2), share.y()), mix(alongX(4), alongX(6), share.y()), share.z());
  }
  Vec3 gradient() const {
    return kVoxel * Vec3(mix(mix(slopeX(0), slopeX(2), share.y()), mix(slopeX(4), slopeX(6), share.y()), share.z()),
                         mix(alongX(2) - alongX(0), alongX(6) - alongX(4), share.z()),
                         mix(alongX(4), alongX(6), share.y()) - mix(alongX(0), alongX(2), share.y()));
  }

 private:
  static constexpr double kVoxel = 1.0 / VolumeBlock::kUnit;

  double alongX(std::size_t k) const { return mix(corners[k], corners[k + 1], share.x()); }
  double slopeX(std::size_t k) const { return corners[k + 1] - corners[k]; }
};

// Returns true if a volume can have samples at a point, in voxels.
bool isReadable(const Vec3& at) {
  return at.allFinite() && at.cwiseAbs().maxCoeff() < SparseVolume::kMostVoxels;
}

}  // namespace

std::array<std::int16_t, 8> VolumeSampler::samplesFrom(const VoxelIndex& voxel) const {
  std::array<std::int16_t, 8> samples;
  const VoxelIndex in = voxel.unaryExpr([](int i) { return i & 7; });
  if (in.maxCoeff() == VolumeBlock::kSize - 1) {  // they lie in several blocks
    for (int k = 0; k < 8; ++k)
      samples[static_cast<std::size_t>(k)] = sample(voxel + VoxelIndex(k & 1, k >> 1 & 1, k >> 2));
    return samples;
  }
  const SparseVolume::View& view = viewOf(SparseVolume::blockOf(voxel));
  if (!view.block) {
    samples.fill(view.isFull ? VolumeBlock::kFull : VolumeBlock::kEmpty);
    return samples;
  }
  for (int k = 0; k < 8; ++k)
    samples[static_cast<std::size_t>(k)] =
        view.block->depths[VolumeBlock::at(in.x() + (k & 1), in.y() + (k >> 1 & 1), in.z() + (k >> 2))];
  return samples;
}

VolumeSampler::Depth VolumeSampler::depthAt(const Vec3& p) const {
  const double voxel = m_volume.voxel();
  const Vec3 at = (p - m_volume.origin()) / voxel;
  if (!isReadable(at)) return {voxel * VolumeBlock::kEmpty / VolumeBlock::kUnit, Vec3::Zero()};
  const SampledCell cell(*this, at);
  return {voxel * cell.depth(), cell.gradient()};
}

double VolumeSampler::depthInVoxels(const Vec3& at) const {
  return isReadable(at) ? SampledCell(*this, at).depth() : VolumeBlock::kEmpty / VolumeBlock::kUnit;
}

Vec3 VolumeSampler::normalAt(const Vec3& p) const {
  const Vec3 at = (p - m_volume.origin()) / m_volume.voxel();
  if (!isReadable(at)) return Vec3::Zero();
  Vec3 normal;
  for (int k = 0; k < 3; ++k)
    normal[k] = SampledCell(*this, at - Vec3::Unit(k)).depth() - SampledCell(*this, at + Vec3::Unit(k)).depth();
  const double length = normal.norm();
  return length > 0.0 ? Vec3(normal / length) : Vec3::Zero();
}

namespace {

// The part of a ray, in voxels from the origin and lengths of its direction, that can meet a volume.
class RayWalk {
 public:
  RayWalk(const SparseVolume& volume, const Vec3& origin, const Vec3& direction)
      : m_sampler(volume),
        m_origin((origin - volume.origin()) / volume.voxel()),
        m_direction(direction / volume.voxel()) {}

  // Returns the distance to the surface; none: no intersection.
  std::optional<double> hit(const Box& bounds) const {
    double from = 0.0, to = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      if (m_direction[k] == 0.0) {
        if (m_origin[k] < bounds.min()[k] || m_origin[k] > bounds.max()[k]) return std::nullopt;
        continue;
      }
      const double a = (bounds.min()[k] - m_origin[k]) / m_direction[k],
                   b = (bounds.max()[k] - m_origin[k]) / m_direction[k];
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    if (!(from <= to)) return std::nullopt;
    return walk(from, to);
  }

 private:
  static constexpr double kStep = 0.5;  // voxels

  double depth(double distance) const { return m_sampler.depthAt(pointAt(distance)).depth; }
  Vec3 pointAt(double distance) const {
    const SparseVolume& volume = m_sampler.volume();
    return volume.origin() + volume.voxel() * (m_origin + distance * m_direction);
  }

  // Advances in short steps near the surface, and otherwise to the end of a block without samples.
  std::optional<double> walk(double from, double to) const {
    const double step = kStep / m_direction.norm();
    bool wasInside = depth(from) > 0.0;
    double before = from;
    for (double at = from; at <= to + step;) {
      const bool isInside = depth(at) > 0.0;
      if (isInside && !wasInside) return between(before, at);
      wasInside = isInside;
      before = at;
      at += std::max(step, leap(at));
    }
    return std::nullopt;
  }

  // Returns the distance to the end of the block, if no surface is in its cells.
  double leap(double distance) const {
    const Vec3 at = m_origin + distance * m_direction;
    const VoxelIndex block = SparseVolume::blockOf(at.array().floor().cast<int>().matrix());
    const SparseVolume& volume = m_sampler.volume();
    const SparseVolume::View here = volume.view(block);
    for (int k = 0; k < 8; ++k) {
      const SparseVolume::View next = volume.view(block + VoxelIndex(k & 1, k >> 1 & 1, k >> 2));
      if (next.block || next.isFull != here.isFull) return 0.0;
    }
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k) {
      if (m_direction[k] == 0.0) continue;
      const double end = VolumeBlock::kSize * (block[k] + (m_direction[k] > 0.0 ? 1 : 0));
      least = std::min(least, (end - at[k]) / m_direction[k]);
    }
    return least;
  }

  double between(double outside, double inside) const {
    for (int i = 0; i < 24; ++i) {
      const double middle = 0.5 * (outside + inside);
      (depth(middle) > 0.0 ? inside : outside) = middle;
    }
    return inside;
  }

  VolumeSampler m_sampler;
  Vec3 m_origin, m_direction;  // voxels
};

}  // namespace

std::optional<VolumeHit> firstHit(const SparseVolume& volume, const Vec3& origin, const Vec3& direction) {
  if (volume.isEmpty() || !origin.allFinite() || !direction.allFinite() || !(direction.norm() > 0.0))
    return std::nullopt;
  const Box voxels = volume.extent();
  const std::optional<double> distance = RayWalk(volume, origin, direction).hit(voxels);
  if (!distance) return std::nullopt;
  const Vec3 point = origin + *distance * direction;
  Vec3 normal = VolumeSampler(volume).normalAt(point);
  if (normal.isZero()) normal = -direction.normalized();
  return VolumeHit{point, normal, *distance};
}

}  // namespace handwheel
