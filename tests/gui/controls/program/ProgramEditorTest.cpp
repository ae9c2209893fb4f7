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

struct ProgramFixture {
  explicit ProgramFixture(const QString& text = kProgram) {
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
  // Returns the underlined columns: "5-6".
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
  ProgramFixture fixture;
  using Kind = EditorWord::Kind;
  const auto colour = [](Kind kind) { return programColour(kind, ThemeKind::Light); };
  QCOMPARE(fixture.colourAt(2, 3), colour(Kind::Comment));
  QCOMPARE(fixture.colourAt(3, 1), colour(Kind::LineNumber));
  QCOMPARE(fixture.colourAt(3, 5), colour(Kind::Preparatory));
  QCOMPARE(fixture.colourAt(4, 5), colour(Kind::Machine));
  QCOMPARE(fixture.colourAt(6, 8), colour(Kind::Axis));
  QCOMPARE(fixture.colourAt(6, 9), colour(Kind::Number));
  QCOMPARE(fixture.colourAt(7, 1), colour(Kind::Variable));
  QSignalSpy changed(&fixture.editor, &QPlainTextEdit::textChanged);
  fixture.editor.moveCursor(QTextCursor::End);
  QTest::keyClicks(&fixture.editor, "G1(new)");
  QCOMPARE(fixture.colourAt(12, 1), colour(Kind::Preparatory));
  QCOMPARE(fixture.colourAt(12, 4), colour(Kind::Comment));
  QCOMPARE(changed.size(), 7);  // by the keys alone: colours change no text
}

void ProgramEditorTest::coloursFollowTheTheme() {
  ProgramFixture fixture;
  applyTheme(*qApp, ThemeKind::Dark);
  QTest::qWait(20);
  fixture.editor.grab();
  QCOMPARE(fixture.colourAt(3, 5), programColour(EditorWord::Kind::Preparatory, ThemeKind::Dark));
}

void ProgramEditorTest::coloursOnlyWhatIsShown() {
  ProgramFixture fixture(longProgram(100000));
  QCOMPARE(fixture.editor.blockCount(), 100000);
  QVERIFY(!fixture.formats(1).isEmpty());
  QVERIFY(fixture.formats(1000).isEmpty());
  fixture.editor.verticalScrollBar()->setValue(50000);
  fixture.editor.grab();
  QVERIFY(!fixture.formats(50010).isEmpty());
  int coloured = 0;
  for (int line = 1; line <= 100000; ++line) coloured += !fixture.formats(line).isEmpty();
  QVERIFY2(coloured < 200, qPrintable(QString::number(coloured)));
  fixture.editor.moveCursor(QTextCursor::End);
  fixture.editor.grab();
  QVERIFY(!fixture.formats(100000).isEmpty());
}

void ProgramEditorTest::marksUnderline() {
  ProgramFixture fixture;
  fixture.editor.setMarks({{10, 5, Severity::Error, "G5 is not supported: use G1, G2 or G3."},
                           {6, 0, Severity::Warning, "Rapid near the chuck."},
                           {9, 8, Severity::Note, "a note"},
                           {5, 99, Severity::Note, "beyond the end of the line"}});
  fixture.editor.grab();
  QCOMPARE(fixture.underlined(10), QString("5-6"));  // the word G5
  QCOMPARE(fixture.underlined(6), QString("1-13"));
  QCOMPARE(fixture.underlined(9), QString("8-8"));
  QCOMPARE(fixture.underlined(5), QString("46-46"));  // its last character
  QCOMPARE(fixture.colourAt(10, 5), programColour(EditorWord::Kind::Preparatory, ThemeKind::Light));
  fixture.editor.setMarks({});
  fixture.editor.grab();
  QCOMPARE(fixture.underlined(10), QString());
}

void ProgramEditorTest::marksMoveWithTheirLines() {
  ProgramFixture fixture;
  fixture.editor.setMarks(
      {{10, 5, Severity::Error, "here"}, {99, 0, Severity::Error, "at the end"}, {-1, 0, {}, "top"}});
  fixture.editor.goTo(1);
  QTest::keyClick(&fixture.editor, Qt::Key_Return);
  const auto text = [&fixture](int line) {
    return fixture.editor.markText(fixture.editor.document()->findBlockByNumber(line - 1));
  };
  QCOMPARE(text(11), QString("here"));
  QCOMPARE(text(10), QString());
  QCOMPARE(text(fixture.editor.blockCount()), QString("at the end"));
  fixture.editor.setPlainText("G1");
  QCOMPARE(text(1), QString());
}

void ProgramEditorTest::marksInToolTips() {
  ProgramFixture fixture;
  fixture.editor.setMarks({{10, 5, Severity::Error, "G5 is not supported."}, {10, 8, Severity::Note, "X1 is inside."}});
  QTextCursor cursor(fixture.editor.document()->findBlockByNumber(9));
  const QPoint point = fixture.editor.cursorRect(cursor).center();
  QHelpEvent help(QEvent::ToolTip, point, fixture.editor.viewport()->mapToGlobal(point));
  QApplication::sendEvent(fixture.editor.viewport(), &help);
  QCOMPARE(QToolTip::text(), QString("G5 is not supported.\nX1 is inside."));
  QToolTip::hideText();
  auto* margin = fixture.editor.findChild<QWidget*>("programMargin");
  QHelpEvent beside(QEvent::ToolTip, {4, point.y()}, margin->mapToGlobal(QPoint(4, point.y())));
  QApplication::sendEvent(margin, &beside);
  QCOMPARE(QToolTip::text(), QString("G5 is not supported.\nX1 is inside."));
  QTest::mouseClick(margin, Qt::LeftButton, {}, {4, point.y()});
  QCOMPARE(fixture.cursorLine(), 10);
}

void ProgramEditorTest::goesFromMarkToMark() {
  ProgramFixture fixture;
  QVERIFY(!fixture.editor.goToMark());
  QShortcut ofTheWindow(Qt::Key_F8, &fixture.editor, nullptr, nullptr, Qt::WindowShortcut);  // the editor comes first
  fixture.editor.setMarks({{3, 9, Severity::Error, "a"}, {6, 0, Severity::Note, "b"}});
  QList<int> lines;
  for (int i = 0; i < 3; ++i) {
    QTest::keyClick(&fixture.editor, Qt::Key_F8);
    lines << fixture.cursorLine();
  }
  QTest::keyClick(&fixture.editor, Qt::Key_F8, Qt::ShiftModifier);
  lines << fixture.cursorLine();
  QCOMPARE(lines, QList<int>({3, 6, 3, 6}));
  QTest::keyClick(&fixture.editor, Qt::Key_F8);
  QCOMPARE(fixture.editor.textCursor().positionInBlock(), 8);
}

// The line is scrolled into view, and the user's cursor stays.
void ProgramEditorTest::executedLine() {
  ProgramFixture fixture(longProgram(1000));
  fixture.editor.goTo(3);
  fixture.editor.setCurrentLine(500);
  QCOMPARE(fixture.editor.currentLine(), 500);
  QCOMPARE(fixture.cursorLine(), 3);
  QVERIFY(fixture.shownFirst() > 480 && fixture.shownFirst() <= 500);
  const int first = fixture.shownFirst();
  fixture.editor.setCurrentLine(501);
  QCOMPARE(fixture.shownFirst(), first);  // it is visible: nothing jumps
  fixture.editor.setCurrentLine(2);
  QVERIFY(fixture.shownFirst() <= 2);
  fixture.editor.setCurrentLine(100000);
  QCOMPARE(fixture.editor.currentLine(), 1000);
  QCOMPARE(fixture.editor.extraSelections().size(), 2);
  fixture.editor.setCurrentLine(0);
  QCOMPARE(fixture.editor.extraSelections().size(), 1);
  fixture.editor.setCurrentLine(-5);
  QCOMPARE(fixture.editor.currentLine(), 0);
}

void ProgramEditorTest::searches() {
  ProgramFixture fixture;
  QVERIFY(fixture.editor.findText("g1 x"));
  QCOMPARE(fixture.cursorLine(), 9);
  QVERIFY(!fixture.editor.findText("G1 Y"));
  QVERIFY(!fixture.editor.findText(QString()));
  QCOMPARE(fixture.cursorLine(), 9);
  QVERIFY(fixture.editor.findText("G18"));  // around the end
  QCOMPARE(fixture.cursorLine(), 3);
  QVERIFY(fixture.editor.findText("M30", true));
  QCOMPARE(fixture.cursorLine(), 11);
}

void ProgramEditorTest::searchBar() {
  ProgramFixture fixture;
  auto* bar = fixture.editor.findChild<QWidget*>("programSearch");
  auto* line = bar->findChild<QLineEdit*>();
  QVERIFY(!bar->isVisible());
  QTest::keyClick(&fixture.editor, Qt::Key_F, Qt::ControlModifier);
  QVERIFY(bar->isVisible() && line->hasFocus());
  QVERIFY(fixture.editor.viewport()->geometry().bottom() < bar->geometry().top());
  QTest::keyClicks(line, "X4");
  QCOMPARE(fixture.cursorLine(), 6);
  QTest::keyClicks(line, "0");
  QCOMPARE(bar->findChild<QLabel*>("programSearchState")->text(), QString("not found"));
  line->selectAll();
  QTest::keyClicks(line, "X");
  QCOMPARE(bar->findChild<QLabel*>("programSearchState")->text(), QString());
  QTest::keyClick(line, Qt::Key_Return);
  QCOMPARE(fixture.cursorLine(), 9);
  QTest::keyClick(line, Qt::Key_Return, Qt::ShiftModifier);
  QCOMPARE(fixture.cursorLine(), 6);
  QTest::keyClick(line, Qt::Key_Escape);
  QVERIFY(!bar->isVisible() && fixture.editor.hasFocus());
  QTest::keyClick(&fixture.editor, Qt::Key_F3);
  QCOMPARE(fixture.cursorLine(), 9);
}

void ProgramEditorTest::hostileTexts() {
  ProgramFixture fixture(QString(300000, 'X'));
  fixture.editor.setMarks({{1, 299999, Severity::Error, "far"}, {1, -7, Severity::Error, "all"}});
  fixture.editor.grab();
  fixture.editor.setMarks(std::vector<ProgramMark>(100000, {1, 0, Severity::Error, "again"}));
  fixture.editor.grab();
  QVERIFY(fixture.editor.markText(fixture.editor.document()->firstBlock()).size() < 1000);
  fixture.editor.setCurrentLine(1);
  fixture.editor.setPlainText(QStringLiteral("G1\0X\u2028Y\r\n\tZ(\n)))"));
  fixture.editor.grab();
  fixture.editor.setPlainText({});
  fixture.editor.setMarks({{5, 5, Severity::Error, "of nothing"}});
  fixture.editor.setCurrentLine(7);
  fixture.editor.goTo(-1, -1);
  fixture.editor.grab();
  QCOMPARE(fixture.editor.currentLine(), 1);
  QCOMPARE(fixture.editor.markText(fixture.editor.document()->firstBlock()), QString("of nothing"));
}

void ProgramEditorTest::pictures() {
  ProgramFixture fixture;
  fixture.editor.setMarks({{10, 5, Severity::Error, "G5 is not supported: use G1, G2 or G3."},
                           {6, 0, Severity::Warning, "Rapid near the chuck."},
                           {4, 5, Severity::Note, "Tool 1: right turning tool"}});
  fixture.editor.setCurrentLine(9);
  fixture.editor.goTo(7);
  QTest::keyClick(&fixture.editor, Qt::Key_F, Qt::ControlModifier);
  lookAt(fixture.editor, "program");
}

HANDWHEEL_CONTROLS_TEST(ProgramEditorTest)
#include "ProgramEditorTest.moc"
