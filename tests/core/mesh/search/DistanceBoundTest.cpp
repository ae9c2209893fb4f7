// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/search/DistanceBound.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

class DistanceBoundTest : public QObject {
  Q_OBJECT

 private slots:
  void parallelSheets();
  void peakBetweenSamples();
  void aroundTheTruth();
  void itself();
  void nothingToBeNearTo();
  void tooFineToProve();
  void cancelled();
  void looksWhetherItIsCancelled();
};

namespace {

SurfaceDistance distanceSurfaceOf(const TriangleSoup& soup) {
  return SurfaceDistance(buildMesh(soup).mesh);
}

TriangleSoup sheet(std::uint32_t n, double height) {
  return test::grid(n + 1, n + 1, false, false,
                    [=](std::uint32_t i, std::uint32_t j) { return Vec3(double(i) / n, double(j) / n, height); });
}

}  // namespace

void DistanceBoundTest::parallelSheets() {
  const SurfaceDistance low = distanceSurfaceOf(sheet(7, 0.0)), high = distanceSurfaceOf(sheet(3, 0.25));
  for (const auto& [a, b] : {std::pair(&low, &high), std::pair(&high, &low)}) {
    QCOMPARE(liesWithin(*a, *b, 0.26), Within::Yes);
    QCOMPARE(liesWithin(*a, *b, 0.24), Within::No);
  }
}

// One triangle over a long narrow slot: its corners and middle are near, but not what is over the slot.
void DistanceBoundTest::peakBetweenSamples() {
  TriangleSoup ground = sheet(1, 0.0);
  test::append(ground, test::moved(sheet(1, 0.0), Vec3(1.2, 0, 0)));
  const TriangleSoup over{{Vec3(0.1, 0.1, 0), Vec3(2.1, 0.1, 0), Vec3(0.1, 0.9, 0)}, {{0, 1, 2}}};
  const SurfaceDistance a = distanceSurfaceOf(over), b = distanceSurfaceOf(ground);
  QCOMPARE(liesWithin(a, b, 0.102), Within::Yes);  // half the slot is 0.1
  QCOMPARE(liesWithin(a, b, 0.099), Within::No);
}

// Both directions between a sphere's tessellations: the coarse one's inner radius is the farthest, in the middle of a
// face.
void DistanceBoundTest::aroundTheTruth() {
  const SurfaceDistance coarse = distanceSurfaceOf(test::icosphere(1));
  QVERIFY(rc::check("Yes above the truth, No below it", [&] {
    const Vec3 shift(0.0, 0.0, *rc::gen::inRange(1, 1000) / 1000.0);
    const SurfaceDistance moved = distanceSurfaceOf(test::moved(sheet(4, 0.0), shift));
    const SurfaceDistance ground = distanceSurfaceOf(test::moved(sheet(9, 0.0), Vec3(-4, -4, 0), 9.0));
    const double factor = *rc::gen::inRange(500, 2000) / 1000.0;
    RC_PRE(std::abs(factor - 1.0) > 2.0 * kBoundSlack);
    RC_ASSERT(liesWithin(moved, ground, factor * shift.z()) == (factor > 1.0 ? Within::Yes : Within::No));
  }));
  double inner = 1.0;
  for (const Face f : coarse.faces()) {
    const TrianglePoints t = coarse.mesh().points(f);
    inner = std::min(inner, std::abs(t[0].dot((t[1] - t[0]).cross(t[2] - t[0]).normalized())));
  }
  const SurfaceDistance fine = distanceSurfaceOf(test::icosphere(5));
  QCOMPARE(liesWithin(coarse, fine, 1.03 * (1.0 - inner)), Within::Yes);
  QCOMPARE(liesWithin(coarse, fine, 0.95 * (1.0 - inner)), Within::No);
}

void DistanceBoundTest::itself() {
  for (const TriangleSoup& soup : {test::cube(), test::bumpySphere(3), test::moved(test::cube(), Vec3(1e6, 0, 0))}) {
    const SurfaceDistance surface = distanceSurfaceOf(soup);
    QCOMPARE(liesWithin(surface, surface, 1e-6), Within::Yes);
  }
}

void DistanceBoundTest::nothingToBeNearTo() {
  const SurfaceDistance none = distanceSurfaceOf({}), cube = distanceSurfaceOf(test::cube());
  QCOMPARE(liesWithin(none, cube, 1.0), Within::Yes);
  QCOMPARE(liesWithin(cube, none, 1.0), Within::No);
}

// Two cuts of one square, which no triangle of the other covers: along its diagonals parts must become that small.
void DistanceBoundTest::tooFineToProve() {
  TriangleSoup other = sheet(1, 0.0);
  other.triangles = {{0, 2, 1}, {1, 2, 3}};
  QCOMPARE(liesWithin(distanceSurfaceOf(other), distanceSurfaceOf(sheet(1, 0.0)), 1e-3), Within::Yes);
  QCOMPARE(liesWithin(distanceSurfaceOf(other), distanceSurfaceOf(sheet(1, 0.0)), 1e-12), Within::Unknown);
}

void DistanceBoundTest::cancelled() {
  JobState job;
  job.cancelled = true;
  const SurfaceDistance cube = distanceSurfaceOf(test::cube());
  QCOMPARE(liesWithin(cube, cube, 1.0, Progress(job)), Within::Unknown);
}

// Also where each face takes a few steps only: 20,000 faces, and at least one step for each.
void DistanceBoundTest::looksWhetherItIsCancelled() {
  JobState job;
  const SurfaceDistance low = distanceSurfaceOf(sheet(100, 0.0)), high = distanceSurfaceOf(sheet(100, 0.25));
  QCOMPARE(liesWithin(low, high, 0.26, Progress(job)), Within::Yes);
  QVERIFY(job.polls >= 20'000u / 1024u);
}

HANDWHEEL_TEST(DistanceBoundTest)
#include "DistanceBoundTest.moc"
