// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/SheetThickening.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;

namespace {

double volume(const HalfEdgeMesh& mesh) {
  return test::volume(mesh.compact().soup);
}

HalfEdgeMesh backed(const TriangleSoup& soup, double thickness) {
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  thickenSheets(mesh, {sheetOf(mesh, 0)}, thickness, NumberType::Float64);
  relink(mesh);
  return mesh;
}

}  // namespace

class SheetThickeningTest : public QObject {
  Q_OBJECT

 private slots:
  void oneTriangle();
  void sheets_data();
  void sheets();
  void flatDisc();
  void onlyThisSheet();
  void thinnerBeforeAnObstacle();
  void fold();
  void saysWhatWasReached();
  void crossedWhereBackAndFrontAreOne();
};

// A pyramid under the triangle: a third of area times height.
void SheetThickeningTest::oneTriangle() {
  const HalfEdgeMesh mesh = backed({{{0, 0, 5}, {2, 0, 5}, {0, 2, 5}}, {{0, 1, 2}}}, 0.25);
  QCOMPARE(mesh.liveFaceCount(), std::size_t{4});
  QVERIFY(test::countEdges(mesh).sound());
  QVERIFY(std::abs(volume(mesh) - 2.0 * 0.25 / 3.0) < 1e-12);
}

void SheetThickeningTest::sheets_data() {
  QTest::addColumn<TriangleSoup>("soup");
  QTest::newRow("two triangles") << TriangleSoup{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  QTest::newRow("strip") << test::cylinder(12, 1, 1.0, 0.3, false);
  QTest::newRow("fan of one inner face") << TriangleSoup{
      {{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, -1, 0}, {1.5, 1, 0}, {-0.5, 1, 0}},
      {{0, 1, 2}, {1, 0, 3}, {2, 1, 4}, {0, 2, 5}}};
  QTest::newRow("annulus") << test::annulus(24, 3, 1.0, 2.0);
  QTest::newRow("ball without a cap") << test::sphereWithoutCap(3);
  QTest::newRow("ball with holes") << test::sphereWithHoles(4, 5, 0.3);
}

void SheetThickeningTest::sheets() {
  QFETCH(TriangleSoup, soup);
  for (const Vec3& shift : {Vec3(0, 0, 0), Vec3(1e5, -1e5, 1e5)}) {
    const HalfEdgeMesh before = buildMesh(test::moved(soup, shift)).mesh;
    const HalfEdgeMesh mesh = backed(test::moved(soup, shift), 0.01);
    QVERIFY(test::countEdges(mesh).sound());
    QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
    QCOMPARE(validate(mesh), std::string());
    QVERIFY(test::volume(test::moved(mesh.compact().soup, -shift)) > 0.0);
    for (Face f = 0; f < before.faceSlots(); ++f) QVERIFY(mesh.points(f) == before.points(f));
  }
}

// Its inner vertices go down by the thickness: between a prism over the inner rings and one over all of it.
void SheetThickeningTest::flatDisc() {
  const double thickness = 1e-3;
  const double v = volume(backed(test::disc(48, 20), thickness));
  QVERIFY(v < M_PI * thickness);
  QVERIFY(v > 0.9 * 0.9 * M_PI * thickness);
}

void SheetThickeningTest::onlyThisSheet() {
  TriangleSoup two = test::disc(12, 3);
  const std::size_t one = two.triangles.size();
  test::append(two, test::moved(test::disc(12, 3), {0, 0, 9}));
  HalfEdgeMesh mesh = buildMesh(two).mesh;
  const std::vector<Face> sheet = sheetOf(mesh, 0);
  QCOMPARE(sheet.size(), one);
  thickenSheets(mesh, {sheet}, 0.01, NumberType::Float64);
  relink(mesh);
  QCOMPARE(test::countBorder(mesh), std::size_t{12});
}

// A flake behind the middle of a square comes nearer than the thickness: there the body is thinner, and as thick as it
// may be elsewhere.
void SheetThickeningTest::thinnerBeforeAnObstacle() {
  const double thickness = 0.04;
  TriangleSoup soup = test::grid(
      13, 13, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i / 6.0 - 1.0, j / 6.0 - 1.0, 0.0); });
  const double alone = volume(backed(soup, thickness));
  test::append(soup, TriangleSoup{{{0.01, 0.01, -0.011}, {0.06, 0.01, -0.1}, {0.01, 0.06, -0.1}}, {{0, 1, 2}}});
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  const std::vector<Face> sheet = sheetOf(mesh, 0);
  thickenSheets(mesh, {sheet}, thickness, NumberType::Float64);
  relink(mesh);
  QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
  QCOMPARE(test::countBorder(mesh), std::size_t{3});  // the flake's
  QCOMPARE(validate(mesh), std::string());
  mesh.removeFace(static_cast<Face>(soup.triangles.size() - 1));
  QVERIFY(volume(mesh) < alone && volume(mesh) > 0.8 * alone);
}

