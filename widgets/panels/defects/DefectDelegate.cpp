// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/defects/DefectDelegate.h"

#include "panels/defects/DefectModel.h"
#include "theme/Icons.h"
#include "theme/Theme.h"

#include <QLocale>
#include <QMouseEvent>
#include <QPainter>

namespace handwheel {

namespace {

constexpr int kRowHeight = 26;
constexpr int kIcon = 16;
constexpr int kDefectGap = 8;

bool isGroup(const QModelIndex& index) {
  return !index.parent().isValid();
}

// Returns the row with the indentation, which the view leaves to the delegate (see the style sheet).
QRect wholeRow(const QRect& item) {
  return {0, item.top(), item.right() + 1, item.height()};
}

QRect eyeRect(const QRect& row) {
  return {row.right() - kDefectGap - kIcon, row.center().y() - kIcon / 2 + 1, kIcon, kIcon};
}

QString groupNumber(const QModelIndex& group) {
  const int count = group.data(DefectModel::CountRole).toInt();
  if (count < 0) return DefectModel::tr("searching…");
  return count == 0 ? DefectModel::tr("none") : QLocale().toString(count);
}

QFont groupFont(const QStyleOptionViewItem& option, const QModelIndex& group) {
  QFont font = option.font;
  font.setBold(group.data(DefectModel::CountRole).toInt() > 0);
  return font;
}

}  // namespace

// The width is that of name and number, or name and brief detail: nothing of these is to be cut off.
QSize DefectDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const QString name = index.data().toString();
  int width = 0;
  if (isGroup(index)) {
    const QFontMetrics metrics(groupFont(option, index));
    width = 4 + 2 * kIcon + 4 * kDefectGap + metrics.horizontalAdvance(name) +
            metrics.horizontalAdvance(groupNumber(index));
  } else {
    const QString brief = index.data(DefectModel::BriefRole).toString();
    width = 2 * kDefectGap + option.fontMetrics.horizontalAdvance(name);
    if (!brief.isEmpty()) width += kDefectGap + option.fontMetrics.horizontalAdvance(brief);
    if (!index.data(DefectModel::NoteRole).toString().isEmpty()) width += kIcon + 4;
  }
  return {width, std::max(kRowHeight, option.fontMetrics.height() + 8)};
}

void DefectDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QStyleOptionViewItem row = option;
  initStyleOption(&row, index);
  const int loop = index.data(DefectModel::LoopRole).toInt();
  if (loop >= 0 && loop == m_highlightedLoop) row.state |= QStyle::State_MouseOver;
  painter->save();
  const ThemeColours& colours = themeColours(currentTheme());
  if (row.state & QStyle::State_Selected) {
    QColor soft = colours.accent;
    soft.setAlpha(56);
    painter->fillRect(wholeRow(row.rect), soft);
    painter->fillRect(QRect(0, row.rect.top(), 3, row.rect.height()), colours.accent);
  } else if (row.state & QStyle::State_MouseOver) {
    painter->fillRect(isGroup(index) ? row.rect : wholeRow(row.rect), colours.hover);
  }
  isGroup(index) ? paintGroup(painter, row, index) : paintDefect(painter, row, index);
  painter->restore();
}

