// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QAction;
class QLabel;

namespace handwheel {

// A card with a description of the selected defect or kind, and a repair button.
class DefectCard : public QFrame {
  Q_OBJECT

 public:
  explicit DefectCard(QAction* fix, QWidget* parent = nullptr);

  // Shows a defect. remains: the end of a sentence with the reason why it remains after a repair or fix, or empty.
  void showDefect(const QString& name, const QString& hint, const QString& remains);
  // Shows a sentence on the expected effect of the fix. An empty text removes it.
  void showPreview(const QString& text);

 private:
  void followReason();

  QLabel* m_name;
  QLabel* m_hint;
  QLabel* m_remains;
  QLabel* m_status;
  QString m_reason;
};

}  // namespace handwheel
