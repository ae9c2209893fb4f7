// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/PatchLevels.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/sculpt/VertexGoals.h"
#include "mesh/selection/RegionGrowing.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"
#include "proximity/ClosestPoint.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

class PatchLevelsTest : public QObject {
  Q_OBJECT

 private slots:
  void levelsOfASphere();
  void anEditAndItsInverse();
  void detailTurnsWithTheCoarseLevel();
  void withoutDetailItIsSubdivision();
  void detailFollowsAFlatPatch();
  void coarserAgain();
  void everyFaceKnowsItsParent();
  void nothingOutsideMoves();
  void inEverySizeAndPosition();
  void patchesWithoutAnInside();
};

namespace {

// Adds offset(position) to the vertices of a level whose faces are all in its patch.
template <class Offset>
HalfEdgeMesh shifted(const PatchLevels& levels, std::size_t level, Offset offset) {
  HalfEdgeMesh mesh = levels.mesh(level);
  std::vector<bool> isHeld(mesh.vertexSlots(), false);
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
      const bool isOutside = !levels.patch(level).contains(f);
      if (mesh.isLive(f) && (isOutside || !mesh.hasOpposite(h))) {
        isHeld[mesh.from(h)] = true;
        isHeld[mesh.to(h)] = true;
      }
    }
  }
  for (Vertex v = 0; v < mesh.vertexSlots(); ++v)
    if (!isHeld[v]) mesh.setPosition(v, mesh.position(v) + offset(mesh.position(v)));
  return mesh;
}

double largestMove(const HalfEdgeMesh& a, const HalfEdgeMesh& b) {
  double most = 0.0;
  for (Vertex v = 0; v < a.vertexSlots(); ++v) most = std::max(most, (a.position(v) - b.position(v)).norm());
  return most;
}

// The part of a sphere around +z, twice subdivided, with bumps at the finest level.
PatchLevels bumpyCap() {
  const HalfEdgeMesh sphere = buildMesh(test::icosphere(2)).mesh;
  const FaceSelection cap = FaceSelection::where(sphere.faceSlots(), [&](Face f) {
    const auto [p, q, r] = sphere.points(f);
    return p.z() + q.z() + r.z() > 1.5;
  });
  PatchLevels levels(sphere, cap);
  levels.refine();
  levels.refine();
  levels.replace(2, shifted(levels, 2, [](const Vec3& p) { return Vec3(0.004 * std::sin(40.0 * p.x()) * p); }));
  return levels;
}

}  // namespace

void PatchLevelsTest::levelsOfASphere() {
  const HalfEdgeMesh mesh = buildMesh(test::icosphere(1)).mesh;
  PatchLevels levels(mesh, FaceSelection::all(mesh));
  for (std::size_t level = 1; level <= 3; ++level) {
    QVERIFY(levels.refine() == SubdivisionFailure::None);
    QCOMPARE(levels.finest(), level);
    QCOMPARE(levels.patch().count(), std::size_t(80) << (2 * level));
    QCOMPARE(validate(levels.mesh()), std::string());
  }
  QVERIFY(test::sameMesh(levels.mesh(0), mesh));
}

void PatchLevelsTest::anEditAndItsInverse() {
  const PatchLevels original = bumpyCap();
  const bool ok = rc::check([&] {
    PatchLevels levels = original;
    const std::size_t level = *rc::gen::inRange<std::size_t>(0, 3);
    const double x = *rc::gen::inRange(-20, 21) / 1000.0, frequency = *rc::gen::inRange(1, 5);
    const HalfEdgeMesh before = levels.mesh(level);
    levels.replace(level, shifted(levels, level, [&](const Vec3& p) {
                     return Vec3(x * std::sin(frequency * p.x()), 0.01, x * std::cos(frequency * p.y()));
                   }));
    RC_ASSERT(validate(levels.mesh()) == std::string());
    RC_ASSERT(largestMove(levels.mesh(), original.mesh()) > 1e-3);
    levels.replace(level, before);
    for (std::size_t i = 0; i <= 2; ++i) RC_ASSERT(largestMove(levels.mesh(i), original.mesh(i)) < 1e-14);
  });
  QVERIFY(ok);
}

void PatchLevelsTest::detailTurnsWithTheCoarseLevel() {
  const HalfEdgeMesh mesh = buildMesh(test::bumpySphere(1)).mesh;
  PatchLevels levels(mesh, FaceSelection::all(mesh));
  levels.refine();
  levels.refine();
  levels.replace(1, shifted(levels, 1, [](const Vec3& p) { return Vec3(0.02 * std::cos(9.0 * p.y()) * p); }));
  levels.replace(2, shifted(levels, 2, [](const Vec3& p) { return Vec3(0.01 * std::sin(30.0 * p.x()) * p); }));
  const HalfEdgeMesh fine = levels.mesh();
  // In small steps, as a hand would turn it: no face turns over at any of them.
  constexpr int kSteps = 8;
  const Vec3 axis = Vec3(1, 2, 3).normalized(), shift(5, -3, 2);
  for (int i = 0; i < kSteps; ++i) {
    const Eigen::AngleAxisd turn(2.0 / kSteps, axis);
    levels.replace(0, shifted(levels, 0, [&](const Vec3& p) { return Vec3(turn * p + shift / kSteps - p); }));
  }
  Pose pose = Pose::Identity();
  for (int i = 0; i < kSteps; ++i)
    pose = Eigen::Translation3d(shift / kSteps) * Eigen::AngleAxisd(2.0 / kSteps, axis) * pose;
  for (Vertex v = 0; v < fine.vertexSlots(); ++v)
    QVERIFY((pose * fine.position(v) - levels.mesh().position(v)).norm() < 1e-13);
}