void DefectDelegate::paintGroup(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const ThemeColours& colours = themeColours(currentTheme());
  const int count = index.data(DefectModel::CountRole).toInt();
  QRect left = option.rect.adjusted(4, 0, -kDefectGap, 0);
  const QRect iconRect(left.left(), left.center().y() - kIcon / 2 + 1, kIcon, kIcon);
  const QIcon sign = index.data(Qt::DecorationRole).value<QIcon>();
  painter->setOpacity(count == 0 ? 0.45 : 1.0);
  sign.paint(painter, iconRect);
  painter->setOpacity(1.0);

  const QRect eye = eyeRect(option.rect);
  QRect right(left.left(), left.top(), eye.left() - kDefectGap - left.left(), left.height());
  QString number = groupNumber(index);
  if (count < 0) {
    const int width = option.fontMetrics.horizontalAdvance(number);
    paintSpinner(painter, {right.right() - width - kIcon - 4, iconRect.top(), kIcon, kIcon});
  } else if (count == 0) {
    icon(QStringLiteral("ok"), colours.success).paint(painter, eye);
  } else {
    const bool shown = index.data(DefectModel::ShownRole).toBool();
    icon(shown ? QStringLiteral("eye") : QStringLiteral("eye-off"), colours.muted).paint(painter, eye);
  }
  painter->setFont(groupFont(option, index));
  const int before = index.data(DefectModel::BeforeRole).toInt();
  const QString compared = QStringLiteral("%1\u2009→\u2009%2").arg(QLocale().toString(before), number);
  const int room = right.width() - kIcon - 2 * kDefectGap;
  if (before >= 0 && painter->fontMetrics().horizontalAdvance(index.data().toString() + compared) <= room)
    number = compared;
  painter->setPen(count > 0 ? colours.text : colours.muted);
  painter->drawText(right, Qt::AlignRight | Qt::AlignVCenter, number);
  const QRect name =
      right.adjusted(kIcon + kDefectGap, 0, -painter->fontMetrics().horizontalAdvance(number) - kDefectGap, 0);
  painter->drawText(name, Qt::AlignLeft | Qt::AlignVCenter,
                    painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight, name.width()));
}

void DefectDelegate::paintDefect(QPainter* painter, const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const {
  const ThemeColours& colours = themeColours(currentTheme());
  QRect rect = option.rect.adjusted(kDefectGap, 0, -kDefectGap, 0);
  if (!index.data(DefectModel::NoteRole).toString().isEmpty()) {
    const QRect sign(rect.right() - kIcon + 1, rect.center().y() - kIcon / 2 + 1, kIcon, kIcon);
    icon(QStringLiteral("warning"), colours.warning).paint(painter, sign);
    rect.setRight(sign.left() - 4);
  }
  const QString name = index.data().toString();
  const int nameWidth = option.fontMetrics.horizontalAdvance(name) + kDefectGap;
  painter->setPen(colours.text);
  painter->drawText(rect, Qt::AlignLeft | Qt::AlignVCenter,
                    option.fontMetrics.elidedText(name, Qt::ElideRight, rect.width()));
  painter->setPen(colours.muted);
  const int room = rect.width() - nameWidth;
  if (room <= 0) return;
  QString detail = index.data(DefectModel::DetailRole).toString();
  if (option.fontMetrics.horizontalAdvance(detail) > room) detail = index.data(DefectModel::BriefRole).toString();
  painter->drawText(rect, Qt::AlignRight | Qt::AlignVCenter,
                    option.fontMetrics.elidedText(detail, Qt::ElideRight, room));
}

void DefectDelegate::paintSpinner(QPainter* painter, const QRect& rect) const {
  painter->save();
  painter->setRenderHint(QPainter::SmoothPixmapTransform);
  painter->translate(QRectF(rect).center());
  painter->rotate(m_spinnerAngle);
  const QRect centred(-rect.width() / 2, -rect.height() / 2, rect.width(), rect.height());
  icon(QStringLiteral("spinner"), themeColours(currentTheme()).accent).paint(painter, centred);
  painter->restore();
}

bool DefectDelegate::editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                                 const QModelIndex& index) {
  if (event->type() == QEvent::MouseButtonRelease && isGroup(index) && index.data(DefectModel::CountRole).toInt() > 0) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if (eyeRect(option.rect).adjusted(-4, -4, 4, 4).contains(mouse->position().toPoint())) {
      emit eyeClicked(index);
      return true;
    }
  }
  return QStyledItemDelegate::editorEvent(event, model, option, index);
}

}  // namespace handwheel
