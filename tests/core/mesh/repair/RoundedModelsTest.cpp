// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Models whose files rounded their coordinates: far from the origin, in survey coordinates, with few digits.
#include "MeshShapes.h"
#include "RepairChecks.h"
#include "TestClass.h"
#include "mesh/boundary/CoordinateRounding.h"
#include "mesh/defects/Defects.h"
#include "mesh/repair/Repair.h"
#include "mesh/structure/MeshBuilder.h"

#include <rapidcheck.h>

#include <QTest>

#include <cmath>
#include <functional>

using namespace handwheel;

namespace {

using Rounding = std::function<double(double)>;

double asFloat(double v) {
  return rounded(v, NumberType::Float32);
}

double withDecimals(double v, int n) {
  return QString::number(v, 'f', n).toDouble();
}

double withDigits(double v, int n) {
  return QString::number(v, 'g', n).toDouble();
}

// A box whose six sides are grids of different sizes that have only the corners in common.
TriangleSoup boxOfGrids(const Vec3& size, const std::array<std::uint32_t, 6>& cells, const Eigen::Affine3d& pose,
                        const Rounding& round) {
  TriangleSoup s;
  for (int side = 0; side < 6; ++side) {
    const int u = side / 2, v = (u + 1) % 3, w = (u + 2) % 3;
    const std::uint32_t n = cells[static_cast<std::size_t>(side)];
    test::append(s, test::grid(n + 1, n + 1, false, false, [&](std::uint32_t i, std::uint32_t j) {
                   Vec3 p = Vec3::Zero();
                   p[u] = side % 2 ? size[u] : 0.0;
                   p[v] = (side % 2 ? i : j) * size[v] / n;
                   p[w] = (side % 2 ? j : i) * size[w] / n;
                   const Vec3 q = pose * p;
                   return Vec3(round(q.x()), round(q.y()), round(q.z()));
                 }));
  }
  return s;
}

Eigen::Affine3d poseAt(const Vec3& position, const Vec3& axis, double angle) {
  return Eigen::Translation3d(position) * Eigen::AngleAxisd(angle, axis.normalized());
}

}  // namespace

class RoundedModelsTest : public QObject {
  Q_OBJECT

 private slots:
  void rounding();
  void boxesBecomeClosed_data();
  void boxesBecomeClosed();
  void coarseGridsAreNoRounding();
};

// Spacing of floats: 2^-11 between 4096 and 8192, 2^-17 between 64 and 128.
void RoundedModelsTest::rounding() {
  const auto of = [](const std::vector<Vec3>& points) { return coordinateSteps(points).reach(); };
  const double expected = Vec3(std::ldexp(1.0, -17), 0.0, std::ldexp(1.0, -11)).norm();
  const double found = of({{100.0, 0.0, 5000.5}, {101.0, 0.0, 5000.0}, {100.0, 0.0, 5001.0}});
  QVERIFY2(found >= expected && found <= 1.02 * expected, qPrintable(QString::number(found)));
  const double survey =
      of({{500000.125, 5400000.37, 100.2}, {500010.001, 5400000.0, 101.0}, {500000.0, 5400010.0, 99}});
  const double twoAxes = Vec3(1e-3, 1e-2, 0.0).norm();  // 0.1 is not small compared to a diagonal of 14
  QVERIFY2(survey >= twoAxes && survey <= 1.02 * twoAxes, qPrintable(QString::number(survey)));
  const double fine =
      of({{500000.125, 5400000.37, 100.25}, {500010.003, 5400000.02, 101.11}, {500000.0, 5400010.0, 99}});
  const double mixed = Vec3(1e-3, 1e-2, 1e-2).norm();
  QVERIFY2(fine >= mixed && fine <= 1.02 * mixed, qPrintable(QString::number(fine)));
  QCOMPARE(of({{std::sqrt(2.0), std::sqrt(3.0), 0.0}, {1.0, 0.1, 0.0}, {0.0, 1.0, 0.3}}), 0.0);
  // The last digits are 0, 1 and 5 only: a drawing on a grid, shifted.
  QCOMPARE(of({{500000.125, 0.0, 7.5}, {500010.0, 4.001, 8.0}, {500000.0, 8.001, 99.0}}), 0.0);
  QCOMPARE(coordinateSteps(HalfEdgeMesh()).reach(), 0.0);
}

