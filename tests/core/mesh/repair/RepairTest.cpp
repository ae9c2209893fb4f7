// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/repair/Repair.h"

#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "RepairChecks.h"
#include "TestClass.h"
#include "mesh/defects/Defects.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshDelta.h"
#include "mesh/structure/MeshValidator.h"
#include "mesh/structure/PositionKey.h"

#include <QTest>
#include <random>
#include <set>
#include <thread>

using namespace handwheel;

namespace {

// Five holes, 40 faces turned over, one doubled and one without extent.
TriangleSoup woundedSphere() {
  TriangleSoup soup = test::sphereWithHoles(4, 5, 0.3);
  std::mt19937 random(3);
  for (int i = 0; i < 40; ++i) {
    Triangle& t = soup.triangles[random() % soup.triangles.size()];
    std::swap(t[1], t[2]);
  }
  soup.triangles.push_back(soup.triangles[100]);
  soup.triangles.push_back({soup.triangles[5][0], soup.triangles[5][0], soup.triangles[5][1]});
  return soup;
}

// An open sheet, with this instead of zeros.
TriangleSoup bowl(int n, double zero) {
  return test::grid(n + 1, n + 1, false, false, [&](std::uint32_t i, std::uint32_t j) {
    const double x = double(i) / n - 0.5, y = double(j) / n - 0.5;
    return Vec3(x, y, x == 0.0 && y == 0.0 ? zero : 0.1 * (x * x + y * y));
  });
}

}  // namespace

class RepairTest : public QObject {
  Q_OBJECT

 private slots:
  void woundedSphereHeals();
  void soundShapesStay();
  void rimStaysOpen();
  void whatWasARimIsKept();
  void rimOnRequest();
  void flatSheetIsNotCovered();
  void separatesWhatTouches();
  void separatedCornersAreNoNearPair();
  void keepOpen();
  void keptHoleOfASheet();
  void maxEdges();
  void debris();
  void openDebris();
  void smallPartsThatCrossAreNoDebris();
  void poleInASheet();
  void needleMovesNothing();
  void cancelledBefore();
  void cancelledAnyTime();
  void undoAndRedo();
  void singlePrecision();
  void coordinatesThatCannotBeCut();
  void aTangleLeavesEffortForTheRest();
  void saysWhatWasCutShort();
};

void RepairTest::woundedSphereHeals() {
  const TriangleSoup soup = woundedSphere();
  const HalfEdgeMesh input = buildMesh(soup).mesh;
  HalfEdgeMesh mesh = input;
  const RepairReport report = repair(mesh, {});
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(test::eulerCharacteristic(mesh), 2l);
  QCOMPARE(test::intersections(mesh), std::size_t{0});
  QCOMPARE(report.loops.size(), std::size_t{5});
  QCOMPARE(test::count(report, LoopOutcome::Filled), std::size_t{5});
  QCOMPARE(report.removedDegenerate, std::size_t{1});
  QCOMPARE(report.removedDuplicates, std::size_t{1});
  QVERIFY(report.modifiedVertices.empty());
  QCOMPARE(test::inconsistent(input, mesh, report), std::string());
  for (Vertex v = 0; v < input.vertexSlots(); ++v) QVERIFY(test::sameBits(input.position(v), mesh.position(v)));
  // The sphere's volume less what its facets cut off, h² / 4 for edges of about 0.08; the patches may be a little off.
  const double full = 4.0 / 3.0 * M_PI;
  QVERIFY(std::abs(std::abs(test::volume(mesh.compact().soup)) - full) < 0.01 * full);
}

void RepairTest::soundShapesStay() {
  for (const TriangleSoup& soup : {test::cube(), test::icosphere(3), test::torus(16, 10), test::bumpySphere(3)}) {
    const HalfEdgeMesh input = buildMesh(soup).mesh;
    HalfEdgeMesh mesh = input;
    const RepairReport report = repair(mesh, {});
    QVERIFY(test::sameMesh(mesh, input));
    QVERIFY(report.loops.empty() && report.modifiedVertices.empty());
    QCOMPARE(report.reversedFaces + report.removedDegenerate + report.removedDuplicates, std::size_t{0});
  }
}

