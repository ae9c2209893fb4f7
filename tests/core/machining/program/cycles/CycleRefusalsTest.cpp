// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../ProgramTrial.h"
#include "TestClass.h"
#include "machining/lathe/LatheJson.h"
#include "machining/program/cycles/BoreCuts.h"
#include "machining/program/cycles/CycleProgram.h"

#include <QtTest>
#include <cmath>

using namespace handwheel;
using test::ProgramTrial;

namespace {

// A cylinder of 36 mm by 50 mm with a bore from its upper end, whose wall and bottom these points are.
TargetProfile withBore(const std::vector<ProfilePoint>& wall) {
  std::vector<ProfileSegment> all = {{{0, -50}, {18, -50}, 0.0}, {{18, -50}, {18, 0}, 0.0}};
  for (const ProfilePoint& p : wall) all.push_back({all.back().to, p, 0.0});
  return TargetProfile::make(std::move(all)).value();
}

// Returns the reason of an error, "word: reason".
std::string refusedBecause(const Error& error) {
  return error.arguments.at(1) + ": " + error.arguments.at(2);
}

}  // namespace

// Targets that cycles and drills cannot make, and why.
class CycleRefusalsTest : public QObject {
  Q_OBJECT

 private slots:
  // The point of a drill of 118° and 6 mm is 1.8 mm high: too long for a flat bore 1.5 mm deep.
  void theShallowestBore() {
    const LatheTools tools = shippedLatheTools();
    const TargetProfile shallow = withBore({{14, 0}, {14, -1.5}, {0, -1.5}});
    const auto refused = boreTools(shallow, 6.0, tools);
    QVERIFY(!refused);
    QCOMPARE(refusedBecause(refused.error()), std::string("drill: its point is longer than the bore is deep"));
    QCOMPARE(drillFor(shallow, tools), 0.0);
    QVERIFY(whyNoDrill(shallow, tools).has_value());
  }

  // The reason for a missing drill is given for the largest that goes into the bore; for a bore narrower than all, for
  // the smallest.
  void whyThereIsNoDrill() {
    const LatheTools tools = shippedLatheTools();
    const TargetProfile deep = withBore({{14, 0}, {14, -30}, {0, -30}}),
                        narrow = withBore({{2, 0}, {2, -30}, {0, -30}});
    QVERIFY(drillFor(deep, tools) > 0.0 && !whyNoDrill(deep, tools));
    const auto why = whyNoDrill(narrow, tools);
    QVERIFY(why && refusedBecause(*why) == "drill: it is too large for the bore");
    QVERIFY(why->arguments.at(3).find("at most") != std::string::npos);
  }

  // A wall that goes back towards the end it is reached from.
  void undercuts() {
    const auto bored =
        boreTools(withBore({{10, 0}, {10, -20}, {14, -15}, {14, -30}, {0, -30}}), 16.0, shippedLatheTools());
    QVERIFY(!bored);
    QCOMPARE(refusedBecause(bored.error()), std::string("target: its bore has an undercut at z = -17.5"));
    const std::vector<ProfilePoint> points = {{18, -60}, {18, -40}, {10, -40}, {10, -20},
                                              {14, -25}, {16, -10}, {16, 0}};
    std::vector<ProfileSegment> lip;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) lip.push_back({points[i], points[i + 1], 0.0});
    const auto turned = roughAndFinish(TargetProfile::make(lip).value(), 20.0, {});
    QVERIFY(!turned);
    QCOMPARE(refusedBecause(turned.error()), std::string("target: it has an undercut at z = -22.5"));
  }
};

HANDWHEEL_TEST(CycleRefusalsTest)
#include "CycleRefusalsTest.moc"
