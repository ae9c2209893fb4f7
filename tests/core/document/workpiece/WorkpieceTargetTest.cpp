// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/target/TargetImport.h"

#include "TestClass.h"
#include "document/DocumentErrors.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/WorkpieceKind.h"
#include "document/workpiece/target/DrawingExport.h"
#include "document/workpiece/target/SectionPicture.h"
#include "document/workpiece/target/TargetBlobs.h"
#include "document/workpiece/target/TargetEdit.h"
#include "document/workpiece/target/TargetPosition.h"
#include "document/workpiece/target/TargetReport.h"
#include "machining/target/TargetErrors.h"
#include "machining/target/files/DrawingWriter.h"

#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <nlohmann/json.hpp>

using namespace handwheel;

namespace {

TargetProfile steppedShaft() {
  return TargetProfile::make({{{0, 0}, {20, 0}, 0.0},
                              {{20, 0}, {20, 30}, 0.0},
                              {{20, 30}, {15, 30}, 0.0},
                              arcAround({15, 33}, 3, -M_PI / 2, -M_PI),
                              {{12, 33}, {12, 80}, 0.0}})
      .value();
}

WorkpieceSnapshot withTarget() {
  WorkpieceSnapshot workpiece;
  workpiece.target = std::make_shared<const WorkpieceTarget>(WorkpieceTarget{steppedShaft(), "Welle 轴.step"});
  return workpiece;
}

}  // namespace

class WorkpieceTargetTest : public QObject {
  Q_OBJECT

 private slots:
  void savedIsLoaded() {
    Container container;
    m_kind.save(withTarget(), container);
    *container.manifest = nlohmann::json::parse(container.manifest->dump());
    std::vector<Error> damage;
    const auto back = m_kind.load(container, damage, {});
    QVERIFY(back.hasValue() && damage.empty());
    const auto& workpiece = static_cast<const WorkpieceSnapshot&>(**back);
    QVERIFY(workpiece.target && workpiece.target->profile == steppedShaft());
    QCOMPARE(workpiece.target->source, std::string("Welle 轴.step"));
    // Without a target there is no property.
    Container bare;
    m_kind.save(WorkpieceSnapshot(), bare);
    QVERIFY(!readTarget((*bare.manifest)["document"], bare, damage) && damage.empty());
  }

  void hostileTargets() {
    Container sound;
    m_kind.save(withTarget(), sound);
    for (const char* text : {"7", "[]", "{}", R"({"segments": -1})", R"({"segments": 1e300})", R"({"segments": 4})",
                             R"({"segments": 99999})", R"({"segments": 18446744073709551615})"}) {
      Container container = sound;
      (*container.manifest)["document"]["target"] = nlohmann::json::parse(text);
      std::vector<Error> damage;
      const auto loaded = m_kind.load(container, damage, {});
      QVERIFY(loaded.hasValue());
      QVERIFY2(damage.size() <= 1, text);
      const auto& workpiece = static_cast<const WorkpieceSnapshot&>(**loaded);
      if (!damage.empty()) QVERIFY(!workpiece.target);
    }
  }

  void undone() {
    WorkpieceKind kind;
    const auto document = kind.make(DocumentKinds::blank(kind));
    auto& workpiece = static_cast<WorkpieceDocument&>(*document);
    TargetEdit edit(withTarget().target);
    edit.exchange(*document);
    QVERIFY(workpiece.workpiece().target != nullptr);
    edit.exchange(*document);
    QVERIFY(workpiece.workpiece().target == nullptr);
  }

  void drawingsAreReadBack() {
    const TargetProfile shaft = steppedShaft();
    for (const char* name : {"shaft.dxf", "shaft.SVG"}) {
      const auto path = at(name);
      QVERIFY(exportDrawing(shaft, {}, path, {}).hasValue());
      const auto imported = importTarget(path, UnturnedFaces::Refuse);
      QVERIFY(imported.hasValue());
      QVERIFY(distanceBetween(imported->profile, shaft) < 1e-6);
      QCOMPARE(imported->source, std::string(name));
      QVERIFY(imported->notes.empty());
    }
  }

