// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/snap/LoopSnapField.h"

#include "haptics/snap/SnapFidelity.h"

#include <cassert>

namespace handwheel {
namespace {

void addRim(SnapFeatures& features, const SnapLoop& rim, SnapOffer offer) {
  const std::size_t n = rim.points.size();
  assert(rim.vertices.size() == n && rim.edges.size() == n);
  for (std::size_t i = 0; i < n; ++i) {
    if (offer.vertices) features.addPoint(rim.vertices[i], rim.points[i]);
    if (offer.edges) features.addSegment(rim.edges[i], rim.points[i], rim.points[(i + 1) % n]);
  }
  if (offer.rims) features.addCurve(rim.number, rim.points, true);
}

double meanEdge(std::span<const SnapLoop> rims) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const SnapLoop& rim : rims)
    for (std::size_t i = 0; i < rim.points.size(); ++i) {
      const double length = (rim.points[(i + 1) % rim.points.size()] - rim.points[i]).norm();
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

LoopSnapField snapSceneOf(std::span<const SnapLoop> rims, SnapOffer offer, Progress progress) {
  SnapFeatures features;
  for (const SnapLoop& rim : rims) addRim(features, rim, offer);
  LoopSnapField scene{SnapField(features, progress)};
  if (!scene.field.empty()) scene.spacing = meanEdge(rims);
  return scene;
}

}  // namespace handwheel
