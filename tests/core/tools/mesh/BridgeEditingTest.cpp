// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/boundary/BridgeEditing.h"

#include "TestClass.h"
#include "mesh/holes/HoleDecomposition.h"

#include <rapidcheck.h>

#include <QTest>

using namespace handwheel;
using Bridges = std::vector<HoleBridge>;

namespace {

constexpr std::size_t kSize = 20;

// Draws from point to point.
bool draw(BridgeEditing& editing, std::uint32_t from, std::uint32_t to, const Bridges& shown) {
  editing.press(from);
  editing.drag(to);
  return editing.release(kSize, shown);
}

}  // namespace

class BridgeEditingTest : public QObject {
  Q_OBJECT

 private slots:
  void oneMore();
  void oneLess();
  void crossingOnesGiveWay();
  void whatIsNoBridge();
  void alwaysABridging();
};

void BridgeEditingTest::oneMore() {
  BridgeEditing editing;
  QVERIFY(!editing.drawn());
  editing.press(2);
  QVERIFY(editing.isDrawing());
  editing.drag(9);
  QVERIFY(editing.drawn() == HoleBridge({2, 9}));
  QVERIFY(editing.release(kSize, {{12, 18}}));
  QVERIFY(!editing.isDrawing());
  QVERIFY(editing.own() == Bridges({{12, 18}, {2, 9}}));
  editing.reset();
  QVERIFY(editing.own().empty());
}

void BridgeEditingTest::oneLess() {
  BridgeEditing editing;
  QVERIFY(draw(editing, 9, 2, {{12, 18}, {2, 9}}));  // in both directions
  QVERIFY(editing.own() == Bridges({{12, 18}}));
}

void BridgeEditingTest::crossingOnesGiveWay() {
  BridgeEditing editing;
  QVERIFY(draw(editing, 0, 10, {{5, 15}, {1, 4}, {11, 14}}));
  QVERIFY(editing.own() == Bridges({{1, 4}, {11, 14}, {0, 10}}));
}

void BridgeEditingTest::whatIsNoBridge() {
  BridgeEditing editing;
  const Bridges shown = {{12, 18}};
  QVERIFY(!draw(editing, 3, 3, shown));
  QVERIFY(!draw(editing, 3, 4, shown));   // an edge of the loop
  QVERIFY(!draw(editing, 0, 19, shown));  // and this one
  editing.press(3);
  editing.drag(std::nullopt);  // let go beside the loop
  QVERIFY(!editing.release(kSize, shown));
  QVERIFY(editing.own().empty());
}

void BridgeEditingTest::alwaysABridging() {
  QVERIFY(rc::check("whatever is drawn, the loop can be cut along it", [] {
    BridgeEditing editing;
    for (int i = 0; i < 30; ++i) {
      draw(editing, *rc::gen::inRange<std::uint32_t>(0, kSize), *rc::gen::inRange<std::uint32_t>(0, kSize),
           editing.own());
      RC_ASSERT(editing.own().empty() || splitHole(kSize, editing.own()).has_value());
    }
  }));
}

HANDWHEEL_TEST(BridgeEditingTest)
#include "BridgeEditingTest.moc"
