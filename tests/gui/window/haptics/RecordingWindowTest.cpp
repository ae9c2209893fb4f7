// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../WindowDriver.h"
#include "../WindowTestMain.h"
#include "MeshShapes.h"
#include "SoupCorners.h"
#include "document/Document.h"
#include "haptics/recording/ForceRecorder.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"
#include "window/haptics/HapticSession.h"
#include "window/haptics/Recordings.h"

#include <QSlider>
#include <QTableWidget>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A window with a cube in it and the simulated hand open.
struct RecordFixture {
  QTemporaryDir folder;
  WindowDriver driver;
  HapticSession& session;
  Recordings& recordings;
  QString stl = folder.filePath(QStringLiteral("cube.stl"));

  RecordFixture()
      : session(*driver.window().findChild<HapticSession*>()), recordings(*driver.window().findChild<Recordings*>()) {
    writeStl(stl, cornersOf(cube()));
  }
  ~RecordFixture() { session.close(); }

  bool begin() {
    if (!driver.open(stl)) return false;
    session.choose("simulated", "hand");
    return QTest::qWaitFor([this] { return session.latest() != nullptr; }, kPatienceMs) && driver.settle();
  }
  // Some tenths of a second.
  bool record() {
    driver.choose("recordDevice");
    const bool isLong =
        QTest::qWaitFor([this] { return session.recorder() && session.recorder()->ticks() > 200; }, kPatienceMs);
    driver.choose("recordDevice");
    return isLong;
  }
  Document& document() { return driver.find<DocumentTabs>("tabRow")->current()->document; }
  QTableWidget* list() { return driver.find<QTableWidget>("recordingList"); }
  QAction* action(const char* name) { return driver.find<QAction>(name); }
};

}  // namespace

