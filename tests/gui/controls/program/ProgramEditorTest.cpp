// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/program/ProgramEditor.h"

#include "ControlPictures.h"
#include "ControlsTestMain.h"
#include "controls/program/ProgramHighlighter.h"

#include <QHelpEvent>
#include <QLineEdit>
#include <QScrollBar>
#include <QShortcut>
#include <QSignalSpy>
#include <QTextLayout>
#include <QToolTip>

using namespace handwheel;
using namespace handwheel::test;

namespace {

using Severity = ProgramMark::Severity;

const QString kProgram = QStringLiteral(
    "%\n"
    "(shoulder, 30 h7)\n"
    "N10 G18 G21 G40\n"
    "N20 T0101 M6\n"
    "N30 G96 D2500 S180 M3 ; constant surface speed\n"
    "N40 G0 X42 Z2\n"
    "#1 = 30.0\n"
    "O100 while [#2 GT #1]\n"
    "N50 G1 X[#2] Z-40 F0.2\n"
    "N60 G5 X1\n"
    "M30\n");

QString longProgram(int lines) {
  QString text;
  for (int i = 1; i < lines; ++i) text += QStringLiteral("N%1 G1 X%2 Z-%3 F0.2 (pass)\n").arg(i).arg(i % 40).arg(i % 7);
  return text + QStringLiteral("M30");
}

struct ProgramBench {
  explicit ProgramBench(const QString& text = kProgram) {
    editor.setPlainText(text);
    editor.resize(520, 320);
    editor.show();
    editor.activateWindow();
    if (!QTest::qWaitForWindowActive(&editor)) qFatal("the editor does not appear");
    editor.setFocus();
    editor.grab();
  }
  QList<QTextLayout::FormatRange> formats(int line) {
    return editor.document()->findBlockByNumber(line - 1).layout()->formats();
  }
  QColor colourAt(int line, int column) {
    for (const QTextLayout::FormatRange& range : formats(line)) {
      if (column - 1 >= range.start && column - 1 < range.start + range.length)
        return range.format.foreground().color();
    }
    return {};
  }
  // The columns that are underlined: "5-6".
  QString underlined(int line) {
    int first = 0, last = 0;
    for (const QTextLayout::FormatRange& range : formats(line)) {
      if (range.format.underlineStyle() != QTextCharFormat::WaveUnderline) continue;
      if (first == 0) first = range.start + 1;
      last = range.start + range.length;
    }
    return first == 0 ? QString() : QStringLiteral("%1-%2").arg(first).arg(last);
  }
  int shownFirst() { return editor.verticalScrollBar()->value() + 1; }
  int cursorLine() { return editor.textCursor().blockNumber() + 1; }

  ProgramEditor editor;
};

}  // namespace

class ProgramEditorTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { applyTheme(*qApp, ThemeKind::Light); }
  void coloursWords();
  void coloursFollowTheTheme();
  void coloursOnlyWhatIsShown();
  void marksUnderline();
  void marksMoveWithTheirLines();
  void marksInToolTips();
  void goesFromMarkToMark();
  void executedLine();
  void searches();
  void searchBar();
  void hostileTexts();
  void pictures();
};

void ProgramEditorTest::coloursWords() {
  ProgramBench bench;
  using Kind = EditorWord::Kind;
  const auto colour = [](Kind kind) { return programColour(kind, ThemeKind::Light); };
  QCOMPARE(bench.colourAt(2, 3), colour(Kind::Comment));
  QCOMPARE(bench.colourAt(3, 1), colour(Kind::LineNumber));
  QCOMPARE(bench.colourAt(3, 5), colour(Kind::Preparatory));
  QCOMPARE(bench.colourAt(4, 5), colour(Kind::Machine));
  QCOMPARE(bench.colourAt(6, 8), colour(Kind::Axis));
  QCOMPARE(bench.colourAt(6, 9), colour(Kind::Number));
  QCOMPARE(bench.colourAt(7, 1), colour(Kind::Variable));
  QSignalSpy changed(&bench.editor, &QPlainTextEdit::textChanged);
  bench.editor.moveCursor(QTextCursor::End);
  QTest::keyClicks(&bench.editor, "G1(new)");
  QCOMPARE(bench.colourAt(12, 1), colour(Kind::Preparatory));
  QCOMPARE(bench.colourAt(12, 4), colour(Kind::Comment));
  QCOMPARE(changed.size(), 7);  // by the keys alone: colours change no text
}

void ProgramEditorTest::coloursFollowTheTheme() {
  ProgramBench bench;
  applyTheme(*qApp, ThemeKind::Dark);
  QTest::qWait(20);
  bench.editor.grab();
  QCOMPARE(bench.colourAt(3, 5), programColour(EditorWord::Kind::Preparatory, ThemeKind::Dark));
}

