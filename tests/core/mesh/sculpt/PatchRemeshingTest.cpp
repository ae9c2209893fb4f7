// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/sculpt/PatchRemeshing.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "SubdivisionShapes.h"
#include "TestClass.h"
#include "mesh/selection/RegionGrowing.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <rapidcheck.h>

#include <QTest>
#include <random>

using namespace handwheel;

namespace {

// A plate with a fan in the middle whose spokes are four times as long as the edges around it.
struct FanInPlate {
  FanInPlate() {
    TriangleSoup soup = test::annulus(24, 8, 1.0, 3.0);
    const auto middle = static_cast<std::uint32_t>(soup.points.size());
    soup.points.push_back(Vec3::Zero());
    for (std::uint32_t j = 0; j < 24; ++j) {
      patch.add(static_cast<Face>(soup.triangles.size()));
      soup.triangles.push_back({middle, j, (j + 1) % 24});
    }
    mesh = test::built(soup);
  }

  HalfEdgeMesh mesh;
  FaceSelection patch;
};

double leastAngle(const HalfEdgeMesh& mesh, const FaceSelection& faces) {
  double least = M_PI;
  faces.forEach([&](Face f) {
    const auto corners = mesh.points(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 u = corners[(k + 1) % 3] - corners[k], v = corners[(k + 2) % 3] - corners[k];
      least = std::min(least, std::atan2(u.cross(v).norm(), u.dot(v)));
    }
  });
  return least;
}

double areaOfFaces(const HalfEdgeMesh& mesh, const FaceSelection& faces) {
  double area = 0.0;
  faces.forEach([&](Face f) {
    const auto [a, b, c] = mesh.points(f);
    area += 0.5 * (b - a).cross(c - a).norm();
  });
  return area;
}

}  // namespace

class PatchRemeshingTest : public QObject {
  Q_OBJECT

 private slots:
  void evenLikeItsSurroundings();
  void coarserThanItWas();
  void anyPatchOfASphere();
  void anyFacesOfAnyMesh();
  void refusals();
};

// The slivers of the fan, with angles of 15°, become triangles with angles of at least 25°; the disc keeps its area,
// and the faces around it stay.
void PatchRemeshingTest::evenLikeItsSurroundings() {
  FanInPlate plate;
  const double area = areaOfFaces(plate.mesh, plate.patch);
  QVERIFY(!isEven(plate.mesh, plate.patch));
  const HalfEdgeMesh before = plate.mesh;
  const RemeshedPatch remeshed = remeshToSurroundings(plate.mesh, plate.patch);
  QVERIFY(remeshed.failure == SubdivisionFailure::None);
  QCOMPARE(validate(plate.mesh), std::string());
  QVERIFY(isEven(plate.mesh, remeshed.faces));
  QVERIFY2(leastAngle(plate.mesh, remeshed.faces) > 25.0 * M_PI / 180.0,
           qPrintable(QString::number(leastAngle(plate.mesh, remeshed.faces) * 180.0 / M_PI)));
  QVERIFY(std::abs(areaOfFaces(plate.mesh, remeshed.faces) - area) < 1e-9);
  for (Face f = 0; f < before.faceSlots(); ++f) {
    QCOMPARE(plate.mesh.isLive(f), !plate.patch.contains(f));
    if (!plate.patch.contains(f)) QVERIFY(plate.mesh.triangle(f) == before.triangle(f));
  }
  QCOMPARE(test::countBorder(plate.mesh), test::countBorder(before));
}

// A patch that was subdivided thrice has 64 times the triangles. Remeshed, it has about as many as equilateral ones
// with the edges of its outline would be.
void PatchRemeshingTest::coarserThanItWas() {
  FanInPlate plate;
  for (int level = 0; level < 3; ++level) plate.patch = subdivide(plate.mesh, plate.patch).faces;
  const double area = areaOfFaces(plate.mesh, plate.patch), length = 2.0 * std::sin(M_PI / 24.0);
  const double wanted = area / (std::sqrt(3.0) / 4.0 * length * length);
  QVERIFY(static_cast<double>(plate.patch.count()) > 5.0 * wanted);
  const RemeshedPatch remeshed = remeshToSurroundings(plate.mesh, plate.patch);
  QVERIFY(remeshed.failure == SubdivisionFailure::None);
  QCOMPARE(validate(plate.mesh), std::string());
  const auto count = static_cast<double>(remeshed.faces.count());
  QVERIFY2(count > 0.7 * wanted && count < 1.5 * wanted, qPrintable(QString::number(count / wanted)));
}

