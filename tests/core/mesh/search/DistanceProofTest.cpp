// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/search/LargestDistance.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

class DistanceProofTest : public QObject {
  Q_OBJECT

 private slots:
  void parallelSheets();
  void slot();
  void aroundTheTruth();
  void itself();
  void regions();
  void unitsMixedUp();
  void nothingToBeNearTo();
  void cancelled();
  void looksWhetherItIsCancelled();
};

namespace {

SurfaceDistance distanceSurfaceOf(const TriangleSoup& soup) {
  return SurfaceDistance(buildMesh(soup).mesh);
}

TriangleSoup sheet(std::uint32_t n, double height, double width = 1.0) {
  return test::grid(n + 1, n + 1, false, false, [=](std::uint32_t i, std::uint32_t j) {
    return Vec3(width * double(i) / n, double(j) / n, height);
  });
}

// Returns true if the surfaces are proven to be within a distance. Otherwise points beyond it must be known.
bool areWithin(const SurfaceDistance& a, const SurfaceDistance& b, double distance) {
  const auto proof = proveWithin(a, b, distance);
  return proof && proof->isWithin(distance);
}
bool arePointsBeyond(const SurfaceDistance& a, const SurfaceDistance& b, double distance) {
  const auto proof = proveWithin(a, b, distance);
  return proof && !proof->beyond.empty() && !proof->isWithin(distance);
}

}  // namespace

void DistanceProofTest::parallelSheets() {
  const SurfaceDistance low = distanceSurfaceOf(sheet(7, 0.0)), high = distanceSurfaceOf(sheet(3, 0.25));
  for (const auto& [a, b] : {std::pair(&low, &high), std::pair(&high, &low)}) {
    QVERIFY(areWithin(*a, *b, 0.26));
    QVERIFY(arePointsBeyond(*a, *b, 0.24));
    const std::size_t all = a->faces().size() + b->faces().size();
    QCOMPARE(proveWithin(*a, *b, 0.24)->beyond.size(), all);
  }
}

// One sheet over a narrow slot between two: all corners and middles are near, but not what is over the slot.
void DistanceProofTest::slot() {
  TriangleSoup ground = sheet(1, 0.0);
  test::append(ground, test::moved(sheet(1, 0.0), Vec3(1.2, 0, 0)));
  const SurfaceDistance a = distanceSurfaceOf(sheet(1, 0.0, 2.2)), b = distanceSurfaceOf(ground);
  QVERIFY(areWithin(a, b, 0.102));  // half the slot is 0.1
  QVERIFY(arePointsBeyond(a, b, 0.099));
}

// The inner radius of the coarse tessellation of a sphere is the farthest from the fine one, in the middle of a face.
void DistanceProofTest::aroundTheTruth() {
  QVERIFY(rc::check("within above the truth, points beyond below it", [&] {
    const double height = *rc::gen::inRange(1, 1000) / 1000.0;
    const SurfaceDistance low = distanceSurfaceOf(sheet(9, 0.0)), high = distanceSurfaceOf(sheet(4, height));
    const double factor = *rc::gen::inRange(500, 2000) / 1000.0;
    RC_PRE(std::abs(factor - 1.0) > 2.0 * kLargestDistanceSlack);
    RC_ASSERT(areWithin(low, high, factor * height) == (factor > 1.0));
    RC_ASSERT(arePointsBeyond(low, high, factor * height) == (factor < 1.0));
  }));
  const SurfaceDistance coarse = distanceSurfaceOf(test::icosphere(1)), fine = distanceSurfaceOf(test::icosphere(5));
  double inner = 1.0;
  for (const Face f : coarse.faces()) {
    const TrianglePoints t = coarse.mesh().points(f);
    inner = std::min(inner, std::abs(t[0].dot((t[1] - t[0]).cross(t[2] - t[0]).normalized())));
  }
  QVERIFY(areWithin(coarse, fine, 1.03 * (1.0 - inner)));
  QVERIFY(arePointsBeyond(coarse, fine, 0.95 * (1.0 - inner)));
}

void DistanceProofTest::itself() {
  for (const TriangleSoup& soup : {test::cube(), test::bumpySphere(3), test::moved(test::cube(), Vec3(1e6, 0, 0))}) {
    const SurfaceDistance surface = distanceSurfaceOf(soup);
    QVERIFY(areWithin(surface, surface, 1e-6));
  }
  // Two cuts of one square, which no triangle of the other covers.
  TriangleSoup other = sheet(1, 0.0);
  other.triangles = {{0, 2, 1}, {1, 2, 3}};
  QVERIFY(areWithin(distanceSurfaceOf(other), distanceSurfaceOf(sheet(1, 0.0)), 1e-6));
}

// A dent in one place is found in the region around it only; elsewhere, the sheets are the same.
void DistanceProofTest::regions() {
  TriangleSoup dented = sheet(20, 0.0);
  Vec3& dent = dented.points[dented.points.size() / 2];
  const Box around(dent - Vec3::Constant(0.1), dent + Vec3::Constant(0.1));
  const Box elsewhere(Vec3(0.0, 0.0, -0.1), Vec3(0.2, 0.2, 0.1));
  dent.z() = -0.05;
  const SurfaceDistance a = distanceSurfaceOf(dented), b = distanceSurfaceOf(sheet(20, 0.0));
  const auto proof = [&](const Box& region) { return *proveWithin(a, b, 0.02, {}, std::span(&region, 1)); };
  const auto whole = proveWithin(a, b, 0.02);
  QVERIFY(whole && !whole->beyond.empty() && !whole->isWithin(0.02));
  QVERIFY(proof(around).beyond == whole->beyond);
  QVERIFY(proof(elsewhere).isWithin(1e-9));
}

// A model in metres beside the same in millimetres: each face is nearest to a corner of the other model, or to all of
// it.
void DistanceProofTest::unitsMixedUp() {
  const TriangleSoup large = test::moved(test::icosphere(5), Vec3(3000, 0, 0), 1000.0);
  const TriangleSoup small = test::moved(test::icosphere(5), Vec3(3, 0, 0), 1.0);
  const auto distance = largestDistance(distanceSurfaceOf(large), distanceSurfaceOf(small));
  QVERIFY(distance);
  // From the farthest point of the large one, at 4000, to the nearest of the small one, at 4.
  QVERIFY(*distance >= 3996.0 && *distance <= 3996.0 * 1.01);
}

void DistanceProofTest::nothingToBeNearTo() {
  const SurfaceDistance none = distanceSurfaceOf({}), cube = distanceSurfaceOf(test::cube());
  QVERIFY(!proveWithin(none, cube, 1.0));
  QVERIFY(!proveWithin(cube, none, 1.0));
}

void DistanceProofTest::cancelled() {
  JobState job;
  job.cancelled = true;
  const SurfaceDistance cube = distanceSurfaceOf(test::cube());
  QVERIFY(!proveWithin(cube, cube, 1.0, Progress(job)));
}

// Also where each face takes a few steps only: 40,000 faces, and a look for 512 of them or more.
void DistanceProofTest::looksWhetherItIsCancelled() {
  JobState job;
  const SurfaceDistance low = distanceSurfaceOf(sheet(100, 0.0)), high = distanceSurfaceOf(sheet(100, 0.25));
  QVERIFY(proveWithin(low, high, 0.26, Progress(job)));
  QVERIFY(job.polls >= 40'000u / 512u);
}

HANDWHEEL_TEST(DistanceProofTest)
#include "DistanceProofTest.moc"
