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
    RecordFixture fixture;
    QVERIFY(!fixture.action("recordDevice")->isEnabled());
    QVERIFY(fixture.driver.open(fixture.stl));
    QVERIFY(!fixture.action("recordDevice")->isEnabled());
    for (const char* name :
         {"playRecording", "leaveRecording", "exportRecording", "renameRecording", "removeRecording"})
      QVERIFY2(!fixture.action(name)->isEnabled(), name);
  }

  void aRecordingIsKeptWithTheDocument() {
    RecordFixture fixture;
    QVERIFY(fixture.begin());
    QVERIFY(!fixture.document().isModified());
    QVERIFY(fixture.record());
    QVERIFY(fixture.document().isModified());
    QCOMPARE(fixture.list()->rowCount(), 1);
    QCOMPARE(fixture.list()->item(0, 0)->text(), QString("Recording 1"));
    const StoredRecording kept = fixture.recordings.all().front();
    QVERIFY(kept.ticks.size() > 200);
    QVERIFY(fixture.list()->item(0, 1)->text().startsWith(QLatin1String("0:0")));
    QCOMPARE(kept.ticks.missing(), std::uint64_t{0});
    QCOMPARE(kept.device, std::string("Simulated hand"));
    QVERIFY(kept.forceLimit > 0.0);
    const QString path = fixture.folder.filePath(QStringLiteral("kept.handwheel"));
    fixture.driver.choose("saveFileAs");
    QVERIFY(fixture.driver.enterFileName("saveDialog", path));
    QVERIFY(fixture.driver.settle());
    QVERIFY(!fixture.document().isModified());
    fixture.driver.choose("closeDocument");
    QVERIFY(fixture.driver.open(path));
    QCOMPARE(fixture.list()->rowCount(), 1);
    QCOMPARE(fixture.recordings.all().front().ticks.size(), kept.ticks.size());
  }

  // An STL cannot hold it: the program asks for another name, and offers its own format.
  void aForeignFileIsNotEnough() {
    RecordFixture fixture;
    QVERIFY(fixture.begin());
    QVERIFY(fixture.record());
    fixture.driver.choose("saveFile");
    QVERIFY(fixture.driver.enterFileName("saveDialog", fixture.folder.filePath(QStringLiteral("other.handwheel"))));
    QVERIFY(fixture.driver.settle());
    QVERIFY(!fixture.document().isModified());
  }

  void eachIsAStepThatCanBeUndone() {
    RecordFixture fixture;
    QVERIFY(fixture.begin());
    QVERIFY(fixture.record() && fixture.record());
    QCOMPARE(fixture.list()->rowCount(), 2);
    QCOMPARE(fixture.list()->currentRow(), 1);
    fixture.list()->item(1, 0)->setText(QStringLiteral("  slow slide "));
    QCOMPARE(fixture.recordings.all()[1].name, std::string("slow slide"));
    fixture.list()->item(1, 0)->setText(QStringLiteral(" "));  // none
    QCOMPARE(fixture.list()->item(1, 0)->text(), QString("slow slide"));
    fixture.driver.choose("removeRecording");
    QCOMPARE(fixture.list()->rowCount(), 1);
    QCOMPARE(fixture.recordings.chosen()->name, std::string("Recording 1"));
    fixture.action("undo")->trigger();
    QCOMPARE(fixture.list()->rowCount(), 2);
    QCOMPARE(fixture.list()->item(1, 0)->text(), QString("slow slide"));
    for (int i = 0; i < 3; ++i) fixture.action("undo")->trigger();
    QCOMPARE(fixture.list()->rowCount(), 0);
    QVERIFY(!fixture.document().isModified());
  }

  // The cursor follows, also without a device, until the recording is left.
  void theCursorFollowsTheRecording() {
    RecordFixture fixture;
    QVERIFY(fixture.begin());
    HandPose pose;
    pose.position = Vec3(30, 0, 0);
    fixture.session.simulatedHand()->setTarget(pose);
    QVERIFY(fixture.record());
    fixture.session.close();
    QVERIFY(fixture.driver.settle());
    Playback& playback = fixture.recordings.playback();
    fixture.driver.choose("playRecording");
    QVERIFY(playback.isPlaying() && fixture.action("playRecording")->isChecked());
    QTRY_VERIFY(!playback.isPlaying());
    QTRY_VERIFY(!fixture.action("playRecording")->isChecked());
    const Recording& ticks = fixture.recordings.chosen()->ticks;
    QCOMPARE(playback.cursor()->tip, ticks[ticks.size() - 1].tip.position);
    auto* slider = fixture.driver.find<QSlider>("recordingPosition");
    QCOMPARE(slider->value(), slider->maximum());
    slider->setValue(0);
    QCOMPARE(playback.cursor()->tip, ticks[0].tip.position);
    fixture.driver.choose("leaveRecording");
    QVERIFY(!playback.isRecordingLoaded() && !playback.cursor());
    QVERIFY(!slider->isEnabled());
  }

  void whatEndsTheDeviceEndsTheRecording() {
    RecordFixture fixture;
    QVERIFY(fixture.begin());
    fixture.driver.choose("recordDevice");
    QTRY_VERIFY(fixture.session.recorder() && fixture.session.recorder()->ticks() > 50);
    fixture.session.close();
    QCOMPARE(fixture.list()->rowCount(), 1);
    QVERIFY(!fixture.action("recordDevice")->isChecked());
  }

  // Another document comes into view: what was recorded belongs to the one in which it began.
  void belongsToTheDocumentInWhichItBegan() {
    RecordFixture fixture;
    QVERIFY(fixture.begin());
    fixture.driver.choose("recordDevice");
    QTRY_VERIFY(fixture.session.recorder() && fixture.session.recorder()->ticks() > 50);
    Document& first = fixture.document();
    const QString other = fixture.folder.filePath(QStringLiteral("other.stl"));
    writeStl(other, cornersOf(tetrahedron()));
    QVERIFY(fixture.driver.open(other));
    QVERIFY(!fixture.session.recorder());
    QCOMPARE(first.file().recordings.size(), std::size_t{1});
    QVERIFY(fixture.recordings.all().empty());
    QCOMPARE(fixture.list()->rowCount(), 0);
  }

  void isWrittenAsATable() {
    RecordFixture fixture;
    QVERIFY(fixture.begin());
    QVERIFY(fixture.record());
    const QString path = fixture.folder.filePath(QStringLiteral("table.csv"));
    fixture.driver.choose("exportRecording");
    QVERIFY(fixture.driver.enterFileName("exportRecordingDialog", path));
    QVERIFY(fixture.driver.settle());
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(static_cast<std::size_t>(file.readAll().count('\n')), fixture.recordings.all()[0].ticks.size() + 1);
  }
};

HANDWHEEL_WINDOW_TEST(RecordingWindowTest)
#include "RecordingWindowTest.moc"
