// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "robot/program/PathFile.h"

#include "../Robots.h"
#include "TestClass.h"

#include <QTest>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const RobotModel& arm() {
  static const RobotModel kArm = readOrThrow(planarArm({0.5, 0.5}, limit(-3, 3))).robot;
  return kArm;
}

JointValues pair(double a, double b) {
  JointValues values(2);
  values << a, b;
  return values;
}

}  // namespace

// Paths as JSON: what is written is read as the same, and what is wrong is named.
class PathFileTest : public QObject {
  Q_OBJECT

 private slots:
  void writtenAndRead() {
    QVERIFY(rc::check("the same path", [] {
      RobotPath path{"from a to b", {}};
      const int count = *rc::gen::inRange(0, 6);
      for (int i = 0; i < count; ++i) {
        PathPlace place{.joints = pair(anyNumber(-3, 3), anyNumber(-3, 3)), .name = std::string(1, char('a' + i))};
        place.isCritical = *rc::gen::arbitrary<bool>();
        if (*rc::gen::arbitrary<bool>()) {
          place.motion = ProgramMotion::Kind::Linear;
          place.speed = anyNumber(1, 1000);
        }
        place.blend = anyNumber(0, 50);
        path.places.push_back(place);
      }
      const auto again = readPath(toJson(arm(), path).dump(), arm(), pair(0, 0));
      RC_ASSERT(again.hasValue());
      RC_ASSERT(*again == path);
    }));
  }

  void waypointsAlone() {
    const auto path = readPath(R"({"waypoints": [[0.1, 0.2], [1, -1]]})", arm(), pair(0, 0));
    QVERIFY(path.hasValue());
    QCOMPARE(path->places.size(), std::size_t{2});
    QVERIFY(path->places[1].joints == pair(1, -1));
    // In another order, and of one joint only: the other stands.
    const auto other = readPath(R"({"joints": ["j2"], "waypoints": [[0.5]]})", arm(), pair(0.25, 0));
    QVERIFY(other.hasValue());
    QVERIFY(other->places[0].joints == pair(0.25, 0.5));
  }

  void refusals_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("code");
    QTest::newRow("no JSON") << "{"
                             << "ElementMalformed";
    QTest::newRow("a list") << "[]"
                            << "ElementMalformed";
    QTest::newRow("nothing") << "{}"
                             << "ElementMalformed";
    QTest::newRow("too few numbers") << R"({"waypoints": [[1]]})"
                                     << "ElementMalformed";
    QTest::newRow("a text") << R"({"waypoints": [[1, "2"]]})"
                            << "ElementMalformed";
    QTest::newRow("beyond a limit") << R"({"waypoints": [[1, 3.1]]})"
                                    << "ValueOutOfRange";
    QTest::newRow("no number at all") << R"({"waypoints": [[1, 1e999]]})"
                                      << "ElementMalformed";
    QTest::newRow("a joint that is not there") << R"({"joints": ["j1", "j9"], "waypoints": []})"
                                               << "ReferenceMissing";
    QTest::newRow("a place without joints") << R"({"places": [{"name": "x"}]})"
                                            << "ElementMalformed";
    QTest::newRow("a motion") << R"({"places": [{"joints": {}, "motion": "leap"}]})"
                              << "ElementMalformed";
  }
  void refusals() {
    QFETCH(const QString, text);
    QFETCH(const QString, code);
    const auto path = readPath(text.toStdString(), arm(), pair(0, 0));
    QVERIFY(!path.hasValue());
    QCOMPARE(QString::fromLatin1(path.error().code->id), code);
  }

  void names() {
    CellPlans plans;
    plans.paths = {{"way", {}}, {"way 2", {}}};
    QCOMPARE(plans.freePathName("way"), std::string("way 3"));
    QCOMPARE(plans.freePathName("other"), std::string("other"));
    QVERIFY(plans.path("way 2") && !plans.path("way 9"));
  }
};

HANDWHEEL_TEST(PathFileTest)
#include "PathFileTest.moc"
