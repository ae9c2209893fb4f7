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

  // remains: the reason why it is still there after a repair or fix, as the end of a sentence; or empty.
  void showDefect(const QString& name, const QString& hint, const QString& remains);
  // Shows the expected effect of the fix: a sentence, or empty.
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
