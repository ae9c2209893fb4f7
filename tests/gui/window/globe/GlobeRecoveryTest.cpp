// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "GlobeWindow.h"
#include "document/recovery/OrphanedAutosaves.h"
#include "window/documents/DocumentTab.h"
#include "window/documents/DocumentTabs.h"

#include <QProcess>
#include <QStandardPaths>
#include <csignal>

using namespace handwheel;
using namespace handwheel::test;

namespace {

constexpr const char* kVictim = "HANDWHEEL_VICTIM";  // set in the process that is killed

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
    QStandardPaths::setTestModeEnabled(true);
    QSettings().setValue("autosaveSeconds", 600);  // no finished edit waits for that
    if (!qEnvironmentVariableIsSet(kVictim))
      QDir(QString::fromStdString(recoveryFolder().string())).removeRecursively();
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
    QFile expected(qEnvironmentVariable(kVictim));
    const double lowest = globe.lowestShown();
    QVERIFY(expected.open(QIODevice::WriteOnly) && expected.write(QByteArray::number(lowest, 'g', 17)) > 0);
    expected.close();
    press(globe);
    QTRY_VERIFY(globe.lowestShown() < lowest);
    std::raise(SIGKILL);
  }

  void comesBackAfterAKill() {
    if (qEnvironmentVariableIsSet(kVictim)) QSKIP("the process that is killed");
    const QTemporaryDir folder;
    QProcess victim;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(kVictim, folder.filePath("lowest"));
    victim.setProcessEnvironment(environment);
    victim.setProcessChannelMode(QProcess::ForwardedChannels);
    victim.start(QCoreApplication::applicationFilePath(), {"GlobeRecoveryTest", "isKilled"});
    QVERIFY(victim.waitForFinished(120000));
    QCOMPARE(victim.exitStatus(), QProcess::CrashExit);
    QFile lowest(folder.filePath("lowest"));
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
