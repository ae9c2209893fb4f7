// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/CommandDelegate.h"

#include "controls/CommandModel.h"
#include "theme/Theme.h"

#include <QIcon>
#include <QPainter>

namespace handwheel {

namespace {

constexpr int kPad = 8;
constexpr int kIcon = 16;

// Draws the text at the left or right end of the rest of the line, and reduces the rest.
void drawPart(QPainter& painter, QRect& line, const QString& text, const QColor& colour, Qt::Alignment side) {
  if (text.isEmpty() || line.width() <= 0) return;
  const QString fitting = painter.fontMetrics().elidedText(text, Qt::ElideRight, line.width());
  painter.setPen(colour);
  painter.drawText(line, side | Qt::AlignVCenter, fitting);
  const int taken = painter.fontMetrics().horizontalAdvance(fitting) + kPad;
  side == Qt::AlignLeft ? line.setLeft(line.left() + taken) : line.setRight(line.right() - taken);
}

}  // namespace

void CommandDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const ThemeColours& colours = themeColours(currentTheme());
  const QString reason = index.data(CommandModel::ReasonRole).toString();
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  if (option.state & QStyle::State_Selected) {
    QColor soft = colours.accent;
    soft.setAlpha(56);
    painter->setPen(Qt::NoPen);
    painter->setBrush(soft);
    painter->drawRoundedRect(option.rect, 4, 4);
  }
  QRect line = option.rect.adjusted(kPad, 0, -kPad, 0);
  if (!reason.isEmpty()) line.setBottom(option.rect.center().y());
  const QRect iconRect(line.left(), line.center().y() - kIcon / 2 + 1, kIcon, kIcon);
  const auto icon = index.data(Qt::DecorationRole).value<QIcon>();
  icon.paint(painter, iconRect, Qt::AlignCenter, reason.isEmpty() ? QIcon::Normal : QIcon::Disabled);
  line.setLeft(line.left() + kIcon + kPad);
  QRect below(line.left(), line.bottom(), line.width(), option.rect.bottom() - line.bottom());
  drawPart(*painter, line, index.data(CommandModel::ShortcutRole).toString(), colours.muted, Qt::AlignRight);
  drawPart(*painter, line, index.data(Qt::DisplayRole).toString(), reason.isEmpty() ? colours.text : colours.muted,
           Qt::AlignLeft);
  drawPart(*painter, line, index.data(CommandModel::PathRole).toString(), colours.muted, Qt::AlignLeft);
  drawPart(*painter, below, reason, colours.warning, Qt::AlignLeft);
  painter->restore();
}

QSize CommandDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const int lines = index.data(CommandModel::ReasonRole).toString().isEmpty() ? 1 : 2;
  return {0, lines * (option.fontMetrics.height() + 2) + kPad};
}

}  // namespace handwheel
