// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "Program.h"
#include "Shapes.h"
#include "TestClass.h"

#include <QStandardPaths>
#include <QTest>
#include <csignal>
#include <cstring>

using namespace handwheel;

namespace {

// A closed torus of 2 n² triangles.
QByteArray torusOf(int n) {
  const auto at = [n](int x, int y) {
    const double u = 2 * M_PI * x / n, v = 2 * M_PI * y / n;
    const double r = 3 + std::cos(v);
    return std::array<double, 3>{r * std::cos(u), r * std::sin(u), std::sin(v)};
  };
  return grid(n, n, at, [](int, int) { return false; }).off();
}

// A torus fine enough to keep the program busy for seconds with text to read and pairs to test.
const QByteArray& largeTorus() {
  static const QByteArray torus = torusOf(600);
  return torus;
}

// Returns the environment without a display, so that the program starts one.
QProcessEnvironment environmentToDraw() {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.remove("DISPLAY");
  return environment;
}

// Those whose environment has this in it.
QList<int> processesWith(const QString& words) {
  QList<int> found;
  for (const QString& name : QDir("/proc").entryList(QDir::Dirs)) {
    if (name.toInt() == 0) continue;
    QFile environment("/proc/" + name + "/environ");
    if (environment.open(QIODevice::ReadOnly) && environment.readAll().contains(words.toUtf8())) found << name.toInt();
  }
  return found;
}

}  // namespace

class InterruptTest : public QObject {
  Q_OBJECT

 private slots:
  // aDisplayRunnerThatMissedItsDisplay() waits for this at the end: the program wakes its display runner after 5 s.
  void initTestCase() {
    const QString sleeping = QStandardPaths::findExecutable("sleep");
    if (sleeping.isEmpty()) return;
    m_missed.put("a.off", torusOf(8));
    QVERIFY(QDir(m_missed.path()).mkdir("bin"));
    QVERIFY(QFile::copy(sleeping, m_missed.path() + "/bin/Xvfb"));
    m_missed.put("bin/xvfb-run", "#!/bin/sh\ntrap : USR1\nXvfb 60 &\ndisplay=$!\nwait\nkill $display\necho went on\n");
    QVERIFY(QFile::setPermissions(m_missed.path() + "/bin/xvfb-run", QFile::ReadOwner | QFile::ExeOwner));
    QProcessEnvironment environment = environmentToDraw();
    environment.insert("PATH", m_missed.path() + "/bin:" + environment.value("PATH"));
    m_missing.setProcessEnvironment(environment);
    m_missing.setWorkingDirectory(m_missed.path());
    m_missing.start(test::programPath(), {"picture", "a.off", "p.png"});
    QVERIFY(m_missing.waitForStarted());
  }

  void endsAndLeavesNothing_data() {
    QTest::addColumn<int>("signal");
    QTest::addColumn<int>("times");
    QTest::newRow("SIGINT") << SIGINT << 1;
    QTest::newRow("SIGTERM") << SIGTERM << 1;
    QTest::newRow("SIGHUP") << SIGHUP << 1;
    QTest::newRow("impatient") << SIGINT << 3;
  }
  void endsAndLeavesNothing() {
    QFETCH(int, signal);
    QFETCH(int, times);
    const Fixture fixture;
    fixture.put("a.off", largeTorus());
    fixture.put("old.stl", "what was there before");
    QProcess process;
    process.setWorkingDirectory(fixture.path());
    process.start(test::programPath(), {"repair", "a.off", "-o", "old.stl", "--report", "r.json"});
    QVERIFY(process.waitForStarted());
    QTRY_VERIFY(catches(process.processId(), signal));
    QTest::qWait(200);  // into the middle of the work
    for (int i = 0; i < times && process.state() == QProcess::Running; ++i) {
      ::kill(static_cast<pid_t>(process.processId()), signal);
      QTest::qWait(20);
    }
    QVERIFY(process.state() == QProcess::NotRunning || process.waitForFinished());
    QCOMPARE(process.exitStatus(), QProcess::NormalExit);
    QCOMPARE(process.exitCode(), 130);
    QCOMPARE(process.readAllStandardError(), QByteArray("handwheel: Cancelled.\n"));
    QCOMPARE(process.readAllStandardOutput(), QByteArray());
    QCOMPARE(fixture.names(), (QStringList{"a.off", "old.stl"}));
    QCOMPARE(fixture.content("old.stl"), QByteArray("what was there before"));
  }

