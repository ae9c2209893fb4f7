// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/OperationText.h"

#include "TestClass.h"

#include <rapidcheck.h>

#include <QTest>
#include <clocale>
#include <numbers>

using namespace handwheel;

namespace {

const Operation& turning() {
  static const Operation operation = {.id = "turn",
                                      .title = "Turn",
                                      .meaning = "Turn",
                                      .parameters = {{.property = {.id = "by",
                                                                   .group = {},
                                                                   .label = "By",
                                                                   .value = 0.0,
                                                                   .quantity = Quantity::Angle,
                                                                   .least = -10.0,
                                                                   .largest = 10.0},
                                                      .meaning = "How far",
                                                      .word = "DEGREES"}}};
  return operation;
}

}  // namespace

class OperationTextTest : public QObject {
  Q_OBJECT

 private slots:
  // Every angle is read back as the very number, in any locale.
  void anglesAreExact() {
    for (const char* locale : {"C", "de_DE.UTF-8"}) {
      std::setlocale(LC_ALL, locale);
      const bool holds = rc::check("angles", [] {
        const double angle =
            *rc::gen::map(rc::gen::inRange<std::int64_t>(-6'283'185'307'179'586, 6'283'185'307'179'586),
                          [](std::int64_t n) { return 1e-15 * static_cast<double>(n); });
        OperationValues values(turning());
        RC_ASSERT(readWord(values, turning().parameters[0], angleText(angle)).empty());
        RC_ASSERT(values.number("by") == angle);
      });
      std::setlocale(LC_ALL, "C");
      QVERIFY(holds);
    }
  }

  void anglesAreShort() {
    QCOMPARE(angleText(0.5 * std::numbers::pi), std::string("90"));
    QCOMPARE(angleText(30.0 * kRadiansPerDegree), std::string("30"));
    QCOMPARE(angleText(0.0), std::string("0"));
  }

  void parts() {
    QCOMPARE(parted("", ','), std::vector<std::string_view>({""}));
    QCOMPARE(parted("a,,b", ','), std::vector<std::string_view>({"a", "", "b"}));
    QCOMPARE(choicesText({"a"}), std::string("a"));
    QCOMPARE(choicesText({"a", "b", "c"}), std::string("a, b or c"));
  }
};

HANDWHEEL_TEST(OperationTextTest)
#include "OperationTextTest.moc"
