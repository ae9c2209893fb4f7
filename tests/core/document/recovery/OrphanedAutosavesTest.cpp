// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "../RecoveryChecks.h"
#include "TestClass.h"
#include "document/container/ArchiveErrors.h"

#include <rapidcheck.h>
#include <chrono>

using namespace handwheel;
using namespace handwheel::test;

class OrphanedAutosavesTest : public QObject {
  Q_OBJECT

 private slots:
  void twoWindowsDoNotOfferTheSame() {
    QTemporaryDir folder;
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, kInfo, containerOf("one")));
    }
    const OrphanedAutosaves first(rootIn(folder));
    RecoverySession second(rootIn(folder));
    QVERIFY(second.store(1, kInfo, containerOf("two")));
    QCOMPARE(first.found().size(), std::size_t{1});
    QVERIFY(contentsIn(rootIn(folder)).empty());
  }

  // A session in use is found later, after it has ended.
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

  // Saved after the autosave, changed again, and killed before the next one.
  void autosavesOlderThanTheFile() {
    QTemporaryDir folder;
    const auto file = std::filesystem::path(folder.filePath("a.handwheel").toStdString());
    put(file, "x");
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, {"id", file.string(), "a", "mesh"}, containerOf("one")));
    }
    const auto isOutdated = [&] { return OrphanedAutosaves(rootIn(folder)).found().at(0).isOutdated; };
    const auto now = std::filesystem::file_time_type::clock::now();
    std::filesystem::last_write_time(file, now - std::chrono::hours(1));
    QVERIFY(!isOutdated());
    std::filesystem::last_write_time(file, now + std::chrono::hours(1));
    QVERIFY(isOutdated());
    std::filesystem::remove(file);
    QVERIFY(!isOutdated());
    std::filesystem::create_directory(file);  // a folder of images: its time is that of the last file added to it
    std::filesystem::last_write_time(file, now + std::chrono::hours(1));
    QVERIFY(!isOutdated());
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
      const OrphanedAutosaves leftovers(rootIn(folder));
      for (const OrphanedAutosave& leftover : leftovers.found())
        if (contentOf(leftover) == "one") leftovers.discard(leftover);
    }
    QVERIFY(contentsIn(rootIn(folder)) == Strings{"two"});
    {
      const OrphanedAutosaves leftovers(rootIn(folder));
      leftovers.discard(leftovers.found().at(0));
    }
    QVERIFY(std::filesystem::is_empty(rootIn(folder)));
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
      const OrphanedAutosaves leftovers(rootIn(folder));
      QCOMPARE(leftovers.found().size(), std::size_t{2});
      for (const OrphanedAutosave& leftover : leftovers.found())
        QVERIFY(leftover.info == (contentOf(leftover) == "3" ? kInfo : AutosaveInfo()));
      QCOMPARE(leftovers.skipped().size(), std::size_t{2});
      for (const Error& error : leftovers.skipped()) {
        QVERIFY(error.code == ArchiveError::EntryDamaged);
        QVERIFY(std::filesystem::exists(error.subject));
      }
    }
    QVERIFY(contentsIn(rootIn(folder)) == (Strings{"2", "3"}));
    {
      const OrphanedAutosaves leftovers(rootIn(folder));
      QCOMPARE(leftovers.skipped().size(), std::size_t{2});
      leftovers.discardSkipped();
    }
    QVERIFY(OrphanedAutosaves(rootIn(folder)).skipped().empty());
    QVERIFY(contentsIn(rootIn(folder)) == (Strings{"2", "3"}));
  }

  // Between creating its folder and locking it a session looks like a dead one, except for the name.
  void aSessionThatBeginsIsNoLeftover() {
    QTemporaryDir folder;
    std::filesystem::create_directories(rootIn(folder) / ".new");
    put(rootIn(folder) / "a file", "x");
    QVERIFY(contentsIn(rootIn(folder)).empty());
    QVERIFY(std::filesystem::exists(rootIn(folder) / ".new"));
  }

  void infoReadsBackTheSame() {
    QVERIFY(rc::check([] {
      const auto text = rc::gen::container<std::string>(rc::gen::inRange<char>(1, 127));
      AutosaveInfo info{*text, *rc::gen::arbitrary<std::string>(), *text, *text};
      if (*rc::gen::arbitrary<bool>())
        info.stamp = FileTimestamp{*rc::gen::arbitrary<std::uintmax_t>(), *rc::gen::arbitrary<std::int64_t>()};
      info.isPartial = *rc::gen::arbitrary<bool>();
      RC_ASSERT(recovery::parseInfo(recovery::infoText(info)) == info);
    }));
    QVERIFY(recovery::parseInfo("[1, 2]") == AutosaveInfo());
  }

  // A description written before stamps existed, and one with an invalid stamp.
  void infoWithoutAStamp() {
    const AutosaveInfo old{"id", "/a b.stl", "a b.stl", "mesh"};
    const std::string text = R"("id": "id", "path": "/a b.stl", "name": "a b.stl", "kind": "mesh")";
    for (const char* more : {"", R"(, "stamp": 3, "partial": 1)", R"(, "stamp": {"bytes": -1, "modified_ns": 2})",
                             R"(, "stamp": {"bytes": 1, "modified_ns": "2"})"})
      QVERIFY(recovery::parseInfo("{" + text + more + "}") == old);
  }
};

HANDWHEEL_TEST(OrphanedAutosavesTest)
#include "OrphanedAutosavesTest.moc"
