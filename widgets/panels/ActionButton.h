// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

class QAction;

namespace handwheel {

// A push button for an action. Text, tooltip, enabled and checked state are those of the action, which
// hears of the pointer or the focus on the button as of that on its menu entry (QAction::hovered).
class ActionButton : public QPushButton {
  Q_OBJECT

 public:
  enum class Rank { Primary, Ordinary, Quiet };

  explicit ActionButton(QAction* action, Rank rank = Rank::Ordinary, QWidget* parent = nullptr);

 protected:
  bool event(QEvent* event) override;

 private:
  void follow(const QAction* action);

  QAction* m_action;
};

}  // namespace handwheel
