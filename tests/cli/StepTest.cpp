// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "BuildPaths.h"
#include "Program.h"
#include "TestClass.h"

#include <QTest>
#include <cmath>
#include <csignal>

using namespace handwheel;

namespace {

// A fixture with a bar of 40 x 100 mm as bar.step.
struct StepFixture : Fixture {
  StepFixture() {
    if (run({"new", "workpiece", "diameter=40", "length=100", "-o", "bar.handwheel"}).code != 0 ||
        run({"convert", "bar.handwheel", "bar.step"}).code != 0)
      qFatal("there is no bar");
  }
};

// Replaces the reading process by a script.
void replaceReader(const Fixture& fixture, const QByteArray& script) {
  fixture.put("step", "#!/bin/sh\n" + script + "\n");
  QFile::setPermissions(fixture.path() + "/step", QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  qputenv("HANDWHEEL_READERS", fixture.path().toUtf8());
}

bool isRunning(const QByteArray& mark) {
  for (const QString& name : QDir("/proc").entryList(QDir::Dirs)) {
    QFile words("/proc/" + name + "/cmdline");
    if (name.toInt() != 0 && words.open(QIODevice::ReadOnly) && words.readAll().contains(mark)) return true;
  }
  return false;
}

}  // namespace

// STEP files as meshes.
class StepTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { qunsetenv("HANDWHEEL_READERS"); }

  void inspected() {
    const StepFixture fixture;
    const Ran ran = fixture.run({"inspect", "--json", "bar.step"});
    QVERIFY2(ran.code == 0, ran.err);
    const nlohmann::json mesh = nlohmann::json::parse(ran.out.toStdString());
    QVERIFY(mesh["closed"].get<bool>() && mesh["manifold"].get<bool>());
    const double exact = M_PI * 400 * 100, area = M_PI * (40 * 100 + 2 * 400), skin = 2e-4 * std::hypot(40, 40, 100);
    const double volume = mesh["volume_mm3"].get<double>();
    QVERIFY(volume < exact && volume > exact - area * skin);
    QVERIFY2(ran.err.contains("exact surfaces and no mesh") && ran.err.contains("0.023 mm"), ran.err);
  }

  void becomesAMesh() {
    const StepFixture fixture;
    for (const char* out : {"bar.stl", "bar.ply", "mesh.handwheel"}) {
      const Ran ran = fixture.run({"convert", "bar.step", out});
      QVERIFY2(ran.code == 0, ran.err);
      QVERIFY(ran.err.contains("Not kept: exact surfaces."));
    }
    const Ran repaired = fixture.run({"repair", "bar.step", "-o", "repaired.stl"});
    QVERIFY2(repaired.code == 0, repaired.err);
    const Ran back = fixture.run({"convert", "bar.step", "other.step"});
    QCOMPARE(back.code, 1);
    QVERIFY2(back.err.contains("ends in .stl, .ply, .obj, .off, .3mf or .handwheel."), back.err);
    QVERIFY(!fixture.names().contains("other.step"));
  }

  void deathsOfTheReaderAreErrorsOfTheFile_data() {
    QTest::addColumn<QByteArray>("script");
    QTest::addColumn<QByteArray>("reason");
    QTest::newRow("killed") << QByteArray("kill -KILL $$")
                            << QByteArray("the system ended it; it may have run out of memory");
    QTest::newRow("crashed") << QByteArray("kill -SEGV $$") << QByteArray("it crashed on this file");
    QTest::newRow("no answer") << QByteArray("exit 0") << QByteArray("its answer is not valid");
    QTest::newRow("failed") << QByteArray("exit 1") << QByteArray("its answer is not valid");
    QTest::newRow("garbage") << QByteArray("cat /proc/self/maps; printf c") << QByteArray("its answer is not valid");
  }
  void deathsOfTheReaderAreErrorsOfTheFile() {
    QFETCH(QByteArray, script);
    QFETCH(QByteArray, reason);
    const StepFixture fixture;
    replaceReader(fixture, script);
    const Ran ran = fixture.run({"inspect", "bar.step"});
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.startsWith("handwheel: bar.step: the library Open CASCADE failed (" + reason + ")."), ran.err);
    QVERIFY2(ran.err.contains("Export the model in another way or another format."), ran.err);
  }

  void aReaderThatIsNotInstalled() {
    const StepFixture fixture;
    qputenv("HANDWHEEL_READERS", "/no/such/folder");
    const Ran ran = fixture.run({"inspect", "bar.step"});
    QCOMPARE(ran.code, 1);
    QVERIFY2(ran.err.contains("bar.step: ") && ran.err.contains("its process cannot be started"), ran.err);
  }

  // The key that ends a command ends its reader, and so does a kill that nobody can hear.
  void interrupted_data() {
    QTest::addColumn<int>("signal");
    QTest::newRow("a key") << SIGINT;
    QTest::newRow("killed") << SIGKILL;
  }
  void interrupted() {
    QFETCH(int, signal);
    const StepFixture fixture;
    replaceReader(fixture, "exec sleep 98765.4321");
    QProcess process;
    process.setWorkingDirectory(fixture.path());
    process.start(test::programPath(), {"convert", "bar.step", "out.stl"});
    QTRY_VERIFY_WITH_TIMEOUT(isRunning("98765.4321"), 30000);
    ::kill(static_cast<pid_t>(process.processId()), signal);
    QVERIFY(process.waitForFinished());
    if (signal == SIGINT) QCOMPARE(process.exitCode(), 130);
    QTRY_VERIFY(!isRunning("98765.4321"));
    QVERIFY(!fixture.names().contains("out.stl"));
  }
};

HANDWHEEL_TEST(StepTest)
#include "StepTest.moc"
