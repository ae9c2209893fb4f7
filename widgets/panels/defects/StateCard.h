// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;

namespace handwheel {

class Inspection;

// The state in a word or two, the most important defect first: "3 holes", "Not manifold", "Watertight". The same on panel,
// card and status bar.
QString stateHeadline(const Inspection& inspection);

// Shows the overall state of a document. "Watertight" in green, or its defects, most important first.
class StateCard : public QFrame {
  Q_OBJECT

 public:
  explicit StateCard(QWidget* parent = nullptr);

  void showState(const Inspection& inspection);

 private:
  QLabel* m_icon;
  QLabel* m_headline;
  QLabel* m_details;
};

}  // namespace handwheel
