// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/contact/ContactSurface.h"

#include "MeshShapes.h"
#include "TestClass.h"

#include <rapidcheck.h>
#include <QtTest>

#include <limits>
#include <map>
#include <set>

using namespace handwheel;
using namespace handwheel::test;

namespace {

double anywhere() {
  return 0.01 * *rc::gen::inRange(-1000, 1001);
}
Vec3 somePoint() {
  return {anywhere(), anywhere(), anywhere()};
}

std::set<std::uint32_t> found(const ContactSurface& surface, const Box& box) {
  std::set<std::uint32_t> ids;
  surface.forEachInBox(box, [&](const ContactTriangle& t) {
    const bool fresh = ids.insert(t.id).second;
    if (!fresh) qFatal("a triangle is there twice");
    return true;
  });
  return ids;
}

std::set<std::uint32_t> expected(const std::map<std::uint32_t, TrianglePoints>& triangles, const Box& box) {
  std::set<std::uint32_t> ids;
  for (const auto& [id, t] : triangles) {
    Box around(t[0]);
    around.extend(t[1]).extend(t[2]);
    if (around.intersects(box)) ids.insert(id);
  }
  return ids;
}

}  // namespace

class ContactSurfaceTest : public QObject {
  Q_OBJECT

 private slots:
  // After any edits it finds the same as a loop over all triangles.
  void findsWhatIsThere() {
    QVERIFY(rc::check([] {
      const TriangleSoup sphere = icosphere(2);
      ContactSurface surface(sphere.points, sphere.triangles);
      std::map<std::uint32_t, TrianglePoints> truth;
      for (std::uint32_t i = 0; i < sphere.triangles.size(); ++i) {
        const Triangle& t = sphere.triangles[i];
        truth[i] = {sphere.points[t[0]], sphere.points[t[1]], sphere.points[t[2]]};
      }
      const int edits = *rc::gen::inRange(0, 20);
      for (int e = 0; e < edits; ++e) {
        const auto removed = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange(0u, 500u));
        std::vector<ContactTriangle> added;
        const int count = *rc::gen::inRange(0, 30);
        for (int i = 0; i < count; ++i)
          added.push_back({{somePoint(), somePoint(), somePoint()}, 500u + static_cast<std::uint32_t>(30 * e + i)});
        if (!truth.empty() && count > 0) added.back().id = truth.begin()->first;  // replaced
        const ContactSurface before = surface;
        const Box all(Vec3::Constant(-100.0), Vec3::Constant(100.0));
        const auto was = found(before, all);
        surface.update(removed, added);
        RC_ASSERT(found(before, all) == was);  // a copy is a snapshot
        for (const std::uint32_t id : removed) truth.erase(id);
        for (const ContactTriangle& t : added) truth[t.id] = t.corners;
      }
      const Vec3 a = somePoint(), b = somePoint();
      for (const double size : {0.01, 0.1, 1.0}) {
        const Box box(size * a.cwiseMin(b), size * a.cwiseMax(b));
        RC_ASSERT(found(surface, box) == expected(truth, box));
      }
    }));
  }

  void leavesOutWhatIsNotFinite() {
    std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {std::numeric_limits<double>::quiet_NaN(), 0, 0}};
    const ContactSurface surface(points, std::vector<Triangle>{{0, 1, 2}, {0, 1, 3}});
    QCOMPARE(found(surface, Box(Vec3::Constant(-9.0), Vec3::Constant(9.0))), std::set<std::uint32_t>{0});
    QCOMPARE(surface.diagonal(), std::sqrt(2.0));
  }

  void mayBeEmpty() {
    ContactSurface surface;
    QVERIFY(surface.empty());
    QCOMPARE(surface.diagonal(), 0.0);
    const Box all(Vec3::Constant(-9.0), Vec3::Constant(9.0));
    QVERIFY(found(surface, all).empty());
    surface.update(std::vector<std::uint32_t>{7},
                   std::vector<ContactTriangle>{{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()}, 3}});
    QCOMPARE(found(surface, all), std::set<std::uint32_t>{3});
  }
};

HANDWHEEL_TEST(ContactSurfaceTest)
#include "ContactSurfaceTest.moc"
