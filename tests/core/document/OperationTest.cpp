// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/Operation.h"

#include "TestClass.h"
#include "document/OperationText.h"

#include <QTest>
#include <cmath>
#include <limits>
#include <numbers>

using namespace handwheel;

namespace {

// A parameter of each type.
const Operation& drilling() {
  static const Operation operation = {
      .id = "drill",
      .title = "Drill",
      .meaning = "Make a hole",
      .operands = "PLACE",
      .parameters = {
          {.property = {.id = "deep", .group = {}, .label = "Deep", .value = false}, .meaning = "Right through"},
          {.property = {.id = "radius",
                        .group = {},
                        .label = "Radius",
                        .value = 2.5,
                        .quantity = Quantity::Length,
                        .least = 0.5,
                        .largest = 20.0},
           .meaning = "Of the drill",
           .word = "MM"},
          {.property = {.id = "tilt",
                        .group = {},
                        .label = "Tilt",
                        .value = 0.0,
                        .quantity = Quantity::Angle,
                        .least = 0.0,
                        .largest = 0.5 * std::numbers::pi},
           .meaning = "From the normal",
           .word = "DEGREES",
           .hasDefault = false},
          {.property = {.id = "pecks", .group = {}, .label = "Pecks", .value = 1.0, .least = 1.0, .largest = 9.0},
           .meaning = "Times that it comes up",
           .word = "N",
           .isWhole = true,
           .formerId = "times"},
          {.property = {.id = "point", .group = {}, .label = "Point", .value = 1.0, .choices = {"Flat", "Cone"}},
           .meaning = "Shape of the end",
           .word = "HOW",
           .words = {"flat", "cone"}},
          {.property = {.id = "towards", .group = {}, .label = {}, .value = "0,0,1", .least = -1.0, .largest = 1.0},
           .meaning = "Direction",
           .word = "X,Y,Z",
           .parts = {{"x"}, {"y"}, {"z"}}},
      }};
  return operation;
}

}  // namespace

class OperationTest : public QObject {
  Q_OBJECT

 private slots:
  void defaults() {
    const OperationValues values(drilling());
    QVERIFY(!values.flag("deep"));
    QCOMPARE(values.number("radius"), 2.5);
    QVERIFY(!values.given("tilt") && !values.value("tilt"));
    QCOMPARE(values.whole("pecks"), std::size_t(1));
    QCOMPARE(values.whole("point"), std::size_t(1));
    QCOMPARE(values.numbers("towards"), std::vector<double>({0.0, 0.0, 1.0}));
    QVERIFY(writtenOptions(values).empty());
  }

  void whatIsSetIsThere() {
    OperationValues values(drilling());
    QCOMPARE(values.set("radius", 3.0), std::string());
    QCOMPARE(values.set("tilt", 0.25), std::string());
    QCOMPARE(values.set("towards", "1,0.5,0"), std::string());
    QVERIFY(values.isSet("radius") && values.isSet("tilt") && !values.isSet("point"));
    QCOMPARE(values.number("radius"), 3.0);
    QCOMPARE(*values.given("tilt"), 0.25);
    QCOMPARE(values.numbers("towards"), std::vector<double>({1.0, 0.5, 0.0}));
    values.reset("tilt");
    QVERIFY(!values.given("tilt"));
    // Setting a value to its default is the same as not setting it.
    QCOMPARE(values.set("radius", 2.5), std::string());
    QCOMPARE(values.set("towards", "0,0,1.0"), std::string());
    QVERIFY(values == OperationValues(drilling()));
  }

  // A value out of the range, or of another type, changes nothing, and the clause names parameter, range and value.
  void refusals_data() {
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("word");
    QTest::addColumn<QString>("clause");
    const auto row = [](const char* id, const char* word, const char* clause) {
      QTest::newRow(qPrintable(QString(id) + " " + word)) << id << word << clause;
    };
    row("deep", "yes", "--deep takes no value");
    row("radius", "0.4", "--radius takes a length from 0.5 to 20 mm, not '0.4'");
    row("radius", "20.5", "--radius takes a length from 0.5 to 20 mm, not '20.5'");
    row("radius", "wide", "--radius takes a length from 0.5 to 20 mm, not 'wide'");
    row("radius", "nan", "--radius takes a length from 0.5 to 20 mm, not 'nan'");
    row("radius", "inf", "--radius takes a length from 0.5 to 20 mm, not 'inf'");
    row("radius", "3mm", "--radius takes a length from 0.5 to 20 mm, not '3mm'");
    row("tilt", "91", "--tilt takes an angle from 0 to 90 degrees, not '91'");
    row("tilt", "2rad", "--tilt takes an angle from 0 to 90 degrees, not '2rad'");
    row("pecks", "1.5", "--pecks takes a whole number from 1 to 9, not '1.5'");
    row("pecks", "0", "--pecks takes a whole number from 1 to 9, not '0'");
    row("point", "blunt", "--point takes flat or cone, not 'blunt'");
    row("towards", "1,0", "--towards takes X,Y,Z, each a number from -1 to 1, not '1,0'");
    row("towards", "1,0,1.5", "--towards takes X,Y,Z, each a number from -1 to 1, not '1,0,1.5'");
    row("towards", "1,0,", "--towards takes X,Y,Z, each a number from -1 to 1, not '1,0,'");
  }
  void refusals() {
    QFETCH(QString, id);
    QFETCH(QString, word);
    QFETCH(QString, clause);
    OperationValues values(drilling());
    const Parameter& parameter = *drilling().find(id.toStdString());
    QCOMPARE(QString::fromStdString(readWord(values, parameter, word.toStdString())), clause);
    QVERIFY(values == OperationValues(drilling()));
  }

