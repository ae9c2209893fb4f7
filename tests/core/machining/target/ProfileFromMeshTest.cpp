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
  // In any position and direction; in the precision of STL files.
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
    const double low = found->target.extentAt(found->target.lowerEnd())->outer;
    const double high = found->target.extentAt(found->target.upperEnd())->outer;
    QVERIFY(std::abs(low + high - 25.0) < 2e-4 && std::abs(std::abs(low - high) - 5.0) < 2e-4);
    // The shoulder is as wide as a sample: 0.1 mm.
    const double shoulder = 0.1 / 3.0 * (225.0 + 150.0 + 100.0);
    const double expected = M_PI * (19.9 * 225.0 + shoulder + 30.0 * 100.0 - (isBored ? 50.0 * 25.0 : 0.0));
    QVERIFY2(std::abs(found->target.volume() / expected - 1.0) < 1e-5, QByteArray::number(found->target.volume()));
  }

  // Points within a flat are arbitrary: a flat face is exact. The ends of a bar of 200 sides, a ring of five points in
  // the upper end, and the lower end without a point in its middle.
  void pointsWithinFlats() {
    constexpr std::uint32_t kSides = 200, kInner = 5;
    TriangleSoup bar;
    const auto ring = [&](std::uint32_t count, double radius, double z) {
      for (std::uint32_t i = 0; i < count; ++i) {
        const double angle = 2.0 * M_PI * i / count;
        bar.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
      }
    };
    ring(kSides, 20.0, 0.0);
    ring(kSides, 20.0, 50.0);
    ring(kInner, 8.0, 50.0);
    bar.points.emplace_back(0.0, 0.0, 50.0);
    const std::uint32_t inner = 2 * kSides, middle = inner + kInner;
    for (std::uint32_t i = 0; i < kSides; ++i) {
      const std::uint32_t next = (i + 1) % kSides, near = inner + i * kInner / kSides;
      const std::uint32_t nearNext = inner + (i + 1) * kInner / kSides % kInner;
      bar.triangles.push_back({i, next, kSides + next});
      bar.triangles.push_back({i, kSides + next, kSides + i});
      bar.triangles.push_back({kSides + i, kSides + next, near});
      if (near != nearNext) bar.triangles.push_back({near, kSides + next, nearNext});
      if (i > 0 && i + 1 < kSides) bar.triangles.push_back({0, i + 1, i});
    }
    for (std::uint32_t i = 0; i < kInner; ++i) bar.triangles.push_back({inner + i, inner + (i + 1) % kInner, middle});
    const auto isTheBar = [](const Result<ProfileFromMesh>& found) {
      return found && std::abs(found->target.volume() / (M_PI * 400.0 * 50.0) - 1.0) < 1e-9 &&
             std::abs(found->deviation - 20.0 * (1.0 - std::cos(M_PI / kSides))) < 1e-9;
    };
    QVERIFY(isTheBar(profileFromMesh(bar)));
    // Without the point in the middle the flat reaches the axis all the same.
    std::erase_if(bar.triangles, [&](const Triangle& t) { return t[2] == middle; });
    bar.points.pop_back();
    for (std::uint32_t i = 1; i + 1 < kInner; ++i) bar.triangles.push_back({inner, inner + i, inner + i + 1});
    QVERIFY(isTheBar(profileFromMesh(bar)));
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
