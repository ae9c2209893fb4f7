// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/CgalHoleFilling.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>
#include <memory>
#include <random>
#include <set>

using namespace handwheel;

namespace {

HoleContext firstHole(const TriangleSoup& soup) {
  const HalfEdgeMesh mesh = buildMesh(soup).mesh;
  return holeContext(mesh, findBoundaryLoops(mesh).at(0));
}

bool closes(const TriangleSoup& part, const Patch& patch) {
  TriangleSoup closed = part;
  test::append(closed, {patch.points, patch.triangles});
  return test::countEdges(closed).sound();
}

double meanEdge(const TriangleSoup& s) {
  double sum = 0.0;
  for (const Triangle& t : s.triangles)
    for (int k = 0; k < 3; ++k) sum += (s.points[t[k]] - s.points[t[(k + 1) % 3]]).norm();
  return sum / (3.0 * s.triangles.size());
}

}  // namespace

class CgalHoleFillingTest : public QObject {
  Q_OBJECT

 private slots:
  void hostileSizesAreRefused();
  void minimalHasNoNewVertices();
  void minimalOfTheSmallestHole();
  void refinedHasTheDensityAround();
  void fairBulgesFlatDoesNot();
  void holdsTheNumberOfVertices();
  void strangeHolesAreRefusedQuietly();
  void givesUpWithinTheEffort();
  void theSameHoleGetsTheSamePatch();
};

// If the surroundings lie against the hole, every patch bends by 180°, and on a grid many have the same area too. The
// result must not depend on memory addresses of the library: blocks of several sizes are allocated.
void CgalHoleFillingTest::theSameHoleGetsTheSamePatch() {
  std::mt19937 random(7);
  std::vector<std::unique_ptr<char[]>> lying;
  for (int shape = 0; shape < 10; ++shape) {
    HoleContext hole;
    constexpr int kSide = 15;
    Vec3 at(0, 0, 0);
    for (const Vec3& direction : {Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, -1, 0)}) {
      for (int i = 0; i < kSide; ++i, at += direction) hole.points.push_back(at + Vec3(0, 0, random() % 8 == 0));
    }
    hole.loopSize = hole.points.size();
    hole.apexes.assign(hole.loopSize, Vec3(kSide / 2.0, kSide / 2.0, 0));
    std::set<std::vector<Triangle>> patches;
    for (int round = 0; round < 10; ++round) {
      for (int i = 0; i < 200; ++i) lying.push_back(std::make_unique<char[]>(100 + random() % 40000));
      std::shuffle(lying.begin(), lying.end(), random);
      lying.resize(lying.size() - 100);
      if (const auto patch = triangulateMinimal(hole)) patches.insert(patch->triangles);
    }
    QCOMPARE(patches.size(), std::size_t{1});
  }
}

void CgalHoleFillingTest::minimalHasNoNewVertices() {
  for (const TriangleSoup& soup :
       {test::sphereWithoutCap(4), test::cylinder(30, 3, 1, 1, false), test::cylinder(500, 2, 1, 1, false)}) {
    const HoleContext hole = firstHole(soup);
    const auto patch = triangulateMinimal(hole);
    QVERIFY(patch.has_value());
    QVERIFY(patch->method == FillMethod::Minimal);
    QCOMPARE(patch->points.size(), hole.loopSize);
    QCOMPARE(patch->triangles.size(), hole.loopSize - 2);
    for (std::size_t i = 0; i < hole.loopSize; ++i) QVERIFY(test::sameBits(patch->points[i], hole.points[i]));
  }
  QVERIFY(closes(test::sphereWithoutCap(4), *triangulateMinimal(firstHole(test::sphereWithoutCap(4)))));
}

void CgalHoleFillingTest::minimalOfTheSmallestHole() {
  TriangleSoup soup = test::icosphere(1);
  const Triangle lost = soup.triangles.back();
  soup.triangles.pop_back();
  const auto patch = triangulateMinimal(firstHole(soup));
  QVERIFY(patch.has_value());
  QCOMPARE(patch->triangles.size(), std::size_t{1});
  QVERIFY(closes(soup, *patch));
  std::set<test::Coordinates> wanted, is;
  for (std::uint32_t v : lost) wanted.insert(test::coordinates(soup.points[v]));
  for (std::uint32_t v : patch->triangles[0]) is.insert(test::coordinates(patch->points[v]));
  QVERIFY(is == wanted);
}

void CgalHoleFillingTest::refinedHasTheDensityAround() {
  const TriangleSoup soup = test::sphereWithoutCap(4);
  const HoleContext hole = firstHole(soup);
  const auto start = triangulateMinimal(hole);
  QVERIFY(start.has_value());
  const std::optional<Continuity> choices[] = {std::nullopt, Continuity::Position, Continuity::Tangent,
                                               Continuity::Curvature};
  for (const auto& bent : choices) {
    const auto patch = refinePatch(hole, *start, bent);
    QVERIFY(patch.has_value());
    QVERIFY(patch->method == (bent ? FillMethod::Fair : FillMethod::Refined));
    QVERIFY(patch->points.size() > hole.loopSize);
    QVERIFY(closes(soup, *patch));
    const double ratio = meanEdge({patch->points, patch->triangles}) / meanEdge(soup);
    QVERIFY(ratio > 0.5 && ratio < 2.0);
  }
}

