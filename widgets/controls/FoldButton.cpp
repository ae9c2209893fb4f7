// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/FoldButton.h"

namespace handwheel {

FoldButton::FoldButton(const QString& text, bool isOpen, QWidget* parent) : QToolButton(parent) {
  setText(text);
  setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  setAutoRaise(true);
  setFocusPolicy(Qt::StrongFocus);
  setOpen(isOpen);
  connect(this, &QToolButton::clicked, this, [this] {
    setOpen(!m_isOpen);
    emit toggledOpen(m_isOpen);
  });
}

void FoldButton::setOpen(bool isOpen) {
  m_isOpen = isOpen;
  setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
  setToolTip(isOpen ? tr("Hide the fields of %1").arg(text()) : tr("Show the fields of %1").arg(text()));
}

}  // namespace handwheel
