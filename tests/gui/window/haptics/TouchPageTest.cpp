// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/haptics/TouchPage.h"

#include "OwnSettings.h"
#include "TestClass.h"
#include "window/WindowServices.h"
#include "window/haptics/HapticSession.h"

#include <QComboBox>
#include <QLineEdit>
#include <QSettings>
#include <QThreadPool>
#include <QtTest>

using namespace handwheel;

namespace {

struct TouchPageFixture {
  QThreadPool pool;
  JobRunner jobs{JobRunner::Policy::Queue, pool};
  WindowServices services;
  MonotonicClock clock;
  HapticSession session{HapticSession::Parts{jobs, pool, services, clock}};
  TouchPage page{session};

  QWidget* row(const char* id) { return page.findChild<QWidget*>(QStringLiteral("property/%1").arg(id)); }
  QAction* command() { return page.findChild<QAction*>("snapDevice"); }
  void choose(const char* id, int index) {
    auto* list = row(id)->findChild<QComboBox*>();
    list->setCurrentIndex(index);
    emit list->activated(index);
  }
  void type(const char* id, const char* value) {
    auto* line = row(id)->findChild<QLineEdit*>();
    line->selectAll();
    QTest::keyClicks(line, value);
    QTest::keyClick(line, Qt::Key_Return);
  }
};

}  // namespace

// The haptic properties of surfaces, in the panel of the device; no device is open.
class TouchPageTest : public QObject {
  Q_OBJECT

 private:
  test::OwnSettings m_settings;

 private slots:
  void initTestCase() { m_settings.use(); }
  void init() { QSettings().clear(); }

  // The command switches what the page shows, and the next start begins with it.
  void theCommandSwitchesSnapping() {
    {
      TouchPageFixture fixture;
      QVERIFY(fixture.command()->isCheckable() && fixture.command()->isChecked());
      QVERIFY(!fixture.command()->shortcut().isEmpty());
      fixture.command()->trigger();
      QVERIFY(!fixture.session.touch().isSnapping);
      QVERIFY(!fixture.command()->isChecked());
    }
    TouchPageFixture again;
    QVERIFY(!again.session.touch().isSnapping && !again.command()->isChecked());
    again.command()->trigger();
    QVERIFY(again.session.touch().isSnapping);
  }

  void whatIsChosenIsFeltAndKept() {
    {
      TouchPageFixture fixture;
      fixture.choose("snap_profile", 3);
      fixture.choose("snap_method", 1);
      fixture.type("snap_stiffness", "0.8");
      QVERIFY(fixture.session.touch().snapShape == SnapShape::Gaussian);
    }
    TouchPageFixture again;
    QVERIFY(again.session.touch().snapShape == SnapShape::Gaussian);
    QVERIFY(again.session.touch().snapMethod == SnapMethod::Sum);
    QCOMPARE(again.session.touch().snapStiffness, 0.8);
  }

  void tooMuchIsNotTaken() {
    TouchPageFixture fixture;
    fixture.type("snap_stiffness", "1000");
    QCOMPARE(fixture.session.touch().snapStiffness, TouchSettings().snapStiffness);
  }
};

HANDWHEEL_WIDGET_TEST(TouchPageTest)
#include "TouchPageTest.moc"
