// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/PropertyList.h"
#include "tools/Tool.h"

#include <QWidget>
#include <functional>

class QPushButton;
class QVBoxLayout;

namespace handwheel {

// What an action of a tool does, "fill the hole", as a title: "Fill the hole".
QString titleOf(const std::string& effect);

// The settings of the tool in use, and a button for each action that it declares.
class ToolPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ToolPanel(QWidget* parent = nullptr);

  PropertyList& settings() { return *m_settings; }
  // Those with an id; they stay as long as the ids do. keyOf: the key of one of them as the user knows it, or nothing.
  void setActions(const std::vector<ToolAction>& actions, const std::function<QString(const ToolAction&)>& keyOf);

 signals:
  void triggered(const std::string& action);

 private:
  PropertyList* m_settings;
  QVBoxLayout* m_column;
  std::vector<std::pair<std::string, QPushButton*>> m_buttons;
};

}  // namespace handwheel
