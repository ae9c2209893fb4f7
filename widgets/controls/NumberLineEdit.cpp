// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/NumberLineEdit.h"

#include "theme/Theme.h"

#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>

namespace handwheel {

namespace {

constexpr int kGap = 4;  // pixels between a mark and the number

bool isEnter(const QKeyEvent& event) {
  return event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
}

bool isStep(const QKeyEvent& event) {
  return event.key() == Qt::Key_Up || event.key() == Qt::Key_Down;
}

}  // namespace

double stepFactor(Qt::KeyboardModifiers modifiers) {
  if (modifiers & Qt::ShiftModifier) return 10.0;
  return modifiers & Qt::ControlModifier ? 0.1 : 1.0;
}

double wheelNotches(const QWheelEvent& event) {
  constexpr double kNotch = 120.0;  // eighths of a degree
  // With Shift or Alt held some systems turn the wheel sideways.
  const QPoint turn = event.angleDelta();
  return (turn.y() != 0 ? turn.y() : turn.x()) / kNotch;
}

void NumberLineEdit::setMarks(const QString& prefix, const QString& unit) {
  m_prefix = prefix;
  m_unit = unit;
  const auto room = [](const QString& mark, const QFont& font) {
    return mark.isEmpty() ? 0 : QFontMetrics(font).horizontalAdvance(mark) + kGap;
  };
  setTextMargins(room(prefix, prefixFont()), 0, room(unit, font()), 0);
  update();
}

// Returns a font for ⌀, which most fonts draw small, and nobody may overlook it.
QFont NumberLineEdit::prefixFont() const {
  QFont large = font();
  large.setPointSizeF(large.pointSizeF() * 1.25);
  return large;
}

// Claims keys that would otherwise start an action of the window. Enter and Esc belong to the line while there is
// something to commit or to revert, and to the tool afterwards.
bool NumberLineEdit::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto& key = static_cast<QKeyEvent&>(*event);
    if (isStep(key) || (isModified() && (isEnter(key) || key.key() == Qt::Key_Escape))) {
      event->accept();
      return true;
    }
  }
  return QLineEdit::event(event);
}

void NumberLineEdit::keyPressEvent(QKeyEvent* event) {
  if (isStep(*event)) {
    emit stepped((event->key() == Qt::Key_Up ? 1.0 : -1.0) * stepFactor(event->modifiers()));
  } else if (isModified() && isEnter(*event)) {
    emit committed();
  } else if (isModified() && event->key() == Qt::Key_Escape) {
    emit reverted();
  } else if (isEnter(*event) || event->key() == Qt::Key_Escape) {
    event->ignore();
  } else {
    QLineEdit::keyPressEvent(event);
  }
}

void NumberLineEdit::keyReleaseEvent(QKeyEvent* event) {
  if (isStep(*event) && !event->isAutoRepeat()) emit stepsEnded();
  QLineEdit::keyReleaseEvent(event);
}

// Without the focus the wheel scrolls the form: nobody changes a value by passing over it.
void NumberLineEdit::wheelEvent(QWheelEvent* event) {
  const double notches = wheelNotches(*event);
  if (!hasFocus() || notches == 0.0) {
    event->ignore();
    return;
  }
  emit stepped(notches * stepFactor(event->modifiers()));
  event->accept();
}

void NumberLineEdit::focusOutEvent(QFocusEvent* event) {
  emit stepsEnded();
  if (isModified() && event->reason() != Qt::PopupFocusReason) emit committed();
  QLineEdit::focusOutEvent(event);
}

void NumberLineEdit::paintEvent(QPaintEvent* event) {
  QLineEdit::paintEvent(event);
  QPainter painter(this);
  const QColor off = palette().color(QPalette::Disabled, QPalette::Text);
  const ThemeColours& colours = themeColours(currentTheme());
  const QRect inner = rect().adjusted(kGap * 2, 0, -kGap * 2, 0);
  painter.setPen(isEnabled() ? colours.muted : off);
  painter.drawText(inner, Qt::AlignRight | Qt::AlignVCenter, m_unit);
  painter.setPen(isEnabled() ? colours.text : off);
  painter.setFont(prefixFont());
  painter.drawText(inner, Qt::AlignLeft | Qt::AlignVCenter, m_prefix);
}

}  // namespace handwheel
