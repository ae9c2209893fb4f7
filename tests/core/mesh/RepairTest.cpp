// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/Repair.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "mesh/Defects.h"
#include "mesh/MeshBuilder.h"
#include "mesh/MeshDelta.h"
#include "mesh/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>
#include <algorithm>
#include <thread>

using namespace handwheel;

namespace {

std::size_t intersections(const HalfEdgeMesh& mesh) { return findSelfIntersections(mesh).value().size(); }

// Input vertices whose position changed, or that no face uses any more though one did.
std::set<Vertex> reallyTouched(const HalfEdgeMesh& before, const HalfEdgeMesh& after) {
  const std::set<test::Place> left = test::places(after.compact().soup);
  std::set<Vertex> touched;
  for (Face f = 0; f < before.faceSlots(); ++f)
    for (Vertex v : before.triangle(f))
      if (!test::sameBits(before.position(v), after.position(v)) || !left.contains(test::place(before.position(v))))
        touched.insert(v);
  return touched;
}

std::size_t count(const RepairReport& report, LoopOutcome outcome) {
  return std::count_if(report.loops.begin(), report.loops.end(),
                       [&](const LoopResult& loop) { return loop.outcome == outcome; });
}

// What every report must say, whatever the mesh.
std::string inconsistent(const HalfEdgeMesh& before, const HalfEdgeMesh& after, const RepairReport& report) {
  const std::vector<BoundaryLoop> loops = findBoundaryLoops(before);
  std::vector<int> seen(loops.size(), 0);
  bool allFilled = true;
  for (const LoopResult& loop : report.loops) {
    if (loop.id >= int(loops.size())) return "an id that the input does not have";
    if (loop.id >= 0) ++seen[loop.id];
    if (loop.id >= 0 && loop.edges != loops[loop.id].borderEdges) return "a loop with the wrong number of edges";
    if ((loop.outcome == LoopOutcome::Filled) != (loop.reason == FillFailure::None)) return "an outcome without a reason";
    allFilled = allFilled && loop.outcome == LoopOutcome::Filled;
  }
  if (std::any_of(seen.begin(), seen.end(), [](int n) { return n != 1; })) return "a loop is not reported exactly once";
  if (allFilled != (test::countBorder(after) == 0)) return "all loops are filled if and only if no border is left";
  return {};
}

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

// A closed shape, rough or smooth, with holes, islands in holes and single faces missing.
TriangleSoup cutAtRandom(TriangleSoup soup, std::mt19937& random) {
  const auto unit = [&] { return random() / 4294967296.0; };
  if (random() % 2) {
    const double roughness = 0.03 * unit();  // along the ray from the middle, which crosses spheres once: no new crossings
    for (Vec3& p : soup.points) p *= 1.0 + roughness * unit();
  }
  for (std::size_t holes = 1 + random() % 5; holes > 0; --holes) {
    const Vec3 centre = soup.points[random() % soup.points.size()];
    const double radius = 0.05 + 0.5 * unit() * unit(), island = random() % 3 ? 0.0 : 0.5 * radius;
    std::erase_if(soup.triangles, [&](const Triangle& t) {
      const double distance = (soup.points[t[0]] - centre).norm();
      return distance < radius && distance >= island;
    });
  }
  for (std::size_t single = random() % 4; single > 0 && soup.triangles.size() > 9; --single)
    soup.triangles.erase(soup.triangles.begin() + std::ptrdiff_t(random() % soup.triangles.size()));
  return soup;
}

}  // namespace

class RepairTest : public QObject {
  Q_OBJECT

 private slots:
  void woundedSphereHeals();
  void soundShapesStay();
  void rimStaysOpen();
  void rimOnRequest();
  void flatSheetIsNotCovered();
  void keepOpen();
  void maxEdges();
  void debris();
  void poleIsReported();
  void needleMovesNothing();
  void cancelledBefore();
  void cancelledAnyTime();
  void undoAndRedo();
  void singlePrecision();
  void randomHoles();
  void anySoup();
};

