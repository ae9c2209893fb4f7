// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/NearFeatures.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "base/Tolerance.h"
#include "haptics/contact/TouchableSurface.h"
#include "haptics/snap/SnapProxy.h"
#include "mesh/structure/MeshBuilder.h"
#include "proximity/ClosestPoint.h"

#include <QtTest>
#include <limits>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr SnapTargets kOfPoints{.corners = true, .edges = true};
constexpr SnapTargets kOfBorders{.borderPoints = true, .borderEdges = true};
constexpr SnapTargets kOfFaces{.borderEdges = true, .faces = true};

struct Felt {
  HalfEdgeMesh mesh;
  ContactSurface surface;

  explicit Felt(const TriangleSoup& soup) : mesh(buildMesh(soup).mesh) {
    HalfEdgeMesh::Compact all = mesh.compact();
    surface = touchableSurface(std::move(all.soup.points), std::move(all.soup.triangles), all.faceOf);
  }
  NearFeatures near(const SnapTargets& snapTargets, const Vec3& position, double reach) const {
    return nearFeatures(mesh, surface, snapTargets, position, reach);
  }
};

std::size_t countOf(const NearFeatures& near, SnapKind kind) {
  std::size_t count = 0;
  for (const SnapItem& item : near.features.items()) count += item.feature.kind == kind ? 1 : 0;
  return count;
}

std::array<std::size_t, 3> countsOf(const NearFeatures& near) {
  return {countOf(near, SnapKind::Point), countOf(near, SnapKind::Segment), countOf(near, SnapKind::Facet)};
}

using Counts = std::array<std::size_t, 3>;

// n × n squares with corners on whole numbers.
TriangleSoup sheet(std::uint32_t n) {
  return grid(n + 1, n + 1, false, false, [](std::uint32_t i, std::uint32_t j) { return Vec3(i, j, 0); });
}

}  // namespace

class NearFeaturesTest : public QObject {
  Q_OBJECT

 private slots:
  // A cube has 8 corners, 12 edges and 12 triangles; the diagonals of its sides are no edges of it, and it has no
  // border.
  void whatACubeOffers() {
    const Felt cube(test::cube(10.0));
    const Vec3 middle = Vec3::Constant(5.0);
    QCOMPARE(countsOf(cube.near(kOfPoints, middle, 20.0)), (Counts{8, 12, 0}));
    QCOMPARE(countsOf(cube.near({.corners = true}, middle, 20.0)), (Counts{8, 0, 0}));
    QCOMPARE(countsOf(cube.near({.faces = true}, middle, 20.0)), (Counts{0, 0, 12}));
    QCOMPARE(countsOf(cube.near(kOfBorders, middle, 20.0)), (Counts{0, 0, 0}));
    QCOMPARE(countsOf(cube.near({}, middle, 20.0)), (Counts{0, 0, 0}));
    QCOMPARE(cube.near(kOfPoints, middle, 20.0).reach, 20.0);
    // Only the sides at one corner are near it: 7 corners and 9 edges.
    QCOMPARE(countsOf(cube.near(kOfPoints, Vec3::Zero(), 1.0)), (Counts{7, 9, 0}));
  }

  // Only the border of a flat sheet counts.
  void aFlatSheet() {
    const Felt felt(sheet(5));
    const Vec3 middle(2.5, 2.5, 0);
    QCOMPARE(countsOf(felt.near(kOfPoints, middle, 9.0)), (Counts{20, 20, 0}));
    QCOMPARE(countsOf(felt.near(kOfBorders, middle, 9.0)), (Counts{20, 20, 0}));
    QCOMPARE(countsOf(felt.near(kOfFaces, middle, 9.0)), (Counts{0, 20, 50}));
  }

  // A roof is an edge from a degree on, between its two sides; beside it are the four edges of its border.
  void aFoldOfADegree() {
    for (const double share : {0.9, 1.1}) {
      const double fold = share * tolerance::kFlatEdge;
      const Vec3 down(0.0, std::cos(fold), -std::sin(fold));
      const Felt roof({{{0, 0, 0}, {1, 0, 0}, {0.5, -1, 0}, 0.5 * Vec3::UnitX() + down}, {{0, 1, 3}, {1, 0, 2}}});
      QCOMPARE(countOf(roof.near({.edges = true}, Vec3(0.5, 0, 0), 9.0), SnapKind::Segment),
               std::size_t(share > 1.0 ? 5 : 4));
    }
  }

  void theMeanSide() {
    // Each square has two triangles with sides 1, 1 and √2.
    QVERIFY(std::abs(meanSide(Felt(sheet(3)).mesh) - (2.0 + std::sqrt(2.0)) / 3.0) < 1e-12);
    QCOMPARE(meanSide(HalfEdgeMesh()), 0.0);
  }