// The mesh stays valid and closed, or is unchanged, whatever the outline of the patch is.
void PatchRemeshingTest::anyPatchOfASphere() {
  QVERIFY(rc::check([] {
    HalfEdgeMesh mesh = test::built(test::icosphere(3));
    FaceSelection patch;
    const auto start = static_cast<Face>(*rc::gen::inRange<std::size_t>(0, mesh.faceSlots()));
    patch.add(start);
    const int rings = *rc::gen::inRange(0, 5);
    for (int i = 0; i < rings; ++i) patch = grownByRing(mesh, patch);
    const int holes = *rc::gen::inRange(0, 8);
    for (int i = 0; i < holes; ++i)
      patch.remove(static_cast<Face>(*rc::gen::inRange<std::size_t>(0, mesh.faceSlots())));
    if (patch.empty()) return;
    const HalfEdgeMesh before = mesh;
    const RemeshedPatch remeshed = remeshToSurroundings(mesh, patch);
    RC_ASSERT(validate(mesh) == std::string());
    RC_ASSERT(test::countBorder(mesh) == 0u);
    RC_ASSERT(test::eulerCharacteristic(mesh) == 2l);
    RC_ASSERT((remeshed.failure == SubdivisionFailure::None) != remeshed.faces.empty());
    if (remeshed.failure != SubdivisionFailure::None) RC_ASSERT(mesh.liveFaceCount() == before.liveFaceCount());
  }));
}

// Faces that touch at a point, lie upon each other or share an edge by three are refused, not handed to OpenMesh.
void PatchRemeshingTest::anyFacesOfAnyMesh() {
  QVERIFY(rc::check([] {
    std::mt19937 random(*rc::gen::arbitrary<unsigned>());
    const bool blocks = *rc::gen::arbitrary<bool>();
    HalfEdgeMesh mesh = buildMesh(blocks ? test::randomBlocks(random, 20, 3) : test::randomSoup(random, 60, 4)).mesh;
    const unsigned rarity = *rc::gen::inRange(1u, 6u);
    const auto patch =
        FaceSelection::where(mesh.faceSlots(), [&](Face f) { return mesh.isLive(f) && random() % rarity == 0; });
    if (patch.empty()) return;
    const std::size_t faces = mesh.liveFaceCount();
    const RemeshedPatch remeshed = remeshToSurroundings(mesh, patch);
    RC_ASSERT(validate(mesh) == std::string());
    if (remeshed.failure != SubdivisionFailure::None) RC_ASSERT(mesh.liveFaceCount() == faces);
  }));
}

void PatchRemeshingTest::refusals() {
  const HalfEdgeMesh sphere = test::built(test::icosphere(2));
  HalfEdgeMesh mesh = sphere;
  QVERIFY(remeshToSurroundings(mesh, FaceSelection::all(mesh)).failure == SubdivisionFailure::NoEdgeInside);
  QVERIFY(isEven(mesh, FaceSelection::all(mesh)));
  FanInPlate plate;
  SubdivisionLimits limits;
  limits.mostFaces = 30;
  QVERIFY(remeshToSurroundings(plate.mesh, plate.patch, limits).failure == SubdivisionFailure::TooManyFaces);
  JobState job;
  job.cancelled = true;
  SubdivisionLimits cancelled;
  cancelled.progress = Progress(job);
  const std::size_t faces = plate.mesh.faceSlots();
  QVERIFY(remeshToSurroundings(plate.mesh, plate.patch, cancelled).failure == SubdivisionFailure::Cancelled);
  QCOMPARE(plate.mesh.faceSlots(), faces);
}

HANDWHEEL_TEST(PatchRemeshingTest)
#include "PatchRemeshingTest.moc"