// The fold of a sheet that comes back over itself at a distance of less than twice the thickness.
void SheetThickeningTest::fold() {
  const double gap = 0.02;
  const TriangleSoup soup = test::grid(41, 9, false, false, [&](std::uint32_t i, std::uint32_t j) {
    const double s = (i - 20.0) / 10.0, turn = 0.5 * M_PI * gap;  // half a circle as wide as the gap
    if (s < 0) return Vec3(-s, j / 8.0, 0.0);
    if (i == 20) return Vec3(-turn, j / 8.0, 0.5 * gap);
    return Vec3(s, j / 8.0, gap);
  });
  for (const TriangleSoup& side : {soup, test::turnedOver(soup)}) {
    const HalfEdgeMesh mesh = backed(side, 0.05);
    QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
    QVERIFY(test::countEdges(mesh).sound());
  }
}

// Edges of 0.2 mm allow a quarter of them, and beside the corners a quarter of the diagonal; not the 2 mm.
void SheetThickeningTest::saysWhatWasReached() {
  const TriangleSoup soup =
      test::grid(9, 9, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(0.2 * i, 0.2 * j, 0.0); });
  for (const double thickness : {0.01, 2.0}) {
    HalfEdgeMesh mesh = buildMesh(soup).mesh;
    const auto front = static_cast<Vertex>(mesh.vertexSlots());
    const SheetThickness reached = thickenSheets(mesh, {sheetOf(mesh, 0)}, thickness, NumberType::Float64).thickness;
    double least = 1.0, largest = 0.0;
    for (Vertex v = front; v < mesh.vertexSlots(); ++v) {
      least = std::min(least, std::abs(mesh.position(v).z()));
      largest = std::max(largest, std::abs(mesh.position(v).z()));
    }
    QVERIFY(std::abs(reached.least - least) < 1e-12);
    QVERIFY(std::abs(reached.largest - largest) < 1e-12);
    QVERIFY(std::abs(least - std::min(thickness, 0.05)) < 1e-12);
    QVERIFY(largest <= std::min(thickness, 0.05 * M_SQRT2) + 1e-12);
  }
}

// So far from the origin, single precision has no room for the thickness: faces go with their backs, and what crosses
// both is met again after they are gone.
void SheetThickeningTest::crossedWhereBackAndFrontAreOne() {
  const double z = 1e5;
  TriangleSoup soup =
      test::grid(9, 9, false, false, [&](std::uint32_t i, std::uint32_t j) { return Vec3(i / 8.0, j / 8.0, z); });
  test::append(soup, TriangleSoup{{{0.4, 0.4, z - 1}, {0.45, 0.4, z + 1}, {0.4, 0.45, z + 1}}, {{0, 1, 2}}});
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  thickenSheets(mesh, {sheetOf(mesh, 0)}, 1e-3, NumberType::Float32);
  relink(mesh);
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(mesh.isLive(static_cast<Face>(soup.triangles.size() - 1)));
}

HANDWHEEL_TEST(SheetThickeningTest)
#include "SheetThickeningTest.moc"