void RepairTest::rimStaysOpen() {
  const HalfEdgeMesh input = buildMesh(test::annulus(24, 4, 1.0, 3.0)).mesh;
  HalfEdgeMesh mesh = input;
  const RepairReport report = repair(mesh, {});
  QCOMPARE(report.loops.size(), std::size_t{2});
  QCOMPARE(test::count(report, LoopOutcome::Filled), std::size_t{1});
  for (const LoopResult& loop : report.loops)
    if (loop.outcome != LoopOutcome::Filled)
      QVERIFY(loop.outcome == LoopOutcome::KeptOpen && loop.reason == FillFailure::SheetBoundary);
  QCOMPARE(test::countBorder(mesh), std::size_t{24});
  QCOMPARE(test::inconsistent(input, mesh, report), std::string());
}

// A tube whose lower end has teeth, so that its outline squared is 109 times its area, is an open sheet. With its upper
// hole filled it looks like none; but who keeps sheets open keeps what was the edge of one, and is informed.
void RepairTest::whatWasARimIsKept() {
  const std::uint32_t n = 64;
  const HalfEdgeMesh input = buildMesh(test::grid(n, 4, true, false, [&](std::uint32_t i, std::uint32_t j) {
                               const double u = 2.0 * M_PI * i / n;
                               return Vec3(std::cos(u), std::sin(u), j == 0 ? (i % 2) * 0.53 : 2.0 * j / 3.0);
                             })).mesh;
  RepairOptions options;
  options.sheets = SheetHandling::Keep;
  for (const FillMethod method : {FillMethod::Fair, FillMethod::Ear}) {
    options.fill.method = method;
    HalfEdgeMesh mesh = input;
    const RepairReport report = repair(mesh, options);
    QCOMPARE(report.loops.size(), std::size_t{2});
    QCOMPARE(test::count(report, LoopOutcome::Filled), std::size_t{1});
    QCOMPARE(test::countBorder(mesh), std::size_t{n});
    const auto kept = std::find_if(report.loops.begin(), report.loops.end(),
                                   [](const LoopResult& loop) { return loop.outcome == LoopOutcome::KeptOpen; });
    QVERIFY(kept != report.loops.end() && kept->isSheetBoundary && kept->reason == FillFailure::WasSheetBoundary);
    QCOMPARE(test::inconsistent(input, mesh, report), std::string());
  }
}

// A shallow bowl: flat enough to be a sheet; a lid over it encloses a volume.
void RepairTest::rimOnRequest() {
  TriangleSoup bowl = test::disc(24, 5);
  for (Vec3& p : bowl.points) p.z() = 1e-3 * (p.x() * p.x() + p.y() * p.y());
  const HalfEdgeMesh input = buildMesh(bowl).mesh;
  HalfEdgeMesh mesh = input;
  QVERIFY(repair(mesh, {}).loops.at(0).reason == FillFailure::SheetBoundary);
  RepairOptions options;
  options.sheets = SheetHandling::Fill;
  options.fill.method = FillMethod::Ear;
  const RepairReport report = repair(mesh, options);
  QCOMPARE(test::count(report, LoopOutcome::Filled), std::size_t{1});
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(test::intersections(mesh), std::size_t{0});
  QCOMPARE(validate(mesh), std::string());
}

// Any patch over a perfectly flat disc either covers it or bulges; if there is one it must not meet the disc.
void RepairTest::flatSheetIsNotCovered() {
  const HalfEdgeMesh input = buildMesh(test::disc(24, 5)).mesh;
  HalfEdgeMesh mesh = input;
  RepairOptions options;
  options.sheets = SheetHandling::Fill;
  const RepairReport report = repair(mesh, options);
  QCOMPARE(test::intersections(mesh), std::size_t{0});
  QCOMPARE(test::inconsistent(input, mesh, report), std::string());
}

