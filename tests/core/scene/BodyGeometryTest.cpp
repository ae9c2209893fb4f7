// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/BodyGeometry.h"

#include "TestClass.h"
#include "scene/MeshGeometry.h"
#include "scene/UnknownGeometry.h"

#include <QTest>
#include <atomic>
#include <cmath>
#include <thread>

using namespace handwheel;

namespace {

// A kind that the room does not have: a later volume, for example.
class CountingGeometry : public BodyGeometry {
 public:
  std::string_view kind() const override { return "counting"; }
  std::size_t bytes() const override { return sizeof *this; }
  mutable std::atomic<int> made = 0;

 protected:
  std::shared_ptr<const TriangleSoup> makeSurface() const override {
    ++made;
    TriangleSoup soup;
    soup.points = {{0, 0, 0}, {3, 0, 0}, {0, 2, 1}};
    soup.triangles = {{0, 1, 2}};
    return std::make_shared<const TriangleSoup>(std::move(soup));
  }
};

}  // namespace

class BodyGeometryTest : public QObject {
  Q_OBJECT

 private slots:
  void surfacesAreMadeOnFirstUse() {
    const CountingGeometry geometry;
    QCOMPARE(geometry.made.load(), 0);
    QCOMPARE(geometry.bounds().max(), Vec3(3, 2, 1));
    QCOMPARE(geometry.bounds().min(), Vec3(0, 0, 0));
    QCOMPARE(geometry.surface(), geometry.surface());
    QCOMPARE(geometry.made.load(), 1);
    QVERIFY(geometry.isKnown());
  }

  void surfacesAreMadeOnceByManyThreads() {
    const CountingGeometry geometry;
    std::vector<std::thread> threads;
    std::vector<const TriangleSoup*> seen(8);
    for (auto& soup : seen) threads.emplace_back([&] { soup = geometry.surface().get(); });
    for (std::thread& thread : threads) thread.join();
    QCOMPARE(geometry.made.load(), 1);
    for (const TriangleSoup* soup : seen) QCOMPARE(soup, seen[0]);
  }

  void meshesAreTheirSurface() {
    TriangleSoup soup;
    soup.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    soup.triangles = {{0, 1, 2}};
    const MeshGeometry geometry(soup);
    QCOMPARE(geometry.kind(), "mesh");
    QCOMPARE(geometry.surface().get(), &geometry.soup());
    QCOMPARE(geometry.bytes(), 3 * sizeof(Vec3) + sizeof(Triangle));
  }

  void unsoundSoups() {
    TriangleSoup sound;
    sound.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    sound.triangles = {{0, 1, 2}};
    QVERIFY(isSoundSoup(sound));
    QVERIFY(!isSoundSoup({}));
    TriangleSoup soup = sound;
    soup.points[1].x() = std::nan("");
    QVERIFY(!isSoundSoup(soup));
    soup.points[1].x() = 1.1 * MeshGeometry::kLargestCoordinate;
    QVERIFY(!isSoundSoup(soup));
    soup = sound;
    soup.triangles[0][2] = 3;
    QVERIFY(!isSoundSoup(soup));
  }

  void unknownKindsHaveNoSurface() {
    const UnknownGeometry geometry("voxels", R"({"kind":"voxels"})", {{"grid", "12345"}});
    QVERIFY(!geometry.isKnown());
    QCOMPARE(geometry.kind(), "voxels");
    QVERIFY(geometry.surface() && geometry.surface()->points.empty() && geometry.bounds().isEmpty());
    QCOMPARE(geometry.parts().at("grid"), "12345");
    QVERIFY(geometry.bytes() >= 5);
  }
};

HANDWHEEL_TEST(BodyGeometryTest)
#include "BodyGeometryTest.moc"
