// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/TurningFidelity.h"

#include "TestClass.h"
#include "machining/TurningPass.h"
#include "machining/force/ForceFidelity.h"

#include <QtTest>

using namespace handwheel;

// The settings of turning. Their values are checked against their uses.
class TurningFidelityTest : public QObject {
  Q_OBJECT

 private slots:
  // The words are in the order of the values in the code.
  void choicesHaveTheOrderOfTheirValues() {
    const FidelitySetting method = turnMethodSetting(), law = forceModelSetting();
    QCOMPARE(textOf(method, static_cast<double>(TurningMethod::Trim)), std::string("trim"));
    QCOMPARE(textOf(method, static_cast<double>(TurningMethod::Poles)), std::string("poles"));
    QCOMPARE(textOf(law, static_cast<double>(ForceLaw::Kosilova)), std::string("kosilova"));
    QCOMPARE(textOf(law, static_cast<double>(ForceLaw::Kienzle)), std::string("kienzle"));
    QCOMPARE(textOf(law, static_cast<double>(ForceLaw::Network)), std::string("network"));
    QCOMPARE(FidelityValues().of(law), static_cast<double>(ForceLaw::Kienzle));  // every material has it
  }
};

HANDWHEEL_TEST(TurningFidelityTest)
#include "TurningFidelityTest.moc"
