// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/UnobstructedView.h"

#include "TestClass.h"
#include "mesh/structure/MeshBuilder.h"

#include <QtTest>

using namespace handwheel;

namespace {

// A square of n x n quads with the given corner and sides.
void addSquare(TriangleSoup& soup, const Vec3& corner, const Vec3& u, const Vec3& v, int n) {
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const auto first = std::uint32_t(soup.points.size());
      for (const auto& [di, dj] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
        soup.points.push_back(corner + u * (double(i + di) / n) + v * (double(j + dj) / n));
      }
      soup.triangles.push_back({first, first + 1, first + 2});
      soup.triangles.push_back({first, first + 2, first + 3});
    }
  }
}

const Box kRegion(Vec3(-1, -1, 0), Vec3(1, 1, 0));

}  // namespace

class ClearViewTest : public QObject {
  Q_OBJECT

 private slots:
  void nothingInFrontMeansStraightOn() {
    TriangleSoup soup;
    addSquare(soup, {-10, -10, 0}, {20, 0, 0}, {0, 20, 0}, 20);
    const Vec3 view = unobstructedDirection(buildMesh(soup).mesh, kRegion, {0, 0, 5});
    QVERIFY((view - Vec3::UnitZ()).norm() < 1e-12);
  }

  // A lid covers the region: straight on shows the lid only, from the side the region is seen.
  void looksPastWhatIsInFront() {
    TriangleSoup soup;
    addSquare(soup, {-10, -10, 0}, {20, 0, 0}, {0, 20, 0}, 20);
    addSquare(soup, {-2, -2, 5}, {4, 0, 0}, {0, 4, 0}, 8);
    const Vec3 view = unobstructedDirection(buildMesh(soup).mesh, kRegion, {0, 0, 1});
    QVERIFY(std::abs(view.norm() - 1.0) < 1e-12);
    QVERIFY(view.z() > 0.0);
    // The sight line from the middle of the region passes the lid's plane outside the lid.
    const Vec3 crossing = view * (5.0 / view.z());
    QVERIFY(std::abs(crossing.x()) > 2.0 || std::abs(crossing.y()) > 2.0);
  }

  void withoutADirectionThereIsNone() {
    QCOMPARE(unobstructedDirection(HalfEdgeMesh(), kRegion, Vec3::Zero()).norm(), 0.0);
  }
};

HANDWHEEL_TEST(ClearViewTest)
#include "ClearViewTest.moc"
