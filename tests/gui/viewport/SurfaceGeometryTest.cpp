// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "mesh/structure/MeshBounds.h"
#include "mesh/structure/MeshBuilder.h"
#include "viewport/surface/SurfaceGeometry.h"

#include <QtTest>
#include <cmath>
#include <numbers>

using namespace handwheel;

namespace {

// The cube from -1 to 1, two triangles a side, seen from outside counter-clockwise.
TriangleSoup cube() {
  TriangleSoup s;
  for (int i = 0; i < 8; ++i) s.points.push_back({i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0});
  s.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                 {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return s;
}

// A roof of two slopes that meet at this angle between their normals.
TriangleSoup roof(double degrees) {
  const double half = degrees * std::numbers::pi / 360;
  TriangleSoup s;
  s.points = {{0, 0, 0}, {0, 1, 0}, {-std::cos(half), 0.5, -std::sin(half)}, {std::cos(half), 0.5, -std::sin(half)}};
  s.triangles = {{0, 1, 2}, {1, 0, 3}};
  return s;
}

TriangleSoup sphere(int n, const Vec3& centre) {
  TriangleSoup s;
  for (int i = 1; i < n; ++i) {
    for (int j = 0; j < 2 * n; ++j) {
      const double theta = std::numbers::pi * i / n, phi = std::numbers::pi * j / n;
      s.points.push_back(centre +
                         Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)));
    }
  }
  const auto at = [n](int i, int j) { return static_cast<std::uint32_t>(i * 2 * n + j % (2 * n)); };
  for (int i = 0; i + 2 < n; ++i) {
    for (int j = 0; j < 2 * n; ++j) {
      s.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      s.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return s;
}

Vec3 vectorAt(const std::vector<float>& values, std::size_t i) {
  return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

}  // namespace

class SurfaceGeometryTest : public QObject {
  Q_OBJECT
 private slots:
  // Each drawn vertex has the value of its mesh vertex, in every block; the simplified version has means.
  void valuesFollowTheirVertices() {
    const HalfEdgeMesh mesh = buildMesh(sphere(12, Vec3::Zero())).mesh;
    std::vector<double> heights(mesh.vertexSlots());
    for (Vertex v = 0; v < mesh.vertexSlots(); ++v) heights[v] = mesh.position(v).z();
    std::vector<SurfaceGeometry> all;
    for (std::size_t b = 0; b < blockCount(mesh, 100); ++b) {
      all.push_back(blockGeometry(mesh, b, Vec3::Zero(), 100, &heights));
    }
    all.push_back(coarseGeometry(mesh, boundsOf(mesh), Vec3::Zero(), 60, &heights));
    for (const SurfaceGeometry& g : all) {
      QCOMPARE(g.values.size(), g.vertexCount());
      for (std::size_t i = 0; i < g.values.size(); ++i) {
        QVERIFY(std::abs(g.values[i] - vectorAt(g.positions, i).z()) < 1e-6);
      }
    }
    QVERIFY(blockGeometry(mesh, 0, Vec3::Zero()).values.empty());
  }

  // A mesh that an undo made shorter has no faces in the blocks behind its end.
  void blockBehindTheEndIsEmpty() {
    const HalfEdgeMesh mesh = buildMesh(cube()).mesh;
    for (const std::size_t block : {std::size_t{2}, std::size_t{3}, std::size_t{65'536}}) {
      const SurfaceGeometry g = blockGeometry(mesh, block, Vec3::Zero(), 6);
      QCOMPARE(g.vertexCount(), std::size_t{0});
      QVERIFY(g.indices.empty());
    }
    QCOMPARE(blockGeometry(mesh, 1, Vec3::Zero(), 6).indices.size(), std::size_t{18});
  }

  // Each corner of a cube lies on three creases: three drawn vertices with the normals of the sides.
  void cubeHasSharpEdges() {
    const HalfEdgeMesh mesh = buildMesh(cube()).mesh;
    const SurfaceGeometry g = blockGeometry(mesh, 0, Vec3::Zero());
    QCOMPARE(g.vertexCount(), std::size_t{24});
    QCOMPARE(g.indices.size(), std::size_t{36});
    for (std::size_t i = 0; i < g.vertexCount(); ++i) {
      const Vec3 n = vectorAt(g.normals, i);
      QCOMPARE(n.cwiseAbs().maxCoeff(), 1.0);
      QCOMPARE(n.dot(vectorAt(g.positions, i)), 1.0);  // outward
    }
  }

  void creaseAngle() {
    const auto vertices = [](double degrees) {
      return blockGeometry(buildMesh(roof(degrees)).mesh, 0, Vec3::Zero()).vertexCount();
    };
    QCOMPARE(vertices(39), std::size_t{4});
    QCOMPARE(vertices(41), std::size_t{6});
  }

  void normalsOfASphereAreItsRadii() {
    const Vec3 centre(1e6, -2e6, 3e6);  // far away: single precision must not show
    const HalfEdgeMesh mesh = buildMesh(sphere(40, centre)).mesh;
    const SurfaceGeometry g = blockGeometry(mesh, 0, centre);
    QCOMPARE(g.vertexCount(), mesh.vertexSlots());
    for (std::size_t i = 0; i < g.vertexCount(); ++i) {
      const Vec3 p = vectorAt(g.positions, i);
      QVERIFY(std::abs(p.norm() - 1) < 1e-6);
      // At the open ends the faces lie on one side only and tilt the normal by half a step.
      QVERIFY(vectorAt(g.normals, i).dot(p) > std::cos(0.06));
    }
  }

  void blocksShareTheFacesOut() {
    const HalfEdgeMesh mesh = buildMesh(sphere(200, Vec3::Zero())).mesh;
    QCOMPARE(blockCount(mesh), std::size_t{3});  // 200 · 2 · 2 · 198 faces = 158 400
    std::size_t triangles = 0;
    for (std::size_t b = 0; b < blockCount(mesh); ++b) {
      const SurfaceGeometry g = blockGeometry(mesh, b, Vec3::Zero());
      triangles += g.indices.size() / 3;
      QVERIFY(g.indices.size() / 3 <= kBlockFaces);
      QVERIFY(*std::max_element(g.indices.begin(), g.indices.end()) < static_cast<int>(g.vertexCount()));
    }
    QCOMPARE(triangles, mesh.liveFaceCount());
  }

  void deadFacesAreNotDrawn() {
    HalfEdgeMesh mesh = buildMesh(cube()).mesh;
    mesh.removeFace(3);
    const SurfaceGeometry g = blockGeometry(mesh, 0, Vec3::Zero());
    QCOMPARE(g.indices.size(), std::size_t{33});
  }

  void coarseStandInHasTheShapeAndFewTriangles() {
    const HalfEdgeMesh mesh = buildMesh(sphere(200, Vec3(7, 8, 9))).mesh;
    const SurfaceGeometry g = coarseGeometry(mesh, boundsOf(mesh), Vec3(7, 8, 9), 10000);
    QVERIFY(g.indices.size() / 3 > 2000);
    QVERIFY(g.indices.size() / 3 < 30000);
    for (std::size_t i = 0; i < g.vertexCount(); ++i) {
      const Vec3 p = vectorAt(g.positions, i);
      QVERIFY(std::abs(p.norm() - 1) < 0.02);
      QVERIFY(vectorAt(g.normals, i).dot(p) > 0.9);
    }
  }
};

HANDWHEEL_TEST(SurfaceGeometryTest)
#include "SurfaceGeometryTest.moc"
