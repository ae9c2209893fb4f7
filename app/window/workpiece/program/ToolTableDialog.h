// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>  // included before <numbers> of Units.h, which moc cannot parse by itself

#include "machining/program/ProgramSetup.h"

#include <QDialog>

class QTableWidget;

namespace handwheel {

// A dialog that changes the tool table of a program. The window stays usable while the dialog is open. The dialog is
// deleted when it is closed.
class ToolTableDialog : public QDialog {
  Q_OBJECT

 public:
  // bodies: the tools of the lathe to choose from. post: the tools in the tool post, from T1.
  ToolTableDialog(const ProgramTools& tools, LatheTools bodies, LatheTools post, ProgramDialect dialect,
                  QWidget* parent);

 signals:
  void chosen(const handwheel::ProgramTools& tools);

 private:
  void addRow(int number, const ProgramTool& tool);
  void takeBody(int row);
  void fromLathe();
  int freeNumber() const;
  ProgramTools tools() const;

  LatheTools m_bodies, m_post;
  ProgramDialect m_dialect;
  QTableWidget* m_table;
};

}  // namespace handwheel
