// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/holes/PatchStatistics.h"

#include "HoleShapes.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/holes/HoleFiller.h"
#include "mesh/structure/MeshBuilder.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

// A cube of size s without its top, and the patch of two triangles that closes it.
struct OpenCube {
  HalfEdgeMesh mesh;
  BoundaryLoop loop;
  Patch patch;
};

OpenCube openCube(double s, const Vec3& corner) {
  TriangleSoup soup = test::cube(s, corner);
  std::erase_if(soup.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(), [&](auto v) { return soup.points[v].z() > corner.z() + 0.5 * s; });
  });
  OpenCube open{buildMesh(soup).mesh, {}, {}};
  open.loop = findBoundaryLoops(open.mesh).at(0);
  open.patch.points = loopPoints(open.mesh, open.loop);
  open.patch.loopSize = 4;
  open.patch.triangles = {{2, 1, 0}, {3, 2, 0}};
  return open;
}

}  // namespace

class PatchStatisticsTest : public QObject {
  Q_OBJECT

 private slots:
  void lidOfACube_data();
  void lidOfACube();
  void roof();
  void withoutArea();
  void comparedWithItsSurroundings();
  void capsAreLikeTheirSphere();
};

void PatchStatisticsTest::lidOfACube_data() {
  QTest::addColumn<double>("size");
  QTest::addColumn<double>("offset");
  QTest::newRow("mm") << 1.0 << 0.0;
  QTest::newRow("tiny") << 1e-6 << 0.0;
  QTest::newRow("huge") << 1e6 << 0.0;
  QTest::newRow("far away") << 1.0 << 1e7;
}

// A right angle along each of the four sides, flat along the diagonal: √2 of 4 + √2 in length.
void PatchStatisticsTest::lidOfACube() {
  QFETCH(double, size);
  QFETCH(double, offset);
  const OpenCube open = openCube(size, Vec3::Constant(offset));
  const PatchStatistics statistics = statisticsOf(open.mesh, open.loop, open.patch);
  QCOMPARE(statistics.triangles, std::size_t(2));
  QVERIFY(std::abs(statistics.area / (size * size) - 1.0) < 1e-6);
  QVERIFY(std::abs(statistics.largestBend - M_PI / 2) < 1e-6);
  QVERIFY(std::abs(statistics.meanBend - M_PI / 2 * std::sqrt(4.0 / (4.0 + M_SQRT2))) < 1e-6);
}

// Four triangles to a point above the middle: the slopes are of 45°, so each pair of neighbours bends by 60°, and each
// bends by 45° from the wall below it.
void PatchStatisticsTest::roof() {
  OpenCube open = openCube(2.0, Vec3::Zero());
  open.patch.points.push_back(Vec3(1, 1, 3));
  open.patch.triangles = {{1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}};
  const PatchStatistics statistics = statisticsOf(open.mesh, open.loop, open.patch);
  QVERIFY(std::abs(statistics.area - 4.0 * M_SQRT2) < 1e-12);
  QVERIFY(std::abs(statistics.largestBend - M_PI / 3) < 1e-12);
}

void PatchStatisticsTest::withoutArea() {
  OpenCube open = openCube(1.0, Vec3::Zero());
  for (Vec3& p : open.patch.points) p = open.patch.points[0];
  const PatchStatistics statistics = statisticsOf(open.mesh, open.loop, open.patch);
  QCOMPARE(statistics.area, 0.0);
  QCOMPARE(statistics.meanBend, 0.0);
}

// A cube bends by 90° everywhere, so does its lid. A flat plate bends nowhere: a lid of it is like it, a tent over its
// square hole of 4 with its point at height h bends by atan(h / 2) at the edge, and rises by h of the size √32.
void PatchStatisticsTest::comparedWithItsSurroundings() {
  const OpenCube open = openCube(2.0, {1, 2, 3});
  const PatchComparison lid = compared(open.mesh, open.loop, open.patch);
  QVERIFY(std::abs(lid.bend - M_PI / 2) < 1e-12 && std::abs(lid.bendAround - M_PI / 2) < 1e-12);
  QVERIFY(!lid.bendsMore() && !lid.risesMore());

  const HalfEdgeMesh plate = buildMesh(test::plateWithHole()).mesh;
  BoundaryLoop hole;
  for (const BoundaryLoop& loop : findBoundaryLoops(plate))
    if (!loop.isSheetBoundary) hole = loop;
  for (const double height : {0.0, 0.5, 1.5, 3.0}) {
    Patch tent;
    tent.points = loopPoints(plate, hole);
    tent.loopSize = tent.points.size();
    const auto n = static_cast<std::uint32_t>(tent.loopSize);
    tent.points.emplace_back(0.0, 0.0, height);
    for (std::uint32_t i = 0; i < n; ++i) tent.triangles.push_back({(i + 1) % n, i, n});
    const PatchComparison shape = compared(plate, hole, tent);
    QCOMPARE(shape.bendAround, 0.0);
    QVERIFY(std::abs(shape.rise - height) < 1e-12 && std::abs(shape.size - std::sqrt(32.0)) < 1e-12);
    QCOMPARE(shape.bendsMore(), std::atan(height / 2.0) > tolerance::kNoticeableBend);
    QCOMPARE(shape.risesMore(), height / std::sqrt(32.0) > tolerance::kNoticeableRise);
  }
}

// Caps of up to 42° that continue the sphere are like it.
void PatchStatisticsTest::capsAreLikeTheirSphere() {
  for (const double radius : {0.2, 0.4, 0.7}) {
    const HalfEdgeMesh mesh = buildMesh(test::sphereWithoutCap(4, radius)).mesh;
    const BoundaryLoop loop = findBoundaryLoops(mesh).at(0);
    const FillAttempt cap = HoleFiller(mesh).propose(loop, {});
    QVERIFY(cap.failure == FillFailure::None && cap.patch.method == FillMethod::Fair);
    const PatchComparison shape = compared(mesh, loop, cap.patch);
    QVERIFY(shape.rise > 0.0 && !shape.risesMore() && !shape.bendsMore());
  }
}

HANDWHEEL_TEST(PatchStatisticsTest)
#include "PatchStatisticsTest.moc"
