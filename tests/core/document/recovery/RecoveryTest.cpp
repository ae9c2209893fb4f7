// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../RecoveryChecks.h"
#include "TestClass.h"

#include <sys/resource.h>
#include <QDir>
#include <csignal>
#include <thread>

using namespace handwheel;
using namespace handwheel::test;

class RecoveryTest : public QObject {
  Q_OBJECT

 private slots:
  void aDeadSessionIsFoundALivingOneIsNot() {
    QTemporaryDir folder;
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, kInfo, containerOf("one")));
      QVERIFY(session.store(2, {}, containerOf("two")));
      QVERIFY(contentsIn(rootIn(folder)).empty());
    }
    const OrphanedAutosaves leftovers(rootIn(folder));
    QCOMPARE(leftovers.found().size(), std::size_t{2});
    QVERIFY(leftovers.skipped().empty());
    for (const OrphanedAutosave& leftover : leftovers.found()) {
      const bool isFirst = contentOf(leftover) == "one";
      QVERIFY(leftover.info == (isFirst ? kInfo : AutosaveInfo()));
      QCOMPARE(leftover.bytes, containerOf("one").size());
      QVERIFY(std::abs(leftover.savedAt - QDateTime::currentMSecsSinceEpoch()) < 24 * 3600 * 1000);
    }
  }

  void thereIsNothingAtFirst() {
    QTemporaryDir folder;
    QVERIFY(OrphanedAutosaves(rootIn(folder)).found().empty());
    { RecoverySession session(rootIn(folder)); }
    QVERIFY(!std::filesystem::exists(rootIn(folder)));
  }

  void theNewestCounts() {
    QTemporaryDir folder;
    {
      RecoverySession session(rootIn(folder));
      for (const char* text : {"old", "new", "newest"}) QVERIFY(session.store(1, kInfo, containerOf(text)));
      AutosaveInfo moved = kInfo;
      moved.path = "/elsewhere";
      QVERIFY(session.store(1, moved, containerOf("moved")));
      QVERIFY(session.store(7, kInfo, containerOf("other")));
    }
    QVERIFY(contentsIn(rootIn(folder)) == (Strings{"moved", "other"}));
    const OrphanedAutosaves leftovers(rootIn(folder));
    const auto moved = std::find_if(leftovers.found().begin(), leftovers.found().end(),
                                    [](const OrphanedAutosave& l) { return contentOf(l) == "moved"; });
    QCOMPARE(moved->info.path, "/elsewhere");
  }

  void whatWasSavedIsRemoved() {
    QTemporaryDir folder;
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, kInfo, containerOf("one")));
      QVERIFY(session.store(2, kInfo, containerOf("two")));
      session.remove(1);
      session.remove(3);
    }
    QVERIFY(contentsIn(rootIn(folder)) == Strings{"two"});
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, kInfo, containerOf("one")));
      session.remove(1);
      QVERIFY(session.store(1, kInfo, containerOf("again")));
      session.remove(1);
    }
    QVERIFY(contentsIn(rootIn(folder)) == Strings{"two"});  // and nothing of the second session is left
    QCOMPARE(QDir(folder.path() + "/recovery").entryList(QDir::Dirs | QDir::NoDotAndDotDot | QDir::Hidden).size(), 1);
  }

  // Its job had to wait for others, and the document was closed meanwhile.
  void storedAfterItWasClosed() {
    QTemporaryDir folder;
    {
      RecoverySession session(rootIn(folder));
      session.close(1);
      QVERIFY(session.store(1, kInfo, containerOf("late")));
      QVERIFY(!std::filesystem::exists(rootIn(folder)));
      QVERIFY(session.store(2, kInfo, containerOf("two")));
      QVERIFY(session.store(3, kInfo, containerOf("three")));
      session.close(3);
      QVERIFY(session.store(3, kInfo, containerOf("late")));
    }
    QVERIFY(contentsIn(rootIn(folder)) == Strings{"two"});
  }

  // The document is closed while its autosave is being written.
  void removedWhileItIsStored() {
    QTemporaryDir folder;
    const std::string large = containerOf(std::string(100 << 20, 'x'));
    RecoverySession session(rootIn(folder));
    JobState state;
    std::thread writer([&] { QVERIFY(session.store(1, kInfo, large, Progress(state))); });
    while (state.fraction.load() == 0.0) std::this_thread::yield();
    session.remove(1);
    writer.join();
    const QStringList files = QDir(folder.path() + "/recovery").entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    QCOMPARE(QDir(folder.path() + "/recovery/" + files.at(0)).entryList(QDir::Files), (QStringList{"1.json", "lock"}));
  }

  // The recovered document is open again, and the program dies again before it was saved.
  void adoptedAutosavesStayRecoverable() {
    QTemporaryDir folder;
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, kInfo, containerOf("one")));
    }
    {
      RecoverySession session(rootIn(folder));
      {
        const OrphanedAutosaves leftovers(rootIn(folder));
        QVERIFY(session.adopt(leftovers.found().at(0), 5));
      }
      QVERIFY(contentsIn(rootIn(folder)).empty());
    }
    const OrphanedAutosaves leftovers(rootIn(folder));
    QCOMPARE(leftovers.found().size(), std::size_t{1});
    QCOMPARE(contentOf(leftovers.found()[0]), "one");
    QVERIFY(leftovers.found()[0].info == kInfo);
  }

  // A full disk, simulated by a limit on the file size.
  void aFullDiskLeavesTheOlderAutosave() {
    QTemporaryDir folder;
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, kInfo, containerOf("old")));
      rlimit before{};
      getrlimit(RLIMIT_FSIZE, &before);
      std::signal(SIGXFSZ, SIG_IGN);
      const rlimit limit{4000, before.rlim_max};
      setrlimit(RLIMIT_FSIZE, &limit);
      const Status status = session.store(1, kInfo, containerOf(std::string(5000, 'x')));
      setrlimit(RLIMIT_FSIZE, &before);
      QVERIFY(!status && status.error().code == ErrorCode::WriteFailed);
    }
    QVERIFY(contentsIn(rootIn(folder)) == Strings{"old"});
  }

  void cancelledLeavesTheOlderAutosave() {
    QTemporaryDir folder;
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, kInfo, containerOf("old")));
      JobState state;
      state.cancelled = true;
      const Status status = session.store(1, kInfo, containerOf("new"), Progress(state));
      QVERIFY(!status && status.error().code == ErrorCode::Cancelled);
    }
    QVERIFY(contentsIn(rootIn(folder)) == Strings{"old"});
  }

  // A user removes the folder while the program runs.
  void aFolderThatVanishes() {
    QTemporaryDir folder;
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, kInfo, containerOf("old")));
      std::filesystem::remove_all(rootIn(folder));
      QVERIFY(session.store(1, kInfo, containerOf("new")));
    }
    const OrphanedAutosaves leftovers(rootIn(folder));
    QCOMPARE(leftovers.found().size(), std::size_t{1});
    QCOMPARE(contentOf(leftovers.found()[0]), "new");
    QVERIFY(leftovers.found()[0].info == kInfo);
  }

  void othersCannotLookInside() {
    QTemporaryDir folder;
    RecoverySession session(rootIn(folder));
    QVERIFY(session.store(1, kInfo, containerOf("secret")));
    const auto path = std::filesystem::directory_iterator(rootIn(folder))->path();
    QVERIFY(std::filesystem::status(path).permissions() == std::filesystem::perms::owner_all);
  }

  void placesThatCannotBeWritten() {
    QTemporaryDir folder;
    put(rootIn(folder), "a file where the folder should be");
    RecoverySession session(rootIn(folder));
    const Status status = session.store(1, kInfo, containerOf("one"));
    QVERIFY(!status && status.error().code == ErrorCode::WriteFailed);
    session.remove(1);
  }
};

HANDWHEEL_TEST(RecoveryTest)
#include "RecoveryTest.moc"
