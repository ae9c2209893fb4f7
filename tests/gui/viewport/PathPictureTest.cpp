// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "viewport/path/PathPicture.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

namespace {

using Look = PathLine::Look;

// Returns the lines of one look with so many points.
std::vector<PathLine> linesOf(const std::vector<PathLine>& all, Look look, std::size_t points) {
  std::vector<PathLine> found;
  for (const PathLine& line : all) {
    if (line.look == look && line.points.size() == points) found.push_back(line);
  }
  return found;
}

}  // namespace

// The look of a path in the view: lines, arrows, dots.
class PathPictureTest : public QObject {
  Q_OBJECT

 private slots:
  // 100 mm along x: the tip of the arrow is 7.5 mm behind the middle, its barbs are 15 mm before that, to both sides.
  void aLeg() {
    const PathPoint points[] = {{Vec3(0, 0, 0), 1}, {Vec3(30, 0, 0), 1}, {Vec3(100, 0, 0), 1}};
    const std::vector<PathLine> all = pathPicture(points);
    QCOMPARE(all.size(), std::size_t{5});
    const std::vector<PathLine> dots = linesOf(all, Look::Waypoint, 1);
    QCOMPARE(dots.size(), std::size_t{2});
    QVERIFY(dots[0].points[0] == Vec3(0, 0, 0) && dots[1].points[0] == Vec3(100, 0, 0));
    std::vector<Vec3> barbs;
    int lines = 0;
    for (const PathLine& line : linesOf(all, Look::Feed, 3)) {
      if (line.points[1] == Vec3(30, 0, 0)) {
        QVERIFY(line.points[0] == Vec3(0, 0, 0) && line.points[2] == Vec3(100, 0, 0));
        ++lines;
        continue;
      }
      QVERIFY((line.points[1] - Vec3(57.5, 0, 0)).norm() < 1e-9);
      QVERIFY((0.5 * (line.points[0] + line.points[2]) - Vec3(42.5, 0, 0)).norm() < 1e-9);
      barbs.push_back(line.points[0] - line.points[2]);
    }
    QCOMPARE(lines, 1);
    QCOMPARE(barbs.size(), std::size_t{2});
    QVERIFY(std::abs(barbs[0].x()) < 1e-9 && std::abs(barbs[1].x()) < 1e-9);
    QVERIFY(std::abs(barbs[0].dot(barbs[1])) < 1e-9 && std::abs(barbs[0].norm() - 10.0) < 1e-9);
  }

  // Travel is drawn as dashes of 12 mm with gaps of 8 mm: of 100 mm they fill 60 mm. Collisions are solid lines.
  void looks() {
    const PathPoint points[] = {
        {Vec3(0, 0, 0), 1}, {Vec3(0, 100, 0), 1, Look::Travel}, {Vec3(0, 150, 0), 2, Look::Collision}};
    const std::vector<PathLine> all = pathPicture(points);
    double filled = 0.0;
    for (const PathLine& dash : linesOf(all, Look::Travel, 2)) filled += (dash.points[1] - dash.points[0]).norm();
    QVERIFY(std::abs(filled - 60.0) < 1e-9);
    const std::vector<PathLine> met = linesOf(all, Look::Collision, 2);
    QCOMPARE(met.size(), std::size_t{1});
    QVERIFY(met[0].points[0] == Vec3(0, 100, 0) && met[0].points[1] == Vec3(0, 150, 0));
    QCOMPARE(linesOf(all, Look::Waypoint, 1).size(), std::size_t{3});
    for (std::size_t i = 1; i < all.size(); ++i) QVERIFY(all[i - 1].look <= all[i].look);
  }

  // 100 legs of 2 mm: arrows where the middles are at least 60 mm apart, at 1, 61, 121 and 181 mm; dots at every sixth
  // millimetre up to 198, and at the end.
  void shortLegs() {
    std::vector<PathPoint> points;
    for (std::size_t i = 0; i <= 100; ++i) points.push_back({Vec3(2.0 * static_cast<double>(i), 0, 0), i});
    const std::vector<PathLine> all = pathPicture(points);
    QCOMPARE(linesOf(all, Look::Feed, 3).size(), std::size_t{8});
    QCOMPARE(linesOf(all, Look::Waypoint, 1).size(), std::size_t{35});
    QCOMPARE(linesOf(all, Look::Feed, 101).size(), std::size_t{1});
  }

  void degenerate() {
    QVERIFY(pathPicture({}).empty());
    const PathPoint one[] = {{Vec3(1, 2, 3), 0}};
    QCOMPARE(pathPicture(one).size(), std::size_t{1});
    // Nothing moves: there is no direction.
    const PathPoint still[] = {{Vec3(1, 2, 3), 1}, {Vec3(1, 2, 3), 1}};
    QVERIFY(linesOf(pathPicture(still), Look::Feed, 3).empty());
    const PathPoint broken[] = {{Vec3::Constant(std::numeric_limits<double>::quiet_NaN()), 1}, {Vec3(1, 2, 3), 1}};
    for (const PathLine& line : pathPicture(broken)) {
      for (const Vec3& point : line.points) QVERIFY(point.allFinite());
    }
  }
};

HANDWHEEL_TEST(PathPictureTest)
#include "PathPictureTest.moc"
