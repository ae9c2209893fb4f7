// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowDriver.h"
#include "../WindowTestMain.h"
#include "BuildPaths.h"
#include "MeshShapes.h"
#include "SoupCorners.h"
#include "haptics/recording/ForceRecorder.h"
#include "window/haptics/HapticSession.h"

#include <QProcess>
#include <QRegularExpression>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Waits for the first scene of a recording: a contact that began before is not felt again.
bool isSceneRecorded(HapticSession& session) {
  const auto isThere = [&] {
    const std::vector<RecordedEvent> events = session.recorder()->recording().events();
    return std::any_of(events.begin(), events.end(),
                       [](const RecordedEvent& e) { return e.text.starts_with(kSceneEvent); });
  };
  return QTest::qWaitFor(isThere, kPatienceMs);
}

}  // namespace

// A recording of the hand is felt again by the command line: the same forces, through every edit that was made.
class FeltAgainTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  // Pressed onto a ball, which is repaired under the hand; the repair is taken back, then done once more.
  void throughEditsAndUndo() {
    const QTemporaryDir folder;
    const QString stl = folder.filePath("ball.stl"), table = folder.filePath("session.csv");
    writeStl(stl, cornersOf(moved(sphereWithoutCap(3, 0.6), Vec3::Zero(), 20.0)));
    WindowDriver driver;
    HapticSession& session = *driver.window().findChild<HapticSession*>();
    QVERIFY(driver.open(stl));
    session.choose("simulated", "hand");
    QTRY_VERIFY(session.latest() != nullptr);
    QVERIFY(driver.settle());
    const auto wait = [&session](std::size_t ticks) {
      const std::size_t until = session.recorder()->ticks() + ticks;
      return QTest::qWaitFor([&] { return session.recorder() && session.recorder()->ticks() > until; }, kPatienceMs);
    };
    const auto leadTo = [&session](const Vec3& position) {
      const WorkspaceMapping mapping = session.mappingInScene();
      HandPose pose;
      pose.position =
          mapping.viewFromDevice().transpose() * (mapping.sceneFromView.inverse() * position) / mapping.scale;
      session.simulatedHand()->setTarget(pose);
    };
    // It begins in contact, of which nothing is known, and is felt again from where the tip was free.
    leadTo(Vec3::Zero());
    QTRY_VERIFY(session.latest()->felt.isContact);
    driver.choose("recordDevice");
    QVERIFY(isSceneRecorded(session));
    leadTo(60.0 * session.camera().towardsViewer());
    QTRY_VERIFY(!session.latest()->felt.isContact && session.latest()->tip.position.norm() > 30.0);
    QVERIFY(wait(50));
    leadTo(Vec3::Zero());
    QTRY_VERIFY(session.latest()->felt.isContact);
    QVERIFY(wait(200));
    for (const char* command : {"repairAll", "undo", "redo"}) {
      driver.choose(command);
      QVERIFY(driver.settle());
      QVERIFY(wait(200));
    }
    driver.choose("recordDevice");
    driver.choose("exportRecording");
    QVERIFY(driver.enterFileName("exportRecordingDialog", table));
    QVERIFY(driver.settle());
    session.close();

    QProcess again;
    again.start(test::programPath(), {"feel", stl, "--path", table});
    QVERIFY(again.waitForFinished());
    const QByteArray out = again.readAllStandardOutput(), errors = again.readAllStandardError();
    QVERIFY2(out.contains(", edits 2\n"), out + errors);
    QVERIFY2(out.contains("the largest difference is 0 N\n"), out + errors);
    const QRegularExpressionMatch same = QRegularExpression("As recorded  (\\d+) ticks").match(QString::fromUtf8(out));
    const QRegularExpressionMatch all = QRegularExpression("Ticks        (\\d+)\n").match(QString::fromUtf8(out));
    QVERIFY(all.captured(1).toInt() > 700);
    QCOMPARE(same.captured(1), all.captured(1));
    QVERIFY(!out.contains("Peak force   0 N"));
  }

  // A box is pressed while a ball beside it is moved away and back: it is felt where it was all the time.
  void whereTheBodiesOfACellWere() {
    const QTemporaryDir folder;
    const QString cell = folder.filePath("cell.handwheel"), table = folder.filePath("session.csv");
    WindowDriver driver;
    HapticSession& session = *driver.window().findChild<HapticSession*>();
    driver.choose("openRobotSample");
    QVERIFY(driver.settle());
    driver.choose("add-box");
    QVERIFY(driver.settle());
    const auto coordinate = [&](const char* property) {
      return driver.find<QWidget>(property)->findChild<QLineEdit*>()->text().toDouble();
    };
    const Vec3 box(coordinate("property/body.1.x"), coordinate("property/body.1.y"), coordinate("property/body.1.z"));
    driver.choose("add-sphere");
    QVERIFY(driver.settle());
    driver.choose("saveFileAs");
    QVERIFY(driver.enterFileName("saveDialog", cell));
    QVERIFY(driver.settle());
    session.choose("simulated", "hand");
    QTRY_VERIFY(session.latest() != nullptr);
    QVERIFY(driver.settle());
    driver.choose("recordDevice");
    QVERIFY(isSceneRecorded(session));
    const auto leadIn = [&] {
      const WorkspaceMapping mapping = session.mappingInScene();
      const Vec3 inView = mapping.sceneFromView.linear().transpose() * (box - session.latest()->tip.position);
      HandPose pose;
      pose.position = session.latest()->device.position + mapping.viewFromDevice().transpose() * inView / mapping.scale;
      session.simulatedHand()->setTarget(pose);
      return session.latest()->felt.isContact && (session.latest()->tip.position - box).norm() < 70.0;
    };
    QTRY_VERIFY_WITH_TIMEOUT(leadIn(), kPatienceMs);
    for (const char* y : {"900", "-700"}) {
      driver.edit("body.2.y", y);
      QVERIFY(driver.settle());
      QTest::qWait(100);
    }
    driver.choose("recordDevice");
    driver.choose("exportRecording");
    QVERIFY(driver.enterFileName("exportRecordingDialog", table));
    QVERIFY(driver.settle());
    session.close();

    QProcess again;
    again.start(test::programPath(), {"feel", cell, "--path", table});
    QVERIFY(again.waitForFinished());
    const QByteArray out = again.readAllStandardOutput(), errors = again.readAllStandardError();
    // Two by the fields, and what else made the scene anew.
    const auto edits = QRegularExpression(QStringLiteral(", edits (\\d+)\n")).match(QString::fromUtf8(out));
    QVERIFY2(edits.captured(1).toInt() >= 2, out + errors);
    QVERIFY2(out.contains("the largest difference is 0 N\n"), out + errors);
    QVERIFY(!out.contains("Peak force   0 N"));
  }
};

HANDWHEEL_WINDOW_TEST(FeltAgainTest)
#include "FeltAgainTest.moc"
