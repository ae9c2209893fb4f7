// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "bench/ContactShapes.h"
#include "document/formats/MeshFormat.h"
#include "mesh/structure/Weld.h"
#include "proximity/TriangleHierarchy.h"

#include <cstdlib>
#include <filesystem>
#include <optional>

// Paths of a device tip over scans that may not be distributed with Handwheel.
namespace handwheel::bench {

struct ReadScan {
  bool isThere = false;
  std::optional<TriangleSoup> mesh = {};  // none: the file could not be read
};

// Reads a scan from the folder HANDWHEEL_DATA and scales it to the diameter 2 kBallRadius.
inline ReadScan scanOf(const char* name) {
  const char* const folder = std::getenv("HANDWHEEL_DATA");
  if (!folder || !std::filesystem::exists(std::filesystem::path(folder) / name)) return {};
  const Result<MeshFile> read = readMeshFile(std::filesystem::path(folder) / name, {});
  if (!read) return {true};
  TriangleSoup soup = weld(read->soup);
  Box box;
  for (const Vec3& p : soup.points) box.extend(p);
  const double scale = 2 * kBallRadius / box.sizes().maxCoeff();
  for (Vec3& p : soup.points) p = scale * (p - box.center());
  return {true, std::move(soup)};
}

// Returns a path of `count` positions, `step` (mm) apart: around the axis and `depth` (mm) below the surface. The
// positions are averaged, so that the path does not follow single facets.
inline std::vector<Vec3> pathOver(const TriangleSoup& mesh, const Vec3& axis, double step, double depth, int count) {
  constexpr int kSmooth = 100;     // number of positions on either side
  constexpr double kRise = 10000;  // number of positions of one movement up the axis and down again
  const TriangleHierarchy surface(mesh.points, mesh.triangles);
  const auto normalOf = [&](std::uint32_t t) {
    const Triangle& c = mesh.triangles[t];
    return (mesh.points[c[1]] - mesh.points[c[0]]).cross(mesh.points[c[2]] - mesh.points[c[0]]).normalized();
  };
  std::vector<Vec3> below;
  Vec3 at = surface.nearest(2 * kBallRadius * axis.unitOrthogonal())->point;
  for (int i = 0; i < count + 2 * kSmooth; ++i) {
    const auto near = surface.nearest(at);
    const Vec3 normal = normalOf(near->triangle);
    below.push_back(near->point - depth * normal);
    const double drift = 0.05 * std::cos(2 * M_PI * i / kRise);
    at = near->point + step * (axis.cross(normal) + drift * axis).normalized();
  }
  std::vector<Vec3> path;
  Vec3 sum = Vec3::Zero();
  for (int i = 0; i < static_cast<int>(below.size()); ++i) {
    sum += below[static_cast<std::size_t>(i)];
    if (i < 2 * kSmooth) continue;
    path.push_back(sum / (2 * kSmooth + 1));
    sum -= below[static_cast<std::size_t>(i - 2 * kSmooth)];
  }
  return path;
}

}  // namespace handwheel::bench
