// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "collision/CollisionMesh.h"

#include "AnyBodies.h"
#include "TestClass.h"
#include "TriangleOracle.h"

#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Returns the winding number of a closed surface around a point, by the solid angles of all its triangles (van Oosterom
// and Strackee 1983, The solid angle of a plane triangle).
double windingOf(const TriangleSoup& soup, const Vec3& p) {
  double sum = 0.0;
  for (const Triangle& t : soup.triangles) {
    const Vec3 a = soup.points[t[0]] - p, b = soup.points[t[1]] - p, c = soup.points[t[2]] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += 2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (4.0 * M_PI);
}

void add(TriangleSoup& soup, const TriangleSoup& other) {
  const auto first = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), other.points.begin(), other.points.end());
  for (const Triangle& t : other.triangles) soup.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
}

// Returns boxes on a grid of whole numbers, which share planes, edges and corners with each other; some inside out.
TriangleSoup anyBoxes() {
  TriangleSoup soup;
  for (int i = *rc::gen::inRange(1, 5); i > 0; --i) {
    const auto whole = [](int least, int most) { return static_cast<double>(*rc::gen::inRange(least, most)); };
    TriangleSoup box = boxSoup({whole(1, 4), whole(1, 4), whole(1, 4)});
    const Vec3 at(whole(-3, 4), whole(-3, 4), whole(-3, 4));
    for (Vec3& p : box.points) p += at;
    if (*rc::gen::inRange(0, 4) == 0) {
      for (Triangle& t : box.triangles) std::swap(t[0], t[1]);
    }
    add(soup, box);
  }
  return soup;
}

// Returns a sphere of triangles whose corners are off it by up to a fifth: closed, but far from convex.
TriangleSoup anyPotato(int rows, int columns) {
  TriangleSoup soup;
  const auto pointAt = [](double polar, double azimuth) {
    const double r = 100.0 * evenly(0.8, 1.2);
    return Vec3(r * std::sin(polar) * std::cos(azimuth), r * std::sin(polar) * std::sin(azimuth), r * std::cos(polar));
  };
  for (int i = 1; i < rows; ++i) {
    for (int k = 0; k < columns; ++k) soup.points.push_back(pointAt(M_PI * i / rows, 2.0 * M_PI * k / columns));
  }
  const auto at = [&](int i, int k) { return static_cast<std::uint32_t>((i - 1) * columns + k % columns); };
  const auto top = static_cast<std::uint32_t>(soup.points.size()), bottom = top + 1;
  soup.points.push_back(pointAt(0.0, 0.0));
  soup.points.push_back(pointAt(M_PI, 0.0));
  for (int k = 0; k < columns; ++k) {
    soup.triangles.push_back({top, at(1, k), at(1, k + 1)});
    soup.triangles.push_back({bottom, at(rows - 1, k + 1), at(rows - 1, k)});
    for (int i = 1; i + 1 < rows; ++i) {
      soup.triangles.push_back({at(i, k), at(i + 1, k), at(i, k + 1)});
      soup.triangles.push_back({at(i, k + 1), at(i + 1, k), at(i + 1, k + 1)});
    }
  }
  return soup;
}

}  // namespace

// Tests the inside of a closed mesh.
class CollisionMeshTest : public QObject {
  Q_OBJECT

 private slots:
  // The ray up from most of these points goes through corners and along edges and faces.
  void pointsBelowCornersAndEdges() {
    QVERIFY(rc::check("as the solid angles say", [] {
      const TriangleSoup soup = anyBoxes();
      const CollisionMesh mesh(soup);
      RC_ASSERT(mesh.isClosed());
      for (int i = 0; i < 60; ++i) {
        const auto half = [] { return 0.5 * *rc::gen::inRange(-14, 15); };
        const Vec3 p(half(), half(), half());
        if (distanceFromSurface(p, soup, Pose::Identity()) < 1e-9) continue;
        RC_ASSERT(mesh.contains(p) == (std::lround(std::abs(windingOf(soup, p))) > 0));
      }
    }));
  }

  void pointsAnywhere() {
    QVERIFY(rc::check("as the solid angles say", [] {
      const TriangleSoup soup = anyPotato(*rc::gen::inRange(2, 9), *rc::gen::inRange(3, 12));
      const CollisionMesh mesh(soup);
      RC_ASSERT(mesh.isClosed());
      for (int i = 0; i < 40; ++i) {
        // Also for a point straight below a corner.
        const bool isBelow = *rc::gen::arbitrary<bool>();
        Vec3 p = anyPosition(120.0);
        if (isBelow) p.head<2>() = soup.points[*rc::gen::inRange<std::size_t>(0, soup.points.size())].head<2>();
        if (distanceFromSurface(p, soup, Pose::Identity()) < 1e-6) continue;
        RC_ASSERT(mesh.contains(p) == (std::abs(windingOf(soup, p)) > 0.5));
      }
    }));
  }

  void hardCases() {
    const TriangleSoup box = boxSoup({1, 2, 3});
    const CollisionMesh mesh(box);
    QVERIFY(mesh.contains({0, 0, 0}) && mesh.contains({0.999, -1.999, 2.999}));
    for (const Vec3& p : {Vec3(1.001, 0, 0), Vec3(0, 0, 3.001), Vec3(0, 0, -3.001), Vec3(0, -2.001, 0)})
      QVERIFY(!mesh.contains(p));
    QVERIFY(!mesh.contains(Vec3(0, std::nan(""), 0)));
    // A mesh turned inside out has an inside, too; two shells of which one is inverted have none between them.
    TriangleSoup turned = box, both = box;
    for (Triangle& t : turned.triangles) std::swap(t[0], t[1]);
    QVERIFY(CollisionMesh(turned).contains({0, 0, 0}));
    TriangleSoup hollow = boxSoup({0.5, 0.5, 0.5});
    for (Triangle& t : hollow.triangles) std::swap(t[0], t[1]);
    add(both, hollow);
    QVERIFY(!CollisionMesh(both).contains({0, 0, 0}) && CollisionMesh(both).contains({0.75, 0, 0}));
    TriangleSoup open = box;
    open.triangles.pop_back();
    QVERIFY(!CollisionMesh(open).contains({0, 0, 0}));
    QVERIFY(!CollisionMesh(TriangleSoup()).contains({0, 0, 0}));
  }
};

HANDWHEEL_TEST(CollisionMeshTest)
#include "CollisionMeshTest.moc"
