// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/Preferences.h"

#include "ControlScenes.h"
#include "ControlsTestMain.h"

#include <QCheckBox>
#include <QComboBox>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

class PreferencesTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }
  void storedAndLoaded();
  void nonsenseCountsAsNotSet();
  void dialogAppliesAtOnce();
};

void PreferencesTest::storedAndLoaded() {
  QVERIFY(loadPreferences() == Preferences());
  for (LengthUnit unit : {LengthUnit::Millimetre, LengthUnit::Centimetre, LengthUnit::Metre, LengthUnit::Inch}) {
    for (int seconds : {0, 5, 77, 600}) {
      const Preferences preferences{
          "blender", unit, "de", seconds, seconds > 0, 100 + seconds / 2, seconds % 2 != 0, 5 + seconds / 10};
      storePreferences(preferences);
      QVERIFY(loadPreferences() == preferences);
    }
  }
}

void PreferencesTest::nonsenseCountsAsNotSet() {
  QSettings settings;
  settings.setValue("lengthUnit", "furlong");
  settings.setValue("autosaveSeconds", "often");
  QVERIFY(loadPreferences() == Preferences());
  settings.setValue("autosaveSeconds", -7);
  QCOMPARE(loadPreferences().autosaveSeconds, Preferences().autosaveSeconds);
  settings.setValue("autosaveSeconds", 1);
  QCOMPARE(loadPreferences().autosaveSeconds, kShortestAutosave);
  settings.setValue("autosaveSeconds", 100000);
  QCOMPARE(loadPreferences().autosaveSeconds, kLongestAutosave);
  settings.setValue("view/space_mouse_speed", 0);
  QCOMPARE(loadPreferences().spaceMouseSpeed, kLeastSpaceMouseSpeed);
  settings.setValue("sound/machine_volume", 0);
  QCOMPARE(loadPreferences().machineVolume, kLeastMachineVolume);
  settings.setValue("view/space_mouse_speed", "fast");
  QCOMPARE(loadPreferences().spaceMouseSpeed, 100);
}

void PreferencesTest::dialogAppliesAtOnce() {
  ShortcutModel keys;
  PreferencesDialog dialog(&keys, sampleNavigation());
  QVERIFY(!dialog.isModal());
  Preferences said;
  connect(&dialog, &PreferencesDialog::changed, this, [&said](const Preferences& p) { said = p; });
  dialog.show();
  auto* pages = dialog.findChild<QListWidget*>("preferencePages");
  const auto chooseLast = [&](int page, const char* name) {
    pages->setCurrentRow(page);
    auto* box = dialog.findChild<QComboBox*>(name);
    box->setFocus();
    QTest::keyClick(box, Qt::Key_End);
  };
  chooseLast(1, "navigationChoice");
  chooseLast(2, "lengthUnitChoice");
  chooseLast(3, "languageChoice");
  pages->setCurrentRow(4);
  auto* seconds = dialog.findChild<QSpinBox*>("autosaveSeconds");
  seconds->setValue(120);
  const Preferences expected{"blender", LengthUnit::Inch, "zh_CN", 120};
  QVERIFY(said == expected);
  QVERIFY(loadPreferences() == expected);
  QTest::mouseClick(dialog.findChild<QCheckBox*>("autosaveOn"), Qt::LeftButton, {}, QPoint(8, 8));
  QCOMPARE(loadPreferences().autosaveSeconds, 0);
  QVERIFY(!seconds->isEnabled());
  pages->setCurrentRow(1);
  auto* speed = dialog.findChild<QSpinBox*>("spaceMouseSpeed");
  speed->setValue(250);
  QCOMPARE(said.spaceMouseSpeed, 250);
  dialog.findChild<QCheckBox*>("spaceMouseOn")->click();
  QVERIFY(!said.hasSpaceMouse && !speed->isEnabled());
  pages->setCurrentRow(5);
  auto* volume = dialog.findChild<QSpinBox*>("machineVolume");
  QVERIFY(!said.hasMachineSound && !volume->isEnabled());
  dialog.findChild<QCheckBox*>("machineSoundOn")->click();
  volume->setValue(40);
  QVERIFY(said.hasMachineSound && volume->isEnabled());
  QCOMPARE(loadPreferences().machineVolume, 40);
  // A second dialog shows what the first has stored.
  PreferencesDialog again(&keys, sampleNavigation());
  QCOMPARE(again.findChild<QComboBox*>("lengthUnitChoice")->currentIndex(), 3);
  QCOMPARE(again.findChild<QComboBox*>("navigationChoice")->currentText(), QString("Blender"));
  QVERIFY(!again.findChild<QCheckBox*>("autosaveOn")->isChecked());
}

HANDWHEEL_CONTROLS_TEST(PreferencesTest)
#include "PreferencesTest.moc"
