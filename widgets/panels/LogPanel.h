// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QTreeView;

namespace handwheel {

class LogModel;

// A panel that shows the log. Rows can be copied with Ctrl+C.
class LogPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LogPanel(LogModel* model, QWidget* parent = nullptr);

 private:
  void copySelected() const;

  QTreeView* m_view;
};

}  // namespace handwheel
