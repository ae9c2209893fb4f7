// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>  // before <numbers> of Units.h, which moc cannot read alone

#include "TestClass.h"
#include "window/haptics/TouchSettings.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>
#include <limits>

using namespace handwheel;

namespace {

// A value that the property may take and has not.
PropertyValue another(const Property& property) {
  if (const bool* isOn = std::get_if<bool>(&property.value)) return !*isOn;
  if (property.choices.empty()) return 0.5 * property.largest;
  return static_cast<double>(property.choices.size()) - 1.0 - std::get<double>(property.value);
}

}  // namespace

// The haptic properties of surfaces: kept in the settings, and edited by properties.
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
    QVERIFY(loadTouch() == TouchSettings());
    TouchSettings touch{TouchSettings().stiffness, 0.002, 0.7};  // kept elsewhere
    touch.isSnapping = false;
    touch.snapShape = SnapShape::Gaussian;
    touch.snapMethod = SnapMethod::Sum;
    touch.snapStiffness = 0.75;
    touch.hasBoundaryCurves = true;
    storeTouch(touch);
    QVERIFY(loadTouch() == touch);
  }

  // A file that somebody has written by hand must not push: what makes no sense is not taken, the rest is.
  void whatMakesNoSenseIsNotTaken() {
    for (const char* text : {"nan", "inf", "-1", "1e300", "much", ""}) {
      QSettings().setValue("haptics/touch_damping", text);
      QSettings().setValue("haptics/touch_friction", 0.25);
      QCOMPARE(loadTouch().damping, TouchSettings().damping);
      QCOMPARE(loadTouch().friction, 0.25);
    }
    for (const char* key : {"snap_on", "snap_profile", "snap_method", "snap_stiffness", "snap_rims"})
      for (const char* text : {"nan", "-1", "17", "much", ""}) {
        QSettings().clear();
        QSettings().setValue(QStringLiteral("haptics/%1").arg(key), text);
        QVERIFY2(loadTouch() == TouchSettings(), key);
      }
  }

  // Each property sets what it shows, and nothing else.
  void asAForm() {
    for (const Property& property : propertiesOf({})) {
      TouchSettings touch;
      const PropertyValue value = another(property);
      handwheel::setProperty(touch, property.id, value);
      for (const Property& shown : propertiesOf(touch)) {
        if (shown.id == property.id) {
          QVERIFY(shown.value == value);
        } else {
          for (const Property& before : propertiesOf({}))
            if (before.id == shown.id) QVERIFY(before.value == shown.value);
        }
      }
      if (!property.choices.empty() || !std::holds_alternative<double>(property.value)) continue;
      handwheel::setProperty(touch, property.id, 1e9);
      for (const Property& shown : propertiesOf(touch))
        if (shown.id == property.id) QCOMPARE(std::get<double>(shown.value), property.largest);
    }
    TouchSettings touch;
    handwheel::setProperty(touch, "colour", 1.0);
    handwheel::setProperty(touch, "touch_stiffness", std::numeric_limits<double>::quiet_NaN());
    handwheel::setProperty(touch, "snap_profile", 4.0);
    handwheel::setProperty(touch, "snap_method", -1.0);
    handwheel::setProperty(touch, "snap_on", 0.0);
    QVERIFY(touch == TouchSettings());
  }
};

HANDWHEEL_TEST(TouchSettingsTest)
#include "TouchSettingsTest.moc"
