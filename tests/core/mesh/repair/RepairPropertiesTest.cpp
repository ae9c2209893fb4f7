// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "LargeInputs.h"
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "RepairChecks.h"
#include "TestClass.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshDelta.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

namespace {

// A closed shape, rough or smooth, with holes, islands in holes and single faces missing.
TriangleSoup cutAtRandom(TriangleSoup soup, std::mt19937& random) {
  const auto unit = [&] { return random() / 4294967296.0; };
  if (random() % 2) {
    // Along the ray from the middle, which crosses spheres once: no new crossings.
    const double roughness = 0.03 * unit();
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

// A ball, convex, with holes of which none has an island inside: the triangles that are gone would close it again
// without meeting any other, so there is always a patch. Holes that meet may leave a sheet between them, which is a
// piece of its own.
TriangleSoup holedBall(std::mt19937& random) {
  TriangleSoup soup = test::icosphere(3);
  for (std::size_t holes = 1 + random() % 5; holes > 0; --holes) {
    const Vec3 centre = soup.points[random() % soup.points.size()];
    soup = test::withHole(std::move(soup), centre, 0.05 + 0.45 * (random() / 4294967296.0));
  }
  return soup;
}

// The least share of runs of a property that must reach the expected result.
struct Share {
  int runs = 0, good = 0;
  void add(bool isGood) {
    ++runs;
    good += isGood;
  }
  bool isAtLeast(double share) const { return runs > 0 && good >= share * runs; }
};

// Blocks that touch, with faces missing, doubled and turned.
TriangleSoup damagedBlocks(std::mt19937& random, std::size_t blocks) {
  TriangleSoup soup = test::randomBlocks(random, blocks, 3);
  for (std::size_t n = random() % 6; n > 0; --n)
    soup.triangles.erase(soup.triangles.begin() + std::ptrdiff_t(random() % soup.triangles.size()));
  for (std::size_t n = random() % 4; n > 0; --n)
    soup.triangles.push_back(soup.triangles[random() % soup.triangles.size()]);
  for (std::size_t n = random() % 4; n > 0; --n) {
    Triangle& t = soup.triangles[random() % soup.triangles.size()];
    std::swap(t[0], t[1]);
  }
  return soup;
}

// Returns the most triangles of a soup in which each is placed by itself. Most of them intersect.
std::size_t mostLoose() {
  return test::sized<std::size_t>(12, 24);
}

// Returns true if a repair reports that another one could do more: a search that took too long, or a sheet whose
// outline was kept open and that now looks like a part with a hole.
bool reportsMoreToDo(const RepairReport& report) {
  const auto isMore = [](const auto& loop) {
    return loop.reason == FillFailure::TooMuchEffort || loop.reason == FillFailure::WasSheetBoundary;
  };
  return report.isSeparationIncomplete || report.isIntersectionRemovalIncomplete ||
         std::any_of(report.loops.begin(), report.loops.end(), isMore) ||
         std::any_of(report.openLoops.begin(), report.openLoops.end(), isMore);
}

// A repaired mesh, scaled back.
TriangleSoup repairedAtSize(const TriangleSoup& soup, int exponent) {
  HalfEdgeMesh mesh = buildMesh(test::moved(soup, Vec3::Zero(), std::ldexp(1.0, exponent))).mesh;
  repair(mesh, {});
  return test::moved(mesh.compact().soup, Vec3::Zero(), std::ldexp(1.0, -exponent));
}

}  // namespace

// Tests properties of every repair on randomly damaged shapes.
class RepairPropertiesTest : public QObject {
  Q_OBJECT

 private slots:
  void sameAtEverySize();
  void patchesAreTheSameAtEverySize();
  void oneSidedStripStaysOpen();
  void manyNeedles();
  void holesOfConvexBodies();
  void randomHoles();
  void shortEdgeOfAKeptSheet();
  void brokenBlocks();
  void anySoup();
  void againChangesNothing();
};

// Needles at edges of needles, which cannot all be flipped away, in a closed shape whose coordinates stay exact.
void RepairPropertiesTest::manyNeedles() {
  QVERIFY(rc::check("without its needles a closed shape is closed and holds the same", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    TriangleSoup soup = test::cube(1024.0);
    for (int n = *rc::gen::inRange(1, 8); n > 0; --n)
      test::addNeedles(soup, random() % soup.triangles.size(), int(random() % 3), {0.25 * (1 + random() % 3)});
    RC_PRE(test::countEdges(soup).sound());  // two points may have come to lie in one another
    HalfEdgeMesh mesh = buildMesh(soup).mesh;
    repair(mesh, {});
    RC_ASSERT(validate(mesh) == std::string());
    RC_ASSERT(test::countEdges(mesh).sound());
    RC_ASSERT(test::intersections(mesh) == std::size_t{0});
    RC_ASSERT(findDefects(mesh).degenerateFaces.empty());
    RC_ASSERT(std::abs(test::volume(mesh.compact().soup) - std::ldexp(1.0, 30)) < 1.0);
  }));
}

void RepairPropertiesTest::holesOfConvexBodies() {
  QVERIFY(rc::check("each hole in a ball is closed", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const HalfEdgeMesh input = buildMesh(holedBall(random)).mesh;
    RC_PRE(test::pieces(input).size() == std::size_t{1});
    HalfEdgeMesh mesh = input;
    RepairOptions options;
    options.fill.method = *rc::gen::element(FillMethod::Fair, FillMethod::Ear);
    const RepairReport report = repair(mesh, options);
    RC_ASSERT(validate(mesh) == std::string());
    RC_ASSERT(!report.loops.empty());
    RC_ASSERT(test::count(report, LoopOutcome::Filled) == report.loops.size());
    RC_ASSERT(test::countEdges(mesh).sound());
    RC_ASSERT(test::intersections(mesh) == std::size_t{0});
  }));
}

