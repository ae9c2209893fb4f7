// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/program/ControlButton.h"

#include <QAction>
#include <QMenu>

namespace handwheel {

ControlButton::ControlButton(QWidget* parent) : QToolButton(parent) {
  setObjectName(QStringLiteral("programControl"));
  setText(tr("Control"));
  setToolTip(tr("Settings of the control that the program does not tell: decimal points and block skips"));
  setPopupMode(QToolButton::InstantPopup);
  setFocusPolicy(Qt::StrongFocus);
  auto* menu = new QMenu(this);
  const auto add = [this, menu](const QString& text, const QString& name) {
    QAction* const made = menu->addAction(text);
    made->setObjectName(name);
    made->setCheckable(true);
    connect(made, &QAction::triggered, this, &ControlButton::changed);
    return made;
  };
  m_increments =
      add(tr("A length without a decimal point counts 0.001 mm or 0.0001 inch"), QStringLiteral("programIncrements"));
  menu->addSeparator();
  for (std::size_t i = 0; i < kSkips; ++i) {
    const QString text = i == 0 ? tr("Skip blocks with / or /1") : tr("Skip blocks with /%1").arg(i + 1);
    m_skips[i] = add(text, QStringLiteral("programSkip%1").arg(i + 1));
  }
  setMenu(menu);
}

void ControlButton::setDialect(ProgramDialect dialect) {
  const bool isFanuc = dialect == ProgramDialect::Fanuc;
  m_increments->setEnabled(isFanuc);
  for (std::size_t i = 1; i < kSkips; ++i) m_skips[i]->setEnabled(isFanuc);
}

void ControlButton::applyTo(ProgramSetup& setup) const {
  setup.hasIncrements = m_increments->isEnabled() && m_increments->isChecked();
  setup.skips = 0;
  for (std::size_t i = 0; i < kSkips; ++i)
    if (m_skips[i]->isEnabled() && m_skips[i]->isChecked())
      setup.skips = static_cast<std::uint16_t>(setup.skips | 1u << (i + 1));
}

}  // namespace handwheel
