// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/program/ProgramEditor.h"

#include "controls/program/ProgramHighlighter.h"
#include "controls/program/ProgramMargin.h"
#include "controls/program/ProgramSearchBar.h"

#include <QFontDatabase>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QScrollBar>
#include <QTextBlock>
#include <QToolTip>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

constexpr int kShownColumns = 48;
constexpr int kShownLines = 20;
constexpr int kMostTexts = 20;  // texts of the marks of a line

QTextEdit::ExtraSelection wholeLine(const QTextBlock& line, const QColor& colour) {
  QTextEdit::ExtraSelection selection;
  selection.format.setBackground(colour);
  selection.format.setProperty(QTextFormat::FullWidthSelection, true);
  selection.cursor = QTextCursor(line);
  return selection;
}

}  // namespace

ProgramEditor::ProgramEditor(QWidget* parent)
    : QPlainTextEdit(parent),
      m_highlighter(new ProgramHighlighter(document())),
      m_margin(new ProgramMargin(this)),
      m_search(new ProgramSearchBar(this)) {
  setObjectName(QStringLiteral("programEditor"));
  setAccessibleName(tr("Program"));
  setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  setLineWrapMode(NoWrap);
  setTabChangesFocus(true);
  m_search->hide();
  connect(this, &QPlainTextEdit::blockCountChanged, this, &ProgramEditor::layOut);
  connect(m_search, &ProgramSearchBar::closed, this, [this] {
    layOut();
    setFocus();
  });
  connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect& area, int dy) {
    dy != 0 ? m_margin->scroll(0, dy) : m_margin->update(0, area.y(), m_margin->width(), area.height());
  });
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, [this] {
    const int line = textCursor().blockNumber() + 1;
    if (std::exchange(m_cursorLine, line) == line) return;
    showLines();
    emit cursorLineChanged(line);
  });
  layOut();
  showLines();
}

void ProgramEditor::setMarks(std::vector<Mark> marks) {
  setProgramMarks(*document(), std::move(marks));
  m_highlighter->refresh();
  m_margin->update();
}

void ProgramEditor::setCurrentLine(int line) {
  m_currentLine = std::clamp(line, 0, blockCount());
  showLines();
  if (m_currentLine == 0) return;
  const int first = firstVisibleBlock().blockNumber() + 1;
  const int shown = std::max(1, viewport()->height() / std::max(1, fontMetrics().lineSpacing()) - 1);
  if (m_currentLine < first || m_currentLine >= first + shown) {
    verticalScrollBar()->setValue(std::max(0, m_currentLine - 1 - shown / 3));
  }
}

void ProgramEditor::goTo(int line, int column) {
  const QTextBlock block = document()->findBlockByNumber(std::clamp(line, 1, blockCount()) - 1);
  QTextCursor cursor(block);
  cursor.setPosition(block.position() + std::clamp(column - 1, 0, block.length() - 1));
  setTextCursor(cursor);
  ensureCursorVisible();
}

bool ProgramEditor::goToMark(bool backwards) {
  const QTextBlock start = textCursor().block();
  QTextBlock line = start;
  do {
    line = backwards ? line.previous() : line.next();
    if (!line.isValid()) line = backwards ? document()->lastBlock() : document()->firstBlock();
    const std::vector<Mark>& marks = programMarks(line);
    if (marks.empty()) continue;
    goTo(line.blockNumber() + 1, std::max(1, marks.front().column));
    return true;
  } while (line != start);
  return false;
}

bool ProgramEditor::findText(const QString& text, bool backwards) {
  if (text.isEmpty()) return false;
  const QTextDocument::FindFlags flags = backwards ? QTextDocument::FindBackward : QTextDocument::FindFlags();
  QTextCursor found = document()->find(text, textCursor(), flags);
  if (found.isNull()) {
    QTextCursor end(document());
    if (backwards) end.movePosition(QTextCursor::End);
    found = document()->find(text, end, flags);
  }
  if (found.isNull()) return false;
  setTextCursor(found);
  return true;
}

