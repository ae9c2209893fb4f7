// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/ProfileFromMesh.h"

#include "TestClass.h"
#include "machining/TurnedSurface.h"
#include "machining/target/TargetErrors.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

// A shaft ⌀20 and ⌀30 with a bore ⌀10, 50 mm long.
TriangleSoup steppedShaft(bool isBored) {
  std::vector<double> outer, inner;
  for (int i = 0; i <= 500; ++i) {
    outer.push_back(i < 200 ? 15.0 : 10.0);
    inner.push_back(isBored ? 5.0 : 0.0);
  }
  const TurnedSurface surface(TurnedProfile::fromRadii(outer, inner, 50.0), 0.01);
  TriangleSoup all;
  for (const auto& block : surface.blocks()) {
    const auto base = static_cast<std::uint32_t>(all.points.size());
    all.points.insert(all.points.end(), block->points.begin(), block->points.end());
    for (const Triangle& t : block->triangles) all.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  return all;
}

}  // namespace

class ProfileFromMeshTest : public QObject {
  Q_OBJECT

 private slots:
  // In any place and direction; in the precision of STL files.
  void sectionIsFound_data() {
    QTest::addColumn<bool>("isBored");
    QTest::addColumn<double>("tilt");
    for (const bool isBored : {false, true})
      for (const double tilt : {0.0, 0.5 * M_PI, 0.7})
        QTest::addRow("%s, %g radian", isBored ? "bored" : "solid", tilt) << isBored << tilt;
  }
  void sectionIsFound() {
    QFETCH(bool, isBored);
    QFETCH(double, tilt);
    TriangleSoup soup = steppedShaft(isBored);
    const Eigen::AngleAxisd turn(tilt, Vec3(1.0, 0.2, 0.0).normalized());
    for (Vec3& p : soup.points) p = (turn * p + Vec3(3.0, -7.0, 11.0)).cast<float>().cast<double>();
    const Result<ProfileFromMesh> found = profileFromMesh(soup);
    QVERIFY(found);
    QVERIFY(found->deviation < turnedMeshTolerance(15.0));
    QVERIFY(std::abs(found->target.length() - 50.0) < 1e-4);
    QVERIFY(std::abs(found->target.largestRadius() - 15.0) < 1e-4);
    QCOMPARE(found->target.isClosed(), isBored);
    // The shoulder is as wide as a sample: 0.1 mm.
    const double shoulder = 0.1 / 3.0 * (225.0 + 150.0 + 100.0);
    const double expected = M_PI * (19.9 * 225.0 + shoulder + 30.0 * 100.0 - (isBored ? 50.0 * 25.0 : 0.0));
    QVERIFY2(std::abs(found->target.volume() / expected - 1.0) < 1e-5, QByteArray::number(found->target.volume()));
  }

  // A flat of 1 mm depth is described by its figure; a box has no axis.
  void othersAreRefused() {
    TriangleSoup flat = steppedShaft(false);
    for (Vec3& p : flat.points) p.x() = std::min(p.x(), 14.0);
    const Result<ProfileFromMesh> found = profileFromMesh(flat);
    QVERIFY(!found);
    QVERIFY(found.error().code == TargetError::MeshNotTurned);
    QVERIFY(std::stod(found.error().arguments.at(0)) > 0.5);
    TriangleSoup box;
    for (int i = 0; i < 8; ++i) box.points.emplace_back(i & 1 ? 30.0 : 0.0, i & 2 ? 20.0 : 0.0, i & 4 ? 10.0 : 0.0);
    box.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    QVERIFY(!profileFromMesh(box));
    QVERIFY(!profileFromMesh({}));
    TriangleSoup point;
    point.points.resize(3, Vec3::Zero());
    point.triangles = {{0, 1, 2}};
    QVERIFY(!profileFromMesh(point));
  }
};

HANDWHEEL_TEST(ProfileFromMeshTest)
#include "ProfileFromMeshTest.moc"