// All of them can be closed, by what was cut out. Only a piece that was cut off is a sheet, which stays open unless
// asked.
void RepairPropertiesTest::randomHoles() {
  const std::vector<TriangleSoup> shapes = {test::icosphere(3), test::torus(32, 16), test::bumpySphere(3)};
  QVERIFY(rc::check("random holes in closed shapes are closed, or left with a reason", [&] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const TriangleSoup soup = cutAtRandom(shapes[random() % 3], random);
    const HalfEdgeMesh input = buildMesh(soup).mesh;
    RC_PRE(test::intersections(input) == std::size_t{0});  // roughness may fold the torus
    HalfEdgeMesh mesh = input;
    RepairOptions options;
    options.fill.method = *rc::gen::element(FillMethod::Fair, FillMethod::Ear);
    options.fill.numbers = *rc::gen::element(NumberType::Float32, NumberType::Float64);
    options.sheets = *rc::gen::element(SheetHandling::Keep, SheetHandling::Thicken, SheetHandling::Fill);
    const RepairReport report = repair(mesh, options);
    RC_ASSERT(validate(mesh) == std::string());
    RC_ASSERT(test::inconsistent(input, mesh, report) == std::string());
    RC_ASSERT(test::intersections(mesh) == std::size_t{0});
    const test::Edges edges = test::countEdges(mesh);
    RC_ASSERT(edges.nonManifold == std::size_t{0});
    RC_ASSERT(edges.inconsistent == std::size_t{0});
    RC_ASSERT(edges.closed() == (test::count(report, LoopOutcome::Filled) == report.loops.size()));
    const std::set<Vertex> said(report.modifiedVertices.begin(), report.modifiedVertices.end());
    for (Vertex v : test::reallyTouched(input, mesh)) RC_ASSERT(said.contains(v));
    RC_CLASSIFY(edges.closed(), "closed");
    RC_ASSERT(edges.closed() || (options.sheets == SheetHandling::Keep && test::pieces(input).size() > 1));
    // Every hole is closed: what is open is the outline of a sheet, of which at least a corner is where it was. Where
    // it touched the rest it was moved by the last digits.
    std::vector<Vec3> outlines;
    for (const BoundaryLoop& loop : findBoundaryLoops(input)) {
      for (const HalfEdge h : loop.halfEdges)
        if (loop.isSheetBoundary) outlines.push_back(input.position(input.from(h)));
    }
    for (const BoundaryLoop& loop : findBoundaryLoops(mesh)) {
      RC_ASSERT(std::any_of(loop.halfEdges.begin(), loop.halfEdges.end(), [&](HalfEdge h) {
        const Vec3& p = mesh.position(mesh.from(h));
        return std::any_of(outlines.begin(), outlines.end(), [&](const Vec3& q) { return (p - q).norm() < 1e-6; });
      }));
    }
  }));
}

