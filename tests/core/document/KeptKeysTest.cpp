// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ContainerChecks.h"
#include "TestClass.h"
#include "document/AtomicFile.h"
#include "document/Document.h"
#include "document/DocumentErrors.h"
#include "document/DocumentKind.h"
#include "document/FileBytes.h"

#include <QTemporaryDir>
#include <QTest>

using namespace handwheel;
using namespace handwheel::test;

namespace {

struct TableSnapshot : Snapshot {
  std::map<std::string, std::int64_t> entries;
};

const TableSnapshot& tableOf(const Snapshot& content) {
  return static_cast<const TableSnapshot&>(content);
}

// The smallest kind whose document has entries that are added and removed: {"entries": {"a": {"value": 1}, …}}.
class TableKind : public DocumentKind {
 public:
  std::string id() const override { return "table"; }
  std::string title() const override { return "Table"; }
  std::vector<FileFormat> formats() const override { return {}; }
  bool recognises(std::string_view, std::string_view) const override { return false; }
  Result<OpenedFile> import(const std::filesystem::path&, const ReadOptions&, Progress) const override {
    return Error{DocumentError::FormatUnknown, {}, {}, {}};
  }
  Result<WrittenFile> exportTo(const Snapshot&, const std::filesystem::path&, Progress) const override {
    return Error{DocumentError::ExtensionUnknown, {}, {}, {}};
  }
  void save(const Snapshot& content, Container& container) const override {
    json& entries = (*container.manifest)["document"]["entries"] = json::object();
    for (const auto& [name, value] : tableOf(content).entries) entries[name]["value"] = value;
    container.blobs["table/count"] = std::to_string(tableOf(content).entries.size());
  }
  Result<SnapshotPointer> load(const Container& container, std::vector<Error>&, Progress) const override {
    auto table = std::make_shared<TableSnapshot>();
    for (const auto& [name, entry] : (*container.manifest)["document"]["entries"].items())
      if (entry.is_object() && entry.contains("value")) table->entries[name] = entry["value"].get<std::int64_t>();
    return SnapshotPointer(table);
  }
  std::unique_ptr<Document> make(OpenedFile) const override { return nullptr; }
  json describe(const Snapshot&) const override { return {}; }
  DisplayModel display(const Snapshot&) const override { return {}; }
};

DocumentKinds tables() {
  std::vector<std::unique_ptr<DocumentKind>> kinds;
  kinds.push_back(std::make_unique<TableKind>());
  return DocumentKinds(std::move(kinds));
}

// A file written by hand: known keys, and unknown ones at every level; also invalid entries.
Container anyTable() {
  Container file;
  json& manifest = *file.manifest;
  manifest = anyObject(3);
  manifest.update({{"id", "one"}, {"kind", "table"}, {"display_unit", "cm"}});
  manifest["handwheel"] = anyObject(2);
  manifest["document"] = anyObject(3);
  json& entries = manifest["document"]["entries"] = anyObject(3);
  for (int i = *rc::gen::inRange(0, 5); i > 0; --i) {
    json& entry = entries[std::string(1, *rc::gen::inRange('a', 'k'))] = anyObject(2);
    entry["value"] = *rc::gen::inRange(0, 9);
  }
  file.blobs = {{"table/old", "gone"}, {"other/data", "kept"}};
  return file;
}

// A table after some of its entries were deleted, changed or added, and the manifest after the same by hand.
void edit(TableSnapshot& table, json& manifest) {
  json& entries = manifest["document"]["entries"];
  const auto before = table.entries;
  for (const auto& [name, value] : before) {
    switch (*rc::gen::inRange(0, 3)) {
      case 0:
        table.entries.erase(name);
        entries.erase(name);
        break;
      case 1:
        table.entries[name] = value + 10;
        entries[name]["value"] = value + 10;
        break;
      default:
        break;
    }
  }
  if (!*rc::gen::arbitrary<bool>()) return;
  table.entries["new"] = 99;
  entries["new"]["value"] = 99;
}

// Removes the keys about the writing of the file.
json comparable(json manifest) {
  for (const char* key : {"format", "program"}) manifest["handwheel"].erase(key);
  return manifest;
}

}  // namespace

// Tests the keys that pass through a document that knows only part of its file.
class KeptKeysTest : public QObject {
  Q_OBJECT

 private slots:
  void strangersStayAndTheDeletedIsGone() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("a.handwheel").toStdString();
    const DocumentKinds kinds = tables();
    QVERIFY(rc::check([&] {
      Container expected = anyTable();
      RC_ASSERT(writeFileAtomically(path, *writeContainer(expected, Compression::Fast)).hasValue());
      // Saves twice: unknown keys that one save keeps must be unknown to the next, too.
      for (int round = 0; round < 2; ++round) {
        const auto opened = kinds.open(path, {});
        RC_ASSERT(opened.hasValue());
        TableSnapshot table = tableOf(*opened->content);
        edit(table, *expected.manifest);
        RC_ASSERT(saveDocument(*opened->kind, opened->file, table, path).hasValue());
        const auto saved = readContainer(*readFileBytes(path));
        RC_ASSERT(saved.hasValue() && saved->damage.empty());
        RC_ASSERT(comparable(*saved->container.manifest) == comparable(*expected.manifest));
        RC_ASSERT(saved->container.blobs ==
                  (std::map<std::string, std::string>{{"table/count", std::to_string(table.entries.size())},
                                                      {"other/data", "kept"}}));
      }
    }));
  }

  // Undo restores an entry, and with it its unknown keys.
  void whatComesBackIsWhole() {
    const QTemporaryDir folder;
    const std::filesystem::path path = folder.filePath("a.handwheel").toStdString();
    Container file;
    *file.manifest = {{"kind", "table"}, {"document", {{"entries", {{"a", {{"value", 1}, {"mood", "good"}}}}}}}};
    QVERIFY(writeFileAtomically(path, *writeContainer(file, Compression::Fast)).hasValue());
    const auto opened = tables().open(path, {});
    QVERIFY(opened.hasValue());
    const auto entriesOf = [&](const Snapshot& content) {
      const auto bytes = containerBytes(TableKind(), opened->file, content, {}, Compression::Fast);
      return (*readContainer(*bytes)->container.manifest)["document"]["entries"];
    };
    QVERIFY(entriesOf(TableSnapshot()).empty());
    QVERIFY(entriesOf(*opened->content) == json({{"a", {{"value", 1}, {"mood", "good"}}}}));
  }
};

HANDWHEEL_TEST(KeptKeysTest)
#include "KeptKeysTest.moc"