void ProgramEditorTest::coloursOnlyWhatIsShown() {
  ProgramBench bench(longProgram(100000));
  QCOMPARE(bench.editor.blockCount(), 100000);
  QVERIFY(!bench.formats(1).isEmpty());
  QVERIFY(bench.formats(1000).isEmpty());
  bench.editor.verticalScrollBar()->setValue(50000);
  bench.editor.grab();
  QVERIFY(!bench.formats(50010).isEmpty());
  int coloured = 0;
  for (int line = 1; line <= 100000; ++line) coloured += !bench.formats(line).isEmpty();
  QVERIFY2(coloured < 200, qPrintable(QString::number(coloured)));
  bench.editor.moveCursor(QTextCursor::End);
  bench.editor.grab();
  QVERIFY(!bench.formats(100000).isEmpty());
}

void ProgramEditorTest::marksUnderline() {
  ProgramBench bench;
  bench.editor.setMarks({{10, 5, Severity::Error, "G5 is not supported: use G1, G2 or G3."},
                         {6, 0, Severity::Warning, "Rapid near the chuck."},
                         {9, 8, Severity::Note, "a note"},
                         {5, 99, Severity::Note, "beyond the end of the line"}});
  bench.editor.grab();
  QCOMPARE(bench.underlined(10), QString("5-6"));  // the word G5
  QCOMPARE(bench.underlined(6), QString("1-13"));
  QCOMPARE(bench.underlined(9), QString("8-8"));
  QCOMPARE(bench.underlined(5), QString("46-46"));  // its last character
  QCOMPARE(bench.colourAt(10, 5), programColour(EditorWord::Kind::Preparatory, ThemeKind::Light));
  bench.editor.setMarks({});
  bench.editor.grab();
  QCOMPARE(bench.underlined(10), QString());
}

void ProgramEditorTest::marksMoveWithTheirLines() {
  ProgramBench bench;
  bench.editor.setMarks({{10, 5, Severity::Error, "here"}, {99, 0, Severity::Error, "at the end"}, {-1, 0, {}, "top"}});
  bench.editor.goTo(1);
  QTest::keyClick(&bench.editor, Qt::Key_Return);
  const auto text = [&bench](int line) {
    return bench.editor.markText(bench.editor.document()->findBlockByNumber(line - 1));
  };
  QCOMPARE(text(11), QString("here"));
  QCOMPARE(text(10), QString());
  QCOMPARE(text(bench.editor.blockCount()), QString("at the end"));
  bench.editor.setPlainText("G1");
  QCOMPARE(text(1), QString());
}

void ProgramEditorTest::marksInToolTips() {
  ProgramBench bench;
  bench.editor.setMarks({{10, 5, Severity::Error, "G5 is not supported."}, {10, 8, Severity::Note, "X1 is inside."}});
  QTextCursor cursor(bench.editor.document()->findBlockByNumber(9));
  const QPoint place = bench.editor.cursorRect(cursor).center();
  QHelpEvent help(QEvent::ToolTip, place, bench.editor.viewport()->mapToGlobal(place));
  QApplication::sendEvent(bench.editor.viewport(), &help);
  QCOMPARE(QToolTip::text(), QString("G5 is not supported.\nX1 is inside."));
  QToolTip::hideText();
  auto* margin = bench.editor.findChild<QWidget*>("programMargin");
  QHelpEvent beside(QEvent::ToolTip, {4, place.y()}, margin->mapToGlobal(QPoint(4, place.y())));
  QApplication::sendEvent(margin, &beside);
  QCOMPARE(QToolTip::text(), QString("G5 is not supported.\nX1 is inside."));
  QTest::mouseClick(margin, Qt::LeftButton, {}, {4, place.y()});
  QCOMPARE(bench.cursorLine(), 10);
}

void ProgramEditorTest::goesFromMarkToMark() {
  ProgramBench bench;
  QVERIFY(!bench.editor.goToMark());
  QShortcut ofTheWindow(Qt::Key_F8, &bench.editor, nullptr, nullptr, Qt::WindowShortcut);  // the editor comes first
  bench.editor.setMarks({{3, 9, Severity::Error, "a"}, {6, 0, Severity::Note, "b"}});
  QList<int> lines;
  for (int i = 0; i < 3; ++i) {
    QTest::keyClick(&bench.editor, Qt::Key_F8);
    lines << bench.cursorLine();
  }
  QTest::keyClick(&bench.editor, Qt::Key_F8, Qt::ShiftModifier);
  lines << bench.cursorLine();
  QCOMPARE(lines, QList<int>({3, 6, 3, 6}));
  QTest::keyClick(&bench.editor, Qt::Key_F8);
  QCOMPARE(bench.editor.textCursor().positionInBlock(), 8);
}

