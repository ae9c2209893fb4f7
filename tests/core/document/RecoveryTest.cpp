// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/Recovery.h"

#include "document/Container.h"
#include "document/FileBytes.h"
#include "document/RecoveryLeftovers.h"

#include <rapidcheck.h>
#include <sys/resource.h>
#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <csignal>
#include <thread>

using namespace handwheel;

namespace {

std::filesystem::path rootIn(const QTemporaryDir& folder) {
  return std::filesystem::path(folder.path().toStdString()) / "recovery";
}

std::string containerOf(const std::string& text) {
  Container container;
  container.blobs["note"] = text;
  return *writeContainer(container, Compression::None);
}

const AutosaveInfo kInfo{"id-1", "/parts/caf\xe9/a.handwheel", "a.handwheel", "mesh"};

std::string contentOf(const Leftover& leftover) {
  const auto bytes = readFileBytes(leftover.file);
  if (!bytes) return "unreadable";
  const auto read = readContainer(*bytes);
  return read && read->damage.empty() ? read->container.blobs.at("note") : "damaged";
}

// What the next start of the program would find.
std::vector<std::string> contentsIn(const std::filesystem::path& root) {
  std::vector<std::string> contents;
  const Leftovers leftovers(root);
  for (const Leftover& leftover : leftovers.found()) contents.push_back(contentOf(leftover));
  std::sort(contents.begin(), contents.end());
  return contents;
}

using Strings = std::vector<std::string>;

void put(const std::filesystem::path& path, const QByteArray& bytes) {
  QFile file(QFile::decodeName(path.c_str()));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(bytes);
}

}  // namespace

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
    const Leftovers leftovers(rootIn(folder));
    QCOMPARE(leftovers.found().size(), std::size_t{2});
    QVERIFY(leftovers.skipped().empty());
    for (const Leftover& leftover : leftovers.found()) {
      const bool isFirst = contentOf(leftover) == "one";
      QVERIFY(leftover.info == (isFirst ? kInfo : AutosaveInfo()));
      QCOMPARE(leftover.bytes, containerOf("one").size());
      QVERIFY(std::abs(leftover.savedAt - QDateTime::currentMSecsSinceEpoch()) < 24 * 3600 * 1000);
    }
  }

  void thereIsNothingAtFirst() {
    QTemporaryDir folder;
    QVERIFY(Leftovers(rootIn(folder)).found().empty());
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
    const Leftovers leftovers(rootIn(folder));
    const auto moved = std::find_if(leftovers.found().begin(), leftovers.found().end(),
                                    [](const Leftover& l) { return contentOf(l) == "moved"; });
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

  void twoWindowsDoNotOfferTheSame() {
    QTemporaryDir folder;
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, kInfo, containerOf("one")));
    }
    const Leftovers first(rootIn(folder));
    RecoverySession second(rootIn(folder));
    QVERIFY(second.store(1, kInfo, containerOf("two")));
    QCOMPARE(first.found().size(), std::size_t{1});
    QVERIFY(contentsIn(rootIn(folder)).empty());
  }

  void undecidedStays() {
    QTemporaryDir folder;
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, kInfo, containerOf("one")));
      QVERIFY(session.store(2, kInfo, containerOf("two")));
    }
    for (int start = 0; start < 3; ++start) QVERIFY(contentsIn(rootIn(folder)) == (Strings{"one", "two"}));
    {
      const Leftovers leftovers(rootIn(folder));
      for (const Leftover& leftover : leftovers.found())
        if (contentOf(leftover) == "one") leftovers.discard(leftover);
    }
    QVERIFY(contentsIn(rootIn(folder)) == Strings{"two"});
    {
      const Leftovers leftovers(rootIn(folder));
      leftovers.discard(leftovers.found().at(0));
    }
    QVERIFY(std::filesystem::is_empty(rootIn(folder)));
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
        const Leftovers leftovers(rootIn(folder));
        QVERIFY(session.adopt(leftovers.found().at(0), 5));
      }
      QVERIFY(contentsIn(rootIn(folder)).empty());
    }
    const Leftovers leftovers(rootIn(folder));
    QCOMPARE(leftovers.found().size(), std::size_t{1});
    QCOMPARE(contentOf(leftovers.found()[0]), "one");
    QVERIFY(leftovers.found()[0].info == kInfo);
  }

  // What a full disk does, brought about with a limit on the file size.
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

  void damagedEntriesAreSkippedAndKept() {
    QTemporaryDir folder;
    {
      RecoverySession session(rootIn(folder));
      for (std::uint64_t key : {1, 2, 3}) QVERIFY(session.store(key, kInfo, containerOf(std::to_string(key))));
    }
    std::filesystem::path session = std::filesystem::directory_iterator(rootIn(folder))->path();
    put(session / "1.handwheel", "");
    put(session / "2.json", "{\"path\": 7, \"name\": ");
    put(session / "4.handwheel", "garbage");
    put(session / "5.json", "{}");
    put(session / "6.handwheel.Xa7dAt", "half written");
    {
      const Leftovers leftovers(rootIn(folder));
      QCOMPARE(leftovers.found().size(), std::size_t{2});
      for (const Leftover& leftover : leftovers.found())
        QVERIFY(leftover.info == (contentOf(leftover) == "3" ? kInfo : AutosaveInfo()));
      QCOMPARE(leftovers.skipped().size(), std::size_t{2});
      for (const Error& error : leftovers.skipped()) {
        QVERIFY(error.code == ErrorCode::EntryDamaged);
        QVERIFY(std::filesystem::exists(error.subject));
      }
    }
    QVERIFY(contentsIn(rootIn(folder)) == (Strings{"2", "3"}));
    {
      const Leftovers leftovers(rootIn(folder));
      QCOMPARE(leftovers.skipped().size(), std::size_t{2});
      leftovers.discardSkipped();
    }
    QVERIFY(Leftovers(rootIn(folder)).skipped().empty());
    QVERIFY(contentsIn(rootIn(folder)) == (Strings{"2", "3"}));
  }

  // Somebody cleans up the folder under the program.
  void aFolderThatVanishes() {
    QTemporaryDir folder;
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, kInfo, containerOf("old")));
      std::filesystem::remove_all(rootIn(folder));
      QVERIFY(session.store(1, kInfo, containerOf("new")));
    }
    const Leftovers leftovers(rootIn(folder));
    QCOMPARE(leftovers.found().size(), std::size_t{1});
    QCOMPARE(contentOf(leftovers.found()[0]), "new");
    QVERIFY(leftovers.found()[0].info == kInfo);
  }

  // Between making its folder and locking it a session looks like a dead one, but for the name.
  void aSessionThatBeginsIsNoLeftover() {
    QTemporaryDir folder;
    std::filesystem::create_directories(rootIn(folder) / ".new");
    put(rootIn(folder) / "a file", "x");
    QVERIFY(contentsIn(rootIn(folder)).empty());
    QVERIFY(std::filesystem::exists(rootIn(folder) / ".new"));
  }

  void othersCannotLookInside() {
    QTemporaryDir folder;
    RecoverySession session(rootIn(folder));
    QVERIFY(session.store(1, kInfo, containerOf("secret")));
    const auto path = std::filesystem::directory_iterator(rootIn(folder))->path();
    QVERIFY(std::filesystem::status(path).permissions() == std::filesystem::perms::owner_all);
  }

  void infoReadsBackTheSame() {
    QVERIFY(rc::check([] {
      const auto text = rc::gen::container<std::string>(rc::gen::inRange<char>(1, 127));
      const AutosaveInfo info{*text, *rc::gen::arbitrary<std::string>(), *text, *text};
      RC_ASSERT(recovery::parseInfo(recovery::infoText(info)) == info);
    }));
    QVERIFY(recovery::parseInfo("[1, 2]") == AutosaveInfo());
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

QTEST_APPLESS_MAIN(RecoveryTest)
#include "RecoveryTest.moc"