  // A drawing opens as a bar that it can be turned from, with the drawing as target; Save never replaces it.
  void drawingsAreOpened() {
    const TargetProfile shaft = steppedShaft();
    std::vector<std::unique_ptr<DocumentKind>> own;
    own.push_back(std::make_unique<WorkpieceKind>());
    const DocumentKinds kinds(std::move(own));
    for (const char* name : {"opened.dxf", "opened.svg"}) {
      const auto path = at(name);
      QVERIFY(exportDrawing(shaft, {}, path, {}).hasValue());
      const auto opened = kinds.open(path, {});
      QVERIFY(opened.hasValue() && opened->file.wouldLoseDataOnOverwrite() && !opened->file.isContainer);
      const auto& bar = static_cast<const WorkpieceSnapshot&>(*opened->content);
      QVERIFY(bar.target && !bar.part);
      QVERIFY(std::abs(bar.target->profile.volume() - shaft.volume()) < 1e-6 * shaft.volume());
      QCOMPARE(bar.stock.diameter, 42.0);  // ⌀40 and 2 mm
      QCOMPARE(bar.stock.length, 111.0);   // 80 mm, 1 mm and 30 mm
      QVERIFY(std::abs(bar.target->profile.upperEnd() - 110.0) < 1e-6);
    }
    QFile text(QString::fromStdString(at("text.dxf").string()));
    QVERIFY(text.open(QIODevice::WriteOnly) && text.write("hello") == 5);
    text.close();
    const auto refused = kinds.open(at("text.dxf"), {});
    QVERIFY(!refused && refused.error().code == DocumentError::FormatUnknown);
  }

  void aDrawingAsPdf() {
    const auto path = at("shaft.pdf");
    WorkpieceSnapshot workpiece;
    workpiece.material = "C45";
    QVERIFY(m_kind.exportTo(workpiece, path, {}).hasValue());
    QFile file(QString::fromStdString(path.string()));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray bytes = file.readAll();
    QVERIFY(bytes.startsWith("%PDF-") && bytes.contains("%%EOF"));
    // A4 across, in points.
    QVERIFY(bytes.contains("/MediaBox [0 0 842") || bytes.contains("/MediaBox [0 0 841"));
  }

  void ofOurOwnFiles() {
    const auto path = at("own.handwheel");
    const OpenedFile blank = DocumentKinds::blank(m_kind);
    QVERIFY(saveDocument(m_kind, blank.file, withTarget(), path).hasValue());
    const auto byTarget = importTarget(path, UnturnedFaces::Refuse);
    QVERIFY(byTarget.hasValue() && byTarget->profile == steppedShaft());
    QVERIFY(saveDocument(m_kind, blank.file, WorkpieceSnapshot(), path).hasValue());
    const auto byPart = importTarget(path, UnturnedFaces::Refuse);
    QVERIFY(byPart.hasValue());
    QVERIFY(std::abs(byPart->profile.volume() / StockCylinder().volume() - 1.0) < 1e-9);
  }

  void refusesOthers() {
    const auto path = at("nothing.dxf");
    QVERIFY(writeText(path, "hello"));
    QCOMPARE(importTarget(path, UnturnedFaces::Refuse).error().code, ErrorCode(DocumentError::FormatUnknown));
    QCOMPARE(importTarget(at("missing.step"), UnturnedFaces::Refuse).error().code, ErrorCode(ErrorCode::FileMissing));
    QVERIFY(writeText(path, "AutoCAD Binary DXF\r\n"));
    const Error error = importTarget(path, UnturnedFaces::Refuse).error();
    QCOMPARE(error.code, ErrorCode(TargetError::BinaryDrawing));
    QCOMPARE(error.subject, path.string());
  }

