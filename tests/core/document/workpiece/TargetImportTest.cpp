// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/target/TargetImport.h"

#include "TestClass.h"
#include "document/workpiece/WorkpieceKind.h"
#include "machining/target/TargetErrors.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace handwheel;

namespace {

// Groups of a DXF file, written as words.
std::string dxfWith(std::string entities, const std::string& header = "") {
  std::string text = "0 SECTION 2 HEADER " + header + "0 ENDSEC 0 SECTION 2 ENTITIES " + entities + "0 ENDSEC 0 EOF";
  std::replace(text.begin(), text.end(), ' ', '\n');
  return text + "\n";
}

// The half section of a pin of ⌀20 × 50 mm.
constexpr const char* kPinLines =
    "0 LINE 10 0 20 0 11 0 21 10 0 LINE 10 0 20 10 11 50 21 10 0 LINE 10 50 20 10 11 50 21 0 ";

// A bar of ⌀50 × 100 mm, turned down to ⌀30 from 40 mm on.
WorkpieceSnapshot shaftToRead() {
  WorkpieceSnapshot workpiece;
  TurnedProfile profile(workpiece.stock, 0.1);
  for (std::size_t i = 0; i < profile.size(); ++i)
    if (profile.z(i) > 40.05) profile.limitOuter(i, 15.0);
  workpiece.part = std::make_shared<const TurnedPart>(TurnedPart::of(std::move(profile), {}, 0.1));
  return workpiece;
}

}  // namespace

// Targets from files of other programs, and the notes on reading them.
class TargetImportTest : public QObject {
  Q_OBJECT

 private slots:
  // A drawing without a unit is in mm, and its elements besides lines are counted.
  void aDrawingWithoutAUnit() {
    const auto path = written("pin.dxf", dxfWith(std::string(kPinLines) + "0 TEXT 1 M8 0 TEXT 1 x 0 HATCH 2 ANSI31 "));
    const auto imported = importTarget(path, UnturnedFaces::Refuse);
    QVERIFY(imported.hasValue());
    QVERIFY(std::abs(imported->profile.volume() / (M_PI * 100.0 * 50.0) - 1.0) < 1e-9);
    QVERIFY(!imported->isPlaced);
    QCOMPARE(imported->notes.size(), std::size_t{2});
    QVERIFY(std::string(imported->notes[0].text).find("unit of length") != std::string::npos);
    QCOMPARE(imported->notes[1].arguments, std::vector<std::string>{"1 HATCH, 2 TEXT"});
  }

  // The same drawing in inches, which its file says.
  void aDrawingInInches() {
    const auto path = written("inches.dxf", dxfWith(kPinLines, "9 $INSUNITS 70 1 "));
    const auto imported = importTarget(path, UnturnedFaces::Refuse);
    QVERIFY(imported.hasValue() && imported->notes.empty());
    QVERIFY(std::abs(imported->profile.length() - 50.0 * 25.4) < 1e-6);
  }

  // Names of entities are bytes of a file that may hold anything; they are shown.
  void aNameThatIsNoText() {
    const auto path = written("bytes.dxf", dxfWith(std::string(kPinLines) + "0 \xff\xfe 1 x "));
    const auto imported = importTarget(path, UnturnedFaces::Refuse);
    QVERIFY(imported.hasValue());
    QCOMPARE(imported->notes.back().arguments, std::vector<std::string>{"1 ?"});
  }

  void aDrawingOfNothing() {
    const auto path = written("nothing.dxf", dxfWith("0 TEXT 1 M8 "));
    const auto imported = importTarget(path, UnturnedFaces::Refuse);
    QVERIFY(!imported && imported.error().code == TargetError::NoProfile);
  }

  // A solid has its exact section.
  void aSolid() {
    const auto path = exported(WorkpieceSnapshot(), "bar.step");
    const auto imported = importTarget(path, UnturnedFaces::Refuse);
    QVERIFY(imported.hasValue() && imported->notes.empty() && !imported->isPlaced);
    QCOMPARE(imported->source, std::string("bar.step"));
    QVERIFY(std::abs(imported->profile.volume() / StockCylinder().volume() - 1.0) < 1e-6);
    const auto damaged = written("damaged.step", "ISO-10303-21;\nHEADER;\nnothing more");
    QVERIFY(!importTarget(damaged, UnturnedFaces::Refuse));
  }

  // An exported file is read again, with ends of the same width. A tetrahedron was never turned.
  void aMesh() {
    const WorkpieceSnapshot shaft = shaftToRead();
    for (const char* const name : {"shaft.stl", "shaft.obj"}) {
      const auto imported = importTarget(exported(shaft, name), UnturnedFaces::Refuse);
      QVERIFY(imported.hasValue());
      QVERIFY(std::abs(imported->profile.volume() / shaft.part->volume() - 1.0) < 2e-3);
      QVERIFY(std::abs(imported->profile.extentAt(imported->profile.lowerEnd())->outer - 25.0) < 1e-3);
      QVERIFY(std::abs(imported->profile.extentAt(imported->profile.upperEnd())->outer - 15.0) < 1e-3);
      QCOMPARE(imported->notes.size(), std::size_t{1});
      const double chord = std::stod(imported->notes.front().arguments.at(0));
      QVERIFY2(chord > 1e-4 && chord < 0.02, imported->notes.front().arguments.at(0).c_str());
    }
    const auto other =
        written("tetrahedron.obj", "v 0 0 0\nv 9 0 0\nv 0 8 0\nv 0 0 7\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
    const auto refused = importTarget(other, UnturnedFaces::Refuse);
    QVERIFY(!refused && refused.error().subject == other.string());
    QVERIFY(!importTarget(written("empty.stl", ""), UnturnedFaces::Refuse));
  }

  // Every ending that is offered can be distinguished from the others, and is written as files have it.
  void endings() {
    const std::vector<std::string> endings = targetEndings();
    for (const char* const known : {".step", ".stp", ".stl", ".obj", ".ply", ".dxf", ".svg", ".handwheel"})
      QVERIFY2(std::count(endings.begin(), endings.end(), known) == 1, known);
    for (const std::string& ending : endings) QVERIFY(ending.starts_with('.') && ending.size() > 2);
  }

 private:
  std::filesystem::path written(const char* name, const std::string& bytes) const {
    QFile file(m_folder.filePath(QString::fromUtf8(name)));
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes.data(), static_cast<qint64>(bytes.size())) < 0)
      qFatal("a file cannot be written");
    return file.fileName().toStdString();
  }
  std::filesystem::path exported(const WorkpieceSnapshot& workpiece, const char* name) const {
    const std::filesystem::path path = m_folder.filePath(QString::fromUtf8(name)).toStdString();
    if (!m_kind.exportTo(workpiece, path, {})) qFatal("a workpiece cannot be exported");
    return path;
  }

  QTemporaryDir m_folder;
  WorkpieceKind m_kind;
};

HANDWHEEL_TEST(TargetImportTest)
#include "TargetImportTest.moc"
