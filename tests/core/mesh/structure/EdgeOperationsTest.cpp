// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/EdgeOperations.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

class EdgeOperationsTest : public QObject {
  Q_OBJECT

 private slots:
  void flipsADiagonal();
  void flippingTwiceIsNothing();
  void refusesToFlip();
  void splits();
  void manyAtRandom();
};

namespace {

HalfEdge halfEdge(const HalfEdgeMesh& mesh, const Vec3& from, const Vec3& to) {
  for (HalfEdge h = 0; h < mesh.halfEdgeSlots(); ++h)
    if (mesh.position(mesh.from(h)) == from && mesh.position(mesh.to(h)) == to) return h;
  return kNone;
}

}  // namespace

void EdgeOperationsTest::flipsADiagonal() {
  HalfEdgeMesh mesh = buildMesh(test::cube()).mesh;
  QVERIFY(flipEdge(mesh, halfEdge(mesh, Vec3(0, 0, 0), Vec3(1, 1, 0))));
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(halfEdge(mesh, Vec3(0, 0, 0), Vec3(1, 1, 0)) == kNone);
  QVERIFY(halfEdge(mesh, Vec3(1, 0, 0), Vec3(0, 1, 0)) != kNone);
  QVERIFY(std::abs(test::volume(mesh.compact().soup) - 1.0) < 1e-15);
  QVERIFY(test::countEdges(mesh).sound());
}

void EdgeOperationsTest::flippingTwiceIsNothing() {
  const TriangleSoup sphere = test::icosphere(2);
  for (HalfEdge h = 0; h < 60; ++h) {
    HalfEdgeMesh mesh = buildMesh(sphere).mesh;
    const Vec3 b = mesh.position(mesh.from(HalfEdgeMesh::previous(h)));
    const Vec3 d = mesh.position(mesh.from(HalfEdgeMesh::previous(mesh.opposite(h))));
    QVERIFY(flipEdge(mesh, h));
    QCOMPARE(validate(mesh), std::string());
    QVERIFY(flipEdge(mesh, halfEdge(mesh, b, d)));
    QCOMPARE(validate(mesh), std::string());
    QVERIFY(std::abs(test::volume(mesh.compact().soup) - test::volume(sphere)) < 1e-12);
    QVERIFY(std::abs(test::area(mesh.compact().soup) - test::area(sphere)) < 1e-12);
  }
}

void EdgeOperationsTest::refusesToFlip() {
  // The other diagonal exists already.
  const HalfEdgeMesh tetrahedron = buildMesh(test::tetrahedron()).mesh;
  for (HalfEdge h = 0; h < 12; ++h) {
    HalfEdgeMesh mesh = tetrahedron;
    QVERIFY(!flipEdge(mesh, h));
    QVERIFY(test::sameMesh(mesh, tetrahedron));
  }
  // One of the new faces would have no area.
  const HalfEdgeMesh kite =
      buildMesh({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(1, 1, 0)}, {{0, 1, 3}, {1, 2, 3}}}).mesh;
  HalfEdgeMesh mesh = kite;
  QVERIFY(!flipEdge(mesh, halfEdge(mesh, Vec3(1, 0, 0), Vec3(1, 1, 0))));
  QVERIFY(test::sameMesh(mesh, kite));
  // There is no second face.
  QVERIFY(!flipEdge(mesh, halfEdge(mesh, Vec3(0, 0, 0), Vec3(1, 0, 0))));
  QVERIFY(test::sameMesh(mesh, kite));
}

void EdgeOperationsTest::splits() {
  const HalfEdgeMesh before = buildMesh(test::cube()).mesh;
  for (HalfEdge h = 0; h < before.halfEdgeSlots(); ++h) {
    HalfEdgeMesh mesh = before;
    const Vec3 middle = 0.5 * (mesh.position(mesh.from(h)) + mesh.position(mesh.to(h)));
    const HalfEdge spoke = splitEdge(mesh, h, middle);
    QCOMPARE(validate(mesh), std::string());
    QVERIFY(mesh.position(mesh.from(spoke)) == middle);
    QCOMPARE(mesh.fan(spoke).size(), std::size_t{4});
    QCOMPARE(mesh.liveFaceCount(), std::size_t{14});
    QVERIFY(test::countEdges(mesh).sound());
    QVERIFY(std::abs(test::volume(mesh.compact().soup) - 1.0) < 1e-15);
    QVERIFY(std::abs(test::area(mesh.compact().soup) - 6.0) < 1e-14);
  }
}

void EdgeOperationsTest::manyAtRandom() {
  QVERIFY(rc::check("flips and splits keep a closed surface closed", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    HalfEdgeMesh mesh = buildMesh(*rc::gen::element(test::icosphere(1), test::torus(6, 5))).mesh;
    const auto anywhereOn =
        [&](HalfEdge h) {  // not always the middle: an edge may come back and would be split there again
          const double w = 0.2 + 0.6 * (random() / 4294967296.0);
          return Vec3(w * mesh.position(mesh.from(h)) + (1.0 - w) * mesh.position(mesh.to(h)));
        };
    const long euler = test::eulerCharacteristic(mesh);
    for (int i = 0; i < 60; ++i) {
      const auto h = static_cast<HalfEdge>(random() % mesh.halfEdgeSlots());
      if (random() % 3)
        flipEdge(mesh, h);
      else
        splitEdge(mesh, h, anywhereOn(h));
      RC_ASSERT(validate(mesh) == std::string());
    }
    RC_ASSERT(test::eulerCharacteristic(mesh) == euler);
    RC_ASSERT(test::countBorder(mesh) == std::size_t{0});
    RC_ASSERT(test::countEdges(mesh).sound());
  }));
}

HANDWHEEL_TEST(EdgeOperationsTest)
#include "EdgeOperationsTest.moc"
