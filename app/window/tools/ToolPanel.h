// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "controls/property/PropertyList.h"
#include "tools/Tool.h"

#include <QWidget>
#include <functional>
#include <map>

class QPushButton;
class QVBoxLayout;

namespace handwheel {

// Formats the effect of a tool action as a title: "Fill the hole".
QString titleOf(const std::string& effect);

// The panel with the settings and actions of the active tool. It has a button for each action that the tool declares.
class ToolPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ToolPanel(QWidget* parent = nullptr);

  PropertyList& settings() { return *m_settings; }
  // Shows buttons for the actions with an id; buttons are kept while the ids are the same. keyOf: the function that
  // returns the key of an action as text, or an empty text.
  void setActions(const std::vector<ToolAction>& actions, const std::function<QString(const ToolAction&)>& keyOf);

 signals:
  void triggered(const std::string& action);

 private:
  PropertyList* m_settings;
  QVBoxLayout* m_column;
  std::vector<std::pair<std::string, QPushButton*>> m_buttons;
  std::map<std::string, std::string> m_effects;  // effects shown on the buttons, by action
};

}  // namespace handwheel