  // However many there are, no more are looked at than a tick can carry, and within the reach none is missing.
  void boundedOnLargeMeshes() {
    const Felt felt(sheet(150));
    for (const Vec3& position : {Vec3(75, 75, 0), Vec3(0, 0, 3), Vec3(149.5, 20.25, -1)}) {
      const NearFeatures near = felt.near(kOfFaces, position, 1000.0);
      QVERIFY(near.reach > 3.0 && near.reach < 1000.0);
      QVERIFY(near.features.items().size() <= 10'000);
      std::set<std::uint32_t> found;
      for (const SnapItem& item : near.features.items())
        if (item.feature.kind == SnapKind::Facet) found.insert(item.feature.id);
      for (Face f = 0; f < felt.mesh.faceSlots(); ++f) {
        const TrianglePoints p = felt.mesh.points(f);
        if ((closestOnTriangle(position, p[0], p[1], p[2]) - position).norm() <= near.reach)
          QVERIFY(found.count(f) == 1);
      }
    }
    TriangleSoup fan;  // all points are equal
    for (int i = 0; i < 3000; ++i) append(fan, moved(tetrahedron(), {0, 0, 0}, 1.0 + 0.001 * i));
    QVERIFY(Felt(fan).near({true, true, true, true, true}, Vec3::Zero(), 1.0).features.items().size() <= 10'000);
  }

  // Features that are gathered anew during the motion pull like those of the whole mesh.
  void theForceIsThatOfTheWholeMesh() {
    const Felt felt(sphereWithoutCap(4));
    SnapFeatures everything;
    for (Face f = 0; f < felt.mesh.faceSlots(); ++f) {
      const TrianglePoints p = felt.mesh.points(f);
      everything.addTriangle(f, p[0], p[1], p[2]);
      for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h)
        if (felt.mesh.isBorder(h))
          everything.addSegment(h, felt.mesh.position(felt.mesh.from(h)), felt.mesh.position(felt.mesh.to(h)));
    }
    const SnapField all(everything);
    const double distance = 0.4 * meanSide(felt.mesh);
    const SnapProfile profile(SnapShape::Quadratic, 0.3, distance);
    SnapProxy ofAll, ofNear;
    SnapField field;
    Vec3 centre = Vec3::Constant(kInfinity);
    double mayMove = 0.0;
    int gathered = 0, drawn = 0;
    for (int i = 0; i < 20'000; ++i) {  // around, and over the rim of the hole and back
      const double u = 1e-3 * i, v = 0.4 + 0.2 * std::sin(3.1e-3 * i);
      const double r = 1.0 + distance * 0.9 * std::sin(7e-3 * i);
      const Vec3 hand = r * Vec3(std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), std::cos(v));
      if (!((hand - centre).norm() <= mayMove)) {
        const NearFeatures near = felt.near(kOfFaces, hand, 16.0 * distance);
        field = SnapField(near.features);
        centre = hand;
        mayMove = 0.5 * (near.reach - distance);
        ++gathered;
      }
      const SnapResult expected = ofAll.step(all, profile, hand), pull = ofNear.step(field, profile, hand);
      QVERIFY((pull.force - expected.force).norm() <= 1e-9 * profile.peak());
      drawn += expected.force.norm() > 0.0 ? 1 : 0;
    }
    QVERIFY(gathered > 20 && gathered < 200);
    QVERIFY(drawn > 5'000);  // the rest is over the hole
  }

  void extremes() {
    const Felt cube(test::cube(10.0));
    for (const Vec3& position : {Vec3(kNan, 0, 0), Vec3(0, kInfinity, 0), Vec3(1e300, 0, 0)})
      QVERIFY(cube.near(kOfPoints, position, 1.0).features.items().empty());
    for (const double reach : {0.0, -1.0, kNan, kInfinity}) {
      const NearFeatures near = cube.near(kOfPoints, Vec3::Zero(), reach);
      QVERIFY(near.features.items().empty() && near.reach == 0.0);
    }
    QVERIFY(Felt({}).near(kOfPoints, Vec3::Zero(), 1.0).features.items().empty());
    for (const double size : {1e-3, 1e4}) {
      const Vec3 far = Vec3(1e5, 0, 0) * size;
      const Felt felt(test::cube(size, far));
      QCOMPARE(countsOf(felt.near(kOfPoints, far, 2.0 * size)), (Counts{8, 12, 0}));
    }
  }
};

HANDWHEEL_TEST(NearFeaturesTest)
#include "NearFeaturesTest.moc"