// Recordings in the window, by what a user presses.
class RecordingWindowTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { QSettings().clear(); }

  void withoutADeviceOrADocumentNothingIsRecorded() {
    RecordFixture b;
    QVERIFY(!b.action("recordDevice")->isEnabled());
    QVERIFY(b.driver.open(b.stl));
    QVERIFY(!b.action("recordDevice")->isEnabled());
    for (const char* name :
         {"playRecording", "leaveRecording", "exportRecording", "renameRecording", "removeRecording"})
      QVERIFY2(!b.action(name)->isEnabled(), name);
  }

  void aRecordingIsKeptWithTheDocument() {
    RecordFixture b;
    QVERIFY(b.begin());
    QVERIFY(!b.document().isModified());
    QVERIFY(b.record());
    QVERIFY(b.document().isModified());
    QCOMPARE(b.list()->rowCount(), 1);
    QCOMPARE(b.list()->item(0, 0)->text(), QString("Recording 1"));
    const StoredRecording kept = b.recordings.all().front();
    QVERIFY(kept.ticks.size() > 200);
    QVERIFY(b.list()->item(0, 1)->text().startsWith(QLatin1String("0:0")));
    QCOMPARE(kept.ticks.missing(), std::uint64_t{0});
    QCOMPARE(kept.device, std::string("Simulated hand"));
    QVERIFY(kept.forceLimit > 0.0);
    const QString path = b.folder.filePath(QStringLiteral("kept.handwheel"));
    b.driver.choose("saveFileAs");
    QVERIFY(b.driver.enterFileName("saveDialog", path));
    QVERIFY(b.driver.settle());
    QVERIFY(!b.document().isModified());
    b.driver.choose("closeDocument");
    QVERIFY(b.driver.open(path));
    QCOMPARE(b.list()->rowCount(), 1);
    QCOMPARE(b.recordings.all().front().ticks.size(), kept.ticks.size());
  }

  // An STL has no place for it: the program asks for another name, and offers its own format.
  void aForeignFileIsNotEnough() {
    RecordFixture b;
    QVERIFY(b.begin());
    QVERIFY(b.record());
    b.driver.choose("saveFile");
    QVERIFY(b.driver.enterFileName("saveDialog", b.folder.filePath(QStringLiteral("other.handwheel"))));
    QVERIFY(b.driver.settle());
    QVERIFY(!b.document().isModified());
  }

  void eachIsAStepThatCanBeUndone() {
    RecordFixture b;
    QVERIFY(b.begin());
    QVERIFY(b.record() && b.record());
    QCOMPARE(b.list()->rowCount(), 2);
    QCOMPARE(b.list()->currentRow(), 1);
    b.list()->item(1, 0)->setText(QStringLiteral("  slow slide "));
    QCOMPARE(b.recordings.all()[1].name, std::string("slow slide"));
    b.list()->item(1, 0)->setText(QStringLiteral(" "));  // none
    QCOMPARE(b.list()->item(1, 0)->text(), QString("slow slide"));
    b.driver.choose("removeRecording");
    QCOMPARE(b.list()->rowCount(), 1);
    QCOMPARE(b.recordings.chosen()->name, std::string("Recording 1"));
    b.action("undo")->trigger();
    QCOMPARE(b.list()->rowCount(), 2);
    QCOMPARE(b.list()->item(1, 0)->text(), QString("slow slide"));
    for (int i = 0; i < 3; ++i) b.action("undo")->trigger();
    QCOMPARE(b.list()->rowCount(), 0);
    QVERIFY(!b.document().isModified());
  }

  // The cursor follows, also without a device, until the recording is left.
  void theCursorFollowsTheRecording() {
    RecordFixture b;
    QVERIFY(b.begin());
    HandPose pose;
    pose.position = Vec3(30, 0, 0);
    b.session.simulatedHand()->setTarget(pose);
    QVERIFY(b.record());
    b.session.close();
    QVERIFY(b.driver.settle());
    Playback& playback = b.recordings.playback();
    b.driver.choose("playRecording");
    QVERIFY(playback.isPlaying() && b.action("playRecording")->isChecked());
    QTRY_VERIFY(!playback.isPlaying());
    QTRY_VERIFY(!b.action("playRecording")->isChecked());
    const Recording& ticks = b.recordings.chosen()->ticks;
    QCOMPARE(playback.cursor()->tip, ticks[ticks.size() - 1].tip.position);
    auto* slider = b.driver.find<QSlider>("recordingPosition");
    QCOMPARE(slider->value(), slider->maximum());
    slider->setValue(0);
    QCOMPARE(playback.cursor()->tip, ticks[0].tip.position);
    b.driver.choose("leaveRecording");
    QVERIFY(!playback.isRecordingLoaded() && !playback.cursor());
    QVERIFY(!slider->isEnabled());
  }

  void whatEndsTheDeviceEndsTheRecording() {
    RecordFixture b;
    QVERIFY(b.begin());
    b.driver.choose("recordDevice");
    QTRY_VERIFY(b.session.recorder() && b.session.recorder()->ticks() > 50);
    b.session.close();
    QCOMPARE(b.list()->rowCount(), 1);
    QVERIFY(!b.action("recordDevice")->isChecked());
  }

  // Another document comes into view: what was recorded belongs to the one in which it began.
  void belongsToTheDocumentInWhichItBegan() {
    RecordFixture b;
    QVERIFY(b.begin());
    b.driver.choose("recordDevice");
    QTRY_VERIFY(b.session.recorder() && b.session.recorder()->ticks() > 50);
    Document& first = b.document();
    const QString other = b.folder.filePath(QStringLiteral("other.stl"));
    writeStl(other, cornersOf(tetrahedron()));
    QVERIFY(b.driver.open(other));
    QVERIFY(!b.session.recorder());
    QCOMPARE(first.file().recordings.size(), std::size_t{1});
    QVERIFY(b.recordings.all().empty());
    QCOMPARE(b.list()->rowCount(), 0);
  }

  void isWrittenAsATable() {
    RecordFixture b;
    QVERIFY(b.begin());
    QVERIFY(b.record());
    const QString path = b.folder.filePath(QStringLiteral("table.csv"));
    b.driver.choose("exportRecording");
    QVERIFY(b.driver.enterFileName("exportRecordingDialog", path));
    QVERIFY(b.driver.settle());
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(static_cast<std::size_t>(file.readAll().count('\n')), b.recordings.all()[0].ticks.size() + 1);
  }
};

HANDWHEEL_WINDOW_TEST(RecordingWindowTest)
#include "RecordingWindowTest.moc"
