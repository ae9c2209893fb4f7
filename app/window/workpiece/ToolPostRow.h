// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/workpiece/ManualLatheTool.h"

#include <QWidget>

class QComboBox;
class QMenu;
class QToolButton;

namespace handwheel {

// The controls of the tool post of a manual lathe. They choose the side of the post that is in use, and mount another
// tool on it from a menu. Drills are mounted in the tailstock. It must be used on the window thread.
class ToolPostRow : public QWidget {
  Q_OBJECT

 public:
  explicit ToolPostRow(QWidget* parent = nullptr);

  void show(const ManualLatheTool& tool);

 signals:
  void sideChosen(int station);
  void mountRequested(const QString& tool);  // id, for the side in use; empty: take the tool off

 private:
  void fillMenu();

  QComboBox* m_sides;
  QToolButton* m_mount;
  QMenu* m_menu;
  std::vector<std::string> m_listed;  // ids of the tools in the post
  LatheTools m_tools;
  LatheSetup m_setup;
};

}  // namespace handwheel
