// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "text/EnglishPlurals.h"
#include "text/ErrorText.h"
#include "text/RepairText.h"

#include <QtTest>

using namespace handwheel;

class ErrorTextTest : public QObject {
  Q_OBJECT

 private slots:
  void everyCodeHasASentence() {
    for (int code = 0; code <= int(ErrorCode::LibraryFailed); ++code) {
      const Error error{ErrorCode(code), {"facets", "12", "9"}, InputPosition::line(7), "scan.stl"};
      const QString sentence = errorSentence(error);
      QVERIFY2(sentence.startsWith("scan.stl, line 7: "), qPrintable(sentence));
      QVERIFY2(sentence.endsWith('.') && !sentence.contains('%'), qPrintable(sentence));
      QVERIFY2(error.code == ErrorCode::Cancelled || errorAdvice(error).endsWith('.'), qPrintable(sentence));
    }
  }

  void whatIsNotKnownIsLeftOut() {
    const Error truncated{ErrorCode::DataTruncated, {"bytes", "", "84"}, InputPosition::byte(84), {}};
    QCOMPARE(errorSentence(truncated), "Byte 84: the file ends too early (bytes: 84 found).");
    QCOMPARE(errorSentence({ErrorCode::FileEmpty, {}, {}, {}}), "The file is empty.");
  }

  void endingsAreListed() {
    QCOMPARE(errorAdvice({ErrorCode::ExtensionUnknown, {".x", ".stl", ".ply", ".step"}, {}, {}}),
             "Use a name that ends in .stl, .ply or .step.");
    QCOMPARE(errorAdvice({ErrorCode::ExtensionUnknown, {"", ".csv"}, {}, {}}), "Use a name that ends in .csv.");
    QCOMPARE(errorAdvice({ErrorCode::FormatUnknown, {}, {}, {}}), "Choose another file.");  // of keys, for example
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
    QVERIFY(summary.contains("1 loosely hanging triangle removed"));
    QVERIFY(summary.contains("2 near points merged"));
    QVERIFY(summary.contains("2 tangled triangles replaced around holes"));
    QVERIFY(summary.contains("1 hole to be kept open gone with triangles that were removed"));
  }

  void numbersInEnglish() {
    const EnglishPlurals english;
    QCOMPARE(english.translate("", "%n hole(s)", nullptr, 1), "%n hole");
    QCOMPARE(english.translate("", "%n hole(s)", nullptr, 2), "%n holes");
    QVERIFY(english.translate("", "Open", nullptr, -1).isNull());
  }
};

HANDWHEEL_TEST(ErrorTextTest)
#include "ErrorTextTest.moc"
