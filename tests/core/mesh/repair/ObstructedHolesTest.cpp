// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/ObstructedHoles.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/repair/intersections/SelfIntersectionRemoval.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>
#include <limits>
#include <random>

using namespace handwheel;

namespace {

// A ball without its top, and a closed rod that stands in it and out of the hole.
TriangleSoup ballWithRod() {
  TriangleSoup s = test::sphereWithoutCap(3, 0.5);
  test::append(s, test::moved(test::cylinder(12, 2, 0.1, 2.0, true), {0.03, 0.02, -0.2}));
  return s;
}

// A ball without its top, and triangles that cross each other in the hole.
TriangleSoup ballWithTangle() {
  TriangleSoup s = test::sphereWithoutCap(2, 0.6);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-0.6, 0.6);
  for (std::uint32_t i = 0; i < 30; ++i) {
    const auto n = static_cast<std::uint32_t>(s.points.size());
    for (int k = 0; k < 3; ++k) {
      const double x = anywhere(random), y = anywhere(random), z = anywhere(random);
      s.points.emplace_back(x, y, 0.9 + 0.5 * z);
    }
    s.triangles.push_back({n, n + 1, n + 2});
  }
  return s;
}

// A sheet that crosses itself everywhere, so that no body has room behind it.
TriangleSoup crumpledSheet() {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-0.5, 0.5);
  return test::grid(30, 30, false, false, [&](std::uint32_t i, std::uint32_t j) {
    const double x = i / 30.0 + 0.3 * anywhere(random), y = j / 30.0 + 0.3 * anywhere(random), z = anywhere(random);
    return Vec3(x, y, z);
  });
}

std::vector<ObstructedHole> holesOf(const HalfEdgeMesh& mesh, bool back) {
  std::vector<ObstructedHole> holes;
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh)) holes.push_back({loop, back});
  return holes;
}

// Those that are no outline of a loose triangle.
std::vector<ObstructedHole> longHolesOf(const HalfEdgeMesh& mesh) {
  std::vector<ObstructedHole> holes = holesOf(mesh, false);
  std::erase_if(holes, [](const ObstructedHole& hole) { return hole.loop.halfEdges.size() <= 3; });
  return holes;
}

}  // namespace

class ObstructedHolesTest : public QObject {
  Q_OBJECT

 private slots:
  void somethingStandsInTheHole();
  void manyAtOnce();
  void backs();
  void cancelled();
  void nothingToDo();
  void oneTangleLeavesEffortForOthers();
  void oneSheetLeavesEffortForOthers();
  void saysWhichWasCutShort();
  void countsSheets();
};

// Every patch crosses the rod; what is cut leaves all of the ball's and the rod's surface where it was.
void ObstructedHolesTest::somethingStandsInTheHole() {
  const HalfEdgeMesh before = buildMesh(ballWithRod()).mesh;
  for (NumberType numbers : {NumberType::Float64, NumberType::Float32}) {
    FillOptions options;
    options.numbers = numbers;
    const std::vector<BoundaryLoop> loops = findBoundaryLoops(before);
    QCOMPARE(loops.size(), std::size_t{1});
    for (const BoundaryLoop& loop : loops) {
      QVERIFY(HoleFiller(before).propose(loop, options).failure == FillFailure::SelfIntersecting);
    }
    HalfEdgeMesh mesh = before;
    const ObstructedClosings closings = closeObstructedHoles(mesh, holesOf(mesh, false), options, 0.01);
    QCOMPARE(closings.holes.size(), std::size_t{1});
    QVERIFY(closings.holes[0].closed);
    QVERIFY(closings.holes[0].newFaces > 0);
    QVERIFY(closings.cutFaces > 0);
    QVERIFY(test::countEdges(mesh).sound());
    QCOMPARE(validate(mesh), std::string());
    QVERIFY(countSelfIntersections(mesh, numbers) <= countSelfIntersections(before, numbers));
    for (Vertex v = 0; v < before.vertexSlots(); ++v) QVERIFY((mesh.position(v) - before.position(v)).norm() < 1e-3);
  }
}

void ObstructedHolesTest::manyAtOnce() {
  TriangleSoup s = ballWithRod();
  test::append(s, test::moved(ballWithRod(), {5, 0, 0}));
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  const ObstructedClosings closings = closeObstructedHoles(mesh, holesOf(mesh, false), {}, 0.01);
  QCOMPARE(
      std::count_if(closings.holes.begin(), closings.holes.end(), [](const ObstructedClosing& c) { return c.closed; }),
      2);
  QVERIFY(test::countEdges(mesh).sound());
}

void ObstructedHolesTest::backs() {
  TriangleSoup s = test::annulus(24, 3, 1.0, 2.0);
  test::append(s, test::moved(test::disc(12, 3), {0, 0, 3}));
  test::append(s, TriangleSoup{{{9, 0, 0}, {9, 1, 0}, {9, 0, 1}}, {{0, 1, 2}}});
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  const ObstructedClosings closings = closeObstructedHoles(mesh, holesOf(mesh, true), {}, 0.01);
  QVERIFY(!closings.holes.empty());
  for (const ObstructedClosing& c : closings.holes) {
    QVERIFY(c.closed);
    QVERIFY(c.method == FillMethod::ThickenedSheet);
  }
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
}

