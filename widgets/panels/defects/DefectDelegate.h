// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStyledItemDelegate>

namespace handwheel {

// Draws the rows of the defects list. A group has its icon, count and eye; a defect has its measurements at the right.
class DefectDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

  // Sets the loop under the cursor in the viewport, drawn as if under the cursor here; -1 for none.
  void setHighlightedLoop(int loop) { m_highlightedLoop = loop; }
  // Advances the animated symbol of a running search. Called by the panel while one runs.
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
