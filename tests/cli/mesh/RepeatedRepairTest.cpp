// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "../Shapes.h"
#include "HeadScan.h"
#include "LargeInputs.h"
#include "TestClass.h"

#include <QTest>
#include <random>
#include <set>

using namespace handwheel;

namespace {

// Three sides of a cube that meet in a corner, each of n × n unit squares: the edge runs along six edges of the cube.
// Whatever closes it, its mirror images close it as well.
Shape halfCube(int n) {
  Shape shape;
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = [axis](int x, int y) {
      std::array<double, 3> p{};
      p[(axis + 1) % 3] = y;
      p[(axis + 2) % 3] = x;
      return p;
    };
    shape.add(grid(n, n, at, [](int, int) { return false; }), {0, 0, 0});
  }
  return shape;
}

// A fan over a jagged square, all but flat: every patch over its edge bends by 180° against it, and on a grid many have
// the same area as well.
Shape jaggedFan(int side, std::mt19937& random) {
  Shape shape;
  std::array<double, 2> at{0, 0};
  for (const std::array<int, 2>& direction : {std::array{1, 0}, {0, 1}, {-1, 0}, {0, -1}}) {
    for (int i = 0; i < side; ++i) {
      shape.points.push_back({at[0], at[1], random() % 8 == 0 ? 1.0 : 0.0});
      for (int k = 0; k < 2; ++k) at[k] += direction[k];
    }
  }
  const int n = static_cast<int>(shape.points.size());
  shape.points.push_back({side / 2.0, side / 2.0, 0});
  for (int i = 0; i < n; ++i) shape.faces.push_back({i, (i + 1) % n, n});
  return shape;
}

// Ten half cubes of several sizes, of which the neighbours cross, and boxes with holes.
Shape difficult() {
  Shape shape;
  for (int i = 0; i < 10; ++i) shape.add(halfCube(6 + i), {i * 7.3, i * 0.7, i * 0.3});
  std::mt19937 random(7);
  for (int i = 0; i < 20; ++i) shape.add(jaggedFan(15, random), {i * 20.0, 60, 0});
  shape.add(holedBox(), {0, -40, 0});
  shape.add(holedBox(), {4.5, -37.5, 3.5});
  return shape;
}

// Returns the distinct outputs of several processes with different memory addresses; one if all wrote the same.
std::set<QByteArray> writtenBy(int processes, const Fixture& fixture, const QString& input, const QString& output) {
  std::set<QByteArray> written;
  for (int i = 0; i < processes; ++i) {
    fixture.run({"repair", input, "-o", output, "--open-sheets", "fill"});
    written.insert(fixture.content(output));
  }
  return written;
}

}  // namespace

// The same input gives the same bytes, in every process.
class RepeatedRepairTest : public QObject {
  Q_OBJECT

 private slots:
  void aDifficultMesh() {
    const Fixture fixture;
    fixture.put("a.off", difficult().off());
    const std::set<QByteArray> written = writtenBy(6, fixture, "a.off", "b.off");
    QCOMPARE(written.size(), std::size_t(1));
    QVERIFY(!written.begin()->isEmpty());
  }

  void aScannedHead() {
    if (!qEnvironmentVariableIsSet("HANDWHEEL_DATA")) QSKIP("HANDWHEEL_DATA is not set");
    if (!QFile::exists(kHeadScan)) QSKIP("head.stl of the package occt-misc is not installed");
    const Fixture fixture;
    fixture.put("a.stl", headSections(test::sized(1, 4)));
    const std::set<QByteArray> written = writtenBy(2, fixture, "a.stl", "b.stl");
    QCOMPARE(written.size(), std::size_t(1));
    QVERIFY(!written.begin()->isEmpty());
  }

  void aScan() {
    if (!qEnvironmentVariableIsSet("HANDWHEEL_DATA")) QSKIP("HANDWHEEL_DATA is not set");
    const QString truck = qEnvironmentVariable("HANDWHEEL_DATA") + "/scans/libigl-tutorial/truck.obj";
    if (!QFile::exists(truck)) QSKIP("the scan is not there");
    const Fixture fixture;
    const std::set<QByteArray> written = writtenBy(4, fixture, truck, "b.stl");
    QCOMPARE(written.size(), std::size_t(1));
    QVERIFY(!written.begin()->isEmpty());
  }
};

HANDWHEEL_TEST(RepeatedRepairTest)
#include "RepeatedRepairTest.moc"
