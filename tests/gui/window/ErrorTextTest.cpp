// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "document/DocumentErrors.h"
#include "document/formats/MeshFileErrors.h"
#include "text/EnglishPlurals.h"
#include "text/ErrorText.h"
#include "text/LossText.h"
#include "text/NoteText.h"
#include "text/RepairText.h"

#include <QtTest>

using namespace handwheel;

namespace {

const ErrorDescription kBent{.id = "Bent",
                             .sentences = {"the %2 of %1 is bent", "%1 is bent", "something is bent"},
                             .advice = {"Straighten %1.", "Straighten it."}};

}  // namespace

class ErrorTextTest : public QObject {
  Q_OBJECT

 private slots:
  void aCodeBringsItsOwnTexts() {
    const auto said = [](std::vector<std::string> arguments) {
      const Error error{kBent, std::move(arguments), InputPosition::line(7), "a.txt"};
      return errorSentence(error) + " " + errorAdvice(error);
    };
    QCOMPARE(said({"rod", "end"}), "a.txt, line 7: the end of rod is bent. Straighten rod.");
    QCOMPARE(said({"rod", ""}), "a.txt, line 7: rod is bent. Straighten rod.");
    QCOMPARE(said({"", "end"}), "a.txt, line 7: something is bent. Straighten it.");
    QCOMPARE(said({}), said({"", ""}));
    QCOMPARE(said({"100 %2", "%1"}), "a.txt, line 7: the %1 of 100 %2 is bent. Straighten 100 %2.");
    QCOMPARE(errorAdvice({ErrorCode::Cancelled, {}, {}, {}}), "");
  }

  void whatIsNotKnownIsLeftOut() {
    const Error truncated{ErrorCode::DataTruncated, {"bytes", "", "84"}, InputPosition::byte(84), {}};
    QCOMPARE(errorSentence(truncated), "Byte 84: the file ends too early (bytes: 84 found).");
    const Error tooLarge{ErrorCode::FileTooLarge, {"facets", "", "100"}, {}, {}};
    QCOMPARE(errorSentence(tooLarge), "The file is too large (more than 100 facets).");
    QCOMPARE(errorSentence({MeshFileError::TokenUnexpected, {"a number", ""}, {}, {}}),
             "A number was expected, but nothing follows.");
    QCOMPARE(errorSentence({MeshFileError::TokenUnexpected, {"", "x"}, {}, {}}), "'x' is not valid here.");
    QCOMPARE(errorSentence({ErrorCode::FileEmpty, {}, {}, {}}), "The file is empty.");
  }

  void endingsAreListed() {
    QCOMPARE(errorAdvice({DocumentError::ExtensionUnknown, {".x", ".stl", ".ply", ".step"}, {}, {}}),
             "Use a name that ends in .stl, .ply or .step.");
    QCOMPARE(errorAdvice({DocumentError::ExtensionUnknown, {"", ".csv"}, {}, {}}), "Use a name that ends in .csv.");
    QCOMPARE(errorAdvice({DocumentError::FormatUnknown, {}, {}, {}}),
             "Choose another file.");  // an error about keys, for example
  }

  // The end of a file's name says which it is.
  void namesOfFilesAreWhole() {
    const std::string mesh = "package://ur_description/meshes/ur5e/collision/base_link_inertia.stl";
    QCOMPARE(errorSentence({ErrorCode::ReferenceMissing, {"the mesh", mesh}, {}, {}}),
             QString::fromStdString("The mesh '" + mesh + "' is referenced, but cannot be found."));
    const Error package{ErrorCode::ReferenceMissing, {"the package", "ur", "/home/a"}, {}, {}};
    QCOMPARE(errorSentence(package), "The package 'ur' was not found in the folder '/home/a' or in those above it.");
    QCOMPARE(errorAdvice(package), "Put the folder 'ur' into '/home/a' or a folder above it, and open the file again.");
  }

  // The program's own phrases are not cut off, even with any signs in them.
  void ownPhrasesAreWhole() {
    const std::string phrase = "balls were expected: x; y; z; radius, with “|” between them";
    const Error error{ErrorCode::ElementMalformed, {"plan.forbidden", phrase}, {}, {}};
    QVERIFY2(errorSentence(error).contains(QString::fromStdString(phrase)), qPrintable(errorSentence(error)));
  }

  // The reason and the remedy of a lathe program's error are sentences, and are shown whole.
  void sentencesAreWhole() {
    const std::string reason = "the next cut does not go in this direction, straight along the other axis";
    const Error error{ErrorCode::NumberMalformed, {reason}, {}, {}};
    QVERIFY2(errorSentence(error).contains(QString::fromStdString(reason)), qPrintable(errorSentence(error)));
  }

  void quotesAreShortAndHarmless() {
    const Error error{ErrorCode::NumberMalformed, {"\x1b[31m" + std::string(500, 'x')}, {}, {}};
    const QString sentence = errorSentence(error);
    QVERIFY(sentence.size() < 100);
    QVERIFY(!sentence.contains(QChar(0x1b)));
  }

  void fileNamesAreHarmlessToo() {
    const QString sentence = errorSentence({ErrorCode::FileEmpty, {}, {}, "a\x1b[31m\nb.stl"});
    QVERIFY(!sentence.contains(QChar(0x1b)) && !sentence.contains('\n'));
    QVERIFY(sentence.endsWith("b.stl: the file is empty."));
  }

