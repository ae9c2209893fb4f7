// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/SuggestionCard.h"

#include "panels/ActionButton.h"
#include "theme/Icons.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace handwheel {

namespace {
constexpr int kMargin = 16;
constexpr int kWidth = 440;
constexpr int kButtonsInRow = 3;
}  // namespace

SuggestionCard::SuggestionCard(QWidget* over)
    : QFrame(over),
      m_icon(new QLabel(this)),
      m_title(new QLabel(this)),
      m_detail(new QLabel(this)),
      m_buttons(new QGridLayout) {
  setObjectName(QStringLiteral("nextStepCard"));
  setProperty("card", true);
  m_title->setObjectName(QStringLiteral("nextStepTitle"));
  m_title->setTextFormat(Qt::PlainText);  // of files, which come from anywhere
  m_detail->setTextFormat(Qt::PlainText);
  m_title->setProperty("strong", true);
  m_title->setWordWrap(true);
  m_detail->setObjectName(QStringLiteral("nextStepDetail"));
  m_detail->setProperty("muted", true);
  m_detail->setWordWrap(true);
  auto* close = new QToolButton(this);
  close->setObjectName(QStringLiteral("nextStepClose"));
  close->setIcon(icon(QStringLiteral("close")));
  close->setIconSize({12, 12});
  close->setToolTip(tr("Do not show this card for this document again"));
  close->setAccessibleName(close->toolTip());
  connect(close, &QToolButton::clicked, this, &SuggestionCard::dismissed);

  auto* title = new QHBoxLayout;
  title->setSpacing(8);
  title->addWidget(m_icon);
  title->addWidget(m_title, 1);
  title->addWidget(close, 0, Qt::AlignTop);
  m_buttons->setSpacing(8);
  m_buttons->setColumnStretch(kButtonsInRow, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 8, 8, 12);
  column->setSpacing(8);
  column->addLayout(title);
  column->addWidget(m_detail);
  column->addLayout(m_buttons);
  over->installEventFilter(this);
  hide();
}

void SuggestionCard::showStep(const Suggestion& step) {
  if (step.isEmpty()) {
    hide();
    emit covers(0);
    return;
  }
  m_icon->setPixmap(handwheel::icon(step.icon, step.colour).pixmap(QSize(20, 20), devicePixelRatioF()));
  m_title->setText(step.title);
  m_detail->setText(step.detail);
  m_detail->setVisible(!step.detail.isEmpty());
  setAccessibleName(step.title);
  while (QLayoutItem* item = m_buttons->takeAt(0)) {
    if (item->widget()) item->widget()->deleteLater();
    delete item;
  }
  auto rank = step.isFirstObvious ? ActionButton::Rank::Primary : ActionButton::Rank::Ordinary;
  for (QAction* action : step.actions) {
    auto* button = new ActionButton(action, rank, this);
    button->setObjectName(QStringLiteral("nextStep/") + action->objectName());
    if (step.pointed)
      connect(button, &ActionButton::pointed, this,
              [pointed = step.pointed, action](bool isPointed) { pointed(action, isPointed); });
    const int place = m_buttons->count();
    m_buttons->addWidget(button, place / kButtonsInRow, place % kButtonsInRow);
    rank = ActionButton::Rank::Ordinary;
  }
  show();
  raise();
  layout()->invalidate();
  place();
}

void SuggestionCard::place() {
  const QSize room = parentWidget()->size();
  const int width = std::min(room.width() - 2 * kMargin, std::max(kWidth, layout()->minimumSize().width()));
  const int height = layout()->totalHeightForWidth(width);
  setGeometry((room.width() - width) / 2, room.height() - height - kMargin, width, height);
  if (!isHidden()) emit covers(height + kMargin);
}

bool SuggestionCard::event(QEvent* event) {
  const bool handled = QFrame::event(event);
  if (event->type() == QEvent::LayoutRequest) place();  // texts or fonts have changed
  return handled;
}

bool SuggestionCard::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && watched == parent() && isVisible()) place();
  return QFrame::eventFilter(watched, event);
}

}  // namespace handwheel
