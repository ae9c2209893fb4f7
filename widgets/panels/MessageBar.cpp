// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/MessageBar.h"

#include "document/Document.h"
#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {

constexpr std::size_t kMostMessages = 50;  // the log has them all

QIcon iconOf(Message::Weight weight) {
  const ThemeColours& colours = themeColours(currentTheme());
  switch (weight) {
    case Message::Weight::Info:
      return icon(QStringLiteral("info"), colours.accent);
    case Message::Weight::Warning:
      return icon(QStringLiteral("warning"), colours.warning);
    case Message::Weight::Error:
      return icon(QStringLiteral("error"), colours.error);
  }
  return {};
}

QString textOf(const Message& message) {
  QStringList lines;
  lines << QStringLiteral("<b>%1</b>").arg(message.title.toHtmlEscaped());
  if (!message.detail.isEmpty()) lines << message.detail.toHtmlEscaped();
  if (!message.advice.isEmpty()) lines << message.advice.toHtmlEscaped();
  return lines.join(QStringLiteral("<br>"));
}

}  // namespace

MessageBar::MessageBar(QWidget* parent)
    : QFrame(parent),
      m_icon(new QLabel(this)),
      m_text(new QLabel(this)),
      m_more(new QPushButton(this)),
      m_action(new QPushButton(this)),
      m_other(new QPushButton(this)) {
  setObjectName(QStringLiteral("messageBar"));
  m_text->setObjectName(QStringLiteral("messageText"));
  m_text->setTextFormat(Qt::RichText);
  m_text->setWordWrap(true);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_more->setObjectName(QStringLiteral("messageMore"));
  m_more->setFlat(true);
  m_more->setToolTip(tr("Show the next message"));
  connect(m_more, &QPushButton::clicked, this, &MessageBar::showNext);
  m_action->setObjectName(QStringLiteral("messageAction"));
  m_other->setObjectName(QStringLiteral("messageOther"));
  auto* close = new QToolButton(this);
  close->setObjectName(QStringLiteral("messageClose"));
  close->setIcon(icon(QStringLiteral("close")));
  close->setIconSize({14, 14});
  close->setToolTip(tr("Close this message"));
  close->setAccessibleName(close->toolTip());
  connect(close, &QToolButton::clicked, this, [this] {
    if (latest()) takeLatest();
  });
  connect(m_action, &QPushButton::clicked, this, [this] { act(&Message::action); });
  connect(m_other, &QPushButton::clicked, this, [this] { act(&Message::other); });

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 8, 8, 8);
  row->setSpacing(12);
  row->addWidget(m_icon, 0, Qt::AlignTop);
  row->addWidget(m_text, 1);
  row->addWidget(m_more, 0, Qt::AlignVCenter);
  row->addWidget(m_action, 0, Qt::AlignVCenter);
  row->addWidget(m_other, 0, Qt::AlignVCenter);
  row->addWidget(close, 0, Qt::AlignTop);
  hide();
}

void MessageBar::lieOver(QWidget* area) {
  m_area = area;
  setAutoFillBackground(true);
  area->installEventFilter(this);
  raise();
  place();
}

void MessageBar::place() {
  constexpr int kCorner = 136;  // pixels: of the view cube with its margin
  if (!m_area) return;
  const int width = std::max(m_area->width() - kCorner, m_area->width() / 2);
  const int height = hasHeightForWidth() ? heightForWidth(width) : sizeHint().height();
  setGeometry(m_area->x(), m_area->y(), width, std::min(height, m_area->height()));
}

bool MessageBar::event(QEvent* event) {
  const bool isDone = QFrame::event(event);
  if (event->type() == QEvent::LayoutRequest || event->type() == QEvent::Show) place();
  return isDone;
}

bool MessageBar::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_area && (event->type() == QEvent::Resize || event->type() == QEvent::Move)) place();
  return QFrame::eventFilter(watched, event);
}

