// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/NonOrientableSurfaces.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/defects/Defects.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"
#include "mesh/structure/OrientationReversal.h"
#include "mesh/structure/PositionTriangles.h"

#include <QTest>

using namespace handwheel;

class NonOrientableSurfacesTest : public QObject {
  Q_OBJECT

 private slots:
  void edgesThatDisagree();
  void shortestCycles();
  void cyclesAreMirrors_data() { nonOrientable(); }
  void cyclesAreMirrors();
  void cuts_data() { nonOrientable(); }
  void cuts();
  void twoSidesStay();
  void closesACrossCap();
  void closes_data() { nonOrientable(); }
  void closes();
  void cancelled();

 private:
  static void nonOrientable() {
    QTest::addColumn<TriangleSoup>("soup");
    QTest::addColumn<long>("across");
    QTest::newRow("Möbius strip") << test::moebiusStrip(24, 4) << 1L;
    QTest::newRow("narrow Möbius strip") << test::moebiusStrip(9, 1) << 1L;
    QTest::newRow("Klein bottle") << test::kleinBottle(20, 8) << 1L;
    QTest::newRow("cross cap") << test::sphereWithCrossCap(2) << 0L;
    TriangleSoup two = test::sphereWithCrossCap(1);
    test::append(two, test::moved(test::moebiusStrip(12, 2), Vec3(5, 0, 0)));
    QTest::newRow("two parts") << two << 1L;
  }
};

namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();

struct Welded {
  explicit Welded(const TriangleSoup& soup) : mesh(buildMesh(soup).mesh), byPosition(mesh) {
    for (const Vertex v : byPosition.classes.representative) points.push_back(mesh.position(v));
  }
  EdgeTable edges() const { return {byPosition.triangles, points.size()}; }
  std::optional<OrientationReversingCycle> shortest(double longest = kAny) const {
    return shortestOrientationReversingCycle(edges(), byPosition.triangles, points, longest);
  }

  HalfEdgeMesh mesh;
  PositionTriangles byPosition;
  std::vector<Vec3> points;
};

bool isOneSided(const HalfEdgeMesh& mesh) {
  const PositionTriangles byPosition(mesh);
  const EdgeTable edges(byPosition.triangles, byPosition.classes.representative.size());
  return !nonOrientableEdges(edges, byPosition.triangles).empty();
}

std::size_t crossings(const HalfEdgeMesh& mesh) {
  return findSelfIntersections(mesh)->size();
}

}  // namespace

void NonOrientableSurfacesTest::edgesThatDisagree() {
  for (const TriangleSoup& soup : {test::moebiusStrip(12, 3), test::kleinBottle(12, 6), test::sphereWithCrossCap(1)})
    QVERIFY(isOneSided(buildMesh(soup).mesh));
  for (const TriangleSoup& soup : {test::cube(), test::torus(9, 7), test::disc(7, 2), test::boxWithInnerWall(),
                                   test::twoCubesSharingAnEdge(), TriangleSoup()})
    QVERIFY(!isOneSided(buildMesh(soup).mesh));
  TriangleSoup turned = test::icosphere(1);  // in disorder, but with two sides
  for (std::size_t i = 0; i < turned.triangles.size(); i += 3)
    std::swap(turned.triangles[i][0], turned.triangles[i][1]);
  const EdgeTable edges(turned.triangles, turned.points.size());
  QVERIFY(nonOrientableEdges(edges, turned.triangles).empty());
}

// The cycle of the cross cap has three edges of known length. A strip is cut across: one edge if it has one cell.
void NonOrientableSurfacesTest::shortestCycles() {
  const TriangleSoup cap = test::sphereWithCrossCap(2);
  const std::size_t n = cap.points.size();
  double around = 0.0;
  for (std::size_t i = 0; i < 3; ++i) around += (cap.points[n - 3 + i] - cap.points[n - 3 + (i + 1) % 3]).norm();
  const auto found = Welded(cap).shortest();
  QVERIFY(found && found->halfEdges.size() == 3);
  QCOMPARE(found->length, around);
  QVERIFY(!Welded(cap).shortest(0.999 * around));
  QVERIFY(Welded(cap).shortest(1.001 * around));
  QVERIFY(!Welded(test::torus(9, 7)).shortest());
  for (const std::uint32_t cells : {9u, 24u}) {
    const auto across = Welded(test::moebiusStrip(cells, 1)).shortest();
    QVERIFY(across && across->isOnBorder && across->halfEdges.size() == 1);
    QVERIFY(across->length <= 0.8 + 1e-12);  // the width
  }
  const auto bottle = Welded(test::kleinBottle(20, 8)).shortest();
  QVERIFY(bottle && !bottle->isOnBorder && bottle->halfEdges.size() >= 3);
}

// Each is closed, or ends at borders; what lies along it and the border, alone, has one side only.
void NonOrientableSurfacesTest::cyclesAreMirrors() {
  QFETCH(TriangleSoup, soup);
  const Welded welded(soup);
  const auto loop = welded.shortest();
  QVERIFY(loop && !loop->halfEdges.empty());
  const auto& triangles = welded.byPosition.triangles;
  std::map<std::uint32_t, int> ends;
  double length = 0.0;
  std::set<std::uint32_t> on;
  for (const std::uint32_t h : loop->halfEdges) {
    const std::uint32_t a = triangles[h / 3][h % 3], b = triangles[h / 3][(h % 3 + 1) % 3];
    ++ends[a];
    ++ends[b];
    on.insert({a, b});
    length += (welded.points[a] - welded.points[b]).norm();
  }
  std::set<std::uint32_t> border;
  welded.edges().forEachEdge([&](std::uint32_t low, std::uint32_t high, std::span<const EdgeTable::Entry> run) {
    if (run.size() == 1) border.insert({low, high});
  });
  for (const auto& [point, count] : ends) QVERIFY(count == 2 || (count == 1 && border.contains(point)));
  if (loop->isOnBorder) on.insert(border.begin(), border.end());
  QVERIFY(std::abs(length - loop->length) < 1e-12);
  TriangleSoup beside;
  beside.points = welded.points;
  for (const Triangle& t : triangles)
    if (on.contains(t[0]) || on.contains(t[1]) || on.contains(t[2])) beside.triangles.push_back(t);
  QVERIFY(isOneSided(buildMesh(beside).mesh));
}

