// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>  // before <numbers> of Units.h, which moc cannot read alone

#include "window/haptics/TouchSettings.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>
#include <limits>

using namespace handwheel;

// How what is touched feels: kept in the settings, and edited by properties.
class TouchSettingsTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir m_settings;

 private slots:
  void initTestCase() {
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, m_settings.path());
    QCoreApplication::setOrganizationName(QStringLiteral("Handwheel"));
    QCoreApplication::setApplicationName(QStringLiteral("HandwheelTest"));
  }
  void init() { QSettings().clear(); }

  void isRemembered() {
    QVERIFY(keptTouch() == TouchSettings());
    const TouchSettings touch{TouchSettings().stiffness, 0.002, 0.7};  // which is kept elsewhere
    keepTouch(touch);
    QVERIFY(keptTouch() == touch);
  }

  // A file that somebody has written by hand must not push: what makes no sense is not taken, the rest is.
  void whatMakesNoSenseIsNotTaken() {
    for (const char* text : {"nan", "inf", "-1", "1e300", "much", ""}) {
      QSettings().setValue("haptics/touch_damping", text);
      QSettings().setValue("haptics/touch_friction", 0.25);
      QCOMPARE(keptTouch().damping, TouchSettings().damping);
      QCOMPARE(keptTouch().friction, 0.25);
    }
  }

  // Each property sets what it shows, and nothing else.
  void asAForm() {
    for (const Property& property : propertiesOf({})) {
      TouchSettings touch;
      const double value = 0.5 * property.largest;
      handwheel::setProperty(touch, property.id, value);
      for (const Property& shown : propertiesOf(touch)) {
        if (shown.id == property.id) {
          QCOMPARE(std::get<double>(shown.value), value);
        } else {
          for (const Property& before : propertiesOf({}))
            if (before.id == shown.id) QVERIFY(before.value == shown.value);
        }
      }
      handwheel::setProperty(touch, property.id, 1e9);
      for (const Property& shown : propertiesOf(touch))
        if (shown.id == property.id) QCOMPARE(std::get<double>(shown.value), property.largest);
    }
    TouchSettings touch;
    handwheel::setProperty(touch, "colour", 1.0);
    handwheel::setProperty(touch, "touch_stiffness", std::numeric_limits<double>::quiet_NaN());
    QVERIFY(touch == TouchSettings());
  }
};

QTEST_GUILESS_MAIN(TouchSettingsTest)
#include "TouchSettingsTest.moc"
