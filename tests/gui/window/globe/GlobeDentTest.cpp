// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "GlobeWindow.h"

using namespace handwheel;
using namespace handwheel::test;

// A globe is changed live through a simulation of its own: shown while it happens, one undo step in the end.
class GlobeDentTest : public QObject {
  Q_OBJECT

  static const DentTool& toolOf(GlobeWindow& globe) {
    return dynamic_cast<const DentTool&>(*globe.tools().runner().tool());
  }
  static GlobeSurface replayed(GlobeWindow& globe, const GlobeSurface& before) {
    DentSimulation simulation(before, globe.document().pose(), std::make_shared<DentChannel>());
    replay(simulation, toolOf(globe).lastGesture());
    return static_cast<const DentState&>(*simulation.state()).surface;
  }
  // The file that the document would be saved as.
  static std::string bytesOf(const GlobeDocument& document) {
    return containerBytes(document.kind(), document.file(), *document.snapshot(), {}, Compression::None).value();
  }
  // Presses with the mouse until something is seen of it.
  static bool press(GlobeWindow& globe, const QPoint& at) {
    QTest::mousePress(globe.view, Qt::LeftButton, {}, at);
    return QTest::qWaitFor([&] { return globe.lowestShown() < 9.8; }, kPatienceMs);
  }

 private slots:
  void init() { QSettings().clear(); }

  // Seen from above: the pole is dented, and nothing beside.
  void byTheMouse() {
    GlobeWindow globe;
    QVERIFY(globe.begin("dentTool", StandardView::Top));
    const GlobeSurface before = globe.document().surface();
    const std::string bytesBefore = bytesOf(globe.document());
    const QPoint pole = globe.pixelOf({0, 0, 10}).toPoint();
    QVERIFY(press(globe, pole));
    QVERIFY(globe.document().surface() == before);
    QCOMPARE(globe.document().history()->count(), 0);
    for (int i = 0; i < 10; ++i) globe.moveTo(pole + QPoint(i % 2, 0), Qt::LeftButton);
    QTest::mouseRelease(globe.view, Qt::LeftButton, {}, pole);
    const GlobeSurface dented = globe.document().surface();
    QCOMPARE(globe.document().history()->count(), 1);
    QVERIFY(dented.heightTowards(Vec3(0, 0, 1)) < 9.0);
    QCOMPARE(dented.heightTowards(Vec3(1, 0, 0)), 10.0);
    QCOMPARE(dented.heightTowards(Vec3(0, 0, -1)), 10.0);
    QVERIFY(replayed(globe, before) == dented);
    const std::string bytes = bytesOf(globe.document());
    QVERIFY(bytes != bytesBefore);
    globe.driver.click("quickActions/undo");
    QVERIFY(globe.document().surface() == before);
    QVERIFY(bytesOf(globe.document()) == bytesBefore);
    QVERIFY(std::abs(globe.lowestShown() - 10.0) < 1e-9);
    globe.driver.click("quickActions/redo");
    QVERIFY(globe.document().surface() == dented);
    QVERIFY(bytesOf(globe.document()) == bytes);
    QVERIFY(globe.lowestShown() < 9.8);
  }

  // The next gesture begins with what the last one left, and is a step of its own.
  void gesturesAddUp() {
    GlobeWindow globe;
    QVERIFY(globe.begin("dentTool", StandardView::Top));
    const QPoint pole = globe.pixelOf({0, 0, 10}).toPoint();
    QVERIFY(press(globe, pole));
    QTest::mouseRelease(globe.view, Qt::LeftButton, {}, pole);
    const GlobeSurface once = globe.document().surface();
    QTest::mousePress(globe.view, Qt::LeftButton, {}, pole);
    QTest::mouseRelease(globe.view, Qt::LeftButton, {}, pole);
    QCOMPARE(globe.document().history()->count(), 2);
    QVERIFY(globe.document().surface().heightTowards(Vec3(0, 0, 1)) < once.heightTowards(Vec3(0, 0, 1)));
    QVERIFY(replayed(globe, once) == globe.document().surface());
  }

  void escapeLosesTheGesture() {
    GlobeWindow globe;
    QVERIFY(globe.begin("dentTool", StandardView::Top));
    const QPoint pole = globe.pixelOf({0, 0, 10}).toPoint();
    QVERIFY(press(globe, pole));
    QTest::keyClick(globe.view, Qt::Key_Escape);
    QTRY_VERIFY(std::abs(globe.lowestShown() - 10.0) < 1e-9);
    QTest::mouseRelease(globe.view, Qt::LeftButton, {}, pole);
    QVERIFY(!globe.document().surface().isDented() && !globe.driver.window().isWindowModified());
    QVERIFY(globe.driver.find<QAction>("dentTool")->isChecked());
  }

