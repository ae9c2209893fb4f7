// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "machining/TurnedSurface.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/structure/MeshBuilder.h"
#include "mesh/structure/MeshValidator.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

TriangleSoup threadSoup(const TurnedSurface& surface) {
  TriangleSoup all;
  for (const auto& block : surface.blocks()) {
    const auto base = static_cast<std::uint32_t>(all.points.size());
    all.points.insert(all.points.end(), block->points.begin(), block->points.end());
    for (const Triangle& t : block->triangles) all.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  return all;
}

double enclosedVolume(const TriangleSoup& soup) {
  double sum = 0.0;
  for (const Triangle& t : soup.triangles)
    sum += soup.points[t[0]].dot(soup.points[t[1]].cross(soup.points[t[2]])) / 6.0;
  return sum;
}

// A pass of a thread with a sharp point, straight along the axis.
TurningPass straightPass(double bottom, double from, double to, double pitch) {
  TurningPass pass;
  pass.noseRadius = 0.0;
  pass.path = {{bottom, to}, {bottom, from}};
  pass.times = {0.0, 1.0};
  pass.thread = ThreadCut();
  pass.thread->pitch = pitch;
  return pass;
}

std::shared_ptr<const PartThreads> threadsOf(const TurningPass& pass) {
  return PartThreads::of({std::make_shared<const TurningPass>(pass)});
}

// The volume of a whole number of turns of a sharp groove of 60°: its section, of a base on the surface and a depth, is
// a triangle, and each ring of it at a radius r has the length 2 π r a turn: 2 π ∫ r w(r) dr.
double grooveVolume(double surface, double depth, double flat, double turns) {
  const double slope = 2.0 * std::tan(M_PI / 6.0), bottom = surface - depth;
  const double width = flat * (surface * surface - bottom * bottom) / 2.0;
  const double flanks =
      slope * (std::pow(surface, 3.0) / 3.0 - bottom * surface * surface / 2.0 + std::pow(bottom, 3.0) / 6.0);
  return turns * 2.0 * M_PI * (width + flanks);
}

}  // namespace

class ThreadSurfaceTest : public QObject {
  Q_OBJECT

 private slots:
  // Through the whole bar, so that the analytic volume of the groove holds.
  void volumeIsThatOfTheHelicalGroove_data() {
    QTest::addColumn<double>("flat");
    QTest::addColumn<int>("starts");
    QTest::addColumn<bool>("isLeft");
    QTest::newRow("sharp") << 0.0 << 1 << false;
    QTest::newRow("flat bottom") << 0.3 << 1 << false;
    QTest::newRow("left-hand") << 0.0 << 1 << true;
    QTest::newRow("three starts") << 0.1 << 3 << false;
  }
  void volumeIsThatOfTheHelicalGroove() {
    QFETCH(double, flat);
    QFETCH(int, starts);
    QFETCH(bool, isLeft);
    const double length = 30.0, pitch = 2.5, depth = 1.5, chord = 1e-3;
    const TurnedProfile profile({20.0, length, 0.0}, 0.05);
    TurningPass pass = straightPass(10.0 - depth, -20.0, length + 20.0, pitch);
    pass.thread->flat = flat;
    pass.thread->starts = starts;
    pass.thread->isLeft = isLeft;
    const auto threads = threadsOf(pass);
    QVERIFY(threads);
    const double groove = grooveVolume(10.0, depth, flat, length / pitch);
    const double counted = threads->volume(profile);
    QVERIFY2(std::abs(counted / groove - 1.0) < 1e-3, qPrintable(QString::number(counted / groove, 'g', 10)));

    const TurnedSurface plain(profile, chord), surface(profile, chord, threads);
    const HalfEdgeMesh mesh = buildMesh(threadSoup(surface)).mesh;
    QVERIFY(validate(mesh).empty());
    QVERIFY(findBoundaryLoops(mesh).empty());
    const double taken = enclosedVolume(threadSoup(plain)) - enclosedVolume(threadSoup(surface));
    QVERIFY2(std::abs(taken / groove - 1.0) < 3e-3, qPrintable(QString::number(taken / groove, 'g', 10)));
  }