// Two bodies that share a corner, as "Separate" does it: by last digits, without a new defect.
void RepairTest::separatesWhatTouches() {
  const HalfEdgeMesh before = buildMesh(test::twoCubesSharingAVertex()).mesh;
  QCOMPARE(findDefects(before).nonManifoldVertices.size(), std::size_t{1});
  HalfEdgeMesh mesh = before;
  const RepairReport report = repair(mesh, {});
  QCOMPARE(report.separatedVertices, std::size_t{1});
  const Defects after = findDefects(mesh);
  QVERIFY(after.nonManifoldVertices.empty() && after.nearVertices.empty() && after.loops.empty());
  QCOMPARE(test::meetingPairs(mesh), std::size_t{0});
  for (Vertex v = 0; v < before.vertexSlots(); ++v) QVERIFY((mesh.position(v) - before.position(v)).norm() < 1e-9);
  QVERIFY(repair(mesh, {}).separatedVertices == 0);
}

// Two squares that share a corner are two sheets afterwards, whose corners are no two halves of one vertex.
void RepairTest::separatedCornersAreNoNearPair() {
  TriangleSoup soup = test::grid(4, 4, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0); });
  const TriangleSoup other = test::moved(soup, {3, 3, 0});
  test::append(soup, other);
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  QCOMPARE(findDefects(mesh).nonManifoldVertices.size(), std::size_t{1});
  repair(mesh, {});
  const Defects after = findDefects(mesh);
  QVERIFY(after.nonManifoldVertices.empty());
  QVERIFY(after.nearVertices.empty());
  QCOMPARE(after.loops.size(), std::size_t{2});
  QCOMPARE(mesh.liveFaceCount(), soup.triangles.size());
}

void RepairTest::keepOpen() {
  const HalfEdgeMesh input = buildMesh(test::sphereWithHoles(4, 5, 0.3)).mesh;
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(input);
  HalfEdgeMesh mesh = input;
  RepairOptions options;
  options.keepOpen = {1, 3};
  const RepairReport report = repair(mesh, options);
  for (const LoopResult& loop : report.loops) {
    const bool kept = options.keepOpen.contains(loop.id);
    QVERIFY(loop.outcome == (kept ? LoopOutcome::KeptOpen : LoopOutcome::Filled));
    QVERIFY(loop.reason == (kept ? FillFailure::KeptOpen : FillFailure::None));
  }
  const std::vector<BoundaryLoop> left = findBoundaryLoops(mesh);
  QCOMPARE(left.size(), std::size_t{2});
  QVERIFY(left[0].halfEdges == loops[1].halfEdges);
  QVERIFY(left[1].halfEdges == loops[3].halfEdges);
  QCOMPARE(test::inconsistent(input, mesh, report), std::string());
}

// A back would close every loop of the sheet, so a sheet with a loop that is to stay open gets none. By its number, and
// by its length: the rim is the longer one.
void RepairTest::keptHoleOfASheet() {
  const HalfEdgeMesh input = buildMesh(test::withHole(test::disc(24, 8), Vec3::Zero(), 0.3)).mesh;
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(input);
  QCOMPARE(loops.size(), std::size_t{2});
  const int rim = loops[0].isSheetBoundary ? 0 : 1, hole = 1 - rim;
  QVERIFY(loops[std::size_t(rim)].isSheetBoundary && !loops[std::size_t(hole)].isSheetBoundary);
  HalfEdgeMesh mesh = input;
  RepairOptions options;
  options.sheets = SheetHandling::Thicken;
  options.keepOpen = {hole};
  const RepairReport report = repair(mesh, options);
  QVERIFY(test::sameMesh(mesh, input));
  QVERIFY(report.loops[std::size_t(hole)].reason == FillFailure::KeptOpen);
  QVERIFY(report.loops[std::size_t(rim)].reason == FillFailure::SheetKeptOpen);
  QCOMPARE(report.sheets.left, (std::map<FillFailure, std::size_t>{{FillFailure::SheetKeptOpen, 1}}));
  QCOMPARE(test::count(report, LoopOutcome::KeptOpen), std::size_t{2});

  mesh = input;
  options.keepOpen = {};
  options.maxEdges = 4;
  const RepairReport tooLong = repair(mesh, options);
  QVERIFY(test::sameMesh(mesh, input));
  QCOMPARE(tooLong.loops.size(), loops.size());
  for (const LoopResult& loop : tooLong.loops) QVERIFY(loop.reason == FillFailure::TooLong);
}