void MessageBar::showMessage(const Message& message) {
  std::erase_if(m_messages, [&message](const Entry& earlier) {
    const bool isSame = earlier.message.about == message.about && earlier.message.title == message.title;
    return isOver(earlier) || (isSame && (message.about || textOf(earlier.message) == textOf(message)));
  });
  if (m_messages.size() == kMostMessages) m_messages.erase(m_messages.begin());
  m_messages.push_back({message, m_document, {}});
  m_messages.back().since.start();
  if (message.about && message.isOver)
    connect(message.about, &Document::changed, this, &MessageBar::removeOver, Qt::UniqueConnection);
  showLatest();
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

bool MessageBar::isOver(const Entry& entry) {
  return entry.message.isOver && entry.message.isOver();
}

void MessageBar::removeOver() {
  if (std::erase_if(m_messages, isOver) > 0) showLatest();
}

void MessageBar::setDocument(const Document* document) {
  if (m_document != document) {
    std::erase_if(m_messages, [this](const Entry& entry) {
      return !entry.message.about && !entry.message.comesFirst && entry.since.hasExpired(m_readingTime);
    });
  }
  m_document = document;
  std::erase_if(m_messages, isOver);
  for (Entry& entry : m_messages) {
    if (entry.arrivedOver != document) entry.arrivedOver = nullptr;
  }
  showLatest();
}

void MessageBar::withdraw(const Document* about, const QString& topic) {
  std::erase_if(m_messages,
                [&](const Entry& entry) { return entry.message.about == about && entry.message.topic == topic; });
  showLatest();
}

void MessageBar::forget(const Document* document) {
  std::erase_if(m_messages, [document](const Entry& entry) { return entry.message.about == document; });
  showLatest();
}

bool MessageBar::isSeen(const Entry& entry) const {
  const Document* about = entry.message.about;
  return !about || about == m_document || entry.arrivedOver == m_document;
}

bool MessageBar::comesFirst(const Entry& entry) const {
  return entry.message.comesFirst && (!entry.message.about || entry.since.elapsed() < m_readingTime);
}

const MessageBar::Entry* MessageBar::latest() const {
  const Entry* best = nullptr;
  for (const Entry& entry : m_messages) {
    const bool isBehind = best && comesFirst(*best) && !entry.message.comesFirst;
    if (isSeen(entry) && !isBehind) best = &entry;
  }
  return best;
}

// Moves the shown message behind all others.
void MessageBar::showNext() {
  const auto shown = m_messages.begin() + (latest() - m_messages.data());
  shown->message.comesFirst = false;  // it was read
  std::rotate(m_messages.begin(), shown, shown + 1);
  showLatest();
}

std::size_t MessageBar::seenCount() const {
  return static_cast<std::size_t>(
      std::count_if(m_messages.begin(), m_messages.end(), [this](const Entry& entry) { return isSeen(entry); }));
}

Message MessageBar::takeLatest() {
  const auto shown = m_messages.begin() + (latest() - m_messages.data());
  Message message = std::move(shown->message);
  m_messages.erase(shown);
  showLatest();
  return message;
}

// A button that was pressed for a message may be released after the message has gone, over one without it.
void MessageBar::act(std::function<void()> Message::*what) {
  if (const Entry* entry = latest(); entry && entry->message.*what) (takeLatest().*what)();
}

void MessageBar::showLatest() {
  const Entry* entry = latest();
  setVisible(entry != nullptr);
  if (!entry) return;
  const Message& message = entry->message;
  drawIcons();
  m_text->setText(textOf(message));
  setAccessibleName(message.title);
  m_action->setText(message.actionText);
  m_action->setVisible(message.action != nullptr);
  m_other->setText(message.otherText);
  m_other->setVisible(message.other != nullptr);
  const auto others = static_cast<int>(seenCount()) - 1;
  m_more->setText(tr("%n more", nullptr, others));
  m_more->setVisible(others > 0);
}

void MessageBar::drawIcons() {
  const Entry* const shown = latest();
  if (!shown) return;
  m_icon->setPixmap(iconOf(shown->message.weight).pixmap(QSize(20, 20), devicePixelRatioF()));
  auto heaviest = Message::Weight::Info;
  for (const Entry& entry : m_messages) {
    if (&entry != shown && isSeen(entry)) heaviest = std::max(heaviest, entry.message.weight);
  }
  m_more->setIcon(heaviest == Message::Weight::Info ? QIcon() : iconOf(heaviest));
}

void MessageBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) drawIcons();
  QFrame::changeEvent(event);
}

}  // namespace handwheel
