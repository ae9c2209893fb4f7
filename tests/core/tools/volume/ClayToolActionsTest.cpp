// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ClayFixture.h"
#include "TestClass.h"

#include <algorithm>

using namespace handwheel;
using namespace handwheel::test;

namespace {

const Property* claySetting(const std::vector<Property>& settings, std::string_view id) {
  const auto found = std::find_if(settings.begin(), settings.end(), [&](const Property& p) { return p.id == id; });
  return found == settings.end() ? nullptr : &*found;
}

double clayNumberOf(const ClayFixture& fixture, std::string_view id) {
  const std::vector<Property> settings = fixture.tool->settings();
  const Property* const setting = claySetting(settings, id);
  return setting ? std::get<double>(setting->value) : -1.0;
}

}  // namespace

// The keys of the clay tool and the settings that it offers for each of its actions.
class ClayToolActionsTest : public QObject {
  Q_OBJECT

 private slots:
  void keysChooseWhatIsDone() {
    ClayFixture fixture;
    for (const auto& [key, action] : {std::pair("add", ClayAction::Add), std::pair("carve", ClayAction::Carve),
                                      std::pair("smooth", ClayAction::Smooth), std::pair("move", ClayAction::Move),
                                      std::pair("mask", ClayAction::Mask)}) {
      QCOMPARE(fixture.runner.perform(key), ToolReply::Used);
      QCOMPARE(clayNumberOf(fixture, "action"), static_cast<double>(action));
    }
    QCOMPARE(fixture.runner.perform("juggle"), ToolReply::Ignored);
    QCOMPARE(fixture.runner.perform("loadStamp"), ToolReply::Ignored);  // nothing can be loaded here
    QCOMPARE(fixture.runner.perform("revert"), ToolReply::Ignored);     // there is no stroke
    QCOMPARE(fixture.steps(), 0);
  }

  // By a quarter more and back, within a voxel and a half and 500 voxels of 0.2 mm.
  void keysChangeTheRadius() {
    ClayFixture fixture;
    fixture.set("radius", PropertyValue(4.0));
    fixture.runner.perform("larger");
    QCOMPARE(clayNumberOf(fixture, "radius"), 5.0);
    fixture.runner.perform("smaller");
    fixture.runner.perform("smaller");
    QCOMPARE(clayNumberOf(fixture, "radius"), 3.2);
    for (int i = 0; i < 40; ++i) fixture.runner.perform("smaller");
    QCOMPARE(clayNumberOf(fixture, "radius"), 1.5 * 0.2);
    for (int i = 0; i < 60; ++i) fixture.runner.perform("larger");
    QCOMPARE(clayNumberOf(fixture, "radius"), 500.0 * 0.2);
  }

  // Each action has the settings that it goes by: a ball has no falloff, what moves and masks no strength, and only
  // what is added or carved has a stamp, which can be turned.
  void settingsOfAnAction() {
    ClayFixture fixture;
    const auto offers = [&](ClayAction action, const char* id) {
      fixture.choose(action);
      return claySetting(fixture.tool->settings(), id) != nullptr;
    };
    for (int i = 0; i <= static_cast<int>(ClayAction::Mask); ++i) {
      const auto action = static_cast<ClayAction>(i);
      const bool isShape = action == ClayAction::Add || action == ClayAction::Carve;
      QCOMPARE(offers(action, "strength"), action != ClayAction::Move && action != ClayAction::Mask);
      QCOMPARE(offers(action, "falloff"), !isShape);
      QCOMPARE(offers(action, "stamp"), isShape);
      QVERIFY(!offers(action, "turn"));
    }
    QVERIFY(offers(ClayAction::Carve, "strength"));
    QCOMPARE(claySetting(fixture.tool->settings(), "strength")->label, std::string("Depth (mouse)"));
    fixture.set("stamp", PropertyValue(1.0));
    QCOMPARE(claySetting(fixture.tool->settings(), "strength")->label, std::string("Strength"));
    fixture.set("turn", PropertyValue(9.0));
    QCOMPARE(clayNumberOf(fixture, "turn"), M_PI);  // half a turn at most
    fixture.choose(ClayAction::Inflate);
    QCOMPARE(claySetting(fixture.tool->settings(), "strength")->label, std::string("Strength"));
  }

  // Invalid values of a setting change nothing; values beyond the limits become the limit.
  void valuesOfSettings() {
    ClayFixture fixture;
    fixture.choose(ClayAction::Smooth);
    fixture.set("action", PropertyValue(10.0));
    fixture.set("action", PropertyValue(std::string("carve")));
    QCOMPARE(clayNumberOf(fixture, "action"), static_cast<double>(ClayAction::Smooth));
    fixture.set("falloff", PropertyValue(-1.0));
    QCOMPARE(clayNumberOf(fixture, "falloff"), 0.0);
    fixture.set("strength", PropertyValue(0.0));
    QCOMPARE(clayNumberOf(fixture, "strength"), 0.01);
    fixture.set("pressure", PropertyValue(3.0));
    QCOMPARE(clayNumberOf(fixture, "pressure"), 3.0);
    fixture.set("resistance", PropertyValue(99.0));
    QCOMPARE(clayNumberOf(fixture, "resistance"), 10.0);
    QCOMPARE(fixture.tool->feelAtDevice().resistance, 10.0);
  }