void PatchLevelsTest::withoutDetailItIsSubdivision() {
  const HalfEdgeMesh mesh = buildMesh(test::icosphere(1)).mesh;
  PatchLevels levels(mesh, FaceSelection::all(mesh));
  levels.refine();
  levels.refine();
  const HalfEdgeMesh coarse = shifted(levels, 0, [](const Vec3& p) { return Vec3(0, 0, 0.1 * p.x() * p.x()); });
  levels.replace(0, coarse);
  PatchLevels fresh(coarse, FaceSelection::all(coarse));
  fresh.refine();
  fresh.refine();
  QVERIFY(largestMove(levels.mesh(), fresh.mesh()) < 1e-14);
}

// Detail that is 0.01 above a flat patch stays so far above it, along its normal, after the patch is tilted.
void PatchLevelsTest::detailFollowsAFlatPatch() {
  const HalfEdgeMesh mesh =
      buildMesh(test::grid(9, 9, false, false, [](auto i, auto j) { return Vec3(i - 4.0, j - 4.0, 0); })).mesh;
  PatchLevels levels(mesh, FaceSelection::all(mesh));
  levels.refine();
  const Vertex middle = test::vertexAt(mesh, Vec3::Zero());
  HalfEdgeMesh fine = levels.mesh();
  fine.setPosition(middle, Vec3(0, 0, 0.01));
  levels.replace(1, fine);
  levels.replace(0, shifted(levels, 0, [](const Vec3& p) { return Vec3(0, 0, 0.5 * p.x()); }));
  const Vec3 normal = Vec3(-0.5, 0, 1).normalized();
  QVERIFY((levels.mesh().position(middle) - 0.01 * normal).norm() < 1e-12);
}

void PatchLevelsTest::coarserAgain() {
  PatchLevels levels = bumpyCap();
  const HalfEdgeMesh one = levels.mesh(1);
  levels.coarsen();
  QCOMPARE(levels.finest(), std::size_t(1));
  QVERIFY(test::sameMesh(levels.mesh(), one));
  levels.coarsen();
  QVERIFY(test::sameMesh(levels.mesh(), buildMesh(test::icosphere(2)).mesh));
}

// Without smoothing, in a flat patch whose corners stand evenly, parts lie within their parents.
void PatchLevelsTest::everyFaceKnowsItsParent() {
  const HalfEdgeMesh mesh =
      buildMesh(test::grid(7, 7, false, false, [](auto i, auto j) { return Vec3(i, j, 0); })).mesh;
  PatchLevels levels(mesh, grownByRing(mesh, {35, 36}));
  levels.refine();
  levels.refine();
  for (Face f = 0; f < levels.mesh().faceSlots(); ++f) {
    const Face parent = levels.faceAt(0, f);
    QVERIFY(parent < mesh.faceSlots());
    QCOMPARE(levels.patch(0).contains(parent), levels.patch().contains(f));
    QCOMPARE(levels.faceAt(2, f), f);
    const auto [p, q, r] = levels.mesh().points(f);
    const auto [a, b, c] = mesh.points(parent);
    const Vec3 middle = (p + q + r) / 3.0;
    QVERIFY((closestOnTriangle(middle, a, b, c) - middle).norm() < 0.25);
  }
}

void PatchLevelsTest::nothingOutsideMoves() {
  PatchLevels levels = bumpyCap();
  const PatchLevels before = levels;
  levels.replace(0, shifted(levels, 0, [](const Vec3&) { return Vec3(0.02, 0.01, 0.03); }));
  const HalfEdgeMesh& mesh = levels.mesh();
  QCOMPARE(validate(mesh), std::string());
  std::size_t moved = 0;
  for (Face f = 0; f < mesh.faceSlots(); ++f) {
    for (const Vertex v : mesh.triangle(f)) {
      const bool isSame = test::sameBits(mesh.position(v), before.mesh().position(v));
      moved += !isSame;
      QVERIFY(isSame || levels.patch().contains(f));
    }
  }
  QVERIFY(moved > 1000);
}

void PatchLevelsTest::inEverySizeAndPosition() {
  for (const auto& [scale, shift] : {std::pair(1e-6, 0.0), std::pair(1e6, 0.0), std::pair(1.0, 1e7)}) {
    const HalfEdgeMesh mesh = buildMesh(test::moved(test::icosphere(2), Vec3(shift, shift, -shift), scale)).mesh;
    PatchLevels levels(mesh, grownByRing(mesh, {0, 1, 2}));
    levels.refine();
    levels.refine();
    const double by = 0.05 * scale;
    levels.replace(0, shifted(levels, 0, [&](const Vec3&) { return Vec3(by, 0, 0); }));
    QCOMPARE(validate(levels.mesh()), std::string());
    const HalfEdgeMesh fine = levels.mesh();
    levels.replace(0, shifted(levels, 0, [&](const Vec3&) { return Vec3(0, by, by); }));
    levels.replace(0, shifted(levels, 0, [&](const Vec3&) { return Vec3(0, -by, -by); }));
    QVERIFY(largestMove(levels.mesh(), fine) <= 1e-13 * scale + 1e-15 * 20 * shift);
  }
}

void PatchLevelsTest::patchesWithoutAnInside() {
  const HalfEdgeMesh mesh = buildMesh(test::icosphere(1)).mesh;
  for (const FaceSelection& patch : {FaceSelection(), FaceSelection{3}}) {
    PatchLevels levels(mesh, patch);
    QVERIFY(levels.refine() == SubdivisionFailure::NoEdgeInside);
    QCOMPARE(levels.finest(), std::size_t(0));
    QVERIFY(levels.replace(0, mesh).empty());
    QCOMPARE(levels.faceAt(0, 5), Face(5));
  }
}

HANDWHEEL_TEST(PatchLevelsTest)
#include "PatchLevelsTest.moc"