  // A document that is closed in the middle of a gesture loses that gesture only: what was done before is in the file.
  void aClosedDocumentLosesTheGesture() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("dented.handwheel");
    GlobeWindow globe;
    QVERIFY(globe.begin("dentTool", StandardView::Top));
    const QPoint pole = globe.pixelOf({0, 0, 10}).toPoint();
    QVERIFY(press(globe, pole));
    QTest::mouseRelease(globe.view, Qt::LeftButton, {}, pole);
    const GlobeSurface saved = globe.document().surface();
    globe.driver.click("quickActions/saveFile");
    QVERIFY(globe.driver.enterFileName("saveDialog", path) && globe.driver.settle());
    const double lowest = globe.lowestShown();
    QTest::mousePress(globe.view, Qt::LeftButton, {}, pole);
    QTRY_VERIFY(globe.lowestShown() < lowest);
    globe.driver.choose("closeDocument");
    QTRY_COMPARE(globe.driver.tabs(), 0);
    QVERIFY(!globe.tools().runner().tool());
    QTest::mouseRelease(globe.view, Qt::LeftButton, {}, pole);
    QVERIFY(globe.driver.open(path));
    QVERIFY(globe.document().surface() == saved);
  }

  // The simulated hand rests below the surface with the button held: the surface yields, is felt less, and is seen.
  void byTheHand() {
    GlobeWindow globe;
    QVERIFY(globe.begin("dentTool", StandardView::Front) && globe.takeHand());
    const GlobeSurface before = globe.document().surface();
    globe.leadTo({0, 0, 8}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(globe.felt().isContact, kPatienceMs);
    QTest::qWait(100);
    QVERIFY(std::abs(globe.felt().proxy.norm() - 10.0) < 1e-6);  // without the button it is as it was
    globe.leadTo({0, 0, 8}, 1);
    QTRY_VERIFY_WITH_TIMEOUT(globe.felt().isContact && globe.felt().proxy.norm() < 9.5, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(globe.lowestShown() < 9.5, kPatienceMs);
    QVERIFY(globe.document().surface() == before);
    globe.leadTo({0, 0, 14}, 1);
    QTRY_VERIFY_WITH_TIMEOUT(!globe.felt().isContact, kPatienceMs);
    globe.leadTo({0, 0, 14}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(globe.document().surface().isDented(), kPatienceMs);
    QCOMPARE(globe.document().history()->count(), 1);
    QVERIFY(replayed(globe, before) == globe.document().surface());
  }

  // The hand goes on with the button held after Esc: nothing is dented any more, also not when it lets go.
  void escapeLosesTheGestureOfTheHand() {
    GlobeWindow globe;
    QVERIFY(globe.begin("dentTool", StandardView::Front) && globe.takeHand());
    globe.leadTo({0, 0, 8}, 1);
    QTRY_VERIFY_WITH_TIMEOUT(globe.lowestShown() < 9.5, kPatienceMs);
    QTest::keyClick(globe.view, Qt::Key_Escape);
    QTRY_VERIFY_WITH_TIMEOUT(globe.felt().isContact && std::abs(globe.felt().proxy.norm() - 10.0) < 1e-6, kPatienceMs);
    QTest::qWait(100);
    QVERIFY(std::abs(globe.felt().proxy.norm() - 10.0) < 1e-6);
    globe.leadTo({0, 0, 14}, 0);
    QTRY_VERIFY_WITH_TIMEOUT(!globe.felt().isContact, kPatienceMs);
    QVERIFY(!globe.document().surface().isDented());
  }

  // A device that goes in the middle of a gesture takes it with it.
  void aDeviceThatGoesLosesTheGesture() {
    GlobeWindow globe;
    QVERIFY(globe.begin("dentTool", StandardView::Front) && globe.takeHand());
    globe.leadTo({0, 0, 8}, 1);
    QTRY_VERIFY_WITH_TIMEOUT(globe.lowestShown() < 9.5, kPatienceMs);
    globe.session.close();
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(globe.lowestShown() - 10.0) < 1e-9, kPatienceMs);
    QVERIFY(!globe.document().surface().isDented());
  }
};

HANDWHEEL_WINDOW_TEST(GlobeDentTest)
#include "GlobeDentTest.moc"
