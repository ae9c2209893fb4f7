// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/tools/ToolPanel.h"

#include "WindowTestMain.h"

#include <QPushButton>

using namespace handwheel;
using namespace handwheel::test;

// While a tool goes on, no button of its panel moves under the pointer, and none becomes another.
class ToolPanelTest : public QObject {
  Q_OBJECT

 private:
  struct Fixture {
    Fixture() {
      panel.resize(300, 600);
      panel.show();
      if (!QTest::qWaitForWindowExposed(&panel)) qFatal("the panel does not appear");
      connect(&panel, &ToolPanel::triggered, [this](const std::string& action) { pressed << action; });
    }
    void show(const std::vector<ToolAction>& actions) {
      panel.setActions(actions, [](const ToolAction&) { return QString(); });
      QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
      QTest::qWait(20);  // for the layout
    }
    QPushButton* button(const char* id) {
      return panel.findChild<QPushButton*>(QStringLiteral("toolAction/") + QLatin1String(id));
    }
    // Top and height; the width is that of the panel.
    std::map<QString, std::pair<int, int>> rows() {
      std::map<QString, std::pair<int, int>> all;
      for (const QPushButton* each : panel.findChildren<QPushButton*>())
        if (each->isVisible()) all[each->objectName()] = {each->y(), each->height()};
      return all;
    }

    ToolPanel panel;
    QList<std::string> pressed;
  };

  static std::vector<ToolAction> actions(const char* onReturn, const char* onEscape) {
    return {{"commit", "Return", onReturn}, {"revert", "Esc", onEscape}, {"smooth", "S", "smooth the boundary"}};
  }

 private slots:
  // Return and Esc come to mean the same: the second button keeps its position and its title, and cannot be pressed.
  void anEffectThatTwoHave() {
    Fixture fixture;
    fixture.show(actions("apply the placement", "leave it unchanged"));
    const auto before = fixture.rows();
    QCOMPARE(before.size(), std::size_t(3));
    const QPushButton* smooth = fixture.button("smooth");
    fixture.show(actions("done", "done"));
    QVERIFY(fixture.rows() == before);
    QCOMPARE(fixture.button("smooth"), smooth);  // a press that has begun on it ends on it
    QCOMPARE(fixture.button("commit")->text(), QString("Done"));
    QCOMPARE(fixture.button("revert")->text(), QString("Leave it unchanged"));
    QVERIFY(fixture.button("commit")->isEnabled() && !fixture.button("revert")->isEnabled());
    fixture.show(actions("apply the placement", "leave it unchanged"));
    QVERIFY(fixture.rows() == before);
    QVERIFY(fixture.button("revert")->isEnabled());
    QTest::mouseClick(fixture.button("revert"), Qt::LeftButton);
    QCOMPARE(fixture.pressed, QList<std::string>{"revert"});
  }

  // An action that is not possible now shows the reason, at the same position.
  void whatIsNotPossible() {
    Fixture fixture;
    std::vector<ToolAction> all = actions("apply the placement", "leave it unchanged");
    fixture.show(all);
    const auto before = fixture.rows();
    all[2].enabled = false;
    all[2].reason = "choose a boundary";
    fixture.show(all);
    QVERIFY(fixture.rows() == before);
    QVERIFY(!fixture.button("smooth")->isEnabled());
    QCOMPARE(fixture.button("smooth")->toolTip(), QString("Not now: choose a boundary."));
  }

  // Settings come and go above the buttons.
  void settingsThatAppear() {
    Fixture fixture;
    fixture.show(actions("apply the placement", "leave it unchanged"));
    const auto before = fixture.rows();
    std::vector<Property> many;
    for (const char* id : {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l", "m",
                           "n", "o", "p", "q", "r", "s", "t", "u", "v", "w", "x", "y", "z"})
      many.push_back({.id = id, .group = {}, .label = id, .value = 1.0});
    for (const std::size_t count : {std::size_t(1), std::size_t(3), many.size(), std::size_t(0)}) {
      fixture.panel.settings().setProperties({many.begin(), many.begin() + static_cast<std::ptrdiff_t>(count)});
      QTest::qWait(20);
      QVERIFY(fixture.rows() == before);
    }
  }

  // An effect that another action has from the start gets no button; nor what has keys only.
  void eachEffectOnce() {
    Fixture fixture;
    std::vector<ToolAction> all = actions("done", "done");
    all.push_back({"next", "N", "next hole"});
    all.back().isKeyOnly = true;
    fixture.show(all);
    QVERIFY(fixture.button("commit") && fixture.button("smooth"));
    QVERIFY(!fixture.button("revert") && !fixture.button("next"));
  }
};

HANDWHEEL_WINDOW_TEST(ToolPanelTest)
#include "ToolPanelTest.moc"
