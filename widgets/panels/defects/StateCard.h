// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;

namespace handwheel {

class DefectList;

// Returns the state of a mesh in a word or two: "3 holes", "Watertight". It names the most important defect only;
// panel, card and status bar use the same text.
QString stateHeadline(const DefectList& defectList);

// Shows the overall state of a document. The headline is "Watertight" in green, or the most important defect; the
// details below list them all.
class StateCard : public QFrame {
  Q_OBJECT

 public:
  explicit StateCard(QWidget* parent = nullptr);

  void showState(const DefectList& defectList);

 private:
  QLabel* m_icon;
  QLabel* m_headline;
  QLabel* m_details;
};

}  // namespace handwheel
