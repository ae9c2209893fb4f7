// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/EdgePairing.h"

#include "MeshShapes.h"
#include "TestClass.h"
#include "mesh/structure/HalfEdgeMesh.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

namespace {

PairedEdges paired(const TriangleSoup& s) {
  return pairEdges(EdgeTable(s.triangles, s.points.size()), s.triangles, s.points);
}

// Blades around the z axis at these angles in degrees; those named forward run upwards along it.
TriangleSoup blades(const std::vector<std::pair<double, bool>>& spokes) {
  TriangleSoup s;
  s.points = {Vec3(0, 0, 0), Vec3(0, 0, 1)};
  for (const auto& [degrees, forward] : spokes) {
    const double u = degrees * M_PI / 180.0;
    const auto n = static_cast<std::uint32_t>(s.points.size());
    s.points.emplace_back(std::cos(u), std::sin(u), 0.5);
    s.triangles.push_back(forward ? Triangle{0, 1, n} : Triangle{1, 0, n});
  }
  return s;
}

// The blade that each one is paired with; -1 for none.
std::vector<int> partners(const TriangleSoup& s) {
  std::vector<int> result;
  const std::vector<std::uint32_t> opposite = paired(s).opposite;
  for (std::size_t f = 0; f < s.triangles.size(); ++f) {
    const std::uint32_t o = opposite[3 * f];  // half-edge 0 of a blade lies on the axis
    result.push_back(o < static_cast<std::uint32_t>(Open::Seam) ? int(o / 3) : -1);
  }
  return result;
}

}  // namespace

class EdgePairingTest : public QObject {
  Q_OBJECT

 private slots:
  void ordinarySurface();
  void wedges();
  void wedgeAcrossTheStart();
  void nestedWedges();
  void oneTooMany();
  void sameDirection();
  void isSymmetric();
};

void EdgePairingTest::ordinarySurface() {
  const TriangleSoup s = test::torus(8, 6);
  const PairedEdges p = paired(s);
  QCOMPARE(p.nonManifoldEdges, std::size_t{0});
  QCOMPARE(p.seams, std::size_t{0});
  for (std::uint32_t h = 0; h < p.opposite.size(); ++h) {
    QCOMPARE(p.opposite[p.opposite[h]], h);
    QVERIFY(p.opposite[h] / 3 != h / 3);
  }
}

// A face (0, 1, n) at angle u has its front towards greater angles, seen from above: its normal is z × r. The solid is
// behind it, at smaller angles. So a backward blade at 0° and a forward one at 60° bound the wedge between them.
void EdgePairingTest::wedges() {
  QCOMPARE(partners(blades({{0, false}, {60, true}, {90, false}, {150, true}})), std::vector<int>({1, 0, 3, 2}));
  QCOMPARE(partners(blades({{0, true}, {60, false}, {90, true}, {150, false}})), std::vector<int>({3, 2, 1, 0}));
}

void EdgePairingTest::wedgeAcrossTheStart() {
  for (double turn = 0.0; turn < 360.0; turn += 15.0) {
    const std::vector<int> expected = {1, 0, 3, 2};
    QCOMPARE(partners(blades({{turn, false}, {turn + 60, true}, {turn + 90, false}, {turn + 150, true}})), expected);
  }
}

// One solid within another, both ending at the edge: the inner blades pair with each other.
void EdgePairingTest::nestedWedges() {
  QCOMPARE(partners(blades({{10, false}, {40, false}, {80, true}, {120, true}})), std::vector<int>({3, 2, 1, 0}));
}

void EdgePairingTest::oneTooMany() {
  const PairedEdges p = paired(blades({{0, false}, {60, true}, {90, false}}));
  QCOMPARE(p.nonManifoldEdges, std::size_t{1});
  QCOMPARE(p.seams, std::size_t{1});
  std::size_t border = 0;
  for (std::uint32_t o : p.opposite) border += o == static_cast<std::uint32_t>(Open::Border);
  QCOMPARE(border, std::size_t{6});  // the outer edges of the three blades; the axis is none
}

void EdgePairingTest::sameDirection() {
  const PairedEdges p = paired(blades({{0, true}, {60, true}}));
  QCOMPARE(p.nonManifoldEdges, std::size_t{0});
  QCOMPARE(p.seams, std::size_t{2});
}

void EdgePairingTest::isSymmetric() {
  QVERIFY(rc::check("pairs are mutual and run against each other; as many as the directions allow", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    std::vector<std::pair<double, bool>> spokes;
    for (int n = *rc::gen::inRange(3, 12); n > 0; --n) spokes.emplace_back(random() % 360, random() % 2);
    const TriangleSoup s = blades(spokes);
    const PairedEdges p = paired(s);
    std::size_t forward = 0, pairs = 0;
    for (std::uint32_t f = 0; f < s.triangles.size(); ++f) {
      forward += spokes[f].second;
      const std::uint32_t o = p.opposite[3 * f];
      if (o >= static_cast<std::uint32_t>(Open::Seam)) continue;
      ++pairs;
      RC_ASSERT(p.opposite[o] == 3 * f);
      RC_ASSERT(spokes[f].second != spokes[o / 3].second);
    }
    RC_ASSERT(pairs == 2 * std::min(forward, spokes.size() - forward));
    RC_ASSERT(p.seams == spokes.size() - pairs);
  }));
}

HANDWHEEL_TEST(EdgePairingTest)
#include "EdgePairingTest.moc"
