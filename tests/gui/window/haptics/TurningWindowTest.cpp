// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowTestMain.h"
#include "TurningWindow.h"
#include "window/tools/ToolHost.h"

using namespace handwheel;
using namespace handwheel::test;

// A bar is turned in the window, by the mouse and by a simulated hand with force.
class TurningWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  // One pass is one undo step; saved and opened again it is the same part, and no larger bar can be had of it.
  void byTheMouse() {
    const QTemporaryDir folder;
    TurningWindow turning;
    QVERIFY(turning.begin());
    const QPoint from = turning.pixelOf(22.0, 30.0), to = turning.pixelOf(22.0, 60.0);
    turning.drag(from, to);
    QVERIFY(turning.workpiece().part);
    const double expected = std::abs(turning.positionOf(from).x()) - 1.0;
    QVERIFY(std::abs(turning.radiusAt(45.0) - expected) < 0.3);  // the distance of a pixel on the screen
    QCOMPARE(turning.radiusAt(90.0), 25.0);
    QVERIFY(turning.driver.settle());
    turning.driver.click("quickActions/undo");
    QVERIFY(!turning.workpiece().part);
    turning.driver.click("quickActions/redo");
    const TurnedProfile profile = turning.workpiece().part->profile;
    const QString path = folder.filePath("part.handwheel");
    turning.driver.click("quickActions/saveFile");
    QVERIFY(turning.driver.enterFileName("saveDialog", path));
    QVERIFY(turning.driver.settle());
    WindowDriver second;
    QVERIFY(second.open(path));
    auto& opened = static_cast<WorkpieceDocument&>(second.window().findChild<DocumentTabs*>()->current()->document);
    QVERIFY(opened.workpiece().part && opened.workpiece().part->profile == profile);
  }

  // Material cut by the simulation while the mouse rests is shown without another input.
  void isShownWhileTheMouseRests() {
    std::shared_ptr<const DisplayModel> shown;  // outlives the window, which calls back when it closes
    TurningWindow turning;
    QVERIFY(turning.begin());
    connect(turning.driver.window().findChild<ToolHost*>(), &ToolHost::previewed, this,
            [&shown](const ToolPreview& preview) { shown = preview.replaced; });
    const QPoint beside = turning.pixelOf(28.0, 30.0), inside = turning.pixelOf(22.0, 30.0);
    QTest::mouseMove(turning.view, beside);
    QTRY_VERIFY(shown);
    const auto uncut = shown;
    QTest::mousePress(turning.view, Qt::LeftButton, {}, beside);
    turning.moveTo(inside);
    QTRY_VERIFY(shown && shown != uncut);
    QTest::mouseRelease(turning.view, Qt::LeftButton, {}, inside);
    QVERIFY(turning.workpiece().part);
  }

  // Undo in the middle of a pass takes that pass, not the one before.
  void undoInAPassTakesThatPass() {
    TurningWindow turning;
    QVERIFY(turning.begin());
    turning.drag(turning.pixelOf(22.0, 30.0), turning.pixelOf(22.0, 60.0));
    QVERIFY(turning.workpiece().part);
    const TurnedProfile before = turning.workpiece().part->profile;
    QTest::mousePress(turning.view, Qt::LeftButton, {}, turning.pixelOf(28.0, 80.0));
    turning.moveTo(turning.pixelOf(20.0, 80.0));
    turning.driver.find<QAction>("undo")->trigger();
    turning.moveTo(turning.pixelOf(20.0, 90.0));
    QTest::mouseRelease(turning.view, Qt::LeftButton, {}, turning.pixelOf(20.0, 90.0));
    QVERIFY(turning.workpiece().part && turning.workpiece().part->profile == before);
    QCOMPARE(turning.document().history()->count(), 1);
    turning.driver.find<QAction>("undo")->trigger();
    QVERIFY(!turning.workpiece().part);
  }

  // Also the first pass of a document, of which there is nothing else to undo.
  void undoTakesTheFirstPass() {
    TurningWindow turning;
    QVERIFY(turning.begin());
    auto* undo = turning.driver.find<QAction>("undo");
    QVERIFY(!undo->isEnabled());
    QTest::mousePress(turning.view, Qt::LeftButton, {}, turning.pixelOf(28.0, 80.0));
    turning.moveTo(turning.pixelOf(20.0, 80.0));
    QTRY_VERIFY(undo->isEnabled());
    undo->trigger();
    QTRY_VERIFY(!undo->isEnabled());
    QTest::mouseRelease(turning.view, Qt::LeftButton, {}, turning.pixelOf(20.0, 80.0));
    QVERIFY(!turning.workpiece().part);
    QCOMPARE(turning.document().history()->count(), 0);
  }

  // The label at the nose shows its coordinates, in the unit of the document.
  void theNoseHasItsNumbers() {
    TurningWindow turning;
    QVERIFY(turning.begin());
    const auto* label = turning.driver.find<QLabel>("toolLabel");
    const QPoint beside = turning.pixelOf(28.0, 40.0);
    const auto expected = [&](double perUnit, int digits, const char* unit) {
      const Vec3 nose = turning.positionOf(beside);
      const QString format = QStringLiteral("⌀ %1 %4  Z %2 %4  %3 %4");
      const auto number = [&](double mm) { return QLocale().toString(mm / perUnit, 'f', digits); };
      return format.arg(number(2.0 * (nose.x() - 1.0)), number(nose.z() - 1.0), number(0.0), QString::fromLatin1(unit));
    };
    const auto shown = [label] { return label->text().replace(QChar::Nbsp, QLatin1Char(' ')); };
    QTest::mouseMove(turning.view, beside);
    QTRY_VERIFY(label->isVisible());
    QTRY_COMPARE(shown(), expected(1.0, 2, "mm"));
    QVERIFY(turning.document().setProperty("display_unit", 3.0));
    QTest::mouseMove(turning.view, beside + QPoint(0, 1));
    QTest::mouseMove(turning.view, beside);
    QTRY_COMPARE(shown(), expected(25.4, 4, "in"));
    QTest::mouseMove(turning.view, turning.pixelOf(28.0, 160.0));  // far from the bar
    QTRY_VERIFY(!label->isVisible());
  }

  // A bar that grows out of the view is fitted again; otherwise the camera stays as it is.
  void aBarThatGrowsStaysInTheView() {
    TurningWindow turning;
    QVERIFY(turning.begin());
    const double height = turning.view->camera().height;
    turning.driver.edit("length", "95");
    QTest::qWait(50);  // the view is fitted by now
    QCOMPARE(turning.view->camera().height, height);
    turning.driver.edit("length", "300");
    QVERIFY(turning.driver.settle());
    // The axis is level.
    QTRY_VERIFY(turning.view->camera().height * turning.view->width() / turning.view->height() > 300.0);
    CameraState near = turning.view->camera();
    near.height = 20.0;
    turning.view->setCamera(near);
    turning.driver.edit("diameter", "80");  // it was not seen whole before
    QTest::qWait(50);
    QCOMPARE(turning.view->camera().height, 20.0);
  }

  // A locked size shows the reason.
  void lockedSizesSayWhy() {
    TurningWindow turning;
    QVERIFY(turning.begin());
    turning.drag(turning.pixelOf(22.0, 30.0), turning.pixelOf(22.0, 60.0));
    QVERIFY(turning.workpiece().part);
    const auto tip = [&](const char* field) {
      const auto rows = turning.driver.window().findChildren<QWidget*>(QString::fromLatin1(field));
      return std::any_of(rows.begin(), rows.end(), [](const QWidget* row) {
        return row->isVisible() && row->toolTip() == QStringLiteral("Undo the passes to change the size.");
      });
    };
    QTRY_VERIFY(tip("property/diameter") && tip("property/length"));
    turning.driver.click("quickActions/undo");
    QTRY_VERIFY(!tip("property/diameter") && !tip("property/length"));
  }

  // The hand feels the bar as it is; pressed with the button held it goes in, and the release is the undo step.
  void byTheHand() {
    TurningWindow turning;
    QVERIFY(turning.begin() && turning.takeHand());
    turning.leadTo({21.0, 0.0, 50.0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(turning.session.latest()->felt.isContact, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(turning.session.latest()->felt.force.x() > 0.05, kPatienceMs);
    QVERIFY(turning.session.latest()->felt.proxy.x() > 25.9);  // the nose of 1 mm rests on the bar of 25
    QVERIFY(!turning.workpiece().part);
    turning.leadTo({21.0, 0.0, 50.0}, 1);
    QTRY_VERIFY_WITH_TIMEOUT(turning.session.latest()->felt.proxy.x() < 23.0, kPatienceMs);
    turning.leadTo({32.0, 0.0, 50.0}, 1);
    QTRY_VERIFY_WITH_TIMEOUT(!turning.session.latest()->felt.isContact, kPatienceMs);
    turning.leadTo({32.0, 0.0, 50.0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(turning.workpiece().part != nullptr, kPatienceMs);
    QVERIFY(turning.radiusAt(50.0) < 22.5);
    QVERIFY(turning.radiusAt(70.0) == 25.0);
    TurnedProfile again(turning.workpiece().stock, turning.workpiece().part->profile.spacing());
    for (const auto& pass : turning.workpiece().part->passes) cut(again, *pass);
    QVERIFY(again == turning.workpiece().part->profile);
  }

  // Esc with the button held: the bar is whole again around the hand, which it does not push. Until the button is
  // pressed anew the hand gets no deeper, and nothing is cut.
  void escapeEndsThePassOfTheHand() {
    TurningWindow turning;
    QVERIFY(turning.begin() && turning.takeHand());
    const auto felt = [&turning] { return turning.session.latest()->felt; };
    turning.leadTo({21.0, 0.0, 50.0}, 1);
    QTRY_VERIFY_WITH_TIMEOUT(felt().proxy.x() < 21.1, kPatienceMs);
    QTest::keyClick(turning.view, Qt::Key_Escape);
    QTest::qWait(200);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(felt().proxy.x() - 21.0) < 0.2, kPatienceMs);
    turning.leadTo({19.0, 0.0, 50.0}, 1);
    QTRY_VERIFY_WITH_TIMEOUT(felt().isContact && felt().force.x() > 0.05, kPatienceMs);
    QTest::qWait(200);
    QVERIFY(std::abs(felt().proxy.x() - 21.0) < 0.2);
    QVERIFY(turning.leadOut());
    QVERIFY(!turning.workpiece().part);
  }

  // Moved along its axis under the tool the part is felt where it is: from z = 60 on.
  void aMovedPartIsFeltWhereItIs() {
    TurningWindow turning;
    QVERIFY(turning.begin() && turning.takeHand());
    const auto isFelt = [&turning] { return turning.session.latest()->felt.isContact; };
    turning.leadTo({21.0, 0.0, 50.0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(isFelt(), kPatienceMs);
    QVERIFY(turning.leadOut());
    QVERIFY(turning.document().setProperty("position", 60.0));
    QVERIFY(turning.driver.settle());
    turning.leadTo({21.0, 0.0, 50.0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(turning.session.latest()->tip.position.x() - 21.0) < 1.0, kPatienceMs);
    QTest::qWait(50);
    QVERIFY(!isFelt());
    QVERIFY(turning.leadOut());
    turning.leadTo({21.0, 0.0, 70.0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(isFelt(), kPatienceMs);
  }

  // Parts of documents are felt without a tool, too.
  void partsAreFelt() {
    TurningWindow turning;
    turning.driver.choose("newWorkpiece");
    QVERIFY(turning.driver.settle());
    turning.view->setStandardView(StandardView::Top);
    QVERIFY(turning.takeHand());
    turning.leadTo({21.0, 0.0, 50.0}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(turning.session.latest()->felt.isContact, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(turning.session.latest()->felt.proxy.x() - 25.0) < 0.2, kPatienceMs);
  }
};

HANDWHEEL_WINDOW_TEST(TurningWindowTest)
#include "TurningWindowTest.moc"