  // Also while it draws: the program that draws under xvfb-run ends with the one that was asked. A picture that is
  // there was a success.
  void noPictureComesLater_data() {
    QTest::addColumn<int>("milliseconds");
    for (int wait : {100, 700, 1300}) QTest::addRow("%d ms", wait) << wait;
  }
  void noPictureComesLater() {
    if (QStandardPaths::findExecutable("xvfb-run").isEmpty()) QSKIP("xvfb-run is not installed");
    QFETCH(int, milliseconds);
    const Fixture fixture;
    fixture.put("a.off", largeTorus());
    QProcess process;
    QProcessEnvironment environment = environmentToDraw();
    environment.insert("RUN_OF_TEST", fixture.path());
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(fixture.path());
    process.start(test::programPath(), {"picture", "a.off", "p.png"});
    QVERIFY(process.waitForStarted());
    QTRY_VERIFY(catches(process.processId(), SIGTERM));
    QTest::qWait(milliseconds);
    process.terminate();
    QVERIFY(process.state() == QProcess::NotRunning || process.waitForFinished(kLongestRun));
    // Until nothing is left that could still draw.
    QTRY_COMPARE_WITH_TIMEOUT(processesWith(fixture.path()), QList<int>(), 30000);
    const bool isDone = process.exitCode() == 0;  // it was quicker than that
    QCOMPARE(fixture.names(), isDone ? (QStringList{"a.off", "p.png"}) : QStringList{"a.off"});
    if (!isDone) QCOMPARE(process.exitCode(), 130);
    const QByteArray printed = process.readAllStandardError();
    QVERIFY2(printed.isEmpty() || printed == "handwheel: Cancelled.\n", printed);
  }

  // Neither processes nor files, also when the program has no time to end them.
  void drawingLeavesNothing_data() {
    QTest::addColumn<int>("signal");
    QTest::addColumn<bool>("isDrawing");
    for (int signal : {SIGTERM, SIGHUP, SIGKILL}) {
      QTest::addRow("%s, display starts", strsignal(signal)) << signal << false;
      QTest::addRow("%s, picture begun", strsignal(signal)) << signal << true;
    }
  }
  void drawingLeavesNothing() {
    if (QStandardPaths::findExecutable("xvfb-run").isEmpty()) QSKIP("xvfb-run is not installed");
    QFETCH(int, signal);
    QFETCH(bool, isDrawing);
    const Fixture fixture;
    fixture.put("a.off", largeTorus());
    QVERIFY(QDir(fixture.path()).mkdir("tmp"));
    const QString mark = fixture.path() + "/tmp";
    QProcess process;
    QProcessEnvironment environment = environmentToDraw();
    environment.insert("TMPDIR", mark);
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(fixture.path());
    process.start(test::programPath(), {"picture", "a.off", "p.png"});
    QVERIFY(process.waitForStarted());
    const int count = isDrawing ? 4 : 2;  // with the shell; with the display and the one that draws
    bool wereThere = false;               // a quick picture may be done when they are counted again
    QTRY_VERIFY_WITH_TIMEOUT(wereThere = wereThere || processesWith(mark).size() >= count, 30000);
    ::kill(static_cast<pid_t>(process.processId()), signal);
    QVERIFY(process.waitForFinished(kLongestRun));
    if (signal != SIGKILL) QCOMPARE(process.exitCode(), 130);
    QTRY_COMPARE_WITH_TIMEOUT(processesWith(mark), QList<int>(), 30000);
    QCOMPARE(fixture.names(), (QStringList{"a.off", "tmp"}));
    QCOMPARE(QDir(mark).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot), QStringList());
  }

  // Progress is for people at a terminal, who would see it after 20 ms.
  void quietInAPipe() {
    const Fixture fixture;
    fixture.put("a.off", torusOf(100));
    QCOMPARE(fixture.run({"repair", "a.off", "-o", "b.stl"}).err.count('\r'), 0);
  }

  // On a busy machine xvfb-run may miss that its display has started: one that always does.
  void aDisplayRunnerThatMissedItsDisplay() {
    if (m_missing.program().isEmpty()) QSKIP("sleep is not installed");
    QVERIFY(m_missing.state() == QProcess::NotRunning || m_missing.waitForFinished(kLongestRun));
    QCOMPARE(m_missing.exitStatus(), QProcess::NormalExit);
    QCOMPARE(m_missing.readAllStandardOutput(), QByteArray("went on\n"));
  }

 private:
  const Fixture m_missed;
  QProcess m_missing;  // its xvfb-run misses that the display has started
};

HANDWHEEL_TEST(InterruptTest)
#include "InterruptTest.moc"
