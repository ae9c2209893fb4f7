// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/FaceComponents.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

namespace {

FaceComponents splitOf(const HalfEdgeMesh& mesh) {
  return {mesh, PositionTriangles(mesh)};
}

}  // namespace

class FaceComponentsTest : public QObject {
  Q_OBJECT

 private slots:
  void inOrderOfTheFirstFace();
  void touchingCountsAsTogether();
  void deadFacesDoNotJoin();
  void shuffledParts();
};

void FaceComponentsTest::inOrderOfTheFirstFace() {
  TriangleSoup s = test::tetrahedron();
  test::append(s, test::cube(1.0, Vec3(5, 0, 0)));
  const HalfEdgeMesh mesh = buildMesh(s).mesh;
  const FaceComponents parts = splitOf(mesh);
  QCOMPARE(parts.count(), std::size_t{2});
  for (Face f = 0; f < mesh.faceSlots(); ++f) QCOMPARE(parts.of(f), f < 4 ? 0u : 1u);
  QCOMPARE(splitOf(HalfEdgeMesh()).count(), std::size_t{0});
}

void FaceComponentsTest::touchingCountsAsTogether() {
  QCOMPARE(splitOf(buildMesh(test::twoCubesSharingAVertex()).mesh).count(), std::size_t{1});
  QCOMPARE(splitOf(buildMesh(test::twoCubesSharingAnEdge()).mesh).count(), std::size_t{1});
}

void FaceComponentsTest::deadFacesDoNotJoin() {
  HalfEdgeMesh mesh = buildMesh(test::grid(2, 4, false, false, [](auto i, auto j) { return Vec3(i, j, 0); })).mesh;
  QCOMPARE(splitOf(mesh).count(), std::size_t{1});
  mesh.removeFace(2);  // the middle one of three cells
  mesh.removeFace(3);
  QCOMPARE(splitOf(mesh).count(), std::size_t{2});
}

void FaceComponentsTest::shuffledParts() {
  QVERIFY(rc::check("spheres apart are as many parts, whatever the order of their faces", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto n = *rc::gen::inRange<std::size_t>(1, 8);
    TriangleSoup s;
    for (std::size_t i = 0; i < n; ++i) test::append(s, test::moved(test::icosphere(1), Vec3(3.0 * i, 0, 0)));
    std::shuffle(s.triangles.begin(), s.triangles.end(), random);
    const HalfEdgeMesh mesh = buildMesh(s).mesh;
    const FaceComponents parts = splitOf(mesh);
    RC_ASSERT(parts.count() == n);
    std::map<std::uint32_t, int> slotOf;
    for (Face f = 0; f < mesh.faceSlots(); ++f) {
      const int slot = static_cast<int>(std::round(mesh.points(f)[0].x() / 3.0));
      RC_ASSERT(slotOf.try_emplace(parts.of(f), slot).first->second == slot);
    }
  }));
}

HANDWHEEL_TEST(FaceComponentsTest)
#include "FaceComponentsTest.moc"