  // A straight line along the surface crosses the grooves: the lowest points are a pitch apart, and go up by the lead
  // in a turn of a right-hand thread.
  void pitchAndHandAreThoseOfTheTriangles_data() {
    QTest::addColumn<int>("starts");
    QTest::addColumn<bool>("isLeft");
    QTest::newRow("right-hand") << 1 << false;
    QTest::newRow("left-hand") << 1 << true;
    QTest::newRow("two starts") << 2 << false;
  }
  void pitchAndHandAreThoseOfTheTriangles() {
    QFETCH(int, starts);
    QFETCH(bool, isLeft);
    const TurnedProfile profile({20.0, 30.0, 0.0}, 0.05);
    TurningPass pass = straightPass(8.5, 5.0, 25.0, 2.5);
    pass.thread->starts = starts;
    pass.thread->isLeft = isLeft;
    pass.thread->offset = 0.7;
    const TriangleSoup soup = threadSoup(TurnedSurface(profile, 1e-2, threadsOf(pass)));
    // The bottom is where a point is at the least radius of all.
    std::map<long, std::vector<double>> bottoms;  // by angle in 1e-6 radian: heights
    for (const Vec3& p : soup.points) {
      const double angle = std::atan2(p.y(), p.x()), r = std::hypot(p.x(), p.y());
      if (std::abs(r - 8.5) < 1e-9 && p.z() > 8.0 && p.z() < 22.0) bottoms[std::lround(angle * 1e6)].push_back(p.z());
    }
    QVERIFY(bottoms.size() > 20);
    for (auto& [angle, heights] : bottoms) {
      std::sort(heights.begin(), heights.end());
      const auto isSame = [](double a, double b) { return b - a < 1e-9; };  // blocks share a ring
      heights.erase(std::unique(heights.begin(), heights.end(), isSame), heights.end());
      for (std::size_t i = 1; i < heights.size(); ++i) QVERIFY(std::abs(heights[i] - heights[i - 1] - 2.5) < 1e-9);
      const double rise = (isLeft ? -2.5 : 2.5) * starts * static_cast<double>(angle) * 1e-6 / (2.0 * M_PI);
      const double above = (heights.front() - 0.7 - rise) / 2.5;
      QVERIFY(std::abs(above - std::round(above)) < 1e-5);
    }
  }

  // Watertight with ends in the material, a chamfer, a shoulder, a bore with a thread of its own, and odd chords.
  void watertight_data() {
    QTest::addColumn<double>("chord");
    for (double chord : {0.5, 0.05, 0.01}) QTest::addRow("%g mm", chord) << chord;
  }
  void watertight() {
    QFETCH(double, chord);
    std::vector<double> outer, inner;
    for (int i = 0; i <= 800; ++i) {
      const double z = 0.05 * i;
      outer.push_back(z < 8.0 ? 15.0 : std::min({10.0, 10.0 - (z - 38.0), z < 10.0 ? 8.0 : 10.0}));
      inner.push_back(z < 6.0 ? 0.0 : 5.0);
    }
    const TurnedProfile profile = TurnedProfile::fromRadii(outer, inner, 40.0);
    TurningPass bore = straightPass(5.8, 12.0, 45.0, 1.5);
    bore.side = TurningSide::Bore;
    bore.noseRadius = 0.05;
    TurningPass left = straightPass(9.2, 20.0, 30.0, 1.75);
    left.thread->isLeft = true;
    TurningPass outside = straightPass(8.6, 9.0, 45.0, 2.0);
    const auto threads =
        PartThreads::of({std::make_shared<const TurningPass>(outside), std::make_shared<const TurningPass>(left),
                         std::make_shared<const TurningPass>(bore)});
    QCOMPARE(threads->grooves().size(), std::size_t(3));
    const TriangleSoup soup = threadSoup(TurnedSurface(profile, chord, threads));
    const HalfEdgeMesh mesh = buildMesh(soup).mesh;
    QVERIFY(validate(mesh).empty());
    QVERIFY(findBoundaryLoops(mesh).empty());
    const double volume = enclosedVolume(soup), expected = profile.volume() - threads->volume(profile);
    QVERIFY2(std::abs(volume / expected - 1.0) < chord / 5.0 + 1e-3, qPrintable(QString::number(volume / expected)));
  }

  // The same again where a pass was deeper; a pass beside it is another thread.
  void deeperPassHoldsTheOneBefore() {
    const auto shared = [](const TurningPass& pass) { return std::make_shared<const TurningPass>(pass); };
    TurningPass aside = straightPass(8.5, 0.0, 30.0, 2.5), flank = straightPass(9.0, 0.0, 30.0, 2.5);
    flank.thread->offset = 0.5 * std::tan(M_PI / 6.0);  // fed in along its flank
    aside.thread->offset = 0.7;
    const TurningPass first = straightPass(9.5, 0.0, 30.0, 2.5), last = straightPass(8.5, 0.0, 30.0, 2.5);
    QCOMPARE(PartThreads::of({shared(first), shared(flank), shared(last), shared(first)})->grooves().size(),
             std::size_t(1));
    QCOMPARE(PartThreads::of({shared(last), shared(aside)})->grooves().size(), std::size_t(2));
    QVERIFY(!PartThreads::of({shared(TurningPass())}));
  }

  // H/8 of the crest and H/4 at the pitch diameter, which ISO 68-1 has at 3/8 H below the crest.
  void isoProfile() {
    ThreadCut cut;
    cut.pitch = 2.5;
    const double height = std::sqrt(3.0) / 2.0 * 2.5, depth = isoMetricDepth(2.5), nose = isoMetricNose(2.5);
    QVERIFY(std::abs(depth - 0.61343 * 2.5) < 1e-4);
    const ThreadEdge edge(cut, nose);
    QVERIFY(std::abs(edge.heightAt(2.5 / 2.0 - 2.5 / 16.0) - depth) < 1e-12);
    QVERIFY(std::abs(edge.heightAt(2.5 / 4.0) - (depth - 3.0 / 8.0 * height)) < 1e-12);
    for (double h : {0.0, 0.05, 0.3, 1.2}) QVERIFY(std::abs(edge.heightAt(cut.distanceAt(h, nose)) - h) < 1e-12);
  }
};

HANDWHEEL_TEST(ThreadSurfaceTest)
#include "ThreadSurfaceTest.moc"
