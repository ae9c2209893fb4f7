// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/defects/DefectCard.h"

#include "panels/ActionButton.h"

#include <QAction>
#include <QLabel>
#include <QVBoxLayout>

namespace handwheel {

DefectCard::DefectCard(QAction* fix, QWidget* parent)
    : QFrame(parent),
      m_name(new QLabel(this)),
      m_hint(new QLabel(this)),
      m_remains(new QLabel(this)),
      m_status(new QLabel(this)) {
  setObjectName(QStringLiteral("defectCard"));
  m_name->setProperty("strong", true);
  m_hint->setProperty("muted", true);
  m_status->setProperty("muted", true);
  m_remains->setObjectName(QStringLiteral("defectRemains"));
  m_status->setObjectName(QStringLiteral("fixPreviewStatus"));
  for (QLabel* label : {m_hint, m_remains, m_status}) label->setWordWrap(true);
  showPreview({});
  auto* button = new ActionButton(fix, ActionButton::Rank::Primary, this);
  const auto follow = [button, fix] { button->setVisible(fix->isVisible()); };
  connect(fix, &QAction::changed, button, follow);
  follow();
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 12, 12, 12);
  column->setSpacing(8);
  for (QWidget* part : std::initializer_list<QWidget*>{m_name, m_hint, m_remains, m_status, button})
    column->addWidget(part);
}

void DefectCard::showPreview(const QString& text) {
  m_status->setText(text);
  m_status->setVisible(!text.isEmpty());
  followReason();
}

void DefectCard::showDefect(const QString& name, const QString& hint, const QString& remains) {
  m_name->setText(name);
  m_hint->setText(hint);
  m_reason = remains;
  m_remains->setText(remains.isEmpty() ? QString() : tr("Remains: %1.").arg(remains));
  followReason();
}

// Hides the reason if the preview says the same.
void DefectCard::followReason() {
  m_remains->setVisible(!m_reason.isEmpty() && !m_status->text().contains(m_reason));
}

}  // namespace handwheel
