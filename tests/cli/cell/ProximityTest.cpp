// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlannedCell.h"
#include "TestClass.h"

#include <QTest>

using namespace handwheel;

// The command "proximity".
class ProximityTest : public QObject {
  Q_OBJECT

 private slots:
  // The robot gets into all three scenarios beside its box; each query tells what it has compared.
  void scenarios() {
    const PlannedCell cell;
    const Ran ran = cell.run({"proximity", "cell.handwheel", "--steps", "10", "--json"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json scenarios = jsonOf(ran.out)["scenarios"];
    QCOMPARE(scenarios.size(), std::size_t{4});
    QVERIFY(scenarios[0]["scenario"].is_null());
    const std::array<const char*, 3> states{"apart", "near", "colliding"};
    for (std::size_t i = 0; i < states.size(); ++i) {
      const nlohmann::json& one = scenarios[i + 1];
      QCOMPARE(one["scenario"].get<std::size_t>(), i + 1);
      QCOMPARE(one["state"].get<std::string>(), std::string(states[i]));
      QCOMPARE(one["distance_mm"].get<double>() >= 20.0, i == 0);
      QCOMPARE(one["near"].get<bool>(), i > 0);
      QCOMPARE(one["colliding"].get<bool>(), i == 2);
      QCOMPARE(one["queries"].size(), std::size_t{4});
      QVERIFY(one["queries"][0]["pairs"].get<double>() > 0.0);
    }
    const Ran one = cell.run({"proximity", "cell.handwheel", "--steps", "10", "--scenario", "3"});
    QVERIFY2(one.code == 0 && one.out.contains("C4 all contacts") && !one.out.contains("Scenario 1"), one.out);
  }

  // A robot without obstacles collides with nothing.
  void withoutObstacles() {
    const PlannedCell cell;
    const Ran ran = cell.run({"proximity", "irb120", "--steps", "10", "--scenario", "3"});
    QCOMPARE(ran.code, 2);
    QVERIFY2(ran.out.contains("does not get there"), ran.out);
  }

  void wrongOptions() {
    const PlannedCell cell;
    for (const QStringList& words : {QStringList{"--scenario", "4"}, QStringList{"--tolerance", "0"},
                                     QStringList{"--steps", "0"}, QStringList{"--tolerance", "nan"}}) {
      const Ran ran = cell.run(QStringList{"proximity", "cell.handwheel"} + words);
      QVERIFY2(ran.code == 1 && ran.err.contains(words[0].toUtf8()), ran.err);
    }
  }
};

HANDWHEEL_TEST(ProximityTest)
#include "ProximityTest.moc"