void RepairTest::maxEdges() {
  TriangleSoup soup = test::withHole(test::icosphere(4), Vec3::UnitX(), 0.5);
  soup = test::withHole(soup, -Vec3::UnitX(), 0.1);
  const HalfEdgeMesh input = buildMesh(soup).mesh;
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(input);
  QCOMPARE(loops.size(), std::size_t{2});
  for (const BoundaryLoop& smaller : loops) {
    HalfEdgeMesh mesh = input;
    RepairOptions options;
    options.maxEdges = smaller.halfEdges.size();
    const RepairReport report = repair(mesh, options);
    for (const LoopResult& loop : report.loops) {
      const bool tooLong = loop.edges > options.maxEdges;
      QVERIFY((loop.reason == FillFailure::TooLong) == tooLong);
      QVERIFY((loop.outcome == LoopOutcome::KeptOpen) == tooLong);
    }
    QCOMPARE(test::inconsistent(input, mesh, report), std::string());
  }
}

void RepairTest::debris() {
  TriangleSoup soup = test::icosphere(4);
  test::append(soup, test::moved(test::tetrahedron(), Vec3(2, 2, 2), 0.01));
  const HalfEdgeMesh input = buildMesh(soup).mesh;
  for (bool remove : {false, true}) {
    HalfEdgeMesh mesh = input;
    RepairOptions options;
    options.removeDebris = remove;
    const RepairReport report = repair(mesh, options);
    QCOMPARE(report.removedDebris, std::size_t(remove ? 4 : 0));
    QCOMPARE(mesh.liveFaceCount(), input.liveFaceCount() - report.removedDebris);
    QCOMPARE(test::eulerCharacteristic(mesh), remove ? 2l : 4l);
    QCOMPARE(validate(mesh), std::string());
  }
}

// A loop whose faces all went with the debris needs no patch, and the report says why.
void RepairTest::openDebris() {
  TriangleSoup soup = test::sphereWithoutCap(4);
  test::append(soup, TriangleSoup{{Vec3(3, 0, 0), Vec3(3, 0.01, 0), Vec3(3, 0, 0.01)}, {{0, 1, 2}}});
  const HalfEdgeMesh input = buildMesh(soup).mesh;
  HalfEdgeMesh mesh = input;
  RepairOptions options;
  options.removeDebris = true;
  const RepairReport report = repair(mesh, options);
  QCOMPARE(report.loops.size(), std::size_t{2});
  for (const LoopResult& loop : report.loops) {
    QCOMPARE(loop.method == FillMethod::Removed, loop.edges == 3);
    QCOMPARE(loop.newFaces > 0, loop.edges != 3);
  }
  QCOMPARE(test::inconsistent(input, mesh, report), std::string());
}

// Every face of both is cut, and all of their corners stay.
void RepairTest::smallPartsThatCrossAreNoDebris() {
  TriangleSoup soup = test::icosphere(4);
  const auto first = static_cast<Vertex>(soup.points.size());
  TriangleSoup star = test::tetrahedron();
  TriangleSoup other;
  for (const Vec3& p : star.points) other.points.push_back(Vec3(0.51, 0.52, 0.53) - p);
  for (const Triangle& t : star.triangles) other.triangles.push_back({t[0], t[2], t[1]});
  test::append(star, other);
  test::append(soup, test::moved(star, Vec3(2, 2, 2), 0.01));
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  RepairOptions options;
  options.cutCrossings = true;
  const RepairReport report = repair(mesh, options);
  QVERIFY(report.cutClusters > 0);
  QCOMPARE(test::intersections(mesh), std::size_t{0});
  std::set<PointKey> corners;
  for (const Vec3& p : mesh.compact().soup.points) corners.insert(positionKey(p));
  for (Vertex v = first; v < soup.points.size(); ++v) QVERIFY(corners.contains(positionKey(soup.points[v])));
}

