// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QPointer>

class QLabel;
class QLineEdit;
class QListView;
class QMainWindow;

namespace handwheel {

class CommandModel;

// A popup that finds and runs any action of the window by name. A few letters of the name suffice. The popup is shown
// over the top of the window; Esc or a click elsewhere closes it. The last used actions are stored in the settings.
class CommandPalette : public QFrame {
  Q_OBJECT

 public:
  explicit CommandPalette(QMainWindow* window);

  // Returns the action "Search commands…" (Ctrl+K) for menu and tool bar.
  QAction* action() const { return m_action; }
  void popUp();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  bool useKey(QKeyEvent* event);
  void search();
  void place();
  void run(const QModelIndex& index);
  void remember(const QString& id);

  QMainWindow* m_window;
  QAction* m_action;
  CommandModel* m_model;
  QLineEdit* m_query;
  QListView* m_list;
  QLabel* m_nothing;
  QPointer<QWidget> m_before;  // widget that had the focus before the palette was opened
};

}  // namespace handwheel
