// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../Program.h"
#include "../Shapes.h"
#include "BuildPaths.h"
#include "TestClass.h"

#include <sys/stat.h>
#include <unistd.h>
#include <QStandardPaths>
#include <QTest>
#include <QtEndian>

using namespace handwheel;
using Json = nlohmann::json;

class RepairFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void outputMayBeTheInput() {
    const Fixture fixture;
    fixture.put("a.off", openCube().off());
    QCOMPARE(fixture.run({"repair", "a.off", "-o", "a.off"}).code, 0);
    QVERIFY(Json::parse(fixture.run({"inspect", "a.off", "--json"}).out.toStdString()).at("closed").get<bool>());
    QCOMPARE(fixture.names(), QStringList{"a.off"});
  }

  void missingFolder() {
    const Fixture fixture;
    fixture.put("a.off", openCube().off());
    const Ran ran = fixture.run({"repair", "a.off", "-o", "no/such/b.stl"});
    QCOMPARE(ran.code, 1);
    QVERIFY(ran.err.startsWith("handwheel: no/such/b.stl: "));
    QVERIFY(ran.err.contains("No such file or directory"));
    QCOMPARE(fixture.names(), QStringList{"a.off"});
  }

  void readOnlyFolder() {
    if (geteuid() == 0) QSKIP("the superuser may write everywhere");
    const Fixture fixture;
    fixture.put("a.off", openCube().off());
    QCOMPARE(chmod(fixture.path().toLocal8Bit(), 0500), 0);
    const Ran ran = fixture.run({"repair", "a.off", "-o", "b.stl"});
    QCOMPARE(chmod(fixture.path().toLocal8Bit(), 0700), 0);
    QCOMPARE(ran.code, 1);
    QVERIFY(ran.err.contains("Permission denied"));
    QCOMPARE(fixture.names(), QStringList{"a.off"});
  }

  void unknownEndingIsReportedBeforeTheWork() {
    const Fixture fixture;
    const Ran ran = fixture.run({"repair", "none.stl", "-o", "b.docx"});
    QCOMPARE(ran.code, 1);
    QVERIFY(ran.err.contains(".docx"));
  }

  // Without a display and without xvfb-run there is no picture, but the repair is done.
  void noPictureIsNoFailure() {
    const Fixture fixture;
    fixture.put("a.off", openCube().off());
    QProcess process;
    QProcessEnvironment environment = environmentWith("C");
    environment.remove("DISPLAY");
    environment.insert("PATH", fixture.path());
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(fixture.path());
    process.start(test::programPath(), {"repair", "a.off", "-o", "b.stl", "--screenshot", "s.png"});
    QVERIFY(process.waitForFinished());
    QCOMPARE(process.exitCode(), 0);
    QCOMPARE(process.readAllStandardError(),
             QByteArray("handwheel: No picture was made: there is no display, and xvfb-run is not installed.\n"));
    QCOMPARE(fixture.names(), (QStringList{"a.off", "b.stl"}));
  }

  void picture() {
    if (QStandardPaths::findExecutable("xvfb-run").isEmpty()) QSKIP("xvfb-run is not installed");
    const Fixture fixture;
    fixture.put("a.off", openCube().off());
    QProcess process;
    QProcessEnvironment environment = environmentWith("C");
    environment.remove("DISPLAY");
    process.setProcessEnvironment(environment);
    process.setWorkingDirectory(fixture.path());
    process.start(test::programPath(), {"repair", "a.off", "-o", "b.stl", "--screenshot", "s.png"});
    QVERIFY(process.waitForFinished(120000));
    QCOMPARE(process.exitCode(), 0);
    // A PNG begins with its signature and the header chunk with width and height, big-endian.
    const QByteArray png = fixture.content("s.png");
    QVERIFY(png.startsWith("\x89PNG\r\n\x1a\n"));
    QCOMPARE(qFromBigEndian<quint32>(png.constData() + 16), 1280u);
    QCOMPARE(qFromBigEndian<quint32>(png.constData() + 20), 800u);
    QCOMPARE(fixture.names(), (QStringList{"a.off", "b.stl", "s.png"}));
  }
};

HANDWHEEL_TEST(RepairFilesTest)
#include "RepairFilesTest.moc"
