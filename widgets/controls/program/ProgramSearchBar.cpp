// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/program/ProgramSearchBar.h"

#include "controls/OwnKeys.h"
#include "controls/program/ProgramEditor.h"
#include "theme/Icons.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

namespace handwheel {

namespace {

QToolButton* searchButton(const char* name, const char* iconName, const QString& text, QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setObjectName(QString::fromLatin1(name));
  button->setIcon(icon(QString::fromLatin1(iconName)));
  button->setToolTip(text);
  button->setAccessibleName(text);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

}  // namespace

ProgramSearchBar::ProgramSearchBar(ProgramEditor* editor)
    : QWidget(editor), m_editor(editor), m_text(new QLineEdit(this)), m_state(new QLabel(this)) {
  setObjectName(QStringLiteral("programSearch"));
  setAutoFillBackground(true);
  new OwnKeys(*this, {Qt::Key_Return, Qt::Key_Enter, Qt::Key_F3, Qt::Key_Escape});
  setFont(QWidget().font());  // not the font of programs
  m_text->setObjectName(QStringLiteral("programSearchText"));
  m_text->setPlaceholderText(tr("Find in the program"));
  m_text->setAccessibleName(m_text->placeholderText());
  m_state->setObjectName(QStringLiteral("programSearchState"));
  m_state->setProperty("muted", true);
  auto* previous = searchButton("programSearchPrevious", "previous", tr("Previous (Shift+F3)"), this);
  auto* next = searchButton("programSearchNext", "next", tr("Next (F3)"), this);
  auto* close = searchButton("programSearchClose", "close", tr("Close (Esc)"), this);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 2, 4, 2);
  row->setSpacing(4);
  row->addWidget(m_text, 1);
  row->addWidget(m_state);
  row->addWidget(previous);
  row->addWidget(next);
  row->addWidget(close);
  connect(m_text, &QLineEdit::textEdited, this, &ProgramSearchBar::searchFromSelection);
  connect(previous, &QToolButton::clicked, this, [this] { go(true); });
  connect(next, &QToolButton::clicked, this, [this] { go(false); });
  connect(close, &QToolButton::clicked, this, [this] {
    hide();
    emit closed();
  });
}

void ProgramSearchBar::start(const QString& text) {
  if (!text.isEmpty() && !text.contains(QChar::ParagraphSeparator)) m_text->setText(text);
  m_state->clear();
  show();
  m_text->setFocus();
  m_text->selectAll();
}

void ProgramSearchBar::go(bool backwards) {
  if (!m_text->text().isEmpty()) showFound(m_editor->findText(m_text->text(), backwards));
}

// A found text stays found while it grows.
void ProgramSearchBar::searchFromSelection() {
  QTextCursor cursor = m_editor->textCursor();
  cursor.setPosition(cursor.selectionStart());
  m_editor->setTextCursor(cursor);
  showFound(m_text->text().isEmpty() || m_editor->findText(m_text->text()));
}

void ProgramSearchBar::showFound(bool isFound) {
  m_state->setText(isFound ? QString() : tr("not found"));
}

void ProgramSearchBar::keyPressEvent(QKeyEvent* event) {
  const bool isBack = event->modifiers() & Qt::ShiftModifier;
  switch (event->key()) {
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_F3:
      return go(isBack);
    case Qt::Key_Escape:
      hide();
      emit closed();
      return;
    default:
      return QWidget::keyPressEvent(event);
  }
}

}  // namespace handwheel
