// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "viewport/camera/NavigationPreset.h"

#include <QtTest>

using namespace handwheel;

namespace {

constexpr auto L = Qt::LeftButton, M = Qt::MiddleButton, R = Qt::RightButton;
constexpr auto Plain = Qt::NoModifier, Shift = Qt::ShiftModifier, Ctrl = Qt::ControlModifier, Alt = Qt::AltModifier;

}  // namespace

// The bindings of each preset, from the documentation of the programs that it follows.
class NavigationPresetTest : public QObject {
  Q_OBJECT
 private slots:
  void gestures_data() {
    using enum NavigationGesture;
    using P = NavigationPreset;
    QTest::addColumn<P>("preset");
    QTest::addColumn<Qt::MouseButtons>("buttons");
    QTest::addColumn<Qt::KeyboardModifiers>("keys");
    QTest::addColumn<bool>("onBackground");
    QTest::addColumn<NavigationGesture>("expected");
    const auto row = [](const char* name, P p, Qt::MouseButtons b, Qt::KeyboardModifiers k, bool bg, auto g) {
      QTest::newRow(name) << p << b << k << bg << g;
    };
    row("handwheel middle", P::Handwheel, M, Plain, false, Orbit);
    row("handwheel shift middle", P::Handwheel, M, Shift, false, Pan);
    row("handwheel right", P::Handwheel, R, Plain, false, Pan);
    row("handwheel left on the model", P::Handwheel, L, Plain, false, None);
    row("handwheel left on the background", P::Handwheel, L, Plain, true, Orbit);
    row("handwheel shift left selects more", P::Handwheel, L, Shift, true, None);
    row("handwheel alt left", P::Handwheel, L, Alt, false, Orbit);
    row("keypad does not count", P::Handwheel, M, Shift | Qt::KeypadModifier, false, Pan);
    row("blender middle", P::Blender, M, Plain, true, Orbit);
    row("blender shift middle", P::Blender, M, Shift, false, Pan);
    row("blender ctrl middle", P::Blender, M, Ctrl, false, Zoom);
    row("blender left", P::Blender, L, Plain, true, None);
    row("freecad middle", P::FreeCad, M, Plain, false, Pan);
    row("freecad middle and left", P::FreeCad, M | L, Plain, false, Orbit);
    row("freecad middle and right", P::FreeCad, M | R, Plain, false, Orbit);
    row("freecad shift right", P::FreeCad, R, Shift, false, Orbit);
    row("freecad ctrl right", P::FreeCad, R, Ctrl, false, Pan);
    row("freecad ctrl shift right", P::FreeCad, R, Ctrl | Shift, false, Zoom);
    row("solidworks middle", P::SolidWorks, M, Plain, false, Orbit);
    row("solidworks ctrl middle", P::SolidWorks, M, Ctrl, false, Pan);
    row("solidworks shift middle", P::SolidWorks, M, Shift, false, Zoom);
    row("laptop right", P::Laptop, R, Plain, false, Orbit);
    row("laptop shift right", P::Laptop, R, Shift, false, Pan);
    row("laptop alt left", P::Laptop, L, Alt, false, Orbit);
    row("laptop alt shift left", P::Laptop, L, Alt | Shift, false, Pan);
    row("laptop middle", P::Laptop, M, Plain, false, None);
  }

  void gestures() {
    QFETCH(NavigationPreset, preset);
    QFETCH(Qt::MouseButtons, buttons);
    QFETCH(Qt::KeyboardModifiers, keys);
    QFETCH(bool, onBackground);
    QTEST(gestureFor(preset, buttons, keys, onBackground), "expected");
  }

  // Every preset has bindings to orbit and pan, and a plain click or drag on the model belongs to the tools.
  void everyPresetIsComplete() {
    for (const NavigationPreset preset : kNavigationPresets) {
      bool orbits = false, pans = false;
      for (const NavigationBinding& b : bindingsOf(preset)) {
        orbits |= b.gesture == NavigationGesture::Orbit && !b.onBackground;
        pans |= b.gesture == NavigationGesture::Pan && !b.onBackground;
        // No second binding for the same input.
        QCOMPARE(gestureFor(preset, b.buttons, b.modifiers, true), b.gesture);
      }
      QVERIFY(orbits && pans);
      QCOMPARE(gestureFor(preset, L, Plain, false), NavigationGesture::None);
      QCOMPARE(presetOf(idOf(preset)), preset);
      QVERIFY(!nameOf(preset).isEmpty());
    }
    QCOMPARE(presetOf("no such preset"), NavigationPreset::Handwheel);
    QVERIFY(!wheelAwayEnlarges(NavigationPreset::SolidWorks));
    QVERIFY(wheelAwayEnlarges(NavigationPreset::Handwheel));
  }

  void hintsNameTheFirstBindings() {
    using Hints = std::vector<std::pair<QString, QString>>;
    QCOMPARE(navigationHints(NavigationPreset::Handwheel),
             (Hints{{"Middle", "orbit"}, {"Shift+middle", "pan"}, {"Wheel", "zoom"}}));
    QCOMPARE(navigationHints(NavigationPreset::FreeCad),
             (Hints{{"Left+middle", "orbit"}, {"Middle", "pan"}, {"Wheel", "zoom"}}));
    QCOMPARE(navigationHints(NavigationPreset::Laptop),
             (Hints{{"Right", "orbit"}, {"Shift+right", "pan"}, {"Wheel", "zoom"}}));
  }
};

HANDWHEEL_TEST(NavigationPresetTest)
#include "NavigationPresetTest.moc"