  // A drawing of 80 mm in a bar of 100 mm, wherever it was drawn: 1 mm is left for facing, 19 mm at the chuck's end. A
  // workpiece stays where it was, if the bar has it all.
  void placed() {
    const StockCylinder stock{50.0, 100.0, 10.0};
    for (const double drawnAt : {-500.0, 0.0, 20.0}) {
      const auto usual = placedTarget({steppedShaft().moved(drawnAt), "x", {}}, stock);
      QVERIFY(std::abs(usual->profile.upperEnd() - 109.0) < 1e-9);
      QVERIFY(std::abs(usual->profile.lowerEnd() - 29.0) < 1e-9);
      const auto asked = placedTarget({steppedShaft().moved(drawnAt), "x", {}}, stock, 2.5);
      QVERIFY(std::abs(asked->profile.upperEnd() - 107.5) < 1e-9);
    }
    const auto kept = placedTarget({steppedShaft().moved(20.0), "x", {}, true}, stock);
    QCOMPARE(kept->profile.lowerEnd(), 20.0);
    const auto beyond = placedTarget({steppedShaft().moved(-5.0), "x", {}, true}, stock);
    QVERIFY(std::abs(beyond->profile.upperEnd() - 109.0) < 1e-9);
    // A bar that is hardly longer leaves its excess, and a shorter one nothing.
    QVERIFY(std::abs(usualAllowance(steppedShaft(), {50.0, 80.25, 0.0}) - 0.25) < 1e-9);
    QCOMPARE(usualAllowance(steppedShaft(), {50.0, 70.0, 0.0}), 0.0);
  }

  // ⌀24 is the upper end of the shaft and ⌀40 the lower one, and the reverse after it is turned. The picture is that of
  // the target in its bar, wherever the bar is.
  void endForEnd() {
    const TargetProfile shaft = steppedShaft(), turned = shaft.turnedEndForEnd();
    QCOMPARE(endsNote(shaft).arguments, std::vector<std::string>({"24", "40"}));
    QCOMPARE(endsNote(turned).arguments, std::vector<std::string>({"40", "24"}));
    const QImage picture = targetInBar({50.0, 100.0, 0.0}, shaft);
    QVERIFY(!picture.isNull());
    QVERIFY(picture == targetInBar({50.0, 100.0, 16.0}, shaft.moved(16.0)));
    QVERIFY(picture != targetInBar({50.0, 100.0, 0.0}, turned));
  }

  // A bar of 100 mm from Z 5 on, with 2 mm left for facing: Z of work on an exercise counts from the finished face, 98
  // mm above its lower end; other Z from that.
  void whereShownZCountsFrom() {
    WorkpieceSnapshot workpiece;
    workpiece.stock = {40.0, 100.0, 5.0};
    QCOMPARE(shownZero(workpiece, false), 0.0);
    QCOMPARE(shownZero(workpiece, true), 100.0);
    Result<TargetProfile> target = TargetProfile::make({{{10.0, 20.0}, {10.0, 103.0}, 0.0}});
    QVERIFY(target.hasValue());
    workpiece.target = std::make_shared<const WorkpieceTarget>(WorkpieceTarget{*target, std::string()});
    QVERIFY(std::abs(shownZero(workpiece, true) - 98.0) < 1e-9);
    QCOMPARE(shownZero(workpiece, false), 0.0);
  }

  // A tool of 2 mm goes in to the axis at Z 50 of a bar of 100 mm: the piece free of the chuck is above Z 51.
  void aPartedPart() {
    WorkpieceSnapshot workpiece;
    QVERIFY(sectionNotes(workpiece).empty());
    TurningPass pass;
    pass.noseRadius = 1.0;
    pass.path = {{30.0, 50.0}, {0.0, 50.0}};
    pass.times = {0.0, 60.0};
    workpiece.part = withPass(workpiece, pass, 0.05);
    QVERIFY(workpiece.part && workpiece.part->profile.pieces().size() == 2);
    const auto section = sectionOf(workpiece);
    QVERIFY(section.hasValue());
    QVERIFY(section->lowerEnd() > 50.9 && section->lowerEnd() < 51.1);
    QVERIFY(std::abs(section->upperEnd() - 100.0) < 1e-9);
    QCOMPARE(sectionNotes(workpiece).size(), std::size_t{1});
    QVERIFY(sectionNotes(workpiece).front().isLoss);
  }

