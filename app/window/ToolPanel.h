// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/PropertyList.h"
#include "tools/Tool.h"

#include <QWidget>

class QPushButton;
class QVBoxLayout;

namespace handwheel {

// The settings of the tool in use, and a button for each action that it declares.
class ToolPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ToolPanel(QWidget* parent = nullptr);

  PropertyList& settings() { return *m_settings; }
  // Those with an id; they stay as long as the ids do.
  void setActions(const std::vector<ToolAction>& actions);

 signals:
  void triggered(const std::string& action);

 private:
  PropertyList* m_settings;
  QVBoxLayout* m_column;
  std::vector<std::pair<std::string, QPushButton*>> m_buttons;
};

// The key of an action as the user's system writes it; empty when it is none but a gesture of the pointer.
QString keyText(const ToolAction& action);

}  // namespace handwheel
