// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyLinks.h"

#include "Shelf.h"
#include "TestClass.h"
#include "document/AtomicFile.h"
#include "scene/UnknownGeometry.h"

#include <sys/stat.h>
#include <QTemporaryDir>
#include <QTest>

using namespace handwheel;
using namespace handwheel::test;
namespace fs = std::filesystem;

namespace {

void write(const fs::path& path, const std::string& bytes) {
  fs::create_directories(path.parent_path());
  if (!writeFileAtomically(path, bytes, {})) throw std::runtime_error("not written");
}

// Returns the link as in a document in this folder that was saved and opened.
BodyLink linked(const fs::path& path, const fs::path& folder) {
  BodyLink link = valueOf(linkTo(path));
  link.relative = relativePathOf(link, folder);
  return link;
}

}  // namespace

class BodyLinksTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_root = m_folder->path().toStdString();
    write(m_root / "job/parts/a.bin", "abc");
  }

  // The digest is the example of FIPS 180-4, appendix B.1.
  void aLinkKnowsItsFile() {
    const BodyLink link = linked(m_root / "job/parts/a.bin", m_root / "job");
    QCOMPARE(link.sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    QCOMPARE(link.relative, "parts/a.bin");
    QCOMPARE(link.path, (m_root / "job/parts/a.bin").string());
    QCOMPARE(linked(m_root / "job/parts/a.bin", {}).relative, "");
  }

  void theFileBesideTheDocumentComesFirst() {
    const BodyLink link = linked(m_root / "job/parts/a.bin", m_root / "job");
    QCOMPARE(locateLink(link, m_root / "job"), m_root / "job/parts/a.bin");
    // A copy of the whole folder uses its own file, though the other is still there.
    fs::copy(m_root / "job", m_root / "copy", fs::copy_options::recursive);
    QCOMPARE(locateLink(link, m_root / "copy"), m_root / "copy/parts/a.bin");
    // At its former path; and if all files came into one folder.
    write(m_root / "flat/a.bin", "abc");
    QCOMPARE(locateLink(link, m_root / "flat"), m_root / "job/parts/a.bin");
    QCOMPARE(locateLink(link, {}), m_root / "job/parts/a.bin");
    fs::remove_all(m_root / "job");
    QCOMPARE(locateLink(link, m_root / "flat"), m_root / "flat/a.bin");
    QVERIFY(locateLink(link, m_root / "elsewhere").empty());
  }

  // Saved elsewhere, then moved with all its files.
  void savedElsewhereAndMoved() {
    Body each = body("a");
    each.link = linked(m_root / "job/parts/a.bin", m_root / "job");
    const OpenedFile shelf = shelfWith(with({}, each));
    QVERIFY(saveDocument(*shelf.kind, shelf.file, *shelf.content, m_root / "shelf.handwheel").hasValue());
    fs::create_directory(m_root / "moved");
    fs::rename(m_root / "job", m_root / "moved/job");
    fs::rename(m_root / "shelf.handwheel", m_root / "moved/shelf.handwheel");
    const OpenedFile opened = valueOf(kinds().open(m_root / "moved/shelf.handwheel", {}));
    const BodyLink& link = *bodiesOf(*opened.content).withName("a")->link;
    QCOMPARE(link.relative, "job/parts/a.bin");
    QCOMPARE(link.state, LinkState::Present);
    QCOMPARE(link.path, (m_root / "moved/job/parts/a.bin").string());
    // A file that is missing may come back, so the path to it stays.
    fs::remove_all(m_root / "moved/job");
    const OpenedFile missing = valueOf(kinds().open(m_root / "moved/shelf.handwheel", {}));
    const BodyLink& lost = *bodiesOf(*missing.content).withName("a")->link;
    QCOMPARE(lost.state, LinkState::Missing);
    QCOMPARE(relativePathOf(lost, m_root), "job/parts/a.bin");
  }

  void states() {
    write(m_root / "job/b.bin", "b");
    write(m_root / "job/c.bin", "c");
    BodySet bodies = with({}, body("plain"));
    for (const char* name : {"parts/a.bin", "b.bin", "c.bin"}) {
      Body each = body(name);
      each.link = linked(m_root / "job" / name, m_root / "job");
      bodies = with(bodies, each);
    }
    fs::remove(m_root / "job/b.bin");
    write(m_root / "job/c.bin", "changed");
    std::vector<Note> notes;
    const BodySet checked = withCheckedBodyLinks(bodies, m_root / "job", notes);
    const auto stateOf = [&](const char* name) { return checked.withName(name)->link->state; };
    QCOMPARE(stateOf("parts/a.bin"), LinkState::Present);
    QCOMPARE(stateOf("b.bin"), LinkState::Missing);
    QCOMPARE(stateOf("c.bin"), LinkState::Changed);
    QVERIFY(!checked.withName("plain")->link);
    QCOMPARE(notes.size(), std::size_t{2});
    QCOMPARE(notes[0].arguments[0], "b.bin");
    QCOMPARE(notes[1].arguments[0], "c.bin");
    for (const BodyPointer& each : bodies) QCOMPARE(checked.withId(each->id)->geometry, each->geometry);
  }

  void openingChecksAndLosesNothing() {
    Body each = body("a", std::make_shared<const MeshGeometry>(tetrahedron()));
    each.link = linked(m_root / "job/parts/a.bin", m_root / "job");
    write(m_root / "job/shelf.handwheel", saved(shelfWith(with({}, each))));
    const auto stateNow = [&] {
      const OpenedFile file = valueOf(kinds().open(m_root / "job/shelf.handwheel", {}));
      const BodyPointer read = bodiesOf(*file.content).withName("a");
      if (read->geometry->surface()->triangles.size() != 4 || !file.file.damage.empty()) return LinkState::Unchecked;
      if (file.file.notes.empty() != (read->link->state == LinkState::Present)) return LinkState::Unchecked;
      return read->link->state;
    };
    QCOMPARE(stateNow(), LinkState::Present);
    write(m_root / "job/parts/a.bin", "abd");
    QCOMPARE(stateNow(), LinkState::Changed);
    fs::remove(m_root / "job/parts/a.bin");
    QCOMPARE(stateNow(), LinkState::Missing);
  }

  // A file whose size says nothing: it must not be read to its end.
  void endlessFiles() {
    Body each = body("a");
    each.link = BodyLink{"/proc/self/pagemap", {}, "00"};
    std::vector<Note> notes;
    const BodySet checked = withCheckedBodyLinks(with({}, each), m_root, notes);
    QCOMPARE(checked.withId(1)->link->state, LinkState::Changed);
  }

  void unknownShapesAreNoted() {
    const auto kept = [](bool isDamaged) {
      return std::make_shared<const UnknownGeometry>("voxels", "{}", std::map<std::string, std::string>(), isDamaged);
    };
    std::vector<Note> notes;
    withCheckedBodyLinks(with(with({}, body("new", kept(false))), body("damaged", kept(true))), m_root, notes);
    QCOMPARE(notes.size(), std::size_t{1});
    QCOMPARE(notes[0].arguments, (std::vector<std::string>{"new", "voxels"}));
  }

  void whatCannotBeLinked() {
    const auto codeOf = [](const fs::path& path) {
      const auto link = linkTo(path);
      return link ? ErrorCode::Cancelled : link.error().code;
    };
    QCOMPARE(codeOf(m_root / "none"), ErrorCode::FileMissing);
    QCOMPARE(codeOf(m_root), ErrorCode::FileUnreadable);
    QCOMPARE(codeOf(m_root / "\xff"), ErrorCode::Unsupported);
    write(m_root / "huge", "");
    fs::resize_file(m_root / "huge", kLargestLinkedFile + 1);
    QCOMPARE(codeOf(m_root / "huge"), ErrorCode::FileTooLarge);
    // Reading them would never end.
    QCOMPARE(mkfifo((m_root / "pipe").c_str(), 0600), 0);
    for (const fs::path& endless : {m_root / "pipe", fs::path("/dev/zero")}) {
      QCOMPARE(codeOf(endless), ErrorCode::FileUnreadable);
      Body each = body("a");
      each.link = BodyLink{endless.string(), {}, "00"};
      std::vector<Note> notes;
      const BodySet checked = withCheckedBodyLinks(with({}, each), m_root, notes);
      QCOMPARE(checked.withId(1)->link->state, LinkState::Missing);
    }
  }

 private:
  std::unique_ptr<QTemporaryDir> m_folder;
  fs::path m_root;
};

HANDWHEEL_TEST(BodyLinksTest)
#include "BodyLinksTest.moc"
