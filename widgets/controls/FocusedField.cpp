// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/FocusedField.h"

#include <QApplication>
#include <QDialog>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPointer>

namespace handwheel {

namespace {

bool isTypedIn(const QWidget& field) {
  const auto* const line = qobject_cast<const QLineEdit*>(&field);
  const auto* const text = qobject_cast<const QPlainTextEdit*>(&field);
  return (line && line->isModified()) || (text && text->document()->isModified());
}

}  // namespace

// The focus is lent to the window and not cleared: a listener would give it to the view.
void commitFocusedField() {
  const QPointer<QWidget> field = QApplication::focusWidget();
  if (!field || !isTypedIn(*field)) return;
  const QPointer<QWidget> window = field->window();
  if (qobject_cast<QDialog*>(window.data())) return;
  window->setFocus(Qt::OtherFocusReason);
  if (!window || !window->hasFocus()) return;  // it was passed on
  if (field && field->isVisible())
    field->setFocus(Qt::OtherFocusReason);
  else
    window->clearFocus();  // the field was removed with its subject
}

}  // namespace handwheel