  void summaryNamesEveryChange() {
    EnglishPlurals english;
    QCoreApplication::installTranslator(&english);
    RepairReport report;
    QVERIFY(repairSummary(report).isEmpty());
    report.reversedFaces = report.removedDegenerate = report.removedDuplicates = report.removedFlaps = 1;
    report.removedDebris = report.mergedVertices = report.separatedVertices = report.nonOrientableCuts = 2;
    report.replacedFaces = 2;
    report.lostLoops = {4};
    report.cutClusters = 3;
    const QStringList summary = repairSummary(report);
    QCOMPARE(summary.size(), 11);
    report.sheets = {1, {}, {}, {0.01, 0.05}};
    QVERIFY(repairSummary(report).contains("sheets thickened by 0.0100 to 0.0500 mm"));
    report.sheets.thickness = {0.01, 0.05, 200, 30};
    QVERIFY(repairSummary(report).contains(
        "sheets thickened by 0.0100 to 0.0500 mm, thinner than requested at 30 of 200 vertices"));
    report.sheets.thickness = {0.5, 0.5};
    QCOMPARE(sheetsText({3, {{FillFailure::SheetTooThin, 1}}, {}, {0.5, 0.5}}, LengthUnit::Millimetre),
             QString("3 of 4 thickened by 0.500 mm; 1 sheet left open: the numbers of the file cannot show such a "
                     "thickness"));
    QVERIFY(repairSummary(report, LengthUnit::Centimetre).contains("sheets thickened by 0.0500 cm"));
    QVERIFY(summary.contains("1 dangling triangle removed"));
    QVERIFY(summary.contains("2 near vertices merged"));
    QVERIFY(summary.contains("2 folded triangles replaced around holes"));
    QVERIFY(summary.contains("1 hole to be kept open lost with removed triangles"));
  }

  // Each property is at the same position, whether it holds or not; properties that were not examined are not
  // mentioned.
  void stateOfAPart() {
    EnglishPlurals english;
    QCoreApplication::installTranslator(&english);
    MeshState state{true, true, true, 0, 1};
    QVERIFY(state.isSound());
    QCOMPARE(stateText(state), "closed, manifold, oriented, free of self-intersections, one piece");
    state = {false, false, false, 1, 2};
    QVERIFY(!state.isSound());
    QCOMPARE(stateText(state), "not closed, not manifold, not oriented, 1 self-intersection, 2 pieces");
    state = {true, true, true, std::nullopt, 2};
    QVERIFY(state.isSound());
    QCOMPARE(stateText(state), "closed, manifold, oriented, 2 pieces");
    state.selfIntersectingPairs = 7563;
    QVERIFY(!state.isSound());
    QCOMPARE(noteText({"The file: %1.", {}, false, state}),
             "The file: closed, manifold, oriented, 7563 self-intersections, 2 pieces.");
  }

  // Three digits that count, whatever the size of the part.
  void lengths_data() {
    QTest::addColumn<double>("mm");
    QTest::addColumn<QString>("text");
    QTest::newRow("none") << 0.0 << "0 mm";
    QTest::newRow("usual") << 31.24 << "31.2 mm";
    QTest::newRow("to be rounded up") << 9.996 << "10.0 mm";
    QTest::newRow("large") << 123.4 << "123 mm";
    QTest::newRow("small part") << 0.01234 << "0.0123 mm";
    QTest::newRow("smaller") << 0.0000999 << "0.0000999 mm";
    QTest::newRow("tiny") << 0.00000123 << "1.23e-06 mm";
    QTest::newRow("negative") << -0.5 << "-0.500 mm";
  }
  void lengths() {
    QFETCH(double, mm);
    QFETCH(QString, text);
    QCOMPARE(lengthText(mm, LengthUnit::Millimetre), text);
    QCOMPARE(lengthText(25.4 * mm, LengthUnit::Inch), text.replace("mm", "in"));
  }

  void lostDataHasTheNamesOfTheFile() {
    DocumentFile file;
    file.lost = {LostAttribute::Colour, LostAttribute::Other};
    file.lostOther = {"quality", "flags"};
    QCOMPARE(lostNames(file), (QStringList{"colours", "quality", "flags"}));
    QCOMPARE(lostText(file), "colours, “quality”, “flags”");
    file.lostOther.emplace_back();
    QCOMPARE(lostNames(file), (QStringList{"colours", "quality", "flags", "further data"}));
    QCOMPARE(lostText(file), "colours, “quality”, “flags”, further data");
    file.lostOther.clear();
    QCOMPARE(lostNames(file), (QStringList{"colours", "further data"}));
  }

  void numbersInEnglish() {
    const EnglishPlurals english;
    QCOMPARE(english.translate("", "%n hole(s)", nullptr, 1), "%n hole");
    QCOMPARE(english.translate("", "%n hole(s)", nullptr, 2), "%n holes");
    QCOMPARE(english.translate("", "%n body(ies)", nullptr, 1), "%n body");
    QCOMPARE(english.translate("", "%n body(ies)", nullptr, 2), "%n bodies");
    QCOMPARE(english.translate("", "%n vertex(ices)", nullptr, 1), "%n vertex");
    QCOMPARE(english.translate("", "%n vertex(ices)", nullptr, 2), "%n vertices");
    QVERIFY(english.translate("", "Open", nullptr, -1).isNull());
  }
};

HANDWHEEL_TEST(ErrorTextTest)
#include "ErrorTextTest.moc"