// A cut along a circle changes neither the Euler characteristic nor the number of faces, only the number of sides; one
// across a strip adds 1, and a Klein bottle is such a strip once it has been cut.
void NonOrientableSurfacesTest::cuts() {
  QFETCH(TriangleSoup, soup);
  QFETCH(long, across);
  const HalfEdgeMesh before = buildMesh(soup).mesh;
  HalfEdgeMesh mesh = before;
  const NonOrientableCut cut = cutNonOrientable(mesh, kAny, NumberType::Float64);
  QVERIFY(cut.isTwoSided && cut.loops > 0);
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(!isOneSided(mesh));
  QCOMPARE(mesh.liveFaceCount(), before.liveFaceCount());
  const TriangleSoup after = mesh.compact().soup;
  QCOMPARE(test::countEdges(mesh).inconsistent, std::size_t{0});
  QCOMPARE(test::eulerCharacteristic(after), test::eulerCharacteristic(before.compact().soup) + across);
  QVERIFY(test::countEdges(mesh).border > test::countEdges(before).border);
  QCOMPARE(test::countSeams(mesh), std::size_t{0});
}

void NonOrientableSurfacesTest::twoSidesStay() {
  for (const TriangleSoup& soup : {test::cube(), test::torus(9, 7), test::boxWithInnerWall(), test::disc(5, 2)}) {
    const HalfEdgeMesh before = buildMesh(soup).mesh;
    HalfEdgeMesh mesh = before;
    QVERIFY(cutNonOrientable(mesh, kAny, NumberType::Float64).isTwoSided);
    QCOMPARE(closeNonOrientable(mesh, {}, kAny, BoundaryCuts::Yes), std::size_t{0});
    QVERIFY(test::sameMesh(mesh, before));
  }
}

// RP² without a disc, closed by a disc: a sphere. Nothing but what the strip touched has moved.
void NonOrientableSurfacesTest::closesACrossCap() {
  for (const int levels : {1, 2, 3}) {
    const TriangleSoup soup = test::sphereWithCrossCap(levels);
    const HalfEdgeMesh before = buildMesh(soup).mesh;
    for (const NumberType numbers : {NumberType::Float64, NumberType::Float32}) {
      HalfEdgeMesh mesh = before;
      FillOptions options;
      options.numbers = numbers;
      QCOMPARE(closeNonOrientable(mesh, options, kAny, BoundaryCuts::No), std::size_t{1});
      QCOMPARE(validate(mesh), std::string());
      QVERIFY(test::countEdges(mesh).sound());
      QCOMPARE(test::eulerCharacteristic(mesh.compact().soup) % 2, 0L);
      QVERIFY(crossings(mesh) <= crossings(before));
      const std::set<test::Coordinates> now = test::allCoordinates(mesh.compact().soup);
      for (std::size_t i = 0; i + 3 < soup.points.size(); ++i) {
        bool isUsed = false;
        for (const Triangle& t : soup.triangles) isUsed = isUsed || std::find(t.begin(), t.end(), i) != t.end();
        QVERIFY(!isUsed || now.contains(test::coordinates(soup.points[i])));
      }
    }
  }
}

// Closed surfaces stay closed, and become oriented; the characteristic of each part is then even. A strip stays open.
void NonOrientableSurfacesTest::closes() {
  QFETCH(TriangleSoup, soup);
  const HalfEdgeMesh before = buildMesh(soup).mesh;
  HalfEdgeMesh mesh = before;
  const bool isClosed = test::countEdges(before).closed();
  if (!isClosed) {
    QCOMPARE(closeNonOrientable(mesh, {}, kAny, BoundaryCuts::No), std::size_t{0});
    QVERIFY(test::sameMesh(mesh, before));
  }
  QVERIFY(closeNonOrientable(mesh, {}, kAny, BoundaryCuts::Yes) > 0);
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(!isOneSided(mesh));
  QVERIFY(crossings(mesh) <= crossings(before));
  const test::Edges edges = test::countEdges(mesh);
  QCOMPARE(edges.nonManifold + edges.inconsistent, std::size_t{0});
  QCOMPARE(edges.closed(), isClosed);
  if (isClosed) QCOMPARE(test::eulerCharacteristic(mesh.compact().soup) % 2, 0L);
}

void NonOrientableSurfacesTest::cancelled() {
  const HalfEdgeMesh before = buildMesh(test::sphereWithCrossCap(2)).mesh;
  HalfEdgeMesh mesh = before;
  JobState state;
  state.cancelled = true;
  QCOMPARE(closeNonOrientable(mesh, {}, kAny, BoundaryCuts::Yes, Progress(state)), std::size_t{0});
  QVERIFY(test::sameMesh(mesh, before));
}

HANDWHEEL_TEST(NonOrientableSurfacesTest)
#include "NonOrientableSurfacesTest.moc"
