// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/surface/PartShape.h"

#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/MeshBuilder.h"

namespace handwheel {

namespace {

constexpr std::size_t kOutlinePoints = 2000;

}  // namespace

PartShape shapeOf(const TriangleSoup& soup) {
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const Box box = boundsOf(mesh);
  PartShape shape;
  if (!box.isEmpty()) shape.origin = box.center();
  for (std::size_t b = 0; b < blockCount(mesh); ++b) shape.blocks.push_back(blockGeometry(mesh, b, shape.origin));
  if (shape.blocks.empty()) shape.blocks.emplace_back();
  shape.faces = std::make_shared<const FaceHierarchy>(mesh);
  return shape;
}

PartOutline outlineOf(const TriangleSoup& soup, std::size_t most) {
  PartOutline outline;
  std::array<Vec3, 6> extremes;
  const std::size_t step = soup.points.size() / std::max<std::size_t>(most, 1) + 1;
  const std::size_t kept = (soup.points.size() / kOutlinePoints / step + 1) * step;
  for (std::size_t i = 0; i < soup.points.size(); i += step) {
    const Vec3& p = soup.points[i];
    if (!p.allFinite()) continue;
    for (int k = 0; k < 3; ++k) {
      if (outline.box.isEmpty() || p[k] < outline.box.min()[k]) extremes[2 * k] = p;
      if (outline.box.isEmpty() || p[k] > outline.box.max()[k]) extremes[2 * k + 1] = p;
    }
    outline.box.extend(p);
    if (i % kept == 0) outline.points.push_back(p);
  }
  if (!outline.box.isEmpty()) outline.points.insert(outline.points.end(), extremes.begin(), extremes.end());
  return outline;
}

}  // namespace handwheel
