// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "CellWindow.h"
#include "PixelsLike.h"
#include "viewport/camera/CameraNavigation.h"
#include "viewport/path/ContactLayer.h"

#include <cmath>

using namespace handwheel;
using namespace handwheel::test;

namespace {

class ContactsWindow : public CellWindow {
 public:
  // Pixels in the colour of contacts.
  int marked() { return pixelsLike(view()->grabImage(), contactColour()); }
  QString number(const char* property) { return field(property).split(' ').front(); }
  // A box about the tool, and so in the last link.
  void addBoxInTheTool() {
    const QString x = number("tool.x"), y = number("tool.y"), z = number("tool.z");
    choose("add-box");
    edit("body.1.x", x);
    edit("body.1.y", y);
    edit("body.1.z", z);
    showAll();
  }
};

}  // namespace

// Contacts are marked in the view.
class CellContactsWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void whereABodyIsInTheRobot() {
    ContactsWindow driver;
    QCOMPARE(driver.marked(), 0);
    driver.addBoxInTheTool();
    QTRY_VERIFY_WITH_TIMEOUT(driver.marked() > 20, kPatienceMs);
    driver.choose("showContacts");
    QCOMPARE(driver.marked(), 0);
    driver.choose("showContacts");
    QTRY_VERIFY_WITH_TIMEOUT(driver.marked() > 20, kPatienceMs);
    driver.edit("body.1.x", "5000");
    QTRY_COMPARE_WITH_TIMEOUT(driver.marked(), 0, kPatienceMs);
    driver.click("quickActions/undo");
    driver.showAll();
    QTRY_VERIFY_WITH_TIMEOUT(driver.marked() > 20, kPatienceMs);
  }

  // The marks go while the body is being dragged out, before it is let go.
  void whileABodyIsDragged() {
    ContactsWindow driver;
    driver.addBoxInTheTool();
    driver.view()->setStandardView(StandardView::Top);
    driver.view()->setCamera(driver.view()->camera());
    driver.showAll();
    QVERIFY(driver.settle());
    QTRY_VERIFY_WITH_TIMEOUT(driver.marked() > 20, kPatienceMs);
    const QPoint grip = driver.pixelOf("body.1");
    QVERIFY(!grip.isNull());
    const QPoint out(grip.x() < driver.view()->width() / 2 ? driver.view()->width() - 20 : 20, grip.y());
    driver.move(grip);
    QTest::mousePress(driver.view(), Qt::LeftButton, {}, grip);
    driver.move((3 * grip + out) / 4);
    driver.move(out);
    QTRY_COMPARE_WITH_TIMEOUT(driver.marked(), 0, kPatienceMs);
    driver.move(grip);
    QTRY_VERIFY_WITH_TIMEOUT(driver.marked() > 20, kPatienceMs);
    QTest::mouseRelease(driver.view(), Qt::LeftButton, {}, grip);
  }
};

HANDWHEEL_WINDOW_TEST(CellContactsWindowTest)
#include "CellContactsWindowTest.moc"
#include "PixelsLike.h"
