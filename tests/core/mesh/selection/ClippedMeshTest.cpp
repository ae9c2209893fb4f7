// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/selection/ClippedMesh.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>
#include <cmath>
#include <random>

using namespace handwheel;

namespace {

PreviewMesh clippedBy(const TriangleSoup& soup, const std::vector<Box>& boxes) {
  return clippedMesh(FaceHierarchy(buildMesh(soup).mesh), boxes);
}

double areaOfPreview(const PreviewMesh& clipped) {
  return test::area(clipped.mesh.compact().soup);
}

}  // namespace

class ClippedMeshTest : public QObject {
  Q_OBJECT

 private slots:
  // A box of which tiles hide a part: what is left has the area by rectangles, and no corner within.
  void aTileOfABox() {
    const TriangleSoup block = test::box({0.0, 0.0, 0.0}, {10.0, 10.0, 4.0});
    // In the middle of the top; over an edge; over a corner.
    const PreviewMesh middle = clippedBy(block, {Box(Vec3(3.0, 3.0, 3.0), Vec3(5.0, 6.0, 5.0))});
    QVERIFY(std::abs(areaOfPreview(middle) - (360.0 - 6.0)) < 1e-9);
    const PreviewMesh edge = clippedBy(block, {Box(Vec3(3.0, -1.0, 3.0), Vec3(5.0, 1.0, 5.0))});
    QVERIFY(std::abs(areaOfPreview(edge) - (360.0 - 2.0 - 2.0)) < 1e-9);
    const PreviewMesh corner = clippedBy(block, {Box(Vec3(-1.0, -1.0, 3.0), Vec3(1.0, 1.0, 5.0))});
    QVERIFY(std::abs(areaOfPreview(corner) - (360.0 - 3.0)) < 1e-9);
    for (Face f = 0; f < edge.mesh.faceSlots(); ++f) {
      if (!edge.mesh.isLive(f)) continue;
      const TrianglePoints p = edge.mesh.points(f);
      const Vec3 middleOf = (p[0] + p[1] + p[2]) / 3.0;
      QVERIFY(!(middleOf.x() > 3.0 && middleOf.x() < 5.0 && middleOf.y() < 1.0 && middleOf.z() > 3.0));
    }
  }

  // Faces that no box reaches keep their numbers; what looks different is said.
  void whatIsTouched() {
    const TriangleSoup block = test::box({0.0, 0.0, 0.0}, {10.0, 10.0, 4.0});
    const HalfEdgeMesh before = buildMesh(block).mesh;
    const PreviewMesh clipped = clippedBy(block, {Box(Vec3(3.0, 3.0, 3.0), Vec3(5.0, 6.0, 5.0))});
    std::size_t gone = 0;
    for (Face f = 0; f < before.faceSlots(); ++f) {
      if (clipped.mesh.isLive(f)) {
        QCOMPARE(clipped.mesh.triangle(f), before.triangle(f));
        QVERIFY(!clipped.touched.contains(f));
        continue;
      }
      ++gone;
      QVERIFY(clipped.touched.contains(f));
      for (const Vec3& p : before.points(f)) QCOMPARE(p.z(), 4.0);
    }
    QVERIFY(gone >= 1 && gone <= 2);
    for (auto f = static_cast<Face>(before.faceSlots()); f < clipped.mesh.faceSlots(); ++f)
      QVERIFY(clipped.touched.contains(f));
    // Beside all faces, and within: nothing is another.
    for (const Box& box :
         {Box(Vec3(20.0, 0.0, 0.0), Vec3(22.0, 2.0, 2.0)), Box(Vec3(4.0, 4.0, 1.0), Vec3(6.0, 6.0, 3.0))}) {
      const PreviewMesh same = clippedBy(block, {box});
      QVERIFY(same.touched.empty());
      QVERIFY(test::sameMesh(same.mesh, before));
    }
    QVERIFY(clippedBy(block, {}).touched.empty());
    QVERIFY(clippedBy({}, {Box(Vec3::Zero(), Vec3::Ones())}).touched.empty());
  }

  // A grid of tiles: what one of them hides and what all but it hide is all together, wherever the sides are.
  void tilesTogether() {
    const FaceHierarchy ball(buildMesh(test::icosphere(3)).mesh);
    const double all = areaOfPreview(clippedMesh(ball, {}));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> shift(0.0, 0.7);
    for (int n = 0; n < 5; ++n) {
      const Vec3 origin = Vec3(shift(random), shift(random), shift(random)) - Vec3::Constant(2.1);
      std::vector<Box> tiles;
      for (int i = 0; i < 216; ++i) {
        const Vec3 low = origin + 0.7 * Vec3(i % 6, i / 6 % 6, i / 36);
        tiles.emplace_back(low, Vec3(low + Vec3::Constant(0.7)));
      }
      QVERIFY(areaOfPreview(clippedMesh(ball, tiles)) < 1e-9 * all);
      double sum = 0.0;
      for (const Box& tile : tiles) sum += all - areaOfPreview(clippedMesh(ball, {&tile, 1}));
      QVERIFY2(std::abs(sum / all - 1.0) < 1e-9, QByteArray::number(sum / all));
    }
  }
};

HANDWHEEL_TEST(ClippedMeshTest)
#include "ClippedMeshTest.moc"
