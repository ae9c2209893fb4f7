// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/recovery/ProcessMark.h"

#include "../RecoveryChecks.h"
#include "TestClass.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

using namespace handwheel;
using namespace handwheel::test;

namespace {

// A process of its own that does nothing until it is killed. It has the descriptors of this one that exec would close.
pid_t idleProcess() {
  const pid_t process = ::fork();
  if (process == 0) {
    for (;;) ::pause();
  }
  return process;
}

// The mark of another process than this: what differs are its number, and when it began.
std::string markOf(pid_t process) {
  QFile file(QStringLiteral("/proc/%1/stat").arg(process));
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QByteArray line = file.readAll();
  const QList<QByteArray> fields = line.mid(line.lastIndexOf(')') + 2).split(' ');
  const std::string own = ownProcessMark(), place = own.substr(0, own.find(' ', own.find(' ') + 1));
  return place + ' ' + std::to_string(process) + ' ' + fields.at(19).toStdString();  // the 22nd of all
}

}  // namespace

// Whether whoever has a lock can still do anything.
class ProcessMarkTest : public QObject {
  Q_OBJECT

 private slots:
  void thisProcessGoesOn() {
    QVERIFY(!ownProcessMark().empty());
    QCOMPARE(ownProcessMark(), markOf(::getpid()));
    QVERIFY(!isProcessOver(ownProcessMark()));
  }

  // Killed and not yet gone: nobody has waited for it, so the system still lists it.
  void aKilledProcessIsOver() {
    const pid_t process = idleProcess();
    QVERIFY(process > 0);
    const std::string mark = markOf(process);
    QVERIFY(!isProcessOver(mark));
    QCOMPARE(::kill(process, SIGKILL), 0);
    siginfo_t ended{};
    QCOMPARE(::waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOWAIT), 0);
    QVERIFY(isProcessOver(mark));
    QCOMPARE(::waitpid(process, nullptr, 0), process);
    QVERIFY(isProcessOver(mark));  // and gone
  }

  // What is of another start of the computer, or no mark, says nothing.
  void anotherPlaceIsNotKnown() {
    const std::string own = ownProcessMark();
    const std::string withoutBeginning = own.substr(0, own.rfind(' ')), bootAlone = own.substr(0, own.find(' '));
    for (const std::string& mark : {std::string(), std::string("x"), "x" + own, withoutBeginning, bootAlone})
      QVERIFY2(!isProcessOver(mark), mark.c_str());
    QVERIFY(isProcessOver(own + "7"));  // its number has another process since
  }

  // A killed program whose lock is still held, as the system has not let go of its files, is found at the first start.
  void aLockOfTheDeadIsTaken() {
    const QTemporaryDir folder;
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, kInfo, containerOf("one")));
    }
    const std::filesystem::path session = std::filesystem::directory_iterator(rootIn(folder))->path();
    const pid_t process = idleProcess();
    const std::string mark = markOf(process);
    QCOMPARE(::kill(process, SIGKILL), 0);
    QCOMPARE(::waitpid(process, nullptr, 0), process);
    put(session / RecoveryLock::kFileName, QByteArray::fromStdString(mark));
    const int held = ::open((session / RecoveryLock::kFileName).c_str(), O_RDWR | O_CLOEXEC);
    QVERIFY(held >= 0 && ::flock(held, LOCK_EX | LOCK_NB) == 0);
    {
      const OrphanedAutosaves first(rootIn(folder));
      QCOMPARE(first.found().size(), std::size_t{1});
      QVERIFY(first.inUse().empty());
      const OrphanedAutosaves second(rootIn(folder));  // the first has it now
      QVERIFY(second.found().empty());
      QVERIFY(second.inUse() == std::vector{session});
    }
    QCOMPARE(contentsIn(rootIn(folder)), Strings{"one"});
    ::close(held);
    QCOMPARE(contentsIn(rootIn(folder)), Strings{"one"});
  }

  // What another has in use now is found by who looks at it again.
  void foundWhenItIsLeft() {
    const QTemporaryDir folder;
    std::vector<std::filesystem::path> inUse;
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, kInfo, containerOf("one")));
      inUse = OrphanedAutosaves(rootIn(folder)).inUse();
      QCOMPARE(inUse.size(), std::size_t{1});
      QVERIFY(OrphanedAutosaves::of(inUse).found().empty());
    }
    QCOMPARE(OrphanedAutosaves::of(inUse).found().size(), std::size_t{1});
    QVERIFY(OrphanedAutosaves::of({}).found().empty());
  }
};

HANDWHEEL_TEST(ProcessMarkTest)
#include "ProcessMarkTest.moc"