// Found by randomHoles(): a patch cuts a sheet that stays open so near to one of its corners that merging the two, as a
// later round did, moves the sheet across the patch.
void RepairPropertiesTest::shortEdgeOfAKeptSheet() {
  std::mt19937 random(101639);
  QCOMPARE(random() % 3, 2u);  // the shape in randomHoles()
  HalfEdgeMesh mesh = buildMesh(cutAtRandom(test::bumpySphere(3), random)).mesh;
  QCOMPARE(test::intersections(mesh), std::size_t{0});
  RepairOptions options;
  options.fill.numbers = NumberType::Float32;
  // The sheet is an island. If the user wants it to stay open, it does; the hole around it is filled if a patch passes
  // by.
  for (const BoundaryLoop& loop : findBoundaryLoops(mesh))
    if (loop.isSheetBoundary) options.keepOpen.insert(loop.id);
  QVERIFY(!repair(mesh, options).openLoops.empty());
  QCOMPARE(test::intersections(mesh), std::size_t{0});
  repair(mesh, options);
  QCOMPARE(test::intersections(mesh), std::size_t{0});
}

// All of them can be made sound: what is missing can be put back, what is doubled taken away, what is turned turned
// back. One in twenty may be left.
void RepairPropertiesTest::brokenBlocks() {
  Share sound;
  QVERIFY(rc::check("blocks that touch, with faces missing, turned and doubled", [&] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const TriangleSoup soup = damagedBlocks(random, *rc::gen::inRange<std::size_t>(2, 20));
    const HalfEdgeMesh input = buildMesh(soup).mesh;
    HalfEdgeMesh mesh = input;
    RepairOptions options;
    options.sheets = SheetHandling::Fill;
    options.fill.numbers = NumberType::Float32;
    const RepairReport report = repair(mesh, options);
    RC_ASSERT(validate(mesh) == std::string());
    RC_ASSERT(test::inconsistent(input, mesh, report) == std::string());
    RC_ASSERT(test::intersections(mesh) <= test::intersections(input));
    const bool isSound = test::countEdges(mesh).sound();
    RC_CLASSIFY(isSound, "sound");
    sound.add(isSound);
  }));
  QVERIFY(sound.isAtLeast(0.95));
}

void RepairPropertiesTest::anySoup() {
  QVERIFY(rc::check("whatever the input, the result is a mesh and the report adds up", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto steps = *rc::gen::inRange<std::uint32_t>(2, 7);
    const auto triangles = *rc::gen::inRange<std::size_t>(1, mostLoose() + 1);
    const HalfEdgeMesh input = buildMesh(test::randomSoup(random, triangles, steps)).mesh;
    HalfEdgeMesh mesh = input;
    RepairOptions options;
    options.sheets = *rc::gen::element(SheetHandling::Keep, SheetHandling::Thicken, SheetHandling::Fill);
    options.removeDebris = *rc::gen::arbitrary<bool>();
    options.fill.numbers = *rc::gen::element(NumberType::Float32, NumberType::Float64);
    const RepairReport report = repair(mesh, options);
    RC_ASSERT(validate(mesh) == std::string());
    RC_ASSERT(test::inconsistent(input, mesh, report) == std::string());
    RC_CLASSIFY(report.loops.size() > 0 && test::count(report, LoopOutcome::Filled) == report.loops.size(),
                "all filled");
    const std::set<Vertex> said(report.modifiedVertices.begin(), report.modifiedVertices.end());
    for (Vertex v = 0; v < input.vertexSlots(); ++v)
      RC_ASSERT(said.contains(v) || test::sameBits(input.position(v), mesh.position(v)));
  }));
}

