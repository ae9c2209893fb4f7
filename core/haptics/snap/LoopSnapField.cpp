// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/snap/LoopSnapField.h"

#include "haptics/snap/SnapFidelity.h"

#include <cassert>

namespace handwheel {
namespace {

void addLoop(SnapFeatures& features, const SnapLoop& loop, SnapOffer offer) {
  const std::size_t n = loop.points.size();
  assert(loop.vertices.size() == n && loop.edges.size() == n);
  for (std::size_t i = 0; i < n; ++i) {
    if (offer.vertices) features.addPoint(loop.vertices[i], loop.points[i]);
    if (offer.edges) features.addSegment(loop.edges[i], loop.points[i], loop.points[(i + 1) % n]);
  }
  if (offer.curves) features.addCurve(loop.number, loop.points, true);
}

double meanEdge(std::span<const SnapLoop> loops) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const SnapLoop& loop : loops)
    for (std::size_t i = 0; i < loop.points.size(); ++i) {
      const double length = (loop.points[(i + 1) % loop.points.size()] - loop.points[i]).norm();
      if (!std::isfinite(length)) continue;
      sum += length;
      ++count;
    }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

}  // namespace

double LoopSnapField::distance(const FidelityValues& values) const {
  return values.of(snapRadiusSetting()) * spacing;
}

LoopSnapField snapSceneOf(std::span<const SnapLoop> loops, SnapOffer offer, Progress progress) {
  SnapFeatures features;
  for (const SnapLoop& loop : loops) addLoop(features, loop, offer);
  LoopSnapField scene{SnapField(features, progress)};
  if (!scene.field.empty()) scene.spacing = meanEdge(loops);
  return scene;
}

}  // namespace handwheel