QString ProgramEditor::markText(const QTextBlock& line) const {
  QStringList texts;
  for (const Mark& mark : programMarks(line)) {
    if (texts.size() == kMostTexts) return (texts << QStringLiteral("…")).join(QLatin1Char('\n'));
    texts << mark.text;
  }
  return texts.join(QLatin1Char('\n'));
}

void ProgramEditor::forEachShownLine(const std::function<void(const QTextBlock&, const QRectF&)>& visit) const {
  const double bottom = viewport()->height();
  QTextBlock line = firstVisibleBlock();
  QRectF rectangle = blockBoundingGeometry(line).translated(contentOffset());
  while (line.isValid() && rectangle.top() <= bottom) {
    visit(line, rectangle);
    const double next = rectangle.bottom();
    line = line.next();
    rectangle = blockBoundingRect(line);
    rectangle.moveTop(next);
  }
}

QSize ProgramEditor::sizeHint() const {
  return {m_margin->sizeHint().width() + kShownColumns * fontMetrics().horizontalAdvance(QLatin1Char('0')),
          kShownLines * fontMetrics().lineSpacing()};
}

// Lays out the margin beside and the search below the text.
void ProgramEditor::layOut() {
  const int left = m_margin->sizeHint().width();
  const int below = m_search->isHidden() ? 0 : m_search->sizeHint().height();
  setViewportMargins(left, 0, 0, below);
  const QRect inside = contentsRect();
  m_margin->setGeometry(inside.left(), inside.top(), left, inside.height() - below);
  m_search->setGeometry(inside.left(), inside.bottom() + 1 - below, inside.width(), below);
}

void ProgramEditor::colourShown() {
  const int first = firstVisibleBlock().blockNumber();
  const int shown = viewport()->height() / std::max(1, fontMetrics().lineSpacing()) + 2;
  m_highlighter->show(first, first + shown);
}

// Highlights the line of the cursor and the executed one.
void ProgramEditor::showLines() {
  const ThemeColours& colours = themeColours(currentTheme());
  QList<QTextEdit::ExtraSelection> lines{wholeLine(textCursor().block(), colours.hover)};
  if (m_currentLine > 0 && m_currentLine <= blockCount()) {
    QColor executed = colours.success;
    executed.setAlpha(70);
    lines << wholeLine(document()->findBlockByNumber(m_currentLine - 1), executed);
  }
  setExtraSelections(lines);
  m_margin->update();
}

void ProgramEditor::changeEvent(QEvent* event) {
  QPlainTextEdit::changeEvent(event);
  if (event->type() == QEvent::FontChange) layOut();
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) {
    m_highlighter->refresh();
    showLines();
  }
}

// Accepts its keys before actions of the window that have the same ones.
bool ProgramEditor::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Find) || key->key() == Qt::Key_F3 || key->key() == Qt::Key_F8) event->accept();
  }
  return QPlainTextEdit::event(event);
}

void ProgramEditor::keyPressEvent(QKeyEvent* event) {
  const bool isBack = event->modifiers() & Qt::ShiftModifier;
  if (event->matches(QKeySequence::Find)) {
    m_search->start(textCursor().selectedText());
    return layOut();
  }
  if (event->key() == Qt::Key_F3) return m_search->go(isBack);
  if (event->key() == Qt::Key_F8) {
    goToMark(isBack);
    return;
  }
  QPlainTextEdit::keyPressEvent(event);
}

void ProgramEditor::resizeEvent(QResizeEvent* event) {
  QPlainTextEdit::resizeEvent(event);
  layOut();
}

void ProgramEditor::paintEvent(QPaintEvent* event) {
  colourShown();
  QPlainTextEdit::paintEvent(event);
}

bool ProgramEditor::viewportEvent(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QPlainTextEdit::viewportEvent(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  QToolTip::showText(help->globalPos(), markText(cursorForPosition(help->pos()).block()), viewport());
  return true;
}

}  // namespace handwheel
