// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/TargetOutline.h"

#include "TestClass.h"
#include "window/workpiece/TextOutlines.h"

#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;

namespace {

// ⌀30 and ⌀20, 60 mm long.
TargetProfile steppedShaft() {
  const std::vector<ProfilePoint> corners = {{0, 0}, {15, 0}, {15, 30}, {10, 30}, {10, 60}, {0, 60}};
  std::vector<ProfileSegment> segments;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) segments.push_back({corners[i], corners[i + 1]});
  return TargetProfile::make(std::move(segments)).value();
}

}  // namespace

// The outline of a target over the part.
class TargetOutlineTest : public QObject {
  Q_OBJECT

 private slots:
  // In each view across the axis the outline is as wide as the shaft, except for the half of a step of 15° by which its
  // plane is off: cos 7.5° of 20 and 30 mm. From above, where one turns, too. Along the axis its rings are seen.
  void seenFromAllSides_data() {
    QTest::addColumn<double>("angle");  // degrees, angle of the line of sight about the axis
    for (int i = 0; i < 36; ++i) QTest::addRow("%d", 10 * i) << 10.0 * i;
  }
  void seenFromAllSides() {
    QFETCH(double, angle);
    const double turn = angle * M_PI / 180.0;
    const Vec3 right(0.0, 0.0, 1.0), towards(std::cos(turn), std::sin(turn), 0.0);
    Eigen::Matrix3d axes;
    axes << right, towards.cross(right), towards;
    CameraState camera;
    camera.orientation = Eigen::Quaterniond(axes);
    double thick = 0.0, thin = 0.0;
    const auto lines = targetOutline(steppedShaft(), outlineStep(camera));
    for (const PathLine& line : *lines) {
      if (line.points.size() != 2) continue;  // a ring
      for (const Vec3& p : line.points) {
        double& widest = p.z() < 29.9 ? thick : thin;
        if (p.z() < 29.9 || p.z() > 30.1) widest = std::max(widest, std::abs(p.dot(camera.up())));
      }
    }
    const double share = std::cos(M_PI / 24.0);
    QVERIFY2(thick >= 15.0 * share - 1e-9 && thick <= 15.0 + 1e-9, qPrintable(QString::number(thick)));
    QVERIFY2(thin >= 10.0 * share - 1e-9 && thin <= 10.0 + 1e-9, qPrintable(QString::number(thin)));
  }

  void seenAlongTheAxis() {
    CameraState camera;  // along z
    QCOMPARE(outlineStep(camera), 0);
    std::size_t rings = 0;
    const auto lines = targetOutline(steppedShaft(), 0);
    for (const PathLine& line : *lines) rings += line.points.size() > 2 ? 1 : 0;
    QCOMPARE(rings, std::size_t{4});
  }

  // The letters of a text that is seen from behind begin at the other end: what was leftmost is rightmost.
  void textsAreReadFromBehind() {
    CameraState camera;
    camera.orientation = Eigen::AngleAxisd(0.5 * M_PI, Vec3::UnitY());  // the viewer is at +x, as the operator
    QVERIFY(!isBehindLathe(camera));
    camera.orientation = Eigen::AngleAxisd(-0.5 * M_PI, Vec3::UnitY());
    QVERIFY(isBehindLathe(camera));
    TextOutlines flag;
    flag.lines = {{{0.0, 0.0}, {0.0, 2.0}, {1.0, 2.0}, {0.0, 1.0}}};
    flag.width = 1.5;
    const TextOutlines behind = flag.reversed();
    const std::vector<Vec2> expected = {{1.5, 0.0}, {1.5, 2.0}, {0.5, 2.0}, {1.5, 1.0}};
    QVERIFY(behind.lines.size() == 1 && behind.lines.front() == expected);
    QCOMPARE(behind.width, 1.5);
  }
};

HANDWHEEL_TEST(TargetOutlineTest)
#include "TargetOutlineTest.moc"