// A rod stands in the hole of a sheet: a patch is cut where it crosses the rod, and the sheet gets a back.
void RepairTest::poleInASheet() {
  TriangleSoup soup = test::annulus(24, 3, 1.0, 3.0);
  test::append(soup, test::moved(test::cylinder(8, 10, 0.1, 20.0, true), Vec3(0.05, 0.02, -10.0)));
  const HalfEdgeMesh input = buildMesh(soup).mesh;
  HalfEdgeMesh mesh = input;
  RepairOptions options;
  options.sheets = SheetHandling::Thicken;
  const RepairReport report = repair(mesh, options);
  QCOMPARE(test::intersections(mesh), std::size_t{0});
  QCOMPARE(test::count(report, LoopOutcome::Filled), std::size_t{2});
  QVERIFY(test::countEdges(mesh).sound());
  for (Vertex v = 0; v < input.vertexSlots(); ++v) QVERIFY((mesh.position(v) - input.position(v)).norm() < 1e-3);
  QCOMPARE(test::inconsistent(input, mesh, report), std::string());
}

// An edge of a cube has a middle point on one side only; a needle without area lies between. Taking it away moves
// nothing.
void RepairTest::needleMovesNothing() {
  TriangleSoup soup = test::cube();
  soup.points.push_back(Vec3(0.5, 0, 0));
  soup.triangles[4] = {0, 8, 5};  // was {0, 1, 5}
  soup.triangles.push_back({8, 1, 5});
  soup.triangles.push_back({0, 1, 8});
  QVERIFY(test::countEdges(soup).sound());
  const HalfEdgeMesh input = buildMesh(soup).mesh;
  HalfEdgeMesh mesh = input;
  const RepairReport report = repair(mesh, {});
  QCOMPARE(report.removedDegenerate, std::size_t{1});
  QVERIFY(test::countEdges(mesh).sound());
  QVERIFY(test::reallyTouched(input, mesh).empty());
  QVERIFY2(report.modifiedVertices.empty(), "vertices that stayed where they were are called modified");
}

void RepairTest::cancelledBefore() {
  const HalfEdgeMesh input = buildMesh(woundedSphere()).mesh;
  HalfEdgeMesh mesh = input;
  JobState job;
  job.cancelled = true;
  QVERIFY(repair(mesh, {}, Progress(job)).cancelled);
  QVERIFY(test::sameMesh(mesh, input));
}

void RepairTest::cancelledAnyTime() {
  const HalfEdgeMesh input = buildMesh(test::sphereWithHoles(3, 5, 0.35)).mesh;
  HalfEdgeMesh repaired = input;
  repair(repaired, {});
  for (int wait : {0, 200, 1000, 3000, 6000, 10000, 20000}) {
    HalfEdgeMesh mesh = input;
    JobState job;
    std::thread canceller([&] {
      std::this_thread::sleep_for(std::chrono::microseconds(wait));
      job.cancelled = true;
    });
    const RepairReport report = repair(mesh, {}, Progress(job));
    canceller.join();
    QVERIFY(test::sameMesh(mesh, report.cancelled ? input : repaired));
  }
}

void RepairTest::undoAndRedo() {
  const HalfEdgeMesh input = buildMesh(woundedSphere()).mesh;
  HalfEdgeMesh mesh = input;
  repair(mesh, {});
  const HalfEdgeMesh repaired = mesh;
  MeshDelta delta = MeshDelta::between(input, repaired);
  mesh = input;
  for (int round = 0; round < 2; ++round) {
    delta.swap(mesh);
    QVERIFY(test::sameMesh(mesh, repaired));
    delta.swap(mesh);
    QVERIFY(test::sameMesh(mesh, input));
  }
}

// A file in single precision is repaired to one that is sound in single precision.
void RepairTest::singlePrecision() {
  TriangleSoup soup = test::sphereWithHoles(3, 5, 0.35);
  for (Vec3& p : soup.points) p = rounded(p, NumberType::Float32);
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  RepairOptions options;
  options.fill.numbers = NumberType::Float32;
  repair(mesh, options);
  TriangleSoup written = mesh.compact().soup;
  for (Vec3& p : written.points) p = rounded(p, NumberType::Float32);
  for (std::size_t i = 0; i < written.points.size(); ++i)
    QVERIFY(test::sameBits(written.points[i], mesh.compact().soup.points[i]));
  QVERIFY(test::countEdges(written).sound());
}

