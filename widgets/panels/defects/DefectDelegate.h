// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace handwheel {

// A delegate that draws the rows of the defects list. The row of a group shows icon, count and eye; the row of a defect
// shows its measurements at the right.
class DefectDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

  // Sets the loop under the cursor in the viewport, whose row is drawn like the row under the cursor; -1: none.
  void setHighlightedLoop(int loop) { m_highlightedLoop = loop; }
  // Advances the animated symbol of a running search. To be called by the panel at intervals while a search runs.
  void turnSpinner() { m_spinnerAngle = (m_spinnerAngle + 30) % 360; }

 signals:
  void eyeClicked(const QModelIndex& group);

 protected:
  bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override;

 private:
  void paintGroup(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
  void paintDefect(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const;
  void paintSpinner(QPainter* painter, const QRect& rect) const;

  int m_highlightedLoop = -1;
  int m_spinnerAngle = 0;
};

}  // namespace handwheel
