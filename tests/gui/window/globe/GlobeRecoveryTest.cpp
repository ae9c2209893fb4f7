// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "GlobeWindow.h"
#include "document/recovery/OrphanedAutosaves.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"

#include <QProcess>
#include <csignal>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// Set in the process that is killed: the folder of data of the one that looks at what it left.
constexpr const char* kVictim = "HANDWHEEL_VICTIM";
constexpr const char* kDataFolder = "XDG_DATA_HOME";
constexpr const char* kLowest = "lowest";  // the file in it with the height of the surface at the kill, in mm

// The paths of the autosaves.
QStringList autosaves() {
  const QDir root(QString::fromStdString(recoveryFolder().string()));
  QStringList paths;
  for (const QString& session : root.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
    const QDir folder(root.filePath(session));
    for (const QString& name : folder.entryList({"*.handwheel"}, QDir::Files)) paths << folder.filePath(name);
  }
  return paths;
}
bool isAutosaved() {
  return !autosaves().isEmpty();
}

// Waits for the autosave of all that was done, and removes it.
bool forgetAutosave(GlobeWindow& globe) {
  const DocumentTab* tab = globe.driver.find<DocumentTabs>("tabRow")->current();
  const auto isThere = [tab] { return tab->autosaved == tab->document.revision() && isAutosaved(); };
  return QTest::qWaitFor(isThere, 30000) && QFile::remove(autosaves().constFirst());
}

void press(GlobeWindow& globe) {
  QTest::mousePress(globe.view, Qt::LeftButton, {}, globe.view->rect().center());
}

}  // namespace

// A process with a globe is killed in the middle of a gesture; what it had done before comes back.
class GlobeRecoveryTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    QSettings().setValue("autosaveSeconds", 600);  // no finished edit waits for that
    if (qEnvironmentVariableIsSet(kVictim)) qputenv(kDataFolder, qgetenv(kVictim));
  }

  // Runs in a process of its own: radius 33 and a dent, which is autosaved by itself; then a gesture without an end.
  void isKilled() {
    if (!qEnvironmentVariableIsSet(kVictim)) QSKIP("only in a process of its own");
    GlobeWindow globe;
    QVERIFY(globe.begin("dentTool", StandardView::Top));
    globe.driver.edit("radius", "33");
    QVERIFY(globe.look(StandardView::Top));
    QVERIFY(forgetAutosave(globe));
    press(globe);
    QTRY_VERIFY(globe.lowestShown() < 32.5);
    QTest::mouseRelease(globe.view, Qt::LeftButton, {}, globe.view->rect().center());
    QCOMPARE(globe.document().history()->count(), 2);
    QVERIFY(QTest::qWaitFor(isAutosaved, 30000));
    QFile expected(QDir(qEnvironmentVariable(kVictim)).filePath(kLowest));
    const double lowest = globe.lowestShown();
    QVERIFY(expected.open(QIODevice::WriteOnly) && expected.write(QByteArray::number(lowest, 'g', 17)) > 0);
    expected.close();
    press(globe);
    QTRY_VERIFY(globe.lowestShown() < lowest);
    std::raise(SIGKILL);
  }

  void comesBackAfterAKill() {
    if (qEnvironmentVariableIsSet(kVictim)) QSKIP("the process that is killed");
    const QString folder = qEnvironmentVariable(kDataFolder);
    QProcess victim;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(kVictim, folder);
    victim.setProcessEnvironment(environment);
    victim.setProcessChannelMode(QProcess::ForwardedChannels);
    victim.start(QCoreApplication::applicationFilePath(), {"GlobeRecoveryTest", "isKilled"});
    QVERIFY(victim.waitForFinished(120000));
    QCOMPARE(victim.exitStatus(), QProcess::CrashExit);
    QFile lowest(QDir(folder).filePath(kLowest));
    QVERIFY(lowest.open(QIODevice::ReadOnly));

    GlobeWindow globe;
    QCOMPARE(globe.driver.tabs(), 0);
    globe.driver.window().offerRecovery();
    globe.driver.click("messageAction");
    QVERIFY(QTest::qWaitFor([&] { return globe.driver.tabs() == 1; }, kPatienceMs));
    QVERIFY(globe.driver.settle());
    QCOMPARE(globe.driver.text("figures"), QStringLiteral("33"));
    QCOMPARE(globe.lowestShown(), lowest.readAll().toDouble());
    QVERIFY(globe.driver.window().isWindowModified());
  }
};

HANDWHEEL_WINDOW_TEST(GlobeRecoveryTest)
#include "GlobeRecoveryTest.moc"
