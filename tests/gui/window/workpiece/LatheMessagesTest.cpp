// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "../haptics/TurningWindow.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "tools/workpiece/ManualLatheTool.h"
#include "window/tools/ToolHost.h"

#include <QDockWidget>
#include <QLabel>
#include <QListWidget>
#include <QRegularExpression>
#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

// The messages of the lathe, in a window of 1280 × 800.
class LatheMessagesTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  // The edge is pushed into the bar, which does not turn: the crash is read whole, without scrolling sideways.
  void theLatestIsSeen() {
    TurningWindow window;
    window.driver.choose("newWorkpiece");
    QVERIFY(window.driver.settle());
    window.driver.find<QAction>("latheTool")->trigger();
    QVERIFY(window.driver.settle());
    window.view->setFocus();
    QVERIFY(window.rests());
    auto& runner = window.driver.window().findChild<ToolHost*>()->runner();
    const auto* const lathe = dynamic_cast<const ManualLatheTool*>(runner.tool());
    QVERIFY(lathe);
    auto* const latest = window.driver.find<QLabel>("latheLatest");
    auto* const all = window.driver.find<QListWidget>("latheCrashes");
    QVERIFY(latest->isVisible() && latest->text().isEmpty());
    // 2 mm each along the bed, 0.2 mm each across it.
    for (int i = 0; i < 30; ++i) QTest::keyClick(window.view, Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(QTest::qWaitFor([&] { return lathe->moment()->tip.y() < 60.5; }, kPatienceMs));
    for (int i = 0; i < 110; ++i) QTest::keyClick(window.view, Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY(QTest::qWaitFor([&] { return !lathe->collisions().empty(); }, kPatienceMs));
    QTRY_VERIFY(all->count() > 0);
    QTRY_COMPARE(latest->text(), all->item(all->count() - 1)->text());
    const QRect seen = latest->visibleRegion().boundingRect();
    QVERIFY2(seen.left() == 0 && seen.width() >= latest->fontMetrics().horizontalAdvance(latest->text()),
             qPrintable(QString("%1 of %2: %3").arg(seen.width()).arg(latest->width()).arg(latest->text())));
  }

  // A bar of 100 mm is parted off at Z 70, and behind that at Z 30: each time the piece that comes off is reported.
  void whatComesOffIsReported() {
    TurningWindow window;
    window.driver.choose("newWorkpiece");
    QVERIFY(window.driver.settle());
    const auto partOff = [&](double z) {
      TurningPass pass;
      pass.noseRadius = 1.0;
      pass.path = {{0.0, z}};
      pass.times = {0.0};
      const auto part = withPass(window.document().workpiece(), pass, 0.1);
      window.document().commit("Part off", std::make_unique<TurnedPartEdit>(part));
      return window.driver.settle();
    };
    QVERIFY(partOff(70.0));
    QTRY_VERIFY(window.driver.text("messageText").contains("has come off at the free end"));
    QVERIFY(!window.driver.text("messageText").contains("came off before"));
    QVERIFY(partOff(30.0));
    QTRY_VERIFY(window.driver.text("messageText").contains("came off before"));
    const QString text = window.driver.text("messageText");
    const QRegularExpressionMatch length = QRegularExpression("A piece of ([0-9.]+) mm").match(text);
    QVERIFY2(std::abs(length.captured(1).toDouble() - 38.0) < 0.21, qPrintable(text));  // from Z 31 to Z 69
    // Undone, the piece is back: nothing says any more that it came off.
    window.document().history()->undo();
    QVERIFY(window.driver.settle());
    QTRY_VERIFY(!window.driver.find<QWidget>("messageBar")->isVisible());
  }
};

HANDWHEEL_WINDOW_TEST(LatheMessagesTest)
#include "LatheMessagesTest.moc"
