// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/TurningFidelity.h"

#include "TestClass.h"
#include "machining/TurningPass.h"
#include "machining/force/ForceFidelity.h"

#include <QtTest>

using namespace handwheel;

// The settings of turning. Their values are checked against what they are used for.
class TurningFidelityTest : public QObject {
  Q_OBJECT

 private slots:
  void defaultsAndPresetsArePossible() {
    for (const FidelitySetting& setting :
         {turnSpacingSetting(), turnMethodSetting(), turnResolutionSetting(), turnStepSetting(), forceModelSetting()}) {
      QVERIFY2(checkValue(setting, setting.standard), setting.id.c_str());
      for (const double preset : setting.presets) QVERIFY2(checkValue(setting, preset), setting.id.c_str());
      QVERIFY2(setting.id.starts_with("turn.") && !setting.label.empty(), setting.id.c_str());
      QVERIFY2(!setting.error.unit.empty() && !setting.cost.unit.empty(), setting.id.c_str());
    }
  }

  // The words are in the order of the values in the code.
  void choicesHaveTheOrderOfTheirValues() {
    const FidelitySetting method = turnMethodSetting(), law = forceModelSetting();
    QCOMPARE(textOf(method, static_cast<double>(TurningMethod::Trim)), std::string("trim"));
    QCOMPARE(textOf(method, static_cast<double>(TurningMethod::Poles)), std::string("poles"));
    QCOMPARE(textOf(law, static_cast<double>(ForceLaw::Kosilova)), std::string("kosilova"));
    QCOMPARE(textOf(law, static_cast<double>(ForceLaw::Kienzle)), std::string("kienzle"));
    QCOMPARE(textOf(law, static_cast<double>(ForceLaw::Network)), std::string("network"));
    QCOMPARE(FidelityValues().of(law), static_cast<double>(ForceLaw::Kienzle));  // which every material has
  }

  // No preset is coarser than one that is said to be less exact.
  void presetsBecomeFiner() {
    for (const FidelitySetting& setting : {turnSpacingSetting(), turnResolutionSetting(), turnStepSetting()}) {
      QVERIFY(setting.presetValue(FidelityPreset::Draft) >= setting.presetValue(FidelityPreset::Balanced));
      QVERIFY(setting.presetValue(FidelityPreset::Balanced) >= setting.presetValue(FidelityPreset::Exact));
    }
  }
};

HANDWHEEL_TEST(TurningFidelityTest)
#include "TurningFidelityTest.moc"
