// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/clay/ClayContact.h"

#include "volume/VolumeSampler.h"

#include <algorithm>

namespace handwheel {
namespace {

constexpr double kStill = 0.01;  // voxels: a step that is no more is the last

// If a simulation removes the material, that around the tool is already gone: then its load counts, and the field only
// where the hand has reached material that the load does not include.
double resistanceTo(const Vec3& hand, const Vec3& tool, const SparseVolume& volume, const ClayFeel& feel,
                    const DrillingLoad* load) {
  constexpr double kBeyond = 0.25;  // voxels
  if (load && load->resistance > 0.0 && (hand - tool).dot(load->direction) > 0.0) return load->resistance;
  const VolumeSampler sampler(volume);
  const double depth = sampler.depthAt(hand).depth;
  const bool isInside = load ? depth > kBeyond * volume.voxel() : depth > 0.0 || sampler.depthAt(tool).depth > 0.0;
  return isInside ? feel.resistance : 0.0;
}

}  // namespace

void ClayContact::reset(const Vec3& hand) {
  m_tool = hand;
  m_isBuried = true;  // if it is in material
}

bool ClayContact::follow(const SparseVolume& volume, const ClayFeel& feel, const Vec3& hand, bool isWorking, double dt,
                         const DrillingLoad* load) {
  const bool isFree = isWorking && feel.isFree;
  const bool isInside = VolumeSampler(volume).depthAt(hand).depth > 0.0;
  if (isWorking && feel.isCutting && !isFree) {
    m_isBuried = false;
    return cut(feel.stiffness, resistanceTo(hand, m_tool, volume, feel, load), hand, dt);
  }
  // Deeper than a tool that slid can be: the material has come to it.
  if (VolumeSampler(volume).depthAt(m_tool).depth > volume.voxel()) m_isBuried = true;
  if (isFree || m_isBuried) {
    m_tool = hand;
    m_isBuried = isInside;
    return false;
  }
  return slide(volume, hand);
}

// Towards the hand in steps that do not go through a surface, and back to it along its normal where one has.
bool ClayContact::slide(const SparseVolume& volume, const Vec3& hand) {
  const VolumeSampler sampler(volume);
  const double voxel = volume.voxel();
  bool isTouching = false;
  for (int i = 0; i < kMostSteps; ++i) {
    Vec3 displacement = hand - m_tool;
    const VolumeSampler::Depth here = sampler.depthAt(m_tool);
    // On the surface only the displacement along it or away from it remains.
    if (here.depth > -0.05 * voxel && here.gradient.norm() > 0.1) {
      const Vec3 inwards = here.gradient.normalized();
      const double into = displacement.dot(inwards);
      if (into > 0.0) {
        isTouching = true;
        displacement -= into * inwards;
      }
    }
    const double length = displacement.norm();
    if (length < kStill * voxel) break;
    const Vec3 before = m_tool;
    const double step = std::min(length, std::max(0.25 * voxel, -here.depth));
    m_tool += step / length * displacement;
    for (int k = 0; k < 3; ++k) {
      const VolumeSampler::Depth there = sampler.depthAt(m_tool);
      if (!(there.depth > 0.0)) break;
      isTouching = true;
      if (!(there.gradient.norm() > 0.1)) break;
      m_tool -= there.depth / there.gradient.norm() * there.gradient.normalized();
    }
    if ((m_tool - before).norm() < kStill * voxel) break;
  }
  return isTouching;
}

// Through material only as fast as it is pressed: F = resistance · speed, exactly, with the force after the step.
bool ClayContact::cut(double stiffness, double resistance, const Vec3& hand, double dt) {
  if (!(resistance > 0.0) || hand == m_tool) {
    m_tool = hand;
    return false;
  }
  m_tool += stiffness * dt / (resistance + stiffness * dt) * (hand - m_tool);
  return true;
}

}  // namespace handwheel
