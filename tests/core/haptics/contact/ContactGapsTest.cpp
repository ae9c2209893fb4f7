// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/ContactGaps.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "haptics/contact/GodObject.h"

#include <QtTest>

#include <cmath>
#include <limits>
#include <random>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Two sheets of 100 mm by 50 mm side by side along x = 0, apart by a gap; cut differently.
TriangleSoup twoSheets(double gap, std::uint32_t leftRows, std::uint32_t rightRows) {
  const auto sheet = [&](std::uint32_t rows, double from, double to) {
    return grid(11, rows + 1, false, false, [=](std::uint32_t i, std::uint32_t j) {
      return Vec3(from + (to - from) * i / 10.0, -50.0 + 100.0 * j / rows, 0.0);
    });
  };
  TriangleSoup s = sheet(leftRows, -50.0, -gap / 2);
  append(s, sheet(rightRows, gap / 2, 50.0));
  return s;
}

// Returns the number of falls of a proxy that slides over it.
int fallsIn(const TriangleSoup& s, double scale = 1.0) {
  const ContactSurface surface(s.points, s.triangles);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(-45.0, 45.0);
  int lost = 0;
  for (int slide = 0; slide < 100; ++slide) {
    const double y = anywhere(random), slope = 0.01 * anywhere(random);
    GodObject god;
    god.place(scale * Vec3(-5, y, 1));
    for (double x = -5 - 0.00013 * slide; x < 5; x += 0.013)
      god.follow(surface, scale * Vec3(x, y + slope * x, -1), {});
    lost += god.contact().proxy.z() < -1e-4 * scale ? 1 : 0;
  }
  return lost;
}

TriangleSoup closed(TriangleSoup s) {
  closeContactGaps(s.points, s.triangles);
  return s;
}

}  // namespace

class ContactGapsTest : public QObject {
  Q_OBJECT

 private slots:
  void closesSeams_data() {
    QTest::addColumn<double>("gap");
    QTest::addColumn<int>("left");
    QTest::addColumn<int>("right");
    QTest::newRow("corner to corner, 1 µm") << 0.001 << 100 << 100;
    QTest::newRow("corner to corner, 20 µm") << 0.02 << 100 << 100;
    QTest::newRow("cut differently, 1 µm") << 0.001 << 100 << 37;
    QTest::newRow("cut differently, 20 µm") << 0.02 << 100 << 37;
    QTest::newRow("nearly alike") << 0.01 << 100 << 99;
  }

  void closesSeams() {
    QFETCH(double, gap);
    QFETCH(int, left);
    QFETCH(int, right);
    for (const double scale : {1e-3, 1.0, 1e3}) {
      const TriangleSoup s = moved(twoSheets(gap, left, right), Vec3::Zero(), scale);
      QVERIFY(fallsIn(s, scale) > 0);  // unmodified, a point falls in
      QCOMPARE(fallsIn(closed(s), scale), 0);
    }
  }

  void leavesHolesOpen() {
    QVERIFY(fallsIn(closed(twoSheets(1.0, 100, 100))) > 90);
    const TriangleSoup ball = sphereWithoutCap(3);
    QCOMPARE(closed(ball).triangles.size(), ball.triangles.size());
  }

  // Closes triangles that each have corners of their own, off by 1e-5 mm.
  void closesSoup() {
    TriangleSoup s = unshared(moved(icosphere(4), Vec3::Zero(), 38.0));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> off(-1e-5, 1e-5);
    for (Vec3& p : s.points) p += Vec3(off(random), off(random), off(random));
    const std::size_t triangles = s.triangles.size();
    const std::vector<Vec3> before = s.points;
    closeContactGaps(s.points, s.triangles);
    QCOMPARE(s.triangles.size(), triangles);  // nothing is left open
    for (const Triangle& t : s.triangles)
      for (const std::uint32_t v : t) QVERIFY((s.points[v] - before[v]).norm() < 4e-5);
  }

  void keepsNumbersOfTriangles() {
    const TriangleSoup s = twoSheets(0.02, 100, 37);
    const TriangleSoup c = closed(s);
    for (std::size_t i = 0; i < s.triangles.size(); ++i)
      for (std::size_t k = 0; k < 3; ++k)
        QVERIFY((c.points[c.triangles[i][k]] - s.points[s.triangles[i][k]]).norm() < 0.035);
  }

  void bearsTheExtremes() {
    TriangleSoup nothing;
    closeContactGaps(nothing.points, nothing.triangles);
    QVERIFY(nothing.triangles.empty());
    TriangleSoup one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 0, 1}}};
    one = closed(one);
    QCOMPARE(one.points.size(), std::size_t{3});
    TriangleSoup bad = twoSheets(0.02, 10, 10);
    bad.points[3].x() = std::numeric_limits<double>::quiet_NaN();
    bad.points[5].y() = std::numeric_limits<double>::infinity();
    bad = closed(bad);
    const TriangleSoup far = moved(twoSheets(0.02, 100, 100), Vec3(1e7, 1e7, 0));
    QVERIFY(closed(far).triangles.size() >= far.triangles.size());
  }
};

HANDWHEEL_TEST(ContactGapsTest)
#include "ContactGapsTest.moc"
