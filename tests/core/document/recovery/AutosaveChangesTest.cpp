// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/recovery/AutosaveChanges.h"

#include "../RecoveryChecks.h"
#include "TestClass.h"

#include <rapidcheck.h>
#include <nlohmann/json.hpp>

using namespace handwheel;
using namespace handwheel::test;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

// An image that never changes, and a small part that does.
Container document(int version) {
  Container container;
  (*container.manifest)["kind"] = "volume";
  (*container.manifest)["version"] = version;
  for (int i = 0; i < 20; ++i) container.blobs["scan/" + std::to_string(i)] = std::string(10'000, static_cast<char>(i));
  container.blobs["note"] = std::to_string(version);
  return container;
}

// Returns the recovered container of the only autosave.
std::optional<Container> recovered(const QTemporaryDir& folder) {
  const OrphanedAutosaves leftovers(rootIn(folder));
  if (leftovers.found().size() != 1) return {};
  const fs::path file = leftovers.found()[0].file;
  if (!joinChanges(file) || fs::exists(recovery::changesFile(file))) return {};
  const auto bytes = readFileBytes(file);
  auto read = bytes ? readContainer(*bytes) : Result<ReadContainer>(bytes.error());
  if (!read || !read->damage.empty()) return {};
  read->container.manifest->erase("handwheel");
  return std::move(read->container);
}

bool same(const Container& a, const Container& b) {
  return *a.manifest == *b.manifest && a.blobs == b.blobs;
}

fs::path fileIn(const QTemporaryDir& folder, const char* name) {
  return fs::directory_iterator(rootIn(folder))->path() / name;
}

}  // namespace

class AutosaveChangesTest : public QObject {
  Q_OBJECT

