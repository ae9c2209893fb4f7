// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/intersections/CoincidentPieces.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>
#include <numeric>

using namespace handwheel;

namespace {

// In the plane z, looking up.
TriangleSoup rectangle(double x0, double y0, double x1, double y1, double z) {
  return {{{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}}, {{0, 1, 2}, {0, 2, 3}}};
}

TriangleSoup both(TriangleSoup a, const TriangleSoup& b) {
  test::append(a, b);
  return a;
}

// Tilts the horizontal planes; exact for coordinates of few bits. Volumes stay.
TriangleSoup sheared(TriangleSoup s) {
  for (Vec3& p : s.points) p.z() += 0.5 * p.x() + 0.25 * p.y();
  return s;
}

const TriangleSoup kPlate = test::box({0, 0, 0}, {4, 4, 1});

}  // namespace

// Tests that the removal of self-intersections joins overlapping coplanar surfaces.
class CoincidentPiecesTest : public QObject {
  Q_OBJECT

 private slots:
  void solidsThatTouch_data();
  void solidsThatTouch();
  void flakes_data();
  void flakes();
  void sheets_data();
  void sheets();
  void aPlateStays();
  void cancelled();

 private:
  static HalfEdgeMesh joined(const TriangleSoup& soup, NumberType numbers) {
    HalfEdgeMesh mesh = buildMesh(soup).mesh;
    std::vector<Face> faces(mesh.faceSlots());
    std::iota(faces.begin(), faces.end(), 0u);
    [&] {
      QVERIFY(test::meetingPairs(mesh) > 0);
      QVERIFY(removeAllSelfIntersections(mesh, faces, numbers).changed);
      QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
      QCOMPARE(validate(mesh), std::string());
    }();
    return mesh;
  }
};

void CoincidentPiecesTest::solidsThatTouch_data() {
  QTest::addColumn<TriangleSoup>("soup");
  QTest::addColumn<double>("volume");
  QTest::addColumn<double>("wall");  // area that both have
  const auto row = [](const char* name, const TriangleSoup& soup, double volume, double wall) {
    QTest::newRow(name) << soup << volume << wall;
  };
  row("a box on a plate", both(kPlate, test::box({1.25, 1.5, 1}, {1, 1, 1})), 17, 1);
  row("beyond its edge", both(kPlate, test::box({3.25, 1.5, 1}, {1, 1, 1})), 17, 0.75);
  row("at its edge", both(kPlate, test::box({3, 1.5, 1}, {1, 1, 1})), 17, 1);
  row("side by side", both(test::cube(), test::cube(1.0, {1, 0.25, 0.5})), 2, 0.375);
  row("two boxes", both(both(kPlate, test::box({1.25, 1.5, 1}, {1, 1, 1})), test::box({2.5, 2.75, 1}, {0.5, 1, 3})),
      18.5, 1.5);
}

// They become one solid: no wall is left between them.
void CoincidentPiecesTest::solidsThatTouch() {
  QFETCH(TriangleSoup, soup);
  QFETCH(double, volume);
  QFETCH(double, wall);
  for (const NumberType numbers : {NumberType::Float32, NumberType::Float64}) {
    const TriangleSoup left = joined(soup, numbers).compact().soup;
    QVERIFY(test::countEdges(left).sound());
    QCOMPARE(test::pieces(buildMesh(left).mesh).size(), std::size_t{1});
    QVERIFY(std::abs(test::volume(left) - volume) < 1e-12);
    QVERIFY(std::abs(test::area(left) - (test::area(soup) - 2.0 * wall)) < 1e-12);
    const TriangleSoup tilted = joined(sheared(soup), numbers).compact().soup;
    QVERIFY(test::countEdges(tilted).sound());
    QVERIFY(std::abs(test::volume(tilted) - volume) < 1e-12);
  }
}

void CoincidentPiecesTest::flakes_data() {
  QTest::addColumn<TriangleSoup>("flakes");
  const TriangleSoup one = rectangle(1.25, 1.5, 2.25, 2.5, 1), other = rectangle(1.5, 1.25, 2.5, 2.25, 1);
  QTest::newRow("one") << one;
  QTest::newRow("turned over") << test::turnedOver(one);
  QTest::newRow("two that overlap") << both(one, other);
  QTest::newRow("two, one turned over") << both(one, test::turnedOver(other));
}

// Squares that lie in the top of a solid go into it: the solid is as it was.
void CoincidentPiecesTest::flakes() {
  QFETCH(TriangleSoup, flakes);
  const TriangleSoup soup = both(kPlate, flakes);
  for (const TriangleSoup& given : {soup, sheared(soup)}) {
    for (const NumberType numbers : {NumberType::Float32, NumberType::Float64}) {
      const TriangleSoup left = joined(given, numbers).compact().soup;
      QVERIFY(test::countEdges(left).sound());
      QVERIFY(std::abs(test::volume(left) - 16.0) < 1e-12);
      QVERIFY(&given != &soup || std::abs(test::area(left) - 48.0) < 1e-12);
    }
  }
}

void CoincidentPiecesTest::sheets_data() {
  QTest::addColumn<TriangleSoup>("first");
  QTest::addColumn<TriangleSoup>("second");
  QTest::addColumn<double>("area");
  const TriangleSoup square = rectangle(0, 0, 2, 2, 0), other = rectangle(1.25, 0.5, 3, 1.5, 0);
  QTest::newRow("same way") << square << other << 4.0 + 1.75 - 0.75;
  QTest::newRow("turned over") << square << test::turnedOver(other) << 4.0 + 1.75 - 0.75;
  QTest::newRow("common border") << square << rectangle(0.25, 0, 3, 2, 0) << 6.0;
}

// Open sheets become one sheet with one border.
void CoincidentPiecesTest::sheets() {
  QFETCH(TriangleSoup, first);
  QFETCH(TriangleSoup, second);
  QFETCH(double, area);
  const HalfEdgeMesh mesh = joined(both(first, second), NumberType::Float64);
  const TriangleSoup left = mesh.compact().soup;
  QCOMPARE(test::countEdges(left).nonManifold, std::size_t{0});
  QCOMPARE(findBoundaryLoops(mesh).size(), std::size_t{1});
  QVERIFY(std::abs(test::area(left) - area) < 1e-12);
}

// Its two sides lie on each other, and are the surface.
void CoincidentPiecesTest::aPlateStays() {
  const TriangleSoup square = rectangle(0, 0, 2, 2, 0);
  HalfEdgeMesh mesh = buildMesh(both(square, test::turnedOver(square))).mesh;
  QCOMPARE(joinCoincidentPieces(mesh, 0), std::size_t{0});
  QCOMPARE(mesh.liveFaceCount(), std::size_t{4});
}

void CoincidentPiecesTest::cancelled() {
  TriangleSoup soup = test::cube();
  soup.triangles.push_back(soup.triangles[3]);
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  JobState state;
  state.cancelled = true;
  QCOMPARE(joinCoincidentPieces(mesh, 0, Progress(state)), std::size_t{0});
  QCOMPARE(mesh.liveFaceCount(), std::size_t{13});
  QCOMPARE(joinCoincidentPieces(mesh, 0), std::size_t{1});
}

HANDWHEEL_TEST(CoincidentPiecesTest)
#include "CoincidentPiecesTest.moc"
