// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "CellWindow.h"

#include <QTreeWidget>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A window with the sample cell and the tool that leads the robot by hand.
class HandGuidingWindow : public WindowDriver {
 public:
  HandGuidingWindow() {
    choose("openCellSample");
    if (!settle()) qFatal("the sample does not open");
    choose("leadTool");
    if (!settle()) qFatal("the tool does not come");
  }
  Viewport* view() { return find<Viewport>("viewport"); }
  QTreeWidgetItem* paths() { return find<QTreeWidget>("planTree")->topLevelItem(1); }
  QString joint(int number) {
    return find<QWidget>(QStringLiteral("property/joint.joint_%1").arg(number).toUtf8().constData())
        ->findChild<QLineEdit*>()
        ->text();
  }
  QStringList joints() {
    QStringList all;
    for (int i = 1; i <= 6; ++i) all << joint(i);
    return all;
  }
  // With the left button, in steps as a hand makes them.
  void drag(const QPoint& by) {
    const QPoint from = view()->rect().center();
    QTest::mousePress(view(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 10; ++i) {
      const QPoint to = from + by * i / 10;
      QMouseEvent moved(QEvent::MouseMove, to, view()->mapToGlobal(to), Qt::NoButton, Qt::LeftButton, {});
      QApplication::sendEvent(view(), &moved);
      QTest::qWait(5);
    }
    QTest::mouseRelease(view(), Qt::LeftButton, {}, from + by);
  }
};

}  // namespace

// A person leads the robot of the sample cell with the mouse.
class HandGuidingWindowTest : public QObject {
  Q_OBJECT

 private slots:
  // A drag is one undo step, and Space makes a waypoint of the present configuration: the first begins a path.
  void waypointsAreTaught() {
    HandGuidingWindow driver;
    const QStringList before = driver.joints();
    QCOMPARE(driver.paths()->childCount(), 1);
    driver.drag({0, -60});
    QVERIFY(driver.settle());
    const QStringList led = driver.joints();
    QVERIFY(led != before);
    driver.click("quickActions/undo");
    QCOMPARE(driver.joints(), before);
    driver.click("quickActions/redo");
    QCOMPARE(driver.joints(), led);
    QTest::keyClick(driver.view(), Qt::Key_Space);
    QVERIFY(driver.settle());
    QCOMPARE(driver.paths()->childCount(), 2);
    QCOMPARE(driver.paths()->child(1)->childCount(), 1);
    driver.drag({60, 0});
    QTest::keyClick(driver.view(), Qt::Key_Space);
    QVERIFY(driver.settle());
    QCOMPARE(driver.paths()->childCount(), 2);
    QCOMPARE(driver.paths()->child(1)->childCount(), 2);
    for (int i = 0; i < 4; ++i) driver.click("quickActions/undo");
    QCOMPARE(driver.joints(), before);
    QCOMPARE(driver.paths()->childCount(), 1);
  }

  // Straight down for far more than there is room: the robot stops above the table and is never red.
  void theTableIsInTheWay() {
    HandGuidingWindow driver;
    driver.view()->setStandardView(StandardView::Front);
    driver.view()->setCamera(driver.view()->camera());
    const auto height = [&] {
      const auto* tool = driver.find<QDockWidget>("kindDock")->findChild<QWidget*>(QStringLiteral("property/tool.z"));
      return tool->findChild<QLineEdit*>()->text().section(' ', 0, 0).toDouble();
    };
    const double before = height();
    driver.drag({0, 400});
    QVERIFY(driver.settle());
    QVERIFY2(height() < before - 100.0, qPrintable(QString::number(height())));
    QVERIFY2(height() > -10.0, qPrintable(QString::number(height())));
  }
};

HANDWHEEL_WINDOW_TEST(HandGuidingWindowTest)
#include "HandGuidingWindowTest.moc"
