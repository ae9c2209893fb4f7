// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/structure/Orientation.h"

#include "MeshChecks.h"
#include "MeshShapes.h"
#include "OneSidedShapes.h"
#include "TestClass.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;

namespace {

std::vector<bool> toTurn(const TriangleSoup& s) {
  return trianglesToReverse(EdgeTable(s.triangles, s.points.size()), s.triangles);
}

TriangleSoup withTurned(TriangleSoup s, const std::vector<bool>& turn) {
  for (std::size_t i = 0; i < turn.size(); ++i)
    if (turn[i]) s.triangles[i] = reversed(s.triangles[i]);
  return s;
}

std::vector<bool> randomTurns(std::size_t n, double share, std::mt19937& random) {
  std::vector<bool> turn(n);
  for (std::size_t i = 0; i < n; ++i) turn[i] = random() < share * 4294967296.0;
  return turn;
}

}  // namespace

class OrientationTest : public QObject {
  Q_OBJECT

 private slots:
  void nothingToDo();
  void undoesRandomTurns();
  void turnsTheFewest();
  void eachPartOnItsOwn();
  void nonOrientableKeepsADisagreement();
  void turnedHalfEdges();
};

void OrientationTest::nothingToDo() {
  for (const TriangleSoup& s : {test::icosphere(2), test::torus(8, 6), test::disc(8, 3), test::turnedOver(test::cube()),
                                test::twoCubesSharingAnEdge()}) {
    const std::vector<bool> turn = toTurn(s);
    QCOMPARE(turn.size(), s.triangles.size());
    QVERIFY(std::find(turn.begin(), turn.end(), true) == turn.end());
  }
}

// After any turns the answer undoes them, or leaves the whole part inside out when more than half were turned.
void OrientationTest::undoesRandomTurns() {
  QVERIFY(rc::check("turned faces are turned back", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const TriangleSoup s = *rc::gen::element(test::icosphere(2), test::torus(8, 6), test::annulus(10, 3, 1, 2));
    const std::vector<bool> turns = randomTurns(s.triangles.size(), 0.01 * *rc::gen::inRange(0, 100), random);
    const std::vector<bool> back = toTurn(withTurned(s, turns));
    RC_ASSERT(test::countEdges(withTurned(withTurned(s, turns), back)).inconsistent == std::size_t{0});
    std::vector<bool> rest = turns;
    rest.flip();
    RC_ASSERT(back == turns || back == rest);
  }));
}

void OrientationTest::turnsTheFewest() {
  QVERIFY(rc::check("never more than half of a part", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const TriangleSoup s = test::icosphere(1);
    const std::vector<bool> back =
        toTurn(withTurned(s, randomTurns(s.triangles.size(), 0.01 * *rc::gen::inRange(0, 100), random)));
    RC_ASSERT(2 * std::count(back.begin(), back.end(), true) <= std::ptrdiff_t(back.size()));
  }));
}

// A part that faces inward is left so: it may be the wall of a cavity.
void OrientationTest::eachPartOnItsOwn() {
  TriangleSoup s = test::icosphere(1);
  const std::size_t first = s.triangles.size();
  test::append(s, test::turnedOver(test::moved(test::icosphere(1), Vec3::Zero(), 0.5)));
  std::vector<bool> turns(s.triangles.size(), false);
  turns[3] = turns[first + 8] = true;
  QVERIFY(toTurn(withTurned(s, turns)) == turns);
}

void OrientationTest::nonOrientableKeepsADisagreement() {
  for (const TriangleSoup& s : {test::moebiusStrip(12, 2), test::kleinBottle(12, 6)})
    QVERIFY(test::countEdges(withTurned(s, toTurn(s))).inconsistent > 0);
}

void OrientationTest::turnedHalfEdges() {
  const Triangle t = {4, 7, 9}, u = reversed(t);
  const std::uint32_t face = 5;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t h = reversedHalfEdge(3 * face + k);
    QCOMPARE(h / 3, face);
    QCOMPARE(u[h % 3], t[(k + 1) % 3]);
    QCOMPARE(u[(h + 1) % 3], t[k]);
  }
}

HANDWHEEL_TEST(OrientationTest)
#include "OrientationTest.moc"