void RepairTest::woundedSphereHeals() {
  const TriangleSoup soup = woundedSphere();
  const HalfEdgeMesh input = buildMesh(soup).mesh;
  HalfEdgeMesh mesh = input;
  const RepairReport report = repair(mesh, {});
  QCOMPARE(validate(mesh), std::string());
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(test::eulerCharacteristic(mesh), 2l);
  QCOMPARE(intersections(mesh), std::size_t{0});
  QCOMPARE(report.loops.size(), std::size_t{5});
  QCOMPARE(count(report, LoopOutcome::Filled), std::size_t{5});
  QCOMPARE(report.removedDegenerate, std::size_t{1});
  QCOMPARE(report.removedDuplicates, std::size_t{1});
  QVERIFY(report.touchedVertices.empty());
  QCOMPARE(inconsistent(input, mesh, report), std::string());
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
    QVERIFY(report.loops.empty() && report.touchedVertices.empty());
    QCOMPARE(report.turnedFaces + report.removedDegenerate + report.removedDuplicates, std::size_t{0});
  }
}

void RepairTest::rimStaysOpen() {
  const HalfEdgeMesh input = buildMesh(test::annulus(24, 4, 1.0, 3.0)).mesh;
  HalfEdgeMesh mesh = input;
  const RepairReport report = repair(mesh, {});
  QCOMPARE(report.loops.size(), std::size_t{2});
  QCOMPARE(count(report, LoopOutcome::Filled), std::size_t{1});
  for (const LoopResult& loop : report.loops)
    if (loop.outcome != LoopOutcome::Filled)
      QVERIFY(loop.outcome == LoopOutcome::KeptOpen && loop.reason == FillFailure::Rim);
  QCOMPARE(test::countBorder(mesh), std::size_t{24});
  QCOMPARE(inconsistent(input, mesh, report), std::string());
}

// A shallow bowl: flat enough to be a sheet; a lid over it encloses a volume.
void RepairTest::rimOnRequest() {
  TriangleSoup bowl = test::disc(24, 5);
  for (Vec3& p : bowl.points) p.z() = 1e-3 * (p.x() * p.x() + p.y() * p.y());
  const HalfEdgeMesh input = buildMesh(bowl).mesh;
  HalfEdgeMesh mesh = input;
  QVERIFY(repair(mesh, {}).loops.at(0).reason == FillFailure::Rim);
  RepairOptions options;
  options.fillRims = true;
  options.fill.method = FillMethod::Ear;
  const RepairReport report = repair(mesh, options);
  QCOMPARE(count(report, LoopOutcome::Filled), std::size_t{1});
  QVERIFY(test::countEdges(mesh).sound());
  QCOMPARE(intersections(mesh), std::size_t{0});
  QCOMPARE(validate(mesh), std::string());
}

// Any patch over a perfectly flat disc either covers it or bulges; if there is one it must not meet the disc.
void RepairTest::flatSheetIsNotCovered() {
  const HalfEdgeMesh input = buildMesh(test::disc(24, 5)).mesh;
  HalfEdgeMesh mesh = input;
  RepairOptions options;
  options.fillRims = true;
  const RepairReport report = repair(mesh, options);
  QCOMPARE(intersections(mesh), std::size_t{0});
  QCOMPARE(inconsistent(input, mesh, report), std::string());
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
  QCOMPARE(inconsistent(input, mesh, report), std::string());
}