void ObstructedHolesTest::cancelled() {
  const HalfEdgeMesh before = buildMesh(ballWithRod()).mesh;
  HalfEdgeMesh mesh = before;
  JobState state;
  state.cancelled = true;
  closeObstructedHoles(mesh, holesOf(before, false), {}, 0.01, Progress(state));
  QVERIFY(test::sameMesh(mesh, before));
}

void ObstructedHolesTest::nothingToDo() {
  HalfEdgeMesh mesh = buildMesh(test::icosphere(2)).mesh;
  QVERIFY(closeObstructedHoles(mesh, {}, {}, 0.01).holes.empty());
}

// Whichever comes first.
void ObstructedHolesTest::oneTangleLeavesEffortForOthers() {
  for (const bool isTangleFirst : {false, true}) {
    TriangleSoup s = isTangleFirst ? ballWithTangle() : ballWithRod();
    test::append(s, test::moved(isTangleFirst ? ballWithRod() : ballWithTangle(), {5, 0, 0}));
    HalfEdgeMesh mesh = buildMesh(s).mesh;
    const std::vector<ObstructedHole> holes = longHolesOf(mesh);
    QCOMPARE(holes.size(), std::size_t{2});
    WorkBudget effort(600'000);
    const ObstructedClosings closings = closeObstructedHoles(mesh, holes, {}, 0.01, Progress().within(effort));
    QVERIFY(closings.holes[isTangleFirst ? 1 : 0].closed);
    QVERIFY(!closings.holes[isTangleFirst ? 1 : 0].isCutShort);
    QVERIFY(!closings.holes[isTangleFirst ? 0 : 1].closed);
    QVERIFY(closings.holes[isTangleFirst ? 0 : 1].isCutShort);
  }
}

// Attempts with a sheet that cannot be thickened do not prevent closing a hole and thickening a flat sheet.
void ObstructedHolesTest::oneSheetLeavesEffortForOthers() {
  TriangleSoup s = crumpledSheet();
  test::append(s, test::moved(ballWithRod(), {5, 0, 0}));
  test::append(s, test::moved(test::disc(12, 3), {9, 0, 0}));
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  std::vector<ObstructedHole> holes = holesOf(mesh, false);
  QCOMPARE(holes.size(), std::size_t{3});
  for (ObstructedHole& hole : holes) hole.back = hole.loop.centre.x() < 2.0 || hole.loop.centre.x() > 8.0;
  WorkBudget effort(2'000'000);
  const ObstructedClosings closings = closeObstructedHoles(mesh, holes, {}, 0.01, Progress().within(effort));
  for (std::size_t i = 0; i < holes.size(); ++i) QCOMPARE(closings.holes[i].closed, holes[i].loop.centre.x() > 2.0);
  QCOMPARE(closings.sheets.thickened, std::size_t{1});
  QCOMPARE(closings.sheets.left, (std::map<FillFailure, std::size_t>{{FillFailure::TooMuchEffort, 1}}));
}

// Sheets, not their outlines: a ring has two.
void ObstructedHolesTest::countsSheets() {
  TriangleSoup s = test::annulus(24, 3, 1.0, 2.0);
  test::append(s, test::moved(test::disc(12, 3), {0, 0, 3}));
  HalfEdgeMesh mesh = buildMesh(s).mesh;
  const std::vector<ObstructedHole> holes = holesOf(mesh, true);
  QCOMPARE(holes.size(), std::size_t{3});
  FillOptions options;
  options.keptCorners.insert(positionKey(s.points.back()));
  const SheetOutcomes sheets = closeObstructedHoles(mesh, holes, options, 0.01).sheets;
  QCOMPARE(sheets.thickened, std::size_t{1});
  QCOMPARE(sheets.left, (std::map<FillFailure, std::size_t>{{FillFailure::SheetKeptOpen, 1}}));
  QVERIFY(std::abs(sheets.thickness.least - 0.01) < 1e-12 && std::abs(sheets.thickness.largest - 0.01) < 1e-12);
}

// One hole is too much work; one may not be closed, because its sheet has a corner that stays as it is.
void ObstructedHolesTest::saysWhichWasCutShort() {
  TriangleSoup s = ballWithTangle();
  test::append(s, test::moved(test::disc(12, 3), {5, 0, 0}));
  const HalfEdgeMesh before = buildMesh(s).mesh;
  std::vector<ObstructedHole> holes = longHolesOf(before);
  QCOMPARE(holes.size(), std::size_t{2});
  holes[1].back = true;
  FillOptions options;
  options.keptCorners.insert(positionKey(loopPoints(before, holes[1].loop).front()));
  for (const bool isEnough : {false, true}) {
    HalfEdgeMesh mesh = before;
    WorkBudget effort(isEnough ? std::numeric_limits<std::size_t>::max() : 1'500'000);
    const ObstructedClosings closings = closeObstructedHoles(mesh, holes, options, 0.01, Progress().within(effort));
    QVERIFY(!effort.isSpent());
    QVERIFY(!closings.holes[0].closed && !closings.holes[1].closed);
    QCOMPARE(closings.holes[0].isCutShort, !isEnough);
    QVERIFY(!closings.holes[1].isCutShort);
  }
}

HANDWHEEL_TEST(ObstructedHolesTest)
#include "ObstructedHolesTest.moc"
