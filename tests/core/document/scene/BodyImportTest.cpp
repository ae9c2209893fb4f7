// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyImport.h"
#include "mesh/structure/MeshErrors.h"

#include "Shelf.h"
#include "TestClass.h"
#include "document/AtomicFile.h"
#include "document/formats/MeshWriter.h"

#include <QTemporaryDir>
#include <QTest>

using namespace handwheel;
using namespace handwheel::test;
namespace fs = std::filesystem;

class BodyImportTest : public QObject {
  Q_OBJECT

 private slots:
  void init() {
    m_folder = std::make_unique<QTemporaryDir>();
    m_root = m_folder->path().toStdString();
    put("part.stl", 10.0);
  }

  void aMeshByCopy() {
    const ImportedBody read = valueOf(readBody(kinds(), m_root / "part.stl", false));
    QCOMPARE(read.body.name, "part");
    QVERIFY(!read.body.link && read.file.damage.empty());
    QCOMPARE(read.file.notes.size(), std::size_t{1});  // Its size
    QCOMPARE(read.file.notes[0].arguments, (std::vector<std::string>{"10", "10", "10"}));
    QCOMPARE(read.body.geometry->kind(), "mesh");
    QCOMPARE(read.body.geometry->surface()->triangles.size(), std::size_t{4});
    QCOMPARE(read.body.geometry->surface()->points.size(), std::size_t{4});
    QCOMPARE(read.body.geometry->bounds().max(), Vec3(10, 10, 10));
  }

  // Its bodies stand in it as they are placed.
  void aContainer() {
    Body placed = body("cube", cube(2));
    placed.pose.translation().x() = 5.0;
    QVERIFY(writeFileAtomically(m_root / "shelf.handwheel", saved(shelfWith(with({}, placed))), {}).hasValue());
    const ImportedBody read = valueOf(readBody(kinds(), m_root / "shelf.handwheel", false));
    QCOMPARE(read.body.name, "shelf");
    QCOMPARE(read.body.geometry->bounds().min(), Vec3(4, -1, -1));
    QCOMPARE(read.body.geometry->bounds().max(), Vec3(6, 1, 1));
  }

  void aLinkIsReadAgain() {
    ImportedBody read = valueOf(readBody(kinds(), m_root / "part.stl", true));
    QCOMPARE(read.body.link->path, (m_root / "part.stl").string());
    QCOMPARE(read.body.link->state, LinkState::Present);
    put("part.stl", 20.0);
    Body present = read.body;
    present.id = 3;
    present.name = "renamed";
    present.pose.translation() = Vec3(1, 2, 3);
    present.visible = false;
    present.link->state = LinkState::Changed;
    const Body updated = valueOf(updatedFromLink(kinds(), present, m_root)).body;
    QCOMPARE(updated.geometry->bounds().max(), Vec3(20, 20, 20));
    QVERIFY(updated.link->sha256 != present.link->sha256);
    QCOMPARE(updated.link->state, LinkState::Present);
    Body rest = updated;
    rest.geometry = present.geometry;
    rest.link = present.link;
    QVERIFY(rest == present);
  }

  // A texture coordinate is not kept.
  void whatIsLostIsReported() {
    const std::string text = "v 0 0 0\nv 30 0 0\nv 0 20 0\nvt 0 0\nf 1/1 2/1 3/1\n";
    QVERIFY(writeFileAtomically(m_root / "textured.obj", text, {}).hasValue());
    const ImportedBody read = valueOf(readBody(kinds(), m_root / "textured.obj", false));
    QVERIFY(!read.file.lost.empty());
    QCOMPARE(read.file.notes.back().arguments, (std::vector<std::string>{"30", "20", "0"}));
    QCOMPARE(fs::path(read.file.path).filename(), fs::path("textured.obj"));
  }

  void whatCannotBeRead() {
    const auto codeOf = [&](const char* name) {
      const auto read = readBody(kinds(), m_root / name, true);
      return read ? ErrorCode::Cancelled : read.error().code;
    };
    QCOMPARE(codeOf("none.stl"), ErrorCode::FileMissing);
    QVERIFY(writeFileAtomically(m_root / "empty.handwheel", saved(shelfWith({})), {}).hasValue());
    QCOMPARE(codeOf("empty.handwheel"), MeshError::NoTriangles);
    Body lost = body("a");
    lost.link = BodyLink{"/none/a.stl", {}, "00"};
    const auto again = updatedFromLink(kinds(), lost, m_root);
    QVERIFY(!again);
    QCOMPARE(again.error().code, BodyError::LinkedFileGone);
  }

 private:
  void put(const char* name, double size) {
    const std::string bytes = writeMesh(tetrahedron(size), MeshFormat::Stl, NumberType::Float32);
    QVERIFY(writeFileAtomically(m_root / name, bytes, {}).hasValue());
  }

  std::unique_ptr<QTemporaryDir> m_folder;
  fs::path m_root;
};

HANDWHEEL_TEST(BodyImportTest)
#include "BodyImportTest.moc"
