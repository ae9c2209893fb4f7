// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"
#include "text/ErrorText.h"
#include "text/RepairText.h"
#include "text/Translations.h"

#include <QtTest>

using namespace handwheel;

class TranslationsTest : public QObject {
  Q_OBJECT

 private slots:
  void theLanguageMeant_data() {
    QTest::addColumn<QString>("setting");
    QTest::addColumn<QStringList>("wanted");
    QTest::addColumn<QString>("language");
    QTest::newRow("chosen") << "de" << QStringList{"en-GB", "en"} << "de";
    QTest::newRow("chosen, with country") << "zh_CN" << QStringList{"de-DE"} << "zh_CN";
    QTest::newRow("system's") << "system" << QStringList{"de-AT", "de"} << "de";
    QTest::newRow("system's, with script") << "system" << QStringList{"zh-Hans-SG", "zh-SG", "zh"} << "zh_CN";
    QTest::newRow("second choice") << "system" << QStringList{"fr-CA", "fr", "de-DE"} << "de";
    QTest::newRow("English before others") << "system" << QStringList{"en-US", "en", "de-DE"} << "en";
    QTest::newRow("none that there is") << "system" << QStringList{"fr-FR", "fr"} << "en";
    QTest::newRow("no locale") << "" << QStringList{"C"} << "en";
    QTest::newRow("unknown setting") << "tlh" << QStringList{"de"} << "de";
    QTest::newRow("not by the first letters") << "system" << QStringList{"der-IN"} << "en";
  }

  void theLanguageMeant() {
    QFETCH(QString, setting);
    QFETCH(QStringList, wanted);
    QTEST(languageFor(setting, wanted), "language");
  }

  // The words are those of German and Chinese text books on meshes.
  void textsPluralsAndNumbers() {
    RepairReport report;
    report.removedDuplicates = 1;
    const Error empty{ErrorCode::FileEmpty, {}, {}, {}};
    QCOMPARE(errorSentence(empty), "The file is empty.");
    {
      const Translations german("de");
      QCOMPARE(german.language(), "de");
      QCOMPARE(errorSentence(empty), "Die Datei ist leer.");
      QVERIFY2(repairSummary(report).value(0).startsWith("1 doppeltes Dreieck"), qPrintable(repairSummary(report)[0]));
      report.removedDuplicates = 2;
      QVERIFY2(repairSummary(report).value(0).startsWith("2 doppelte Dreiecke"), qPrintable(repairSummary(report)[0]));
      QCOMPARE(QLocale().toString(1234567.5, 'f', 1), "1.234.567,5");
    }
    QCOMPARE(errorSentence(empty), "The file is empty.");
    {
      const Translations chinese("zh_CN");
      QVERIFY2(errorSentence(empty).contains("文件为空"), qPrintable(errorSentence(empty)));
      QVERIFY2(repairSummary(report).value(0).contains("2 个"), qPrintable(repairSummary(report)[0]));
    }
    const Translations english("en");
    QCOMPARE(repairSummary(report).value(0), "2 duplicate triangles removed");
  }

  void phrasesOfTheCoreWithNamesInThem() {
    const Error unknown{ErrorCode::Unsupported, {"the shape 'capsule'"}, InputPosition::line(7), "arm.urdf"};
    const Error truncated{ErrorCode::DataTruncated, {"facets", "12", "9"}, {}, "part.stl"};
    const Error nameless{ErrorCode::ElementMalformed, {"joint", "it has no name"}, {}, {}};
    QCOMPARE(errorSentence(unknown), "arm.urdf, line 7: the shape 'capsule' is not supported.");
    {
      const Translations german("de");
      QCOMPARE(errorSentence(unknown), "arm.urdf, Zeile 7: die Form „capsule“ wird nicht unterstützt.");
      QCOMPARE(errorSentence(truncated), "part.stl: die Datei endet zu früh (Facetten: 12 erwartet, 9 gefunden).");
      QCOMPARE(errorSentence(nameless), "Das Element „Gelenk“ ist fehlerhaft: der Name fehlt.");
    }
    const Translations chinese("zh_CN");
    QCOMPARE(errorSentence(truncated), "part.stl：文件提前结束（面片：应为 12，实为 9）。");
  }

  void phrasesAreWholeAndQuotesAreShort() {
    const std::string phrase = "a pole is across the axis, too far away or not finite";
    QVERIFY(errorSentence({ErrorCode::ElementMalformed, {"profile", phrase}, {}, {}}).contains(phrase.c_str()));
    const std::string name(500, 'x');
    for (const std::string& argument : {name, "the shape '" + name + "'"})
      QVERIFY(errorSentence({ErrorCode::Unsupported, {argument}, {}, {}}).size() < 100);
  }

  void everyLanguageButEnglishHasItsTexts() {
    for (const Language& language : windowLanguages())
      QCOMPARE(QFile::exists(":/translations/handwheel_" + language.code + ".qm"), language.code != "en");
  }
};

HANDWHEEL_TEST(TranslationsTest)
#include "TranslationsTest.moc"