// Exact numbers of the cubes' coordinates would need more bits than cuts take. What touches is parted all the same, and
// a sheet gets its back.
void RepairTest::coordinatesThatCannotBeCut() {
  for (const double tiny : {1e-170, 5e-324}) {
    TriangleSoup soup = test::twoCubesSharingAnEdge();
    for (Vec3& p : soup.points) p = p.unaryExpr([&](double x) { return x == 0.0 ? tiny : x; });
    HalfEdgeMesh mesh = buildMesh(soup).mesh;
    QCOMPARE(test::countEdges(mesh).nonManifold, std::size_t{1});
    QVERIFY(repair(mesh, {}).separatedVertices > 0);
    QVERIFY(test::countEdges(mesh.compact().soup).sound());

    mesh = buildMesh(bowl(60, tiny)).mesh;
    RepairOptions options;
    options.sheets = SheetHandling::Thicken;
    const RepairReport report = repair(mesh, options);
    QCOMPARE(report.loops.size(), std::size_t{1});
    QVERIFY(report.loops[0].method == FillMethod::ThickenedSheet);
    QVERIFY(test::countEdges(mesh.compact().soup).sound());
  }
}

// To close the cut of a small surface with one side takes more than there is, for triangles cross it; what touches
// elsewhere is parted all the same, and a hole with something in it is closed.
void RepairTest::aTangleLeavesEffortForTheRest() {
  TriangleSoup soup = test::sphereWithCrossCap(1);
  std::mt19937 random(0);
  std::uniform_real_distribution<double> anywhere(-1.5, 1.5);
  for (int i = 0; i < 60; ++i) {
    const auto n = static_cast<std::uint32_t>(soup.points.size());
    for (int k = 0; k < 3; ++k) {
      const double x = anywhere(random), y = anywhere(random), z = anywhere(random);
      soup.points.emplace_back(x, y, z);
    }
    soup.triangles.push_back({n, n + 1, n + 2});
  }
  test::append(soup, test::moved(test::twoCubesSharingAnEdge(), {1e4, 0, 0}));
  HalfEdgeMesh mesh = buildMesh(soup).mesh;
  QCOMPARE(test::countEdges(mesh).nonManifold, std::size_t{1});
  const RepairReport report = repair(mesh, {});
  QVERIFY(report.separatedVertices > 0);
  QVERIFY(!report.isSeparationIncomplete);
  QCOMPARE(test::countEdges(mesh.compact().soup).nonManifold, std::size_t{0});
}

void RepairTest::saysWhatWasCutShort() {
  TriangleSoup wedges;  // overlapping wedges around one edge
  for (int i = 0; i < 60; ++i) {
    const double u = 2 * M_PI * i / 60, v = 2 * M_PI * (i + 15.5) / 60;
    TriangleSoup wedge = test::tetrahedron();
    wedge.points = {Vec3(3, 3, 3), Vec3(3 + std::cos(u), 3 + std::sin(u), 3.5),
                    Vec3(3 + std::cos(v), 3 + std::sin(v), 3.5), Vec3(3, 3, 4)};
    for (Vec3& p : wedge.points) p = rounded(p, NumberType::Float32);
    test::append(wedges, wedge);
  }
  HalfEdgeMesh mesh = buildMesh(wedges).mesh;
  QVERIFY(repair(mesh, {}).isSeparationIncomplete);

  RepairOptions options;
  options.cutCrossings = true;
  std::mt19937 random(0);
  TriangleSoup soup = test::randomSoup(random, 100, 1000);
  soup.points[soup.triangles[0][0]].x() = 1e-90;  // exact arithmetic takes long
  mesh = buildMesh(soup).mesh;
  QVERIFY(repair(mesh, options).isIntersectionRemovalIncomplete);

  TriangleSoup cubes = test::twoCubesSharingAnEdge();
  test::append(cubes, test::cube(1.0, {0.41, 0.27, 0.33}));
  mesh = buildMesh(cubes).mesh;
  const RepairReport report = repair(mesh, options);
  QVERIFY(report.cutClusters > 0 && report.separatedVertices > 0);
  QVERIFY(!report.isSeparationIncomplete && !report.isIntersectionRemovalIncomplete);
}

HANDWHEEL_TEST(RepairTest)
#include "RepairTest.moc"