// It is scrolled into view, and the cursor of the person stays.
void ProgramEditorTest::executedLine() {
  ProgramBench bench(longProgram(1000));
  bench.editor.goTo(3);
  bench.editor.setCurrentLine(500);
  QCOMPARE(bench.editor.currentLine(), 500);
  QCOMPARE(bench.cursorLine(), 3);
  QVERIFY(bench.shownFirst() > 480 && bench.shownFirst() <= 500);
  const int first = bench.shownFirst();
  bench.editor.setCurrentLine(501);
  QCOMPARE(bench.shownFirst(), first);  // it is in sight: nothing jumps
  bench.editor.setCurrentLine(2);
  QVERIFY(bench.shownFirst() <= 2);
  bench.editor.setCurrentLine(100000);
  QCOMPARE(bench.editor.currentLine(), 1000);
  QCOMPARE(bench.editor.extraSelections().size(), 2);
  bench.editor.setCurrentLine(0);
  QCOMPARE(bench.editor.extraSelections().size(), 1);
  bench.editor.setCurrentLine(-5);
  QCOMPARE(bench.editor.currentLine(), 0);
}

void ProgramEditorTest::searches() {
  ProgramBench bench;
  QVERIFY(bench.editor.findText("g1 x"));
  QCOMPARE(bench.cursorLine(), 9);
  QVERIFY(!bench.editor.findText("G1 Y"));
  QVERIFY(!bench.editor.findText(QString()));
  QCOMPARE(bench.cursorLine(), 9);
  QVERIFY(bench.editor.findText("G18"));  // around the end
  QCOMPARE(bench.cursorLine(), 3);
  QVERIFY(bench.editor.findText("M30", true));
  QCOMPARE(bench.cursorLine(), 11);
}

void ProgramEditorTest::searchBar() {
  ProgramBench bench;
  auto* bar = bench.editor.findChild<QWidget*>("programSearch");
  auto* line = bar->findChild<QLineEdit*>();
  QVERIFY(!bar->isVisible());
  QTest::keyClick(&bench.editor, Qt::Key_F, Qt::ControlModifier);
  QVERIFY(bar->isVisible() && line->hasFocus());
  QVERIFY(bench.editor.viewport()->geometry().bottom() < bar->geometry().top());
  QTest::keyClicks(line, "X4");
  QCOMPARE(bench.cursorLine(), 6);
  QTest::keyClicks(line, "0");
  QCOMPARE(bar->findChild<QLabel*>("programSearchState")->text(), QString("not found"));
  line->selectAll();
  QTest::keyClicks(line, "X");
  QCOMPARE(bar->findChild<QLabel*>("programSearchState")->text(), QString());
  QTest::keyClick(line, Qt::Key_Return);
  QCOMPARE(bench.cursorLine(), 9);
  QTest::keyClick(line, Qt::Key_Return, Qt::ShiftModifier);
  QCOMPARE(bench.cursorLine(), 6);
  QTest::keyClick(line, Qt::Key_Escape);
  QVERIFY(!bar->isVisible() && bench.editor.hasFocus());
  QTest::keyClick(&bench.editor, Qt::Key_F3);
  QCOMPARE(bench.cursorLine(), 9);
}

void ProgramEditorTest::hostileTexts() {
  ProgramBench bench(QString(300000, 'X'));
  bench.editor.setMarks({{1, 299999, Severity::Error, "far"}, {1, -7, Severity::Error, "all"}});
  bench.editor.grab();
  bench.editor.setMarks(std::vector<ProgramMark>(100000, {1, 0, Severity::Error, "again"}));
  bench.editor.grab();
  QVERIFY(bench.editor.markText(bench.editor.document()->firstBlock()).size() < 1000);
  bench.editor.setCurrentLine(1);
  bench.editor.setPlainText(QStringLiteral("G1\0X\u2028Y\r\n\tZ(\n)))"));
  bench.editor.grab();
  bench.editor.setPlainText({});
  bench.editor.setMarks({{5, 5, Severity::Error, "of nothing"}});
  bench.editor.setCurrentLine(7);
  bench.editor.goTo(-1, -1);
  bench.editor.grab();
  QCOMPARE(bench.editor.currentLine(), 1);
  QCOMPARE(bench.editor.markText(bench.editor.document()->firstBlock()), QString("of nothing"));
}

void ProgramEditorTest::pictures() {
  ProgramBench bench;
  bench.editor.setMarks({{10, 5, Severity::Error, "G5 is not supported: use G1, G2 or G3."},
                         {6, 0, Severity::Warning, "Rapid near the chuck."},
                         {4, 5, Severity::Note, "Tool 1: right turning tool"}});
  bench.editor.setCurrentLine(9);
  bench.editor.goTo(7);
  QTest::keyClick(&bench.editor, Qt::Key_F, Qt::ControlModifier);
  lookAt(bench.editor, "program");
}

HANDWHEEL_CONTROLS_TEST(ProgramEditorTest)
#include "ProgramEditorTest.moc"
