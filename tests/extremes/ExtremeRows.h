// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Extremes.h"
#include "mesh/structure/MeshBuilder.h"

#include <QMetaType>
#include <QTest>

// The extreme meshes as rows of a data-driven test, and checks common to all tests.
namespace handwheel::test {

// Adds the column "extreme" with one row for each extreme mesh of at most this number of triangles.
inline void everyMesh(std::size_t mostTriangles = ~std::size_t{0}) {
  QTest::addColumn<ExtremeMesh>("extreme");
  for (const ExtremeMesh& mesh : allMeshes()) {
    if (mesh.soup().triangles.size() <= mostTriangles) QTest::newRow(mesh.name.c_str()) << mesh;
  }
}

inline Box boxOf(const TriangleSoup& soup) {
  Box box;
  for (const Triangle& t : soup.triangles)
    for (const std::uint32_t v : t) box.extend(soup.points[v]);
  return box;
}

inline Box boxOf(const HalfEdgeMesh& mesh) {
  return boxOf(mesh.compact().soup);
}

// Returns the largest absolute coordinate (mm), with which rounding errors grow.
inline double reachOf(const Box& box) {
  return box.isEmpty() ? 0.0 : std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
}

// Returns a multiple of the spacing of floating-point numbers at the largest coordinate (mm).
inline double rounding(const Box& box, double units = 16.0) {
  using Limits = std::numeric_limits<double>;
  return units * (reachOf(box) * Limits::epsilon() + Limits::denorm_min());
}

}  // namespace handwheel::test
