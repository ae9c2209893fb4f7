// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "MeshDocuments.h"
#include "MeshShapes.h"
#include "Program.h"
#include "TestClass.h"
#include "document/RecordingsEdit.h"
#include "haptics/recording/RecordingCsv.h"

#include <QTest>
#include <sstream>

using namespace handwheel;

namespace {

Recording steps(int count) {
  Recording recording;
  for (int i = 0; i < count; ++i) {
    RecordedTick tick;
    tick.tick = static_cast<std::uint64_t>(i);
    tick.tip.time = 0.25 * i;
    tick.tip.position = Vec3(0.1 * i, 0, 0);
    recording.add(tick);
  }
  return recording;
}

QByteArray tableOf(const Recording& recording) {
  std::ostringstream out;
  return writeCsv(recording, out) ? QByteArray::fromStdString(out.str()) : QByteArray();
}

// A document with these recordings.
void save(const Fixture& fixture, std::vector<StoredRecording> recordings) {
  const auto document = test::meshDocument(test::tetrahedron());
  document->commit("recordings", std::make_unique<RecordingsEdit>(std::move(recordings)));
  const auto path = (fixture.path() + "/a.handwheel").toStdString();
  if (!saveDocument(document->kind(), document->file(), *document->snapshot(), path)) qFatal("cannot save");
}

}  // namespace

class RecordingTest : public QObject {
  Q_OBJECT

 private slots:
  void listsThem() {
    const Fixture fixture;
    save(fixture, {{"0001", "first", "Novint Falcon", 8.0, steps(5)}, {"0002", "second", "", 0.0, steps(1)}});
    const Ran ran = fixture.run({"recording", "a.handwheel"}, "de_DE.UTF-8");
    QVERIFY2(ran.code == 0 && ran.err.isEmpty(), ran.err);
    QCOMPARE(ran.out, QByteArray("first: 1 s, 5 samples, Novint Falcon\nsecond: 0 s, 1 sample\n"));
  }

  void writesTheOnlyOneAndTheOneNamed() {
    const Fixture fixture;
    save(fixture, {{"0001", "first", "", 8.0, steps(5)}});
    QCOMPARE(fixture.run({"recording", "a.handwheel", "-o", "one.csv"}, "de_DE.UTF-8").code, 0);
    QCOMPARE(fixture.content("one.csv"), tableOf(steps(5)));
    save(fixture, {{"0001", "first", "", 8.0, steps(5)}, {"0002", "second", "", 0.0, steps(3)}});
    QCOMPARE(fixture.run({"recording", "a.handwheel", "--name", "second", "--out", "two.csv"}).code, 0);
    QCOMPARE(fixture.content("two.csv"), tableOf(steps(3)));
  }

  void saysWhatIsMissing() {
    const Fixture fixture;
    save(fixture, {});
    QVERIFY(fixture.run({"recording", "a.handwheel"}).out.contains("There are no recordings."));
    const Ran none = fixture.run({"recording", "a.handwheel", "-o", "x.csv"});
    QVERIFY(none.code == 1 && none.err.contains("no recordings"));
    save(fixture, {{"0001", "first", "", 8.0, steps(5)}, {"0002", "second", "", 0.0, steps(3)}});
    QVERIFY(fixture.run({"recording", "a.handwheel", "-o", "x.csv"}).err.contains("--name"));
    const Ran other = fixture.run({"recording", "a.handwheel", "--name", "third", "-o", "x.csv"});
    QVERIFY(other.code == 1 && other.err.contains("third"));
    const QByteArray before = fixture.content("a.handwheel");
    QCOMPARE(fixture.run({"recording", "a.handwheel", "--name", "first", "-o", "a.handwheel"}).code, 1);
    QCOMPARE(fixture.content("a.handwheel"), before);
    QVERIFY(!fixture.names().contains("x.csv"));
  }
};

HANDWHEEL_TEST(RecordingTest)
#include "RecordingTest.moc"