void RoundedModelsTest::boxesBecomeClosed_data() {
  QTest::addColumn<double>("size");
  QTest::addColumn<double>("distance");
  QTest::addColumn<double>("step");  // distance of neighbouring coordinates
  QTest::addColumn<int>("kind");     // 0: float; 1: three decimals; 2: six digits; 3: all digits; 4: two decimals
  QTest::newRow("float, near") << 1.0 << 0.0 << 1e-7 << 0;
  QTest::newRow("float, 5 m away") << 1.0 << 5000.0 << 5e-4 << 0;
  QTest::newRow("float, 60 m away") << 20.0 << 60000.0 << 4e-3 << 0;
  QTest::newRow("float, a town in metres") << 900.0 << 5.4e6 << 0.5 << 0;
  QTest::newRow("survey, millimetres") << 8.0 << 5.4e6 << 1e-3 << 1;
  QTest::newRow("survey, centimetres") << 40.0 << 5.4e6 << 1e-2 << 4;
  QTest::newRow("six digits") << 80.0 << 50.0 << 1e-3 << 2;
  QTest::newRow("two decimals") << 20.0 << 0.0 << 1e-2 << 4;
  QTest::newRow("three decimals") << 25.0 << 0.0 << 1e-3 << 1;
  QTest::newRow("all digits, far") << 1.0 << 1e6 << 1e-9 << 3;
}

void RoundedModelsTest::boxesBecomeClosed() {
  QFETCH(double, size);
  QFETCH(double, distance);
  QFETCH(double, step);
  QFETCH(int, kind);
  const Rounding rounding = kind == 0   ? Rounding(asFloat)
                            : kind == 1 ? Rounding([](double v) { return withDecimals(v, 3); })
                            : kind == 2 ? Rounding([](double v) { return withDigits(v, 6); })
                            : kind == 4 ? Rounding([](double v) { return withDecimals(v, 2); })
                                        : Rounding([](double v) { return v; });
  const auto unit = [] { return (*rc::gen::inRange(-1000, 1001)) / 1000.0; };
  const bool isSound = rc::check([&] {
    const Vec3 sides(size * (1.0 + 0.5 * unit()), size, size * (1.0 + 0.3 * unit()));
    std::array<std::uint32_t, 6> cells{};
    for (std::uint32_t& n : cells) n = *rc::gen::inRange(1u, 8u);
    const bool isAligned = *rc::gen::arbitrary<bool>();
    const Vec3 axis(unit(), unit(), unit() + 1.5);
    const Vec3 at = distance * Vec3(0.3 + 0.1 * unit(), -0.5 + 0.2 * unit(), 0.9 + 0.1 * unit());
    HalfEdgeMesh mesh =
        buildMesh(boxOfGrids(sides, cells, poseAt(at, axis, isAligned ? 0.0 : 3.0 * unit()), rounding)).mesh;
    repair(mesh, {});
    const Defects defects = findDefects(mesh);
    RC_ASSERT(defects.loops.empty());
    RC_ASSERT(defects.components.size() == 1u);
    RC_ASSERT(test::intersections(mesh) == 0u);
    const double area = 2.0 * (sides.x() * sides.y() + sides.y() * sides.z() + sides.z() * sides.x());
    RC_ASSERT(std::abs(defects.components.front().volume - sides.prod()) <= area * step);
  });
  QVERIFY(isSound);
}

// A slit of 0.1 mm in a sheet of 10 mm, drawn on a grid of 0.1 mm, is a detail.
void RoundedModelsTest::coarseGridsAreNoRounding() {
  const TriangleSoup sheet{
      {{0, 0, 0}, {10, 0, 0}, {10, 4.9, 0}, {0, 4.9, 0}, {0, 5, 0}, {10, 5, 0}, {10, 10, 0.3}, {0, 10, 0.3}},
      {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}};
  HalfEdgeMesh mesh = buildMesh(sheet).mesh;
  QCOMPARE(coordinateSteps(mesh).reach(), 0.0);
  repair(mesh, {});
  QCOMPARE(findDefects(mesh).components.size(), std::size_t(2));
}

HANDWHEEL_TEST(RoundedModelsTest)
#include "RoundedModelsTest.moc"
