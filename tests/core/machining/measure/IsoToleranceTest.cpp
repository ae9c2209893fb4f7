// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/measure/IsoTolerance.h"

#include "TestClass.h"
#include "machining/measure/RoughnessGrade.h"

#include <QtTest>
#include <cmath>
#include <limits>

using namespace handwheel;

// The tables of ISO 286 against limits as handbooks print them.
class IsoToleranceTest : public QObject {
  Q_OBJECT

 private slots:
  void classes_data() {
    QTest::addColumn<double>("nominal");
    QTest::addColumn<QByteArray>("code");
    QTest::addColumn<int>("lower");  // micrometres
    QTest::addColumn<int>("upper");
    const auto row = [](double nominal, const char* code, int lower, int upper) {
      QTest::addRow("%g%s", nominal, code) << nominal << QByteArray(code) << lower << upper;
    };
    row(20, "h10", -84, 0);
    row(20, "H7", 0, 21);
    row(25, "f7", -41, -20);
    row(50, "g6", -25, -9);
    row(10, "g6", -14, -5);
    row(40, "k6", 2, 18);
    row(3, "k6", 0, 6);
    row(40, "k8", 0, 39);
    row(30, "js6", -6, 6);  // ± 6.5, compared below
    row(35, "p6", 26, 42);
    row(60, "n6", 20, 39);
    row(16, "m6", 7, 18);
    row(25, "H11", 0, 130);
    row(25, "F8", 20, 53);
    row(18, "h5", -8, 0);
    row(18.001, "h5", -9, 0);
    row(120, "h12", -350, 0);
    row(25, "IT10", -42, 42);  // 84 µm wide: half on both sides
    row(25, "js10", -42, 42);
    row(12, "d9", -93, -50);
    row(12, "E9", 32, 75);
  }
  void classes() {
    QFETCH(double, nominal);
    QFETCH(QByteArray, code);
    QFETCH(int, lower);
    QFETCH(int, upper);
    const auto found = isoDeviations(nominal, code.toStdString());
    QVERIFY(found.has_value());
    const double slack = code == "js6" ? 0.5001e-3 : 1e-12;
    QVERIFY(std::abs(found->lower - 1e-3 * lower) < slack);
    QVERIFY(std::abs(found->upper - 1e-3 * upper) < slack);
  }

  void whatNoTableHas() {
    for (const char* code :
         {"", "h", "10", "h4", "h13", "h100", "H-7", "hH7", "Js7", "K7", "P7", "z6", "hhh7", "h7 ", "ab7"})
      QVERIFY2(!isoDeviations(20.0, code), code);
    for (const double nominal : {0.0, -1.0, 120.1, 1e300, std::nan(""), std::numeric_limits<double>::infinity()}) {
      QVERIFY(!isoDeviations(nominal, "h7"));
      QVERIFY(!standardTolerance(nominal, 7));
    }
  }

  // The grades from 6 on follow 10^(1/5) for each step, and each size step is wider than the one below.
  void gradesGrow() {
    for (int grade = 5; grade <= 12; ++grade) {
      double before = 0.0;
      for (const double size : {2.0, 5.0, 8.0, 15.0, 25.0, 40.0, 70.0, 100.0}) {
        const double width = standardTolerance(size, grade).value();
        QVERIFY(width > before);
        before = width;
        if (grade >= 7) QVERIFY(std::abs(width / standardTolerance(size, grade - 1).value() - 1.585) < 0.23);
      }
    }
  }

  void roughness() {
    QCOMPARE(roughnessOf("N7").value(), 1.6);
    QCOMPARE(roughnessOf("N1").value(), 0.025);
    QCOMPARE(roughnessOf("N12").value(), 50.0);
    for (const char* text : {"", "N", "N0", "N13", "n7", "N7 ", "7", "N007"}) QVERIFY2(!roughnessOf(text), text);
    QCOMPARE(roughnessGrade(1.3), std::string("N7"));
    QCOMPARE(roughnessGrade(1.6), std::string("N7"));
    QCOMPARE(roughnessGrade(0.0), std::string("N1"));
    QCOMPARE(roughnessGrade(51.0), std::string());
    QCOMPARE(roughnessGrade(std::nan("")), std::string());
    // The published figures of theory for a nose of 0.8 mm.
    QVERIFY(std::abs(idealRoughness(0.09, 0.8) - 0.316) < 5e-4);
    QVERIFY(std::abs(idealRoughness(0.11, 0.8) - 0.473) < 5e-4);
    QCOMPARE(idealRoughness(0.0, 0.0), 0.0);
    QVERIFY(std::isinf(idealRoughness(0.1, 0.0)));
  }
};

HANDWHEEL_TEST(IsoToleranceTest)
#include "IsoToleranceTest.moc"
