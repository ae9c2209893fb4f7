// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BatchFixture.h"
#include "LargeInputs.h"
#include "TestClass.h"

#include <cstring>

using namespace handwheel;

// Every file has a process of its own, which may end as it likes.
class BatchProcessesTest : public QObject {
  Q_OBJECT

 private slots:
  // Ends a child like a crash or the system would.
  void endedChildStopsNoOther_data() {
    QTest::addColumn<int>("signal");
    QTest::addColumn<QByteArray>("reason");
    QTest::newRow("killed") << SIGKILL << QByteArray("The system ended its process; memory may have run out.");
    QTest::newRow("crashed") << SIGSEGV << QByteArray("Its process crashed (Segmentation fault).");
  }
  void endedChildStopsNoOther() {
    QFETCH(int, signal);
    QFETCH(QByteArray, reason);
    const Fixture fixture;
    putGoodFiles(fixture);
    putInto(fixture, "in/large.off", largeTube());
    Batch batch(fixture, {"in", "-o", "out", "-j", "2"});
    QTRY_VERIFY_WITH_TIMEOUT(batch.childFor("in/large.off") != 0, 30000);
    ::kill(batch.childFor("in/large.off"), signal);
    const Ran ran = batch.finish();
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.out.contains("in/large.off: failed: " + reason + "\n"), ran.out);
    QCOMPARE(states(fixture.json("out/repair-report.json")),
             (QStringList{"in/a.off closed", "in/large.off failed", "in/sub/b.off closed", "in/sub/c.off closed"}));
    QVERIFY(!QFile::exists(fixture.path() + "/out/large.off"));
  }

  // Also one that does not listen.
  void timeLimit() {
    const Fixture fixture;
    putGoodFiles(fixture);
    putInto(fixture, "in/large.off", largeTube());
    Batch batch(fixture, {"in", "-o", "out", "--time-limit", "5"});
    QTRY_VERIFY_WITH_TIMEOUT(batch.childFor("in/large.off") != 0, 30000);
    ::kill(batch.childFor("in/large.off"), SIGSTOP);
    const Ran ran = batch.finish();
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.out.contains("in/large.off: failed: It took longer than 5 s.\n"), ran.out);
    QCOMPARE(ran.out.count(": closed"), 3);
  }

  void interrupt_data() {
    QTest::addColumn<int>("signal");
    QTest::addColumn<bool>("isDeaf");
    QTest::newRow("SIGINT") << SIGINT << false;
    QTest::newRow("SIGTERM") << SIGTERM << false;
    QTest::newRow("SIGHUP") << SIGHUP << false;
    QTest::newRow("a child does not listen") << SIGINT << true;
  }
  void interrupt() {
    QFETCH(int, signal);
    QFETCH(bool, isDeaf);
    const Fixture fixture;
    putGoodFiles(fixture);
    for (const char* name : {"in/large1.off", "in/large2.off"}) putInto(fixture, name, largeTube());
    putInto(fixture, "out/large1.off", "what was there before");
    Batch batch(fixture, {"in", "-o", "out", "-j", "2"});
    QTRY_VERIFY_WITH_TIMEOUT(batch.childFor("in/large1.off") != 0 && batch.childFor("in/large2.off") != 0, 30000);
    const QList<pid_t> children = batch.children();
    if (isDeaf) ::kill(children.front(), SIGSTOP);
    batch.send(signal);
    const Ran ran = batch.finish();
    QCOMPARE(ran.code, 130);
    QCOMPARE(ran.err, QByteArray("handwheel: Cancelled after 1 of 5 files. Run again with --resume to do the rest.\n"));
    for (pid_t child : children) QVERIFY(isGone(child));
    QCOMPARE(QDir(fixture.path() + "/out").entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
             (QStringList{"a.off", "large1.off", "repair-report.json"}));
    QCOMPARE(fixture.content("out/large1.off"), QByteArray("what was there before"));
    QCOMPARE(states(fixture.json("out/repair-report.json")), QStringList{"in/a.off closed"});
    if (!test::withLargeInputs()) {  // The rest need not be large
      for (const char* name : {"in/large1.off", "in/large2.off"}) putInto(fixture, name, cube().off());
    }
    const Ran next = fixture.run({"repair", "in", "-o", "out", "-j", "2", "--resume"});
    QVERIFY(next.code == 0 || next.code == 2);
    QCOMPARE(next.out.count("done before"), 1);
  }

  // A program that is ended without a word takes its processes with it.
  void endedBatchLeavesNoProcess_data() {
    QTest::addColumn<int>("signal");
    for (int signal : {SIGKILL, SIGQUIT, SIGPIPE, SIGSEGV}) QTest::newRow(strsignal(signal)) << signal;
  }
  void endedBatchLeavesNoProcess() {
    QFETCH(int, signal);
    const Fixture fixture;
    for (const char* name : {"in/large1.off", "in/large2.off"}) putInto(fixture, name, largeTube());
    putInto(fixture, "out/large1.off", "what was there before");
    Batch batch(fixture, {"in", "-o", "out", "-j", "2"});
    QTRY_VERIFY_WITH_TIMEOUT(batch.childFor("in/large1.off") != 0 && batch.childFor("in/large2.off") != 0, 30000);
    const QList<pid_t> children = batch.children();
    batch.send(signal);
    QCOMPARE(batch.finish().code, -1);
    for (pid_t child : children) QTRY_VERIFY(isGone(child));
    QCOMPARE(QDir(fixture.path() + "/out").entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
             QStringList{"large1.off"});
    QCOMPARE(fixture.content("out/large1.off"), QByteArray("what was there before"));
  }
};

HANDWHEEL_TEST(BatchProcessesTest)
#include "BatchProcessesTest.moc"
