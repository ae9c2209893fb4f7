// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/OperationSettings.h"

#include "TestClass.h"

#include <QTest>
#include <cmath>

using namespace handwheel;

namespace {

const Operation& milling() {
  static const Operation operation = {
      .id = "mill",
      .title = "Mill",
      .meaning = "Mill",
      .parameters = {
          {.property = {.id = "step-down",
                        .group = {},
                        .label = "Step",
                        .value = 2.0,
                        .quantity = Quantity::Length,
                        .least = 0.5,
                        .largest = 4.0},
           .meaning = "Depth of a pass",
           .word = "MM"},
          {.property = {.id = "passes", .group = {}, .label = "Passes", .value = 1.0, .least = 1.0, .largest = 9.0},
           .meaning = "How many",
           .word = "N",
           .isWhole = true},
          {.property = {.id = "way", .group = {}, .label = "Way", .value = 0.0, .choices = {"Climb", "Against"}},
           .meaning = "Direction",
           .word = "WAY",
           .words = {"climb", "against"}},
          {.property = {.id = "wet", .group = {}, .label = "Coolant", .value = false}, .meaning = "With coolant"},
          {.property = {.id = "from", .group = {}, .label = {}, .value = "0,0", .least = -10.0, .largest = 10.0},
           .meaning = "Where it starts",
           .word = "X,Y",
           .parts = {{"x", "From x"}, {"y", "From y"}}},
          {.property = {.id = "finish", .group = {}, .label = "Finish", .value = 0.25},
           .meaning = "Left for the last pass; default: that of the tool",
           .word = "MM",
           .hasDefault = false},
      }};
  return operation;
}

}  // namespace

class OperationSettingsTest : public QObject {
  Q_OBJECT

 private slots:
  void settingsAreTheParameters() {
    const OperationValues values(milling());
    const Property step = settingOf(values, "step_down");
    QCOMPARE(step.id, std::string("step_down"));
    QCOMPARE(step.label, std::string("Step"));
    QCOMPARE(std::get<double>(step.value), 2.0);
    QCOMPARE(step.quantity, Quantity::Length);
    QCOMPARE(step.least, 0.5);
    QCOMPARE(step.largest, 4.0);
    QCOMPARE(settingOf(values, "way").choices, std::vector<std::string>({"Climb", "Against"}));
    QCOMPARE(settingOf(values, "from_y").label, std::string("From y"));
  }

  // A setting without a value or default is shown as it is described.
  void withoutAValue() {
    OperationValues values(milling());
    QVERIFY(!values.given("finish"));
    QCOMPARE(std::get<double>(settingOf(values, "finish").value), 0.25);
    QVERIFY(takeSetting(values, "finish", 0.5));
    QCOMPARE(std::get<double>(settingOf(values, "finish").value), 0.5);
  }

  // Values set by a panel are brought between their limits.
  void taking() {
    OperationValues values(milling());
    QVERIFY(takeSetting(values, "step_down", 99.0));
    QCOMPARE(values.number("step-down"), 4.0);
    QVERIFY(takeSetting(values, "passes", 3.4));
    QCOMPARE(values.whole("passes"), std::size_t(3));
    QVERIFY(takeSetting(values, "way", 1.0));
    QVERIFY(takeSetting(values, "wet", true));
    QVERIFY(takeSetting(values, "from_y", -99.0));
    QCOMPARE(values.numbers("from"), std::vector<double>({0.0, -10.0}));
    QCOMPARE(std::get<double>(settingOf(values, "from_y").value), -10.0);
    QVERIFY(std::get<bool>(settingOf(values, "wet").value));
  }

  void whatIsNoValue() {
    OperationValues values(milling());
    for (const auto& [id, value] :
         std::initializer_list<std::pair<const char*, PropertyValue>>{{"step_down", true},
                                                                      {"step_down", std::nan("")},
                                                                      {"step_down", "deep"},
                                                                      {"way", 2.0},
                                                                      {"way", -1.0},
                                                                      {"way", 0.5},
                                                                      {"way", std::nan("")},
                                                                      {"wet", 1.0},
                                                                      {"from_x", "3"},
                                                                      {"from", "1,2,3"},
                                                                      {"from_z", 1.0},
                                                                      {"speed", 1.0},
                                                                      {"", 1.0}})
      QVERIFY2(!takeSetting(values, id, value), id);
    QVERIFY(values == OperationValues(milling()));
  }
};

HANDWHEEL_TEST(OperationSettingsTest)
#include "OperationSettingsTest.moc"
