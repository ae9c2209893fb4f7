// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "CancelPoints.h"
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/boundary/Stitching.h"
#include "mesh/defects/Defects.h"
#include "mesh/defects/MeshReport.h"
#include "mesh/repair/Repair.h"
#include "mesh/structure/CancelPolling.h"
#include "mesh/structure/EdgeTable.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/Weld.h"

#include <rapidcheck.h>

#include <QTest>
#include <functional>

using namespace handwheel;

namespace {

// 172,800 half-edges: loops over them look at the cancel flag three times.
TriangleSoup largeTorus() {
  return test::torus(240, 120);
}

TriangleSoup largeTorusWithHoles() {
  TriangleSoup soup = largeTorus();
  for (const Vec3& centre : {Vec3(2.7, 0, 0), Vec3(0, 2.7, 0), Vec3(-1.3, 0, 0)})
    soup = test::withHole(soup, centre, 0.1);
  return soup;
}

// Runs the work to its end, then cancels it at each of its cancel points. isRight(cancelled): of what it left.
void cancelEverywhere(const std::function<void(Progress)>& work, const std::function<bool(bool cancelled)>& isRight,
                      std::size_t mostAllocationsAfter) {
  std::size_t allocations = 0;
  {
    test::CancelPoint never;
    work(never.progress());
    allocations = never.allocations();
    QVERIFY(never.isMonotone());
  }
  QVERIFY(isRight(false));
  for (std::size_t n : test::cancelPoints(allocations)) {
    bool isReached = false, isMonotone = false;
    std::size_t after = 0;
    {
      test::CancelPoint point(n);
      work(point.progress());
      isReached = point.isReached();
      isMonotone = point.isMonotone();
      after = point.allocationsAfter();
    }
    QVERIFY(isMonotone);
    QVERIFY2(after <= mostAllocationsAfter,
             qPrintable(QString("%1 after the %2th of %3").arg(after).arg(n).arg(allocations)));
    QVERIFY2(isRight(isReached), qPrintable(QString("at allocation %1 of %2").arg(n).arg(allocations)));
  }
}

}  // namespace

class CancellingTest : public QObject {
  Q_OBJECT

 private slots:
  void loopsLookOftenEnough();
  void edgesAreLeftSoon();
  void relinking();
  void building();
  void repairing();
  void inspecting();
  void reporting();
  void stitching();
};

void CancellingTest::loopsLookOftenEnough() {
  rc::check("within kIterationsPerPoll steps of the cancel", [] {
    const std::size_t n = *rc::gen::inRange<std::size_t>(1, 4 * kIterationsPerPoll);
    const std::size_t cancelled = *rc::gen::inRange<std::size_t>(0, n);
    JobState job;
    std::size_t i = 0;
    for (; i < n && pollProgress(i, n, Progress(job)); ++i) {
      RC_ASSERT(job.fraction <= double(i) / double(n));
      RC_ASSERT(double(i) / double(n) - job.fraction < double(kIterationsPerPoll) / double(n));
      if (i == cancelled) job.cancelled = true;
    }
    RC_ASSERT(i > cancelled && i <= std::min(n, cancelled + kIterationsPerPoll));
  });
}

void CancellingTest::edgesAreLeftSoon() {
  const TriangleSoup soup = test::torus(400, 400);  // 160,000 vertices, each the lower end of about three edges
  const EdgeTable edges(soup.triangles, soup.points.size());
  for (std::size_t cancelled : {std::size_t{1}, 3 * kIterationsPerPoll / 2, 3 * kIterationsPerPoll}) {
    JobState job;
    std::size_t visits = 0;
    const auto visit = [&](std::uint32_t, std::uint32_t, std::span<const EdgeTable::Entry>) {
      if (++visits == cancelled) job.cancelled = true;
    };
    edges.forEachEdge(visit, Progress(job));
    QVERIFY(visits - cancelled <= 4 * kIterationsPerPoll);
    QVERIFY(visits < 3 * soup.points.size());
  }
}

// A fan of faces takes a few allocations, and there are more half-edges than fans: so no more than this until a look.
static constexpr std::size_t kFansPerLook = kIterationsPerPoll;

void CancellingTest::relinking() {
  const HalfEdgeMesh input = buildMesh(largeTorus()).mesh;
  HalfEdgeMesh before = input;
  before.setOpen(before.opposite(0), Open::Border);
  before.setOpen(0, Open::Border);
  HalfEdgeMesh mesh;
  cancelEverywhere(
      [&](Progress progress) {
        mesh = before;
        relink(mesh, progress);
      },
      [&](bool cancelled) { return test::sameMesh(mesh, cancelled ? before : input); }, kFansPerLook);
}

void CancellingTest::building() {
  const TriangleSoup soup = test::unshared(largeTorus());
  const HalfEdgeMesh whole = buildMesh(soup).mesh;
  BuiltMesh built;
  cancelEverywhere([&](Progress progress) { built = buildMesh(soup, progress); },
                   [&](bool cancelled) { return test::sameMesh(built.mesh, cancelled ? HalfEdgeMesh() : whole); },
                   kFansPerLook);
}

void CancellingTest::repairing() {
  const HalfEdgeMesh input = buildMesh(largeTorusWithHoles()).mesh;
  HalfEdgeMesh repaired = input, mesh;
  repair(repaired, {});
  QVERIFY(test::countBorder(input) > 0 && test::countBorder(repaired) == 0);
  RepairReport report;
  cancelEverywhere(
      [&](Progress progress) {
        mesh = input;
        report = repair(mesh, {}, progress);
      },
      [&](bool cancelled) {
        return report.cancelled == cancelled && test::sameMesh(mesh, cancelled ? input : repaired);
      },
      kFansPerLook);
}

void CancellingTest::inspecting() {
  const HalfEdgeMesh mesh = buildMesh(largeTorusWithHoles()).mesh;
  const std::size_t loops = findDefects(mesh).loops.size();
  QCOMPARE(loops, std::size_t{3});
  Defects defects;
  cancelEverywhere([&](Progress progress) { defects = findDefects(mesh, tolerance::kNearWeld, progress); },
                   [&](bool cancelled) { return cancelled || defects.loops.size() == loops; }, kFansPerLook);
}

void CancellingTest::reporting() {
  const TriangleSoup soup = largeTorusWithHoles();
  MeshReport report;
  cancelEverywhere([&](Progress progress) { report = reportOn(soup, SelfIntersections::Skip, progress); },
                   [&](bool cancelled) { return cancelled || report.loops.size() == 3; }, 2 * kFansPerLook);
}

// The two halves of a torus that a file tore apart.
void CancellingTest::stitching() {
  TriangleSoup soup = largeTorus();
  TriangleSoup upper, lower;
  upper.points = soup.points;
  lower.points = soup.points;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i) {
    (2 * i < soup.triangles.size() ? upper : lower).triangles.push_back(soup.triangles[i]);
  }
  test::append(upper, test::moved(lower, Vec3(1e-6, 0, 0)));
  const HalfEdgeMesh before = buildMesh(upper).mesh;
  HalfEdgeMesh stitched = before, mesh;
  QVERIFY(!stitchBoundaries(stitched, {}).empty());
  QCOMPARE(test::countBorder(stitched), std::size_t{0});
  cancelEverywhere(
      [&](Progress progress) {
        mesh = before;
        stitchBoundaries(mesh, {}, progress);
      },
      [&](bool cancelled) { return test::sameMesh(mesh, stitched) || (cancelled && test::sameMesh(mesh, before)); },
      kFansPerLook);
}

HANDWHEEL_TEST(CancellingTest)
#include "CancellingTest.moc"
