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
#include <algorithm>

namespace handwheel {

namespace {
constexpr int kMargin = 16;
constexpr int kWidth = 440;
constexpr int kWidestCard = 760;  // lines of more letters are hard to read
constexpr int kWiderBy = 40;
constexpr double kCoveredShare = 0.2;  // share of the height, above which the card becomes wider
constexpr int kButtonsInRow = 3;

void clearLayout(QLayout& layout) {
  while (QLayoutItem* item = layout.takeAt(0)) {
    if (item->widget()) item->widget()->deleteLater();
    delete item;
  }
}
}  // namespace

SuggestionCard::SuggestionCard(QWidget* over)
    : QFrame(over),
      m_icon(new QLabel(this)),
      m_title(new QLabel(this)),
      m_detail(new QLabel(this)),
      m_fold(new QToolButton(this)),
      m_first(new QHBoxLayout),
      m_buttons(new QGridLayout) {
  setObjectName(QStringLiteral("nextStepCard"));
  setProperty("card", true);
  m_title->setObjectName(QStringLiteral("nextStepTitle"));
  m_title->setTextFormat(Qt::PlainText);  // names of files may come from anywhere
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
  m_fold->setObjectName(QStringLiteral("nextStepFold"));
  m_fold->setIconSize({12, 12});
  connect(m_fold, &QToolButton::clicked, this, [this] { setFolded(!m_isFolded); });

  auto* title = new QHBoxLayout;
  title->setSpacing(8);
  title->addWidget(m_icon);
  title->addWidget(m_title, 1);
  title->addLayout(m_first);
  title->addWidget(m_fold, 0, Qt::AlignTop);
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
  setFolded(false);
  hide();
}

void SuggestionCard::setFolded(bool folded) {
  m_isFolded = folded;
  m_fold->setIcon(icon(folded ? QStringLiteral("up") : QStringLiteral("down")));
  m_fold->setToolTip(folded ? tr("Show the details and all actions") : tr("Fold this card to one line"));
  m_fold->setAccessibleName(m_fold->toolTip());
  if (!m_step.isEmpty()) showStep(Suggestion(m_step));
}

void SuggestionCard::showStep(const Suggestion& step) {
  m_step = step;
  if (step.isEmpty()) {
    hide();
    emit covers(0);
    return;
  }
  m_icon->setPixmap(handwheel::icon(step.icon, step.colour).pixmap(QSize(20, 20), devicePixelRatioF()));
  m_title->setText(step.title);
  m_detail->setText(step.detail);
  m_detail->setVisible(!m_isFolded && !step.detail.isEmpty());
  m_fold->setVisible(m_isFolded || !step.detail.isEmpty() || step.actions.size() > 1);
  setAccessibleName(step.title);
  showButtons();
  show();
  raise();
  layout()->invalidate();
  place();
}

void SuggestionCard::showButtons() {
  clearLayout(*m_first);
  clearLayout(*m_buttons);
  auto rank = m_step.isFirstObvious ? ActionButton::Rank::Primary : ActionButton::Rank::Ordinary;
  for (QAction* action : m_step.actions) {
    auto* button = new ActionButton(action, rank, this);
    button->setObjectName(QStringLiteral("nextStep/") + action->objectName());
    if (m_step.pointed)
      connect(button, &ActionButton::pointed, this,
              [pointed = m_step.pointed, action](bool isPointed) { pointed(action, isPointed); });
    if (m_isFolded) return m_first->addWidget(button);
    const int index = m_buttons->count();
    m_buttons->addWidget(button, index / kButtonsInRow, index % kButtonsInRow);
    rank = ActionButton::Rank::Ordinary;
  }
}

// Returns the least width at which the card covers little of the height, or at which it is lowest.
int SuggestionCard::widthIn(const QSize& room) const {
  const int most = room.width() - 2 * kMargin;
  int width = std::max(kWidth, layout()->minimumSize().width());
  int height = layout()->totalHeightForWidth(width);
  for (int wider = width + kWiderBy; wider <= std::min(kWidestCard, most); wider += kWiderBy) {
    if (height <= kCoveredShare * room.height()) break;
    const int lower = layout()->totalHeightForWidth(wider);
    if (lower >= height) continue;
    width = wider;
    height = lower;
  }
  return std::min(most, width);
}

void SuggestionCard::place() {
  const QSize room = parentWidget()->size();
  const int width = widthIn(room), height = layout()->totalHeightForWidth(width);
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
