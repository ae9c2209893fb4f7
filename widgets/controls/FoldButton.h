// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

namespace handwheel {

// The heading of a collapsible section, with an arrow that shows its state. It is operated by mouse and keyboard.
class FoldButton : public QToolButton {
  Q_OBJECT

 public:
  FoldButton(const QString& text, bool isOpen, QWidget* parent = nullptr);

  bool isOpen() const { return m_isOpen; }

 signals:
  void toggledOpen(bool isOpen);  // emitted only for changes by the user

 private:
  void setOpen(bool isOpen);

  bool m_isOpen = true;
};

}  // namespace handwheel
