// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QButtonGroup>
#include <QComboBox>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QSet>
#include <QTest>
#include <functional>

// Functions that find accessibility defects of a window. Such defects affect people who use the keyboard, a screen
// reader or large letters. Each function returns one line per finding: the path of object names and classes from the
// root. Only visible widgets are examined.
namespace handwheel::test {

inline QString pathOf(const QWidget* widget, const QWidget& root) {
  QStringList parts;
  for (; widget && widget != &root; widget = widget->parentWidget()) {
    const QString name = widget->objectName();
    parts.prepend(name.isEmpty() ? QString::fromLatin1(widget->metaObject()->className()) : name);
  }
  return parts.join(QLatin1Char('/'));
}

// Returns true for a part of another widget that is operated through that widget, such as the line of a spin box or the
// list of a combo box.
inline bool isInnerPart(const QWidget* widget) {
  for (const QWidget* p = widget->parentWidget(); p && !p->isWindow(); p = p->parentWidget()) {
    if (qobject_cast<const QComboBox*>(p) || qobject_cast<const QAbstractSpinBox*>(p) ||
        qobject_cast<const QKeySequenceEdit*>(p) || qobject_cast<const QLineEdit*>(p) ||
        qobject_cast<const QAbstractItemView*>(p)) {
      return true;
    }
    if (p->inherits("QTabBar")) return true;
  }
  return false;
}

inline QList<QWidget*> visibleWidgets(QWidget& root) {
  QList<QWidget*> widgets = root.findChildren<QWidget*>();
  widgets.removeIf([&root](const QWidget* w) { return !w->isVisibleTo(&root) || w->window() != root.window(); });
  return widgets;
}

// Returns the widgets that take the focus by Tab, but have no accessible name.
inline QStringList withoutAccessibleName(QWidget& root) {
  QStringList found;
  for (QWidget* widget : visibleWidgets(root)) {
    if (!(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy() || isInnerPart(widget)) continue;
    const QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(widget);
    if (!interface || interface->text(QAccessible::Name).trimmed().isEmpty()) found << pathOf(widget, root);
  }
  return found;
}

// Returns true for widgets that a mouse can operate.
inline bool isOperated(const QWidget* widget) {
  if (!widget->isEnabled() || isInnerPart(widget) || qobject_cast<const QScrollBar*>(widget)) return false;
  return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
         qobject_cast<const QComboBox*>(widget) || qobject_cast<const QAbstractSlider*>(widget) ||
         qobject_cast<const QAbstractSpinBox*>(widget) || qobject_cast<const QAbstractItemView*>(widget) ||
         qobject_cast<const QKeySequenceEdit*>(widget) || (widget->focusPolicy() & Qt::TabFocus);
}

// Returns the widgets that the mouse can operate and that pressing Tab again and again never reaches. In a group of
// exclusive buttons, reaching one button is enough. The window must be visible and able to become active (X without a
// window manager activates no tool window). otherwise: a function that returns true for widgets that are reached by
// other means, such as a menu.
inline QStringList notReachedByTab(QWidget& root, const std::function<bool(const QWidget*)>& otherwise = {}) {
  root.window()->activateWindow();
  const auto isActive = [&root] { return root.window()->isActiveWindow(); };
  if (!QTest::qWaitFor(isActive)) return {QStringLiteral("the window is not active")};
  QSet<const QWidget*> reached;
  const int limit = 2 * int(root.window()->findChildren<QWidget*>().size()) + 2;
  for (int i = 0; i < limit; ++i) {
    QWidget* before = QApplication::focusWidget();
    QTest::keyClick(before ? before : root.window(), Qt::Key_Tab);
    QWidget* now = QApplication::focusWidget();
    if (!now || (now == before && i > 0) || (i > 0 && reached.contains(now))) break;
    reached.insert(now);
    if (const auto* button = qobject_cast<QAbstractButton*>(now); button && button->group()) {
      for (const QAbstractButton* other : button->group()->buttons()) reached.insert(other);
    }
  }
  QStringList found;
  for (const QWidget* widget : visibleWidgets(root)) {
    const QWidget* target = widget;
    while (target->focusProxy()) target = target->focusProxy();
    if (!isOperated(widget) || reached.contains(target) || (otherwise && otherwise(widget))) continue;
    found << pathOf(widget, root);
  }
  return found;
}

// Returns the labels and buttons with less room than their text needs.
inline QStringList cutTexts(QWidget& root) {
  QStringList found;
  for (const QWidget* widget : visibleWidgets(root)) {
    const auto* label = qobject_cast<const QLabel*>(widget);
    const bool texted = (label && !label->text().isEmpty()) || qobject_cast<const QAbstractButton*>(widget);
    if (!texted || isInnerPart(widget)) continue;
    const QSize needed = widget->hasHeightForWidth()  // the text wraps
                             ? QSize(widget->minimumSizeHint().width(), widget->heightForWidth(widget->width()))
                             : widget->sizeHint();
    if (widget->width() >= needed.width() && widget->height() >= needed.height()) continue;
    found << QStringLiteral("%1: %2x%3 of %4x%5")
                 .arg(pathOf(widget, root))
                 .arg(widget->width())
                 .arg(widget->height())
                 .arg(needed.width())
                 .arg(needed.height());
  }
  return found;
}

// Returns the visible cells and headers of lists with less width than their text needs.
inline QStringList cutCells(QWidget& root) {
  QStringList found;
  const auto tell = [&](const QWidget& widget, const QString& text, int width, int needed) {
    found << QStringLiteral("%1 “%2”: %3 of %4").arg(pathOf(&widget, root), text).arg(width).arg(needed);
  };
  for (QWidget* widget : visibleWidgets(root)) {
    if (const auto* header = qobject_cast<QHeaderView*>(widget)) {
      if (header->orientation() != Qt::Horizontal || !header->model()) continue;
      for (int i = 0; i < header->count(); ++i) {
        const QString text = header->model()->headerData(i, Qt::Horizontal).toString();
        const int needed = header->fontMetrics().horizontalAdvance(text);
        if (!header->isSectionHidden(i) && header->sectionSize(i) < needed)
          tell(*header, text, header->sectionSize(i), needed);
      }
      continue;
    }
    const auto* view = qobject_cast<QAbstractItemView*>(widget);
    if (!view || !view->model() || isInnerPart(view)) continue;
    const std::function<void(const QModelIndex&)> lookUnder = [&](const QModelIndex& parent) {
      for (int row = 0; row < view->model()->rowCount(parent); ++row) {
        for (int column = 0; column < view->model()->columnCount(parent); ++column) {
          const QModelIndex index = view->model()->index(row, column, parent);
          const QRect cell = view->visualRect(index);
          const QString text = index.data().toString();
          const int needed = view->sizeHintForIndex(index).width();
          if (text.isEmpty() || !view->viewport()->rect().intersects(cell) || view->indexWidget(index)) continue;
          if (cell.width() < needed) tell(*view, text, cell.width(), needed);
        }
        lookUnder(view->model()->index(row, 0, parent));
      }
    };
    lookUnder(view->rootIndex());
  }
  return found;
}

}  // namespace handwheel::test
