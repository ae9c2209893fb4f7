// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/Shells.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

class ShellsTest : public QObject {
  Q_OBJECT

 private slots:
  void bodiesThatTouchAreApart();
  void everyFaceInOneShell();
  void splitAndMergedIsTheSame();
  void reversedTwiceIsTheSame();
  void extractingCutsBorders();
  void joiningCoincidingBorders();
  void nothing();
};

namespace {

// The triangles by their positions, each beginning with its least corner.
std::multiset<std::array<test::Coordinates, 3>> trianglesOf(const HalfEdgeMesh& mesh) {
  std::multiset<std::array<test::Coordinates, 3>> result;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    if (!mesh.isLive(f)) continue;
    const TrianglePoints t = mesh.points(f);
    std::array<test::Coordinates, 3> p{test::coordinates(t[0]), test::coordinates(t[1]), test::coordinates(t[2])};
    std::rotate(p.begin(), std::min_element(p.begin(), p.end()), p.end());
    result.insert(p);
  }
  return result;
}

TriangleSoup scene(std::mt19937& random) {
  TriangleSoup soup = test::randomBlocks(random, 6, 3);
  test::append(soup, test::moved(test::icosphere(1), Vec3(10, 0, 0)));
  test::append(soup, test::moved(test::moebiusStrip(8, 2), Vec3(20, 0, 0)));
  test::append(soup, test::moved(test::randomSoup(random, 10, 3), Vec3(30, 0, 0)));
  return soup;
}

}  // namespace

void ShellsTest::bodiesThatTouchAreApart() {
  QCOMPARE(findShells(buildMesh(test::cube()).mesh).size(), std::size_t{1});
  for (const TriangleSoup& two : {test::twoCubesSharingAVertex(), test::twoCubesSharingAnEdge()}) {
    const std::vector<HalfEdgeMesh> shells = splitIntoShells(buildMesh(two).mesh);
    QCOMPARE(shells.size(), std::size_t{2});
    for (const HalfEdgeMesh& shell : shells) {
      QCOMPARE(shell.faceSlots(), std::size_t{12});
      QCOMPARE(shell.vertexSlots(), std::size_t{8});
      QVERIFY(test::countEdges(shell).sound());
      QVERIFY(std::abs(test::volume(shell.compact().soup) - 1.0) < 1e-12);
    }
  }
}

void ShellsTest::everyFaceInOneShell() {
  QVERIFY(rc::check("the pieces are those found by walking across edges", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const HalfEdgeMesh mesh = buildMesh(scene(random)).mesh;
    const auto shells = findShells(mesh);
    std::set<Face> seen;
    for (const auto& shell : shells) {
      RC_ASSERT(std::is_sorted(shell.begin(), shell.end()));
      seen.insert(shell.begin(), shell.end());
      for (Face f : shell) RC_ASSERT(mesh.isLive(f));
    }
    RC_ASSERT(seen.size() == mesh.liveFaceCount());
    RC_ASSERT(shells.size() == test::pieces(mesh).size());
  }));
}

void ShellsTest::splitAndMergedIsTheSame() {
  QVERIFY(rc::check("split, then merged: the same triangles, the same edges", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const HalfEdgeMesh mesh = buildMesh(scene(random)).mesh;
    HalfEdgeMesh merged;
    for (const HalfEdgeMesh& shell : splitIntoShells(mesh)) {
      RC_ASSERT(validate(shell) == std::string());
      const Face first = append(merged, shell);
      RC_ASSERT(first + shell.faceSlots() == merged.faceSlots());
    }
    RC_ASSERT(validate(merged) == std::string());
    RC_ASSERT(trianglesOf(merged) == trianglesOf(mesh));
    RC_ASSERT(test::countBorder(merged) == test::countBorder(mesh));
    RC_ASSERT(test::countSeams(merged) == test::countSeams(mesh));
    RC_ASSERT(test::eulerCharacteristic(merged) == test::eulerCharacteristic(mesh));
  }));
}

// Borders, seams and neighbours included; once, every triangle has its other side out.
void ShellsTest::reversedTwiceIsTheSame() {
  for (const TriangleSoup& soup : {test::cube(), test::sphereWithHoles(3, 3, 0.3)}) {
    const HalfEdgeMesh before = buildMesh(soup).mesh;
    HalfEdgeMesh mesh = before;
    for (const std::vector<Face>& shell : findShells(mesh)) reverseShells(mesh, shell);
    QCOMPARE(validate(mesh), std::string());
    for (Face f = 0; f < before.faceSlots(); ++f) {
      const TrianglePoints a = before.points(f), b = mesh.points(f);
      QCOMPARE((a[1] - a[0]).cross(a[2] - a[0]), Vec3(-(b[1] - b[0]).cross(b[2] - b[0])));
    }
    for (const std::vector<Face>& shell : findShells(mesh)) reverseShells(mesh, shell);
    QVERIFY(test::sameMesh(mesh, before));
  }
}

void ShellsTest::extractingCutsBorders() {
  const HalfEdgeMesh mesh = buildMesh(test::cube()).mesh;
  const std::vector<Face> top{2, 3};
  const HalfEdgeMesh square = extracted(mesh, top);
  QCOMPARE(validate(square), std::string());
  QCOMPARE(test::countBorder(square), std::size_t{4});
  QCOMPARE(square.vertexSlots(), std::size_t{4});
  QVERIFY(square.points(0) == mesh.points(2) && square.points(1) == mesh.points(3));
}

void ShellsTest::joiningCoincidingBorders() {
  const HalfEdgeMesh cube = buildMesh(test::cube()).mesh;
  const std::vector<Face> top{2, 3}, rest{0, 1, 4, 5, 6, 7, 8, 9, 10, 11};
  HalfEdgeMesh merged = extracted(cube, rest);
  QCOMPARE(append(merged, extracted(cube, top)), Face{10});
  QCOMPARE(test::countBorder(merged), std::size_t{8});
  relink(merged);
  QCOMPARE(validate(merged), std::string());
  QCOMPARE(test::countBorder(merged), std::size_t{0});
  QCOMPARE(trianglesOf(merged), trianglesOf(cube));
}

void ShellsTest::nothing() {
  HalfEdgeMesh none;
  QVERIFY(findShells(none).empty());
  QVERIFY(splitIntoShells(none).empty());
  QCOMPARE(append(none, HalfEdgeMesh()), Face{0});
  JobState job;
  job.cancelled = true;
  QVERIFY(splitIntoShells(buildMesh(test::cube()).mesh, Progress(job)).empty());
}

HANDWHEEL_TEST(ShellsTest)
#include "ShellsTest.moc"
