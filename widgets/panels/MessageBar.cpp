// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/MessageBar.h"

#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QAccessible>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
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
      m_more(new QLabel(this)),
      m_action(new QPushButton(this)),
      m_other(new QPushButton(this)) {
  setObjectName(QStringLiteral("messageBar"));
  m_text->setObjectName(QStringLiteral("messageText"));
  m_text->setTextFormat(Qt::RichText);
  m_text->setWordWrap(true);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_more->setObjectName(QStringLiteral("messageMore"));
  m_more->setProperty("muted", true);
  m_action->setObjectName(QStringLiteral("messageAction"));
  m_other->setObjectName(QStringLiteral("messageOther"));
  auto* close = new QToolButton(this);
  close->setObjectName(QStringLiteral("messageClose"));
  close->setIcon(icon(QStringLiteral("close")));
  close->setIconSize({14, 14});
  close->setToolTip(tr("Close this message"));
  close->setAccessibleName(close->toolTip());
  const auto take = [this] {
    const Message message = std::move(m_messages.back());
    m_messages.pop_back();
    showLatest();
    return message;
  };
  connect(close, &QToolButton::clicked, this, take);
  connect(m_action, &QPushButton::clicked, this, [take] { take().action(); });
  connect(m_other, &QPushButton::clicked, this, [take] { take().other(); });

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

void MessageBar::showMessage(const Message& message) {
  std::erase_if(m_messages, [text = textOf(message)](const Message& earlier) { return textOf(earlier) == text; });
  if (m_messages.size() == kMostMessages) m_messages.erase(m_messages.begin());
  m_messages.push_back(message);
  showLatest();
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

void MessageBar::showLatest() {
  setVisible(!m_messages.empty());
  if (m_messages.empty()) return;
  const Message& message = m_messages.back();
  drawIcon();
  m_text->setText(textOf(message));
  setAccessibleName(message.title);
  m_action->setText(message.actionText);
  m_action->setVisible(message.action != nullptr);
  m_other->setText(message.otherText);
  m_other->setVisible(message.other != nullptr);
  m_more->setText(tr("%n more", nullptr, static_cast<int>(m_messages.size()) - 1));
  m_more->setVisible(m_messages.size() > 1);
}

void MessageBar::drawIcon() {
  if (m_messages.empty()) return;
  m_icon->setPixmap(iconOf(m_messages.back().weight).pixmap(QSize(20, 20), devicePixelRatioF()));
}

void MessageBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) drawIcon();
  QFrame::changeEvent(event);
}

}  // namespace handwheel
