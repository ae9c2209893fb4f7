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

}  // namespace

class CgalHoleFillingTest : public QObject {
  Q_OBJECT

 private slots:
  void hostileSizesAreRefused();
  void minimalHasNoNewVertices();
  void minimalOfTheSmallestHole();
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

// The library would overflow the stack.
void CgalHoleFillingTest::hostileSizesAreRefused() {
  QVERIFY(!triangulateMinimal(firstHole(test::cylinder(tolerance::kLibraryFillEdges + 1, 1, 1.0, 0.1, false))));
}

// The library itself has no bound and asks nobody: it is stopped where it calls back.
void CgalHoleFillingTest::givesUpWithinTheEffort() {
  constexpr std::size_t kMost = 20'000;
  const HoleContext hole = firstHole(test::cylinder(6000, 2, 1, 1, false));
  const auto spentBy = [](const auto& fill, std::size_t most) {
    WorkBudget effort(most);
    const bool isMade = fill(Progress().within(effort)).has_value();
    return std::pair(isMade, effort.spent());
  };
  const auto minimal = [&](Progress progress) { return triangulateMinimal(hole, progress); };
  QVERIFY(spentBy(minimal, std::size_t(1) << 40).first);
  QVERIFY(spentBy(minimal, std::size_t(1) << 40).second > kMost);
  QVERIFY(!spentBy(minimal, kMost).first);
}

HANDWHEEL_TEST(CgalHoleFillingTest)
#include "CgalHoleFillingTest.moc"
