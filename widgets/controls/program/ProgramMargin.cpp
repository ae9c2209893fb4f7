// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/program/ProgramMargin.h"

#include "controls/program/ProgramEditor.h"
#include "theme/Theme.h"

#include <QHelpEvent>
#include <QPaintEvent>
#include <QPainter>
#include <QTextBlock>
#include <QToolTip>
#include <QWheelEvent>

namespace handwheel {

namespace {

constexpr int kNumberGap = 6;  // pixels at either side of the numbers

// Circle, triangle and square: the severities differ without colours, too.
void paintSeverity(QPainter& painter, const QRectF& box, ProgramMark::Severity severity, const QColor& colour) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  switch (severity) {
    case ProgramMark::Severity::Note:
      return painter.drawEllipse(box);
    case ProgramMark::Severity::Warning:
      painter.drawPolygon(QPolygonF{QPointF(box.center().x(), box.top()), box.bottomRight(), box.bottomLeft()});
      return;
    case ProgramMark::Severity::Error:
      return painter.drawRect(box);
  }
}

}  // namespace

ProgramMargin::ProgramMargin(ProgramEditor* editor) : QWidget(editor), m_editor(editor) {
  setObjectName(QStringLiteral("programMargin"));
}

QSize ProgramMargin::sizeHint() const {
  const QFontMetrics metrics(m_editor->font());
  const QString widest(std::max<qsizetype>(3, QString::number(m_editor->blockCount()).size()), QLatin1Char('9'));
  return {metrics.horizontalAdvance(widest) + metrics.height() + 2 * kNumberGap, 0};
}

void ProgramMargin::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setFont(m_editor->font());
  const ThemeColours& colours = themeColours(currentTheme());
  painter.fillRect(event->rect(), colours.window);
  const QFontMetrics metrics(m_editor->font());
  const double icon = 0.5 * metrics.height();
  const int cursorLine = m_editor->textCursor().blockNumber();
  m_editor->forEachShownLine([&](const QTextBlock& line, const QRectF& rectangle) {
    const int number = line.blockNumber();
    painter.setPen(number == cursorLine ? colours.text : colours.muted);
    const QRectF row(0.0, rectangle.top(), width() - kNumberGap, metrics.height());
    painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, QString::number(number + 1));
    const QRectF box(kNumberGap, row.center().y() - 0.5 * icon, icon, icon);
    const std::vector<ProgramMark>& marks = programMarks(line);
    if (!marks.empty()) paintSeverity(painter, box, worstOf(marks), severityColour(worstOf(marks), colours));
    if (number + 1 != m_editor->currentLine()) return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.success);
    painter.drawPolygon(QPolygonF{box.topLeft(), QPointF(box.right() + 2.0, box.center().y()), box.bottomLeft()});
  });
}

bool ProgramMargin::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const QString text = m_editor->markText(m_editor->cursorForPosition({0, help->pos().y()}).block());
  QToolTip::showText(help->globalPos(), text, this);
  return true;
}

void ProgramMargin::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return QWidget::mousePressEvent(event);
  m_editor->setTextCursor(m_editor->cursorForPosition({0, static_cast<int>(event->position().y())}));
  m_editor->setFocus();
}

void ProgramMargin::wheelEvent(QWheelEvent* event) {
  m_editor->scrollByWheel(event);
}

}  // namespace handwheel