void RepairTest::maxEdges() {
  TriangleSoup soup = test::withHole(test::icosphere(4), Vec3::UnitX(), 0.5);
  soup = test::withHole(soup, -Vec3::UnitX(), 0.1);
  const HalfEdgeMesh input = buildMesh(soup).mesh;
  for (const BoundaryLoop& smaller : findBoundaryLoops(input)) {
    HalfEdgeMesh mesh = input;
    RepairOptions options;
    options.maxEdges = smaller.halfEdges.size();
    const RepairReport report = repair(mesh, options);
    for (const LoopResult& loop : report.loops) {
      const bool tooLong = loop.edges > options.maxEdges;
      QVERIFY((loop.reason == FillFailure::TooLong) == tooLong);
      QVERIFY((loop.outcome == LoopOutcome::KeptOpen) == tooLong);
    }
    QCOMPARE(inconsistent(input, mesh, report), std::string());
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

void RepairTest::poleIsReported() {
  TriangleSoup soup = test::annulus(24, 3, 1.0, 3.0);
  test::append(soup, test::moved(test::cylinder(8, 10, 0.1, 20.0, true), Vec3(0.05, 0.02, -10.0)));
  const HalfEdgeMesh input = buildMesh(soup).mesh;
  HalfEdgeMesh mesh = input;
  const RepairReport report = repair(mesh, {});
  QCOMPARE(intersections(mesh), std::size_t{0});
  QCOMPARE(count(report, LoopOutcome::Failed), std::size_t{1});
  for (const LoopResult& loop : report.loops)
    QVERIFY(loop.reason == FillFailure::Rim || loop.reason == FillFailure::SelfIntersecting);
  QCOMPARE(inconsistent(input, mesh, report), std::string());
}

// An edge of a cube has a middle point on one side only; a needle without area lies between. Taking it away moves nothing.
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
  QVERIFY(reallyTouched(input, mesh).empty());
  QVERIFY2(report.touchedVertices.empty(), "vertices that stayed where they were are called touched");
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

void RepairTest::randomHoles() {
  const std::vector<TriangleSoup> shapes = {test::icosphere(3), test::torus(32, 16), test::bumpySphere(3)};
  QVERIFY(rc::check("random holes in closed shapes are closed, or left with a reason", [&] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const TriangleSoup soup = cutAtRandom(shapes[random() % 3], random);
    const HalfEdgeMesh input = buildMesh(soup).mesh;
    RC_PRE(intersections(input) == std::size_t{0});  // roughness may fold the torus
    HalfEdgeMesh mesh = input;
    RepairOptions options;
    options.fill.method = *rc::gen::element(FillMethod::Fair, FillMethod::Ear);
    options.fill.numbers = *rc::gen::element(NumberType::Float32, NumberType::Float64);
    options.fillRims = *rc::gen::arbitrary<bool>();
    const RepairReport report = repair(mesh, options);
    RC_ASSERT(validate(mesh) == std::string());
    RC_ASSERT(inconsistent(input, mesh, report) == std::string());
    RC_ASSERT(intersections(mesh) == std::size_t{0});
    const test::Edges edges = test::countEdges(mesh);
    RC_ASSERT(edges.nonManifold == std::size_t{0});
    RC_ASSERT(edges.inconsistent == std::size_t{0});
    RC_ASSERT(edges.closed() == (count(report, LoopOutcome::Filled) == report.loops.size()));
    const std::set<Vertex> said(report.touchedVertices.begin(), report.touchedVertices.end());
    for (Vertex v : reallyTouched(input, mesh)) RC_ASSERT(said.contains(v));
    RC_CLASSIFY(edges.closed(), "closed");
  }));
}

void RepairTest::anySoup() {
  QVERIFY(rc::check("whatever the input, the result is a mesh and the report adds up", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto steps = *rc::gen::inRange<std::uint32_t>(2, 7);
    const HalfEdgeMesh input = buildMesh(test::randomSoup(random, *rc::gen::inRange<std::size_t>(1, 40), steps)).mesh;
    HalfEdgeMesh mesh = input;
    RepairOptions options;
    options.fillRims = *rc::gen::arbitrary<bool>();
    options.removeDebris = *rc::gen::arbitrary<bool>();
    options.fill.numbers = *rc::gen::element(NumberType::Float32, NumberType::Float64);
    const RepairReport report = repair(mesh, options);
    RC_ASSERT(validate(mesh) == std::string());
    RC_ASSERT(inconsistent(input, mesh, report) == std::string());
    RC_CLASSIFY(report.loops.size() > 0 && count(report, LoopOutcome::Filled) == report.loops.size(), "all filled");
    const std::set<Vertex> said(report.touchedVertices.begin(), report.touchedVertices.end());
    for (Vertex v = 0; v < input.vertexSlots(); ++v)
      RC_ASSERT(said.contains(v) || test::sameBits(input.position(v), mesh.position(v)));
  }));
}

QTEST_GUILESS_MAIN(RepairTest)
#include "RepairTest.moc"