  // The history says what each stroke did, and how much of the ball it took or gave.
  void strokesInTheHistory_data() {
    QTest::addColumn<int>("action");
    QTest::addColumn<QString>("text");
    const auto row = [](ClayAction action, const char* text) {
      QTest::newRow(text) << static_cast<int>(action) << QString(text);
    };
    row(ClayAction::Add, "Add clay: +");
    row(ClayAction::Inflate, "Inflate clay: +");
    row(ClayAction::Flatten, "Flatten clay: −");
    row(ClayAction::Move, "Move clay: ");
    row(ClayAction::Smudge, "Smudge clay: ");
    row(ClayAction::Attract, "Attract clay: ");
    row(ClayAction::Pinch, "Pinch clay: ");
  }
  void strokesInTheHistory() {
    QFETCH(int, action);
    QFETCH(QString, text);
    ClayFixture fixture;
    fixture.choose(static_cast<ClayAction>(action));
    fixture.set("radius", PropertyValue(5.0));
    fixture.set("strength", PropertyValue(1.0));
    const double before = fixture.document.volume()->volume.enclosed();
    fixture.stroke(4.0, 8.0);
    QCOMPARE(fixture.steps(), 1);
    const QString reported = fixture.document.history()->undoText();
    QVERIFY2(reported.startsWith(text) && reported.endsWith(QStringLiteral(" mm³")), qPrintable(reported));
    const double change = fixture.document.volume()->volume.enclosed() - before;
    QString amount = reported.section(QStringLiteral(": "), 1).section(QLatin1Char(' '), 0, 0);
    const bool isLess = amount.startsWith(QStringLiteral("−"));
    const double shown = QLocale().toDouble(amount.mid(1)) * (isLess ? -1.0 : 1.0);
    QVERIFY2(std::abs(shown - change) <= 5e-3 * std::abs(change), qPrintable(reported));  // three digits
  }

  // The circle of the brush is where the mouse is over the clay, and goes with it.
  void theBrushIsShown() {
    ClayFixture fixture;
    fixture.set("radius", PropertyValue(3.0));
    fixture.event(PointerEvent::Kind::Hover, 12.0, 0.0);
    const auto circle = fixture.tool->preview().circle;
    QVERIFY(circle && circle->second == 3.0);
    QVERIFY((circle->first - Vec3(12.0, 0.0, 16.0)).norm() < 0.05);  // on the ball of 20 mm
    QCOMPARE(fixture.event(PointerEvent::Kind::Leave, 12.0, 0.0), ToolReply::Used);
    QVERIFY(!fixture.tool->preview().circle);
    fixture.event(PointerEvent::Kind::Hover, 25.0, 0.0);
    QVERIFY(!fixture.tool->preview().circle);
  }

  // In the middle of a stroke only discarding it is offered.
  void actionsOfAStroke() {
    ClayFixture fixture;
    const auto enabled = [&](const char* key) {
      const std::vector<ToolAction> actions = fixture.tool->actions();
      const auto found = std::find_if(actions.begin(), actions.end(),
                                      [&](const ToolAction& a) { return a.id == std::string_view(key); });
      return found != actions.end() && found->enabled;
    };
    for (const bool isStroke : {false, true}) {
      if (isStroke) fixture.event(PointerEvent::Kind::Press, 0.0, 0.0);
      for (const char* const key : {"smaller", "larger", "add", "carve", "smooth", "move", "mask", "invertMask"})
        QCOMPARE(enabled(key), !isStroke);
      QCOMPARE(enabled("revert"), isStroke);
      QVERIFY(!enabled("clearMask") && !enabled("loadStamp"));
    }
  }

  // The force depends on the action: the device cuts when it carves, moves freely when it adds and moves, and otherwise
  // rests on the surface.
  void feltAtADevice() {
    ClayFixture fixture;
    for (int i = 0; i <= static_cast<int>(ClayAction::Mask); ++i) {
      const auto action = static_cast<ClayAction>(i);
      fixture.choose(action);
      QCOMPARE(fixture.tool->feelAtDevice().isCutting, action == ClayAction::Carve);
      QCOMPARE(fixture.tool->feelAtDevice().isFree, action == ClayAction::Add || action == ClayAction::Move);
    }
  }
};

HANDWHEEL_TEST(ClayToolActionsTest)
#include "ClayToolActionsTest.moc"