 private slots:
  // Stores, removes and enlarges autosaves in any order: the last stored one is recovered.
  void theLastIsRecovered() {
    QVERIFY(rc::check([] {
      QTemporaryDir folder;
      Container container = document(0);
      bool isThere = false;
      {
        RecoverySession session(rootIn(folder));
        const int steps = *rc::gen::inRange(1, 12);
        for (int i = 0; i < steps; ++i) {
          const int what = *rc::gen::inRange(0, 8);
          if (what == 0) {
            session.remove(1);
            isThere = false;
            continue;
          }
          (*container.manifest)["version"] = i;
          const std::string name = "scan/" + std::to_string(*rc::gen::inRange(0, 25));
          if (what == 1) container.blobs.erase(name);
          if (what == 2) container.blobs[name] = std::string(20'000, static_cast<char>(*rc::gen::inRange(0, 100)));
          if (what == 3)
            for (auto& [each, bytes] : container.blobs) bytes += "more";
          if (what > 3) container.blobs["note"] = std::to_string(i);
          RC_ASSERT(session.store(1, kInfo, container).hasValue());
          isThere = true;
        }
      }
      const std::optional<Container> back = recovered(folder);
      RC_ASSERT(back.has_value() == isThere);
      if (back) RC_ASSERT(same(*back, container));
    }));
  }

  // A small change writes a small file; the large one stays as it is on the disk.
  void onlyChangesAreWritten() {
    QTemporaryDir folder;
    RecoverySession session(rootIn(folder));
    QVERIFY(session.store(1, kInfo, document(1)));
    const fs::path whole = fileIn(folder, "1.handwheel"), changes = fileIn(folder, "1.changes");
    QVERIFY(!fs::exists(changes));
    const auto before = readFileBytes(whole);
    for (int version = 2; version < 5; ++version) {
      QVERIFY(session.store(1, kInfo, document(version)));
      QVERIFY(*readFileBytes(whole) == *before);
      QVERIFY(fs::file_size(changes) < fs::file_size(whole) / 20);
    }
    // Half of it is new: it is written as a whole, and the changes are gone.
    Container other = document(5);
    for (int i = 0; i < 12; ++i) other.blobs["scan/" + std::to_string(i)] += "x";
    QVERIFY(session.store(1, kInfo, other));
    QVERIFY(!fs::exists(changes));
    QVERIFY(session.store(1, kInfo, document(6)));
    session.remove(1);
    QVERIFY(!fs::exists(changes) && !fs::exists(whole));
  }

  // The program died after a whole autosave replaced another, and before its changes were removed: they are older, and
  // left out. Damaged ones are, too.
  void changesOfAnotherAutosave() {
    QTemporaryDir folder;
    std::string older;
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, kInfo, document(1)));
      QVERIFY(session.store(1, kInfo, document(2)));
      older = *readFileBytes(fileIn(folder, "1.changes"));
    }
    const std::string newer = *writeContainer(document(3), Compression::None);
    QVERIFY(!withChanges(newer, older));
    const std::string first = *writeContainer(document(1), Compression::None);
    const std::optional<Container> joined = withChanges(first, older);
    QVERIFY(joined.has_value());
    QCOMPARE(joined->blobs.at("note"), std::string("2"));
    for (std::size_t at = 0; at < older.size(); at += 37) {
      std::string damaged = older;
      damaged[at] = static_cast<char>(damaged[at] ^ 0x20);
      const std::optional<Container> read = withChanges(first, damaged);
      if (read) QVERIFY(read->blobs == document(2).blobs);
    }
    put(fileIn(folder, "1.handwheel"), QByteArray::fromStdString(newer));
    const OrphanedAutosaves leftovers(rootIn(folder));
    QVERIFY(joinChanges(leftovers.found().at(0).file));
    QCOMPARE(contentOf(leftovers.found().at(0)), std::string("3"));
    leftovers.discard(leftovers.found().at(0));
    QVERIFY(!fs::exists(fileIn(folder, "1.changes")));
  }

  // Changes that cannot be read are no silent loss: the autosave is recovered without them, and they are kept and
  // listed until they are discarded.
  void damagedChangesAreKept() {
    QTemporaryDir folder;
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, kInfo, document(1)));
      QVERIFY(session.store(1, kInfo, document(2)));
    }
    const fs::path damaged = fileIn(folder, "1.damaged");
    put(fileIn(folder, "1.changes"), QByteArray("no container"));
    {
      RecoverySession session(rootIn(folder));
      const OrphanedAutosaves leftovers(rootIn(folder));
      const auto joined = joinChanges(leftovers.found().at(0).file);
      QVERIFY(joined.hasValue());
      QVERIFY(*joined == JoinedChanges::Damaged);
      QCOMPARE(contentOf(leftovers.found().at(0)), std::string("1"));
      QVERIFY(session.adopt(leftovers.found().at(0), 9));
    }
    QVERIFY(fs::exists(damaged));
    {
      const OrphanedAutosaves leftovers(rootIn(folder));
      QCOMPARE(leftovers.found().size(), std::size_t{1});
      QCOMPARE(leftovers.skipped().size(), std::size_t{1});
      QCOMPARE(leftovers.skipped()[0].subject, damaged.string());
      leftovers.discardSkipped();
    }
    QVERIFY(!fs::exists(damaged));
  }

  // Recovered, worked on, and killed again.
  void adoptedWithItsChanges() {
    QTemporaryDir folder;
    {
      RecoverySession session(rootIn(folder));
      QVERIFY(session.store(1, kInfo, document(1)));
      QVERIFY(session.store(1, kInfo, document(2)));
    }
    {
      RecoverySession session(rootIn(folder));
      {
        const OrphanedAutosaves leftovers(rootIn(folder));
        QVERIFY(joinChanges(leftovers.found().at(0).file));
        QVERIFY(session.adopt(leftovers.found().at(0), 9));
      }
      QVERIFY(session.store(9, kInfo, document(3)));
      QVERIFY(session.store(9, kInfo, document(4)));
    }
    const std::optional<Container> back = recovered(folder);
    QVERIFY(back.has_value());
    QCOMPARE(back->blobs.at("note"), std::string("4"));
  }
};

HANDWHEEL_TEST(AutosaveChangesTest)
#include "AutosaveChangesTest.moc"
