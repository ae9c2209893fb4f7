// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/defects/InsideOutShells.h"

#include "../SoupsTogether.h"
#include "MeshChecks.h"
#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/defects/Defects.h"
#include "mesh/defects/MeshReport.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QTest>

using namespace handwheel;

class InsideOutShellsTest : public QObject {
  Q_OBJECT

 private slots:
  void shells_data();
  void shells();
  void platesAsThinAsRounding();
  void cancelled();
};

void InsideOutShellsTest::shells_data() {
  QTest::addColumn<TriangleSoup>("soup");
  QTest::addColumn<int>("turned");
  QTest::addColumn<double>("volume");  // then; not a number: open
  const TriangleSoup large = test::cube(4.0), inner = test::cube(1.0, {1, 1, 1});
  const TriangleSoup beside = test::cube(1.0, {9, 0, 0}), innermost = test::cube(0.5, {1.2, 1.2, 1.2});
  const auto over = test::turnedOver;
  QTest::newRow("nothing") << TriangleSoup{} << 0 << 0.0;
  QTest::newRow("right") << large << 0 << 64.0;
  QTest::newRow("inside out") << over(large) << 12 << 64.0;
  QTest::newRow("a cavity stays") << test::together({large, over(inner)}) << 0 << 63.0;
  QTest::newRow("a cavity turns with its body") << test::together({over(large), inner}) << 24 << 63.0;
  QTest::newRow("a body in a body") << test::together({over(large), over(inner)}) << 24 << 65.0;
  QTest::newRow("three in each other") << test::together({over(large), inner, over(innermost)}) << 36 << 63.125;
  QTest::newRow("one of two") << test::together({large, over(beside)}) << 12 << 65.0;
  QTest::newRow("far off") << test::moved(over(test::icosphere(3)), {1e6, -1e6, 1e6}) << 1280 << std::nan("");
  // A plate without thickness has no inside, whatever the rounding of its volume.
  TriangleSoup plate = test::disc(64, 8);
  for (Vec3& p : plate.points) p = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()) * p + Vec3(17, -3, 5);
  QTest::newRow("plate") << test::together({plate, test::turnedOver(plate)}) << 0 << std::nan("");
  // A small opening leaves no doubt about the inside, half a sphere does.
  const TriangleSoup nearlyClosed = test::sphereWithoutCap(2);
  QTest::newRow("nearly closed") << nearlyClosed << 0 << std::nan("");
  QTest::newRow("nearly closed, inside out")
      << over(nearlyClosed) << static_cast<int>(nearlyClosed.triangles.size()) << std::nan("");
  QTest::newRow("nearly closed, with a cavity")
      << test::together({over(nearlyClosed), test::moved(test::icosphere(1), Vec3::Zero(), 0.2)})
      << static_cast<int>(nearlyClosed.triangles.size()) + 80 << std::nan("");
  QTest::newRow("half a sphere") << over(test::withHole(test::icosphere(3), Vec3::UnitZ(), 1.4)) << 0 << std::nan("");
  QTest::newRow("sheet") << over(test::disc(24, 4)) << 0 << std::nan("");
}

void InsideOutShellsTest::shells() {
  QFETCH(TriangleSoup, soup);
  const HalfEdgeMesh before = buildMesh(soup).mesh;
  HalfEdgeMesh mesh = before;
  QFETCH(int, turned);
  const MeshReport report = reportOn(soup, SelfIntersections::Skip);
  QCOMPARE(findDefects(before).insideOut.empty(), turned == 0);
  QCOMPARE(findDefects(before).insideOut.size(), report.insideOutBodies);
  QCOMPARE(report.oriented, turned == 0);
  QCOMPARE(static_cast<int>(orientOutward(mesh)), turned);
  QFETCH(double, volume);
  QCOMPARE(validate(mesh), std::string());
  QCOMPARE(mesh.liveFaceCount(), before.liveFaceCount());
  if (!std::isnan(volume)) QCOMPARE(test::volume(mesh.compact().soup), volume);
  for (Vertex v = 0; v < before.vertexSlots(); ++v) QVERIFY(test::sameBits(mesh.position(v), before.position(v)));
  if (turned > 0) QCOMPARE(orientOutward(mesh), std::size_t{0});  // once is enough
}

// An inside-out plate of 1 × 1 has no inside as long as its volume is less than 1e-14 of area times diagonal, 2 √2.
void InsideOutShellsTest::platesAsThinAsRounding() {
  const auto found = [](double share) {
    const double thickness = share * 1e-14 * 2.0 * M_SQRT2;
    const TriangleSoup plate = test::box({0, 0, -0.5 * thickness}, {1, 1, thickness});
    return findInsideOutShells(buildMesh(test::turnedOver(plate)).mesh).size();
  };
  QCOMPARE(found(0.9), std::size_t{0});
  QCOMPARE(found(1.1), std::size_t{1});
}

void InsideOutShellsTest::cancelled() {
  const HalfEdgeMesh before = buildMesh(test::turnedOver(test::cube())).mesh;
  HalfEdgeMesh mesh = before;
  JobState state;
  state.cancelled = true;
  QCOMPARE(orientOutward(mesh, Progress(state)), std::size_t{0});
  QVERIFY(test::sameMesh(mesh, before));
}

HANDWHEEL_TEST(InsideOutShellsTest)
#include "InsideOutShellsTest.moc"