// Flat: the new points are means of the loop's. Fair: the middle rises towards the sphere, the further the smoother it
// continues it; a membrane spans the loop.
void CgalHoleFillingTest::fairBulgesFlatDoesNot() {
  const HoleContext hole = firstHole(test::sphereWithoutCap(4));
  const auto start = triangulateMinimal(hole);
  double rim = 0.0;
  for (const Vec3& p : hole.loop()) rim = std::max(rim, p.z());
  const auto top = [&](std::optional<Continuity> bent) {
    const Patch patch = refinePatch(hole, *start, bent).value();
    double z = 0.0;
    for (const Vec3& p : patch.points) z = std::max(z, p.z());
    return z;
  };
  const double flat = top(std::nullopt), fair = top(Continuity::Tangent);
  QVERIFY(flat <= rim + 1e-12);
  QVERIFY(top(Continuity::Position) <= rim + 1e-12);
  QVERIFY(std::abs(top(Continuity::Curvature) - 1.0) < std::abs(fair - 1.0));
  QVERIFY(fair > rim + 0.7 * (1.0 - rim));
}

// Tubes whose rims have tiny edges: at their density a lid would need n² / 11 vertices. It gets fewer, but gets some.
void CgalHoleFillingTest::holdsTheNumberOfVertices() {
  for (const std::uint32_t n : {300U, 4000U}) {
    const HoleContext hole = firstHole(test::cylinder(n, 4, 1.0, 0.02, false));
    const auto start = triangulateMinimal(hole);
    QVERIFY(start.has_value());
    const auto patch = refinePatch(hole, *start, Continuity::Tangent);
    QVERIFY(patch.has_value());
    const std::size_t added = patch->points.size() - n;
    const std::size_t most = std::min<std::size_t>(tolerance::kPatchVertices, n * tolerance::kPatchVerticesPerEdge);
    QVERIFY2(added <= most + most / 2 && added >= most / 2, qPrintable(QString::number(added)));
  }
}

// No hole at all, two edges, all points on a line: nothing thrown, nothing that closes.
void CgalHoleFillingTest::strangeHolesAreRefusedQuietly() {
  HoleContext hole;
  const auto put = [&](const std::vector<Vec3>& points) {
    hole.points = points;
    hole.loopSize = points.size();
    hole.apexes.assign(points.size(), Vec3(0, 0, 5));
    hole.edgeLength.assign(points.size(), 1.0);
  };
  for (const std::vector<Vec3>& points :
       {std::vector<Vec3>{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0)},
        std::vector<Vec3>{Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0)},
        std::vector<Vec3>{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 0, 0), Vec3(1, 0, 0)}}) {
    put(points);
    const auto patch = triangulateMinimal(hole);
    if (patch) QVERIFY(patch->triangles.size() <= points.size());
  }
}

// The library would overflow the stack, or take minutes.
void CgalHoleFillingTest::hostileSizesAreRefused() {
  QVERIFY(!triangulateMinimal(firstHole(test::cylinder(tolerance::kLibraryFillEdges + 1, 1, 1.0, 0.1, false))));
  TriangleSoup cone;  // with one face left out
  const auto n = static_cast<std::uint32_t>(tolerance::kLibraryFanFaces + 2);
  for (std::uint32_t i = 0; i < n; ++i) {
    cone.points.push_back(Vec3(std::cos(2.0 * M_PI * i / n), std::sin(2.0 * M_PI * i / n), 0));
    if (i > 0) cone.triangles.push_back({i, (i + 1) % n, n});
  }
  cone.points.push_back(Vec3(0, 0, 1));
  const HalfEdgeMesh mesh = buildMesh(cone).mesh;
  HoleContext hole = holeContext(mesh, findBoundaryLoops(mesh).at(0));
  const Patch patch{3, hole.points, {{0, 2, 1}}, FillMethod::Minimal};
  hole.edgeLength.assign(hole.edgeLength.size(), 1.0);
  QVERIFY(!refinePatch(hole, patch, std::nullopt));
}

// The library itself has no bound and asks nobody: it is stopped where it calls back.
void CgalHoleFillingTest::givesUpWithinTheEffort() {
  constexpr std::size_t kMost = 20'000;
  const HoleContext hole = firstHole(test::cylinder(6000, 2, 1, 1, false));
  const auto start = triangulateMinimal(hole);
  QVERIFY(start.has_value());
  const auto spentBy = [](const auto& fill, std::size_t most) {
    WorkBudget effort(most);
    const bool isMade = fill(Progress().within(effort)).has_value();
    return std::pair(isMade, effort.spent());
  };
  const auto minimal = [&](Progress progress) { return triangulateMinimal(hole, progress); };
  const auto refined = [&](Progress progress) {
    return refinePatch(hole, *start, std::nullopt, tolerance::kPatchDensity, progress);
  };
  QVERIFY(spentBy(minimal, std::size_t(1) << 40).first);
  QVERIFY(spentBy(refined, std::size_t(1) << 40).first);
  QVERIFY(spentBy(minimal, std::size_t(1) << 40).second > kMost);
  QVERIFY(spentBy(refined, std::size_t(1) << 40).second > kMost);
  QVERIFY(!spentBy(minimal, kMost).first);
  QVERIFY(!spentBy(refined, kMost).first);
}

HANDWHEEL_TEST(CgalHoleFillingTest)
#include "CgalHoleFillingTest.moc"
