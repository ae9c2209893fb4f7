// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPushButton>

class QAction;

namespace handwheel {

// A push button for an action. Its text, tooltip, enabled and checked state follow the action.
class ActionButton : public QPushButton {
  Q_OBJECT

 public:
  enum class Rank { Primary, Ordinary, Quiet };

  explicit ActionButton(QAction* action, Rank rank = Rank::Ordinary, QWidget* parent = nullptr);

  QAction* action() const { return m_action; }

 signals:
  // Emitted when the pointer or the focus comes to the button, or leaves it.
  void pointed(bool isPointed);

 protected:
  bool event(QEvent* event) override;

 private:
  void follow();

  QAction* m_action;
};

}  // namespace handwheel
