// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "document/workpiece/exercise/AssignedTask.h"

#include <QtTest>
#include <nlohmann/json.hpp>

using namespace handwheel;

// The limits that the panel of the lathe compares with, as the marks do.
class WorkLimitsTest : public QObject {
  Q_OBJECT

 private slots:
  // The lathe takes 2000 N and 4 kW; the mark for the force is lost at 1500 N, that for the power only at 5 kW.
  void theSmallerOfBoth() {
    const auto description = std::make_shared<const nlohmann::json>(nlohmann::json::parse(R"({"subject": "turning",
        "task": {"diameter": 40, "length": 100, "force_limit": 2000, "power_limit": 4, "largest_feed": 0.8},
        "criteria": [{"id": "f", "figure": "force", "upper": 1500}, {"id": "p", "figure": "power", "upper": 5},
                     {"id": "d", "figure": "diameter", "upper": 30}, {"id": "n", "figure": "force"}]})"));
    const AssignedExercise assigned{description, std::make_shared<const nlohmann::json>(nlohmann::json::object())};
    QVERIFY(workLimits(assigned) == (WorkLimits{1500.0, 4.0, 0.8}));
    QVERIFY(workLimits({}) == WorkLimits());
  }
};

HANDWHEEL_TEST(WorkLimitsTest)
#include "WorkLimitsTest.moc"
