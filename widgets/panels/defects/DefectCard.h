// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QAction;
class QLabel;

namespace handwheel {

// Describes the selected defect, or all of a kind, with a repair button.
class DefectCard : public QFrame {
  Q_OBJECT

 public:
  explicit DefectCard(QAction* fix, QWidget* parent = nullptr);

  void showDefect(const QString& name, const QString& hint);
  // What the fix would do: a sentence, or empty.
  void showPreview(const QString& text);

 private:
  QLabel* m_name;
  QLabel* m_hint;
  QLabel* m_status;
};

}  // namespace handwheel
