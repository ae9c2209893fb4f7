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
    : QFrame(parent), m_icon(new QLabel(this)), m_text(new QLabel(this)), m_action(new QPushButton(this)) {
  setObjectName(QStringLiteral("messageBar"));
  m_text->setObjectName(QStringLiteral("messageText"));
  m_text->setTextFormat(Qt::RichText);
  m_text->setWordWrap(true);
  m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_action->setObjectName(QStringLiteral("messageAction"));
  auto* close = new QToolButton(this);
  close->setObjectName(QStringLiteral("messageClose"));
  close->setIcon(icon(QStringLiteral("close")));
  close->setIconSize({14, 14});
  close->setToolTip(tr("Close this message"));
  close->setAccessibleName(close->toolTip());
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  connect(m_action, &QPushButton::clicked, this, [this] {
    hide();
    if (const auto run = std::exchange(m_run, nullptr)) run();
  });

  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 8, 8, 8);
  row->setSpacing(12);
  row->addWidget(m_icon, 0, Qt::AlignTop);
  row->addWidget(m_text, 1);
  row->addWidget(m_action, 0, Qt::AlignVCenter);
  row->addWidget(close, 0, Qt::AlignTop);
  hide();
}

void MessageBar::showMessage(const Message& message) {
  m_weight = message.weight;
  drawIcon();
  m_text->setText(textOf(message));
  setAccessibleName(message.title);
  m_run = message.action;
  m_action->setText(message.actionText);
  m_action->setVisible(m_run != nullptr);
  show();
  QAccessibleEvent alert(this, QAccessible::Alert);
  QAccessible::updateAccessibility(&alert);
}

void MessageBar::drawIcon() {
  m_icon->setPixmap(iconOf(m_weight).pixmap(QSize(20, 20), devicePixelRatioF()));
}

void MessageBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) drawIcon();
  QFrame::changeEvent(event);
}

}  // namespace handwheel