// The repaired mesh is read again as if from a file.
void RepairPropertiesTest::againChangesNothing() {
  const std::vector<TriangleSoup> shapes = {test::icosphere(3), test::torus(32, 16), test::bumpySphere(3)};
  Share judged;
  QVERIFY(rc::check("repair of a repaired shape changes nothing", [&] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const int kind = *rc::gen::inRange(0, 3);
    const TriangleSoup soup = kind == 0   ? cutAtRandom(shapes[random() % 3], random)
                              : kind == 1 ? damagedBlocks(random, 2 + random() % 18)
                                          : test::randomSoup(random, 1 + random() % mostLoose(), 2 + random() % 5);
    RepairOptions options;
    options.sheets = *rc::gen::element(SheetHandling::Keep, SheetHandling::Fill);
    options.cutCrossings = *rc::gen::arbitrary<bool>();
    HalfEdgeMesh mesh = buildMesh(soup).mesh;
    const RepairReport report = repair(mesh, options);
    judged.add(!reportsMoreToDo(report));
    if (reportsMoreToDo(report)) return;
    const HalfEdgeMesh repaired = buildMesh(mesh.compact().soup).mesh;
    HalfEdgeMesh again = repaired;
    repair(again, options);
    RC_ASSERT(MeshDelta::isEmptyBetween(repaired, again));
  }));
  QVERIFY(judged.isAtLeast(0.9));
}

// Powers of two change no digit, so the patches are the same. At 2^±332, 1e±100, squares of areas vanish or overflow.
void RepairPropertiesTest::sameAtEverySize() {
  for (const TriangleSoup& soup :
       {test::sphereWithHoles(3, 2, 0.3), test::withHole(test::disc(24, 8), Vec3(0.1, 0, 0), 0.4)}) {
    const TriangleSoup here = repairedAtSize(soup, 0);
    QVERIFY(here.triangles.size() > soup.triangles.size());
    for (const int exponent : {-332, -140, 140, 332}) {
      const TriangleSoup there = repairedAtSize(soup, exponent);
      QVERIFY(there.triangles == here.triangles);
      QVERIFY(there.points == here.points);
    }
  }
}

// The same for single patches, as the window fills them.
void RepairPropertiesTest::patchesAreTheSameAtEverySize() {
  const TriangleSoup soup = test::sphereWithHoles(3, 2, 0.3);
  std::vector<Patch> here;
  for (const int exponent : {0, -332, 332}) {
    const HalfEdgeMesh mesh = buildMesh(test::moved(soup, Vec3::Zero(), std::ldexp(1.0, exponent))).mesh;
    HoleFiller filler(mesh);
    const std::vector<BoundaryLoop> loops = findBoundaryLoops(mesh);
    QCOMPARE(loops.size(), std::size_t{2});
    for (std::size_t i = 0; i < loops.size(); ++i) {
      const FillAttempt attempt = filler.propose(loops[i], {});
      QCOMPARE(attempt.failure, FillFailure::None);
      filler.accept(loops[i], attempt.patch);
      if (exponent == 0) here.push_back(attempt.patch);
      QVERIFY(attempt.patch.triangles == here[i].triangles);
      for (std::size_t k = 0; k < here[i].points.size(); ++k)
        QVERIFY(attempt.patch.points[k] == std::ldexp(1.0, exponent) * here[i].points[k]);
    }
    QVERIFY(findBoundaryLoops(filler.mesh()).empty());
    QCOMPARE(validate(filler.mesh()), std::string());
  }
}

// Its boundary is one loop; half of it is no hole.
void RepairPropertiesTest::oneSidedStripStaysOpen() {
  HalfEdgeMesh mesh = buildMesh(test::moebiusStrip(24, 3)).mesh;
  const std::size_t faces = mesh.liveFaceCount();
  repair(mesh, {});
  QCOMPARE(mesh.liveFaceCount(), faces);
}

HANDWHEEL_TEST(RepairPropertiesTest)
#include "RepairPropertiesTest.moc"
