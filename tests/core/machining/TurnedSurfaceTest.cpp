// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/TurnedSurface.h"

#include "TestClass.h"
#include "mesh/boundary/BoundaryLoops.h"
#include "mesh/structure/MeshBuilder.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;

namespace {

TriangleSoup joined(const TurnedSurface& surface) {
  TriangleSoup all;
  for (const auto& block : surface.blocks()) {
    const auto base = static_cast<std::uint32_t>(all.points.size());
    all.points.insert(all.points.end(), block->points.begin(), block->points.end());
    for (const Triangle& t : block->triangles) all.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  }
  return all;
}

double signedVolume(const TriangleSoup& soup) {
  double sum = 0.0;
  for (const Triangle& t : soup.triangles)
    sum += soup.points[t[0]].dot(soup.points[t[1]].cross(soup.points[t[2]])) / 6.0;
  return sum;
}

}  // namespace

class TurnedSurfaceTest : public QObject {
  Q_OBJECT

 private slots:
  // Closed and facing outwards, with the volume of the profile less that outside of the chords of the circles.
  void closedWithTheVolumeOfTheProfile_data() {
    QTest::addColumn<int>("cuts");
    for (int cuts : {0, 1, 5, 40}) QTest::addRow("%d cuts", cuts) << cuts;
  }
  void closedWithTheVolumeOfTheProfile() {
    QFETCH(int, cuts);
    TurnedProfile profile({40.0, 100.0, 0.0}, 0.1);
    const double chord = 0.02;
    TurnedSurface surface(profile, chord);
    for (int i = 0; i < cuts; ++i) {
      const double r = 16.0 + 5.0 * std::sin(i), z = 97.0 * std::fmod(0.618 * i, 1.0);
      surface.update(profile, profile.cut({r, z}, {r + 2.0, z + 6.0}, 1.5));
    }
    if (cuts == 40) surface.update(profile, profile.cut({-1.0, 50.0}, {-1.0, 51.0}, 1.5));  // to the axis
    const HalfEdgeMesh mesh = buildMesh(joined(surface)).mesh;
    QVERIFY(findBoundaryLoops(mesh).empty());
    const double volume = signedVolume(joined(surface));
    QVERIFY(volume > 0.0);
    QVERIFY2(std::abs(volume / profile.volume() - 1.0) < 4.0 * chord / 20.0, qPrintable(QString::number(volume)));
  }

  // With a bore through, one from each end, a parted section, and one in which the bore meets the outside.
  void closedWithBores_data() {
    QTest::addColumn<int>("which");
    QTest::newRow("through") << 0;
    QTest::newRow("blind, at the upper end") << 1;
    QTest::newRow("blind, at both ends") << 2;
    QTest::newRow("bored through and parted") << 3;
    QTest::newRow("one sample is parted") << 4;
    QTest::newRow("a hollow inside") << 5;
  }
  void closedWithBores() {
    QFETCH(int, which);
    TurnedProfile profile({40.0, 100.0, 0.0}, 0.1);
    const double chord = 0.02;
    TurnedSurface surface(profile, chord);
    TurnedProfile::Range changed;
    for (std::size_t i = 0; i < profile.size(); ++i) {
      const double z = profile.z(i), wave = 12.0 + std::sin(0.3 * z);
      const bool isHollow = which == 0 || which >= 3 || (z > 60.0) || (which == 2 && z < 30.0);
      const bool isIn = which == 5 ? z > 20.0 && z < 80.0 : isHollow;
      if (isIn && profile.limitInner(i, wave)) changed.extend({i, i + 1});
      if (which == 3 && std::abs(z - 40.0) < 2.0 && profile.limitOuter(i, 5.0)) changed.extend({i, i + 1});
      if (which == 4 && i == 500 && profile.limitOuter(i, 5.0)) changed.extend({i, i + 1});
    }
    surface.update(profile, changed);
    QCOMPARE(profile.pieces().size(), std::size_t{which == 3 || which == 4 ? 2u : 1u});
    const HalfEdgeMesh mesh = buildMesh(joined(surface)).mesh;
    QVERIFY(findBoundaryLoops(mesh).empty());
    const double volume = signedVolume(joined(surface));
    QVERIFY2(std::abs(volume / profile.volume() - 1.0) < 6.0 * chord / 8.0, qPrintable(QString::number(volume)));
  }

  void onlyWhatChangedIsBuilt() {
    TurnedProfile profile({40.0, 100.0, 0.0}, 0.02);
    const TurnedSurface before(profile, 0.05);
    TurnedSurface after = before;
    const TurnedProfile::Range changed = profile.cut({19.0, 50.0}, {19.0, 51.0}, 1.5);
    after.update(profile, changed);
    QCOMPARE(after.blocks().size(), before.blocks().size());
    std::size_t built = 0;
    for (std::size_t b = 0; b < after.blocks().size(); ++b) {
      const double from = profile.z(b * TurnedSurface::kBlockSamples),
                   to = from + profile.spacing() * TurnedSurface::kBlockSamples;
      const bool isTouched = to >= profile.z(changed.first) && from <= profile.z(changed.last - 1);
      QCOMPARE(after.blocks()[b] != before.blocks()[b], isTouched);
      built += isTouched ? 1 : 0;
    }
    QVERIFY(built >= 1 && built <= 3);
  }
};

HANDWHEEL_TEST(TurnedSurfaceTest)
#include "TurnedSurfaceTest.moc"