  void valuesOfAnotherType() {
    OperationValues values(drilling());
    QVERIFY(!values.set("radius", true).empty());
    QVERIFY(!values.set("radius", std::nan("")).empty());
    QVERIFY(!values.set("radius", std::numeric_limits<double>::infinity()).empty());
    QVERIFY(!values.set("point", 2.0).empty());
    QVERIFY(!values.set("point", -1.0).empty());
    QVERIFY(!values.set("point", 0.5).empty());
    QVERIFY(!values.set("towards", 1.0).empty());
    QVERIFY(values == OperationValues(drilling()));
  }

  void words() {
    OperationValues values(drilling());
    for (const auto& [id, word] : std::initializer_list<std::pair<const char*, const char*>>{{"deep", ""},
                                                                                             {"radius", "+3"},
                                                                                             {"tilt", "0.25rad"},
                                                                                             {"pecks", "3"},
                                                                                             {"point", "flat"},
                                                                                             {"towards", "0,1,0"}})
      QCOMPARE(readWord(values, *drilling().find(id), word), std::string());
    QCOMPARE(optionLine(values),
             std::string("--deep --radius 3 --tilt " + angleText(0.25) + " --pecks 3 --point flat --towards 0,1,0"));
    QCOMPARE(readWord(values, *drilling().find("tilt"), "30deg"), std::string());
    QCOMPARE(*values.given("tilt"), 30.0 * kRadiansPerDegree);
  }

  void helpPages() {
    QCOMPARE(syntaxOf(drilling()), std::string("drill PLACE [--deep] [--radius MM] [--tilt DEGREES] [--pecks N] "
                                               "[--point HOW] [--towards X,Y,Z]"));
    const auto help = [](const char* id) { return helpOf(*drilling().find(id)); };
    QCOMPARE(help("deep"), std::string("Right through"));
    QCOMPARE(help("radius"), std::string("Of the drill (0.5 to 20, default 2.5)"));
    QCOMPARE(help("tilt"), std::string("From the normal (0 to 90)"));
    QCOMPARE(help("point"), std::string("Shape of the end: flat or cone (default)"));
  }

  // Ranges are formatted as a person types them: no exponent, and three digits of a computed default.
  void rangesInWords() {
    Parameter parameter = *drilling().find("radius");
    const auto help = [&](double least, double largest, double standard, Quantity quantity = Quantity::Number) {
      parameter.property.least = least;
      parameter.property.largest = largest;
      parameter.property.value = standard;
      parameter.property.quantity = quantity;
      return helpOf(parameter);
    };
    QCOMPARE(help(0.35, 2.0, std::numbers::sqrt2), std::string("Of the drill (0.35 to 2, default 1.41)"));
    QCOMPARE(help(0.0, 1e6, 1e5 / 3.0), std::string("Of the drill (0 to 1000000, default 33300)"));
    QCOMPARE(help(0.0, 1.0, 1e-5), std::string("Of the drill (0 to 1, default 0.00001)"));
    QCOMPARE(help(-1000.0, 0.0, -2.0 / 3.0), std::string("Of the drill (-1000 to 0, default -0.667)"));
    QCOMPARE(help(kRadiansPerDegree, std::numbers::pi, 0.35, Quantity::Angle),
             std::string("Of the drill (1 to 180, default 20.1)"));
    parameter.isWhole = true;
    QCOMPARE(help(1.0, 123456.0, 98765.0), std::string("Of the drill (1 to 123456, default 98765)"));
  }
};

HANDWHEEL_TEST(OperationTest)
#include "OperationTest.moc"