  // The allowance for facing can be changed, undone and saved; a target that does not fit is reported.
  void theAllowanceIsAProperty() {
    WorkpieceKind kind;
    OpenedFile opened = DocumentKinds::blank(kind);
    auto bar = std::make_shared<WorkpieceSnapshot>(withTarget());  // 50 × 100 mm
    bar->target = placedTarget({steppedShaft(), "x.dxf", {}}, bar->stock);
    opened.content = bar;
    const auto document = kind.make(std::move(opened));
    const auto& now = static_cast<const WorkpieceDocument&>(*document);
    const auto value = [&](const char* id) { return std::get<double>(document->property(id)->value); };
    QCOMPARE(value("facing_allowance"), 1.0);
    QCOMPARE(value("target_face"), 99.0);
    QCOMPARE(value("target_left"), 19.0);
    QVERIFY(document->setProperty("facing_allowance", 3.0));
    QVERIFY(std::abs(now.workpiece().target->profile.upperEnd() - 97.0) < 1e-9);
    QCOMPARE(now.workpiece().target->source, std::string("x.dxf"));
    QVERIFY(std::abs(programZero(now.workpiece()) - 97.0) < 1e-9);
    Container container;
    m_kind.save(now.workpiece(), container);
    std::vector<Error> damage;
    const auto back = m_kind.load(container, damage, {});
    QVERIFY(std::abs(programAllowance(static_cast<const WorkpieceSnapshot&>(**back)) - 3.0) < 1e-9);
    document->history()->undo();
    QCOMPARE(value("facing_allowance"), 1.0);
    QVERIFY(document->property("facing_allowance")->problem.empty());
    QVERIFY(document->setProperty("facing_allowance", 20.5));  // the limit is 20 mm
    QVERIFY(!document->property("facing_allowance")->problem.empty());
    for (const PropertyValue& wrong : {PropertyValue(-1.0), PropertyValue(101.0), PropertyValue(std::string("1"))})
      QVERIFY(!document->setProperty("facing_allowance", wrong));
  }

  void deviationOfABar() {
    WorkpieceSnapshot workpiece = withTarget();
    workpiece.stock = {44.0, 80.0, 0.0};
    const TargetDeviation d = deviationOf(workpiece);
    QVERIFY(std::abs(d.largestOver.distance - 10.0) < 1e-6);  // 22 against 12
    QCOMPARE(d.largestUnder.distance, 0.0);
  }

  void describesDimensions() {
    const auto described = m_kind.describe(withTarget());
    QCOMPARE(described["dimensions"].size(), std::size_t{3});  // two faces and the bar
    QCOMPARE(described["dimensions"][1]["diameter"].get<double>(), 50.0);
    QCOMPARE(described["dimensions"][1]["text"].get<std::string>(),
             std::string("cylinder Ø50, Z 0 to 100, length 100"));
    QVERIFY(described["target"]["deviation"]["largest_over"]["distance"].get<double>() > 0.0);
  }

 private:
  std::filesystem::path at(const char* name) const { return m_folder.filePath(name).toStdString(); }
  static bool writeText(const std::filesystem::path& path, const char* text) {
    QFile file(QString::fromStdString(path.string()));
    return file.open(QIODevice::WriteOnly) && file.write(text) > 0;
  }

  QTemporaryDir m_folder;
  WorkpieceKind m_kind;
};

HANDWHEEL_TEST_RUN(WorkpieceTargetTest, handwheel::test::runTest<QGuiApplication, WorkpieceTargetTest>)
#include "WorkpieceTargetTest.moc"
