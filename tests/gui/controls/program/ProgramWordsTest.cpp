// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/program/ProgramWords.h"

#include "TestClass.h"
#include "controls/program/ProgramHighlighter.h"

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <map>

using namespace handwheel;
using Kind = EditorWord::Kind;

namespace {

// Returns "G1|prep X10|…": the words with the first letter of their kind.
QString wordsOf(const QString& line) {
  const std::map<Kind, QString> names{{Kind::Comment, "comment"},       {Kind::Preparatory, "prep"},
                                      {Kind::Machine, "machine"},       {Kind::Axis, "axis"},
                                      {Kind::Number, "number"},         {Kind::LineNumber, "line"},
                                      {Kind::Subprogram, "subprogram"}, {Kind::Variable, "variable"},
                                      {Kind::Keyword, "keyword"},       {Kind::Unknown, "unknown"}};
  QStringList words;
  for (const EditorWord& word : programWords(line)) {
    words << line.mid(word.start, word.length) + "=" + names.at(word.kind);
  }
  return words.join(" | ");
}

// WCAG 2.1, "relative luminance" and "contrast ratio".
double luminance(const QColor& colour) {
  const auto part = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
  return 0.2126 * part(colour.redF()) + 0.7152 * part(colour.greenF()) + 0.0722 * part(colour.blueF());
}

double contrast(const QColor& a, const QColor& b) {
  const double x = luminance(a) + 0.05, y = luminance(b) + 0.05;
  return std::max(x, y) / std::min(x, y);
}

}  // namespace

class ProgramWordsTest : public QObject {
  Q_OBJECT

 private slots:
  void words_data();
  void words();
  void wordsAreInOrderInsideTheLine();
  void coloursAreReadable();
};

void ProgramWordsTest::words_data() {
  QTest::addColumn<QString>("line");
  QTest::addColumn<QString>("found");
  QTest::newRow("empty") << ""
                         << "";
  QTest::newRow("move") << "N10 G1 X10.5 Z-2 F.2"
                        << "N10=line | G1=prep | X=axis | 10.5=number | Z=axis | -2=number | F.2=machine";
  QTest::newRow("without blanks") << "g01x1z2m3"
                                  << "g01=prep | x=axis | 1=number | z=axis | 2=number | m3=machine";
  QTest::newRow("blanks before the number") << "G 1 X 5"
                                            << "G 1=prep | X=axis |  5=number";
  QTest::newRow("decimals of G") << "G92.1 T0101 S1200"
                                 << "G92.1=prep | T0101=machine | S1200=machine";
  QTest::newRow("comments") << "G0 (rapid) X1 ; to here (all)"
                            << "G0=prep | (rapid)=comment | X=axis | 1=number | ; to here (all)=comment";
  QTest::newRow("comment without end") << "(open G1"
                                       << "(open G1=comment";
  QTest::newRow("variables") << "#1=[#<x end>+#100/2] X#5 ##1"
                             << "#1=variable | #<x end>=variable | #100=variable | 2=number | X=axis | #5=variable | "
                                "##1=variable";
  QTest::newRow("functions") << "Z[SIN[30] * 2]"
                             << "Z=axis | SIN=keyword | 30=number | 2=number";
  QTest::newRow("Fanuc's loop") << "WHILE [#1 LT 10] DO1"
                                << "WHILE=keyword | #1=variable | LT=keyword | 10=number | DO=keyword | 1=number";
  QTest::newRow("subprograms") << "O100 sub"
                               << "O100=subprogram | sub=keyword";
  QTest::newRow("named") << "o<finish pass> call [1]"
                         << "o<finish pass>=subprogram | call=keyword | 1=number";
  QTest::newRow("Fanuc's increments") << "U-1. W0.5"
                                      << "U=axis | -1.=number | W=axis | 0.5=number";
  QTest::newRow("unknown") << QString::fromUtf8("G1 X1 \xc3\xa4 $")
                           << QString::fromUtf8("G1=prep | X=axis | 1=number | \xc3\xa4=unknown | $=unknown");
  QTest::newRow("percent and delete") << "%/N1"
                                      << "N1=line";
  QTest::newRow("variable without end") << "#<abc"
                                        << "#<abc=variable";
  QTest::newRow("sign without number") << "X- Z"
                                       << "X=axis | Z=axis";
}

void ProgramWordsTest::words() {
  QFETCH(QString, line);
  QTEST(wordsOf(line), "found");
}

void ProgramWordsTest::wordsAreInOrderInsideTheLine() {
  QVERIFY(rc::check("words are in order, inside the line and not empty", [] {
    const auto letters = *rc::gen::container<std::string>(
        rc::gen::oneOf(rc::gen::element('G', 'X', '#', '<', '>', '(', ')', ';', '1', '.', '-', ' ', '[', 'O'),
                       rc::gen::arbitrary<char>()));
    const QString line = QString::fromLatin1(letters.data(), static_cast<qsizetype>(letters.size()));
    int end = 0;
    for (const EditorWord& word : programWords(line)) {
      RC_ASSERT(word.start >= end && word.length > 0);
      end = word.start + word.length;
    }
    RC_ASSERT(end <= line.size());
  }));
}

void ProgramWordsTest::coloursAreReadable() {
  for (ThemeKind theme : {ThemeKind::Light, ThemeKind::Dark}) {
    for (int kind = 0; kind <= static_cast<int>(Kind::Unknown); ++kind) {
      const QColor colour = programColour(static_cast<Kind>(kind), theme);
      const double ratio = contrast(colour, themeColours(theme).base);
      QVERIFY2(ratio >= 4.5, qPrintable(QStringLiteral("%1 %2").arg(colour.name()).arg(ratio)));
    }
  }
}

HANDWHEEL_TEST(ProgramWordsTest)
#include "ProgramWordsTest.moc"
