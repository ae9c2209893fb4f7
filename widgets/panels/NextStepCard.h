// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <vector>

class QAction;
class QHBoxLayout;
class QLabel;

namespace handwheel {

// What a document needs next, and the actions that do it; the first is the obvious one.
struct NextStep {
  QString icon;
  QColor colour;
  QString title;
  QString detail;
  std::vector<QAction*> actions;

  bool isEmpty() const { return title.isEmpty(); }
};

// Floats over the lower edge of the viewport and offers the obvious next action.
class NextStepCard : public QFrame {
  Q_OBJECT

 public:
  explicit NextStepCard(QWidget* over);

  void showStep(const NextStep& step);  // hides when the step is empty

 signals:
  void dismissed();
  // So many pixels at the lower edge are not to be seen behind the card; 0 when it is hidden.
  void covers(int pixels);

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();

  QLabel* m_icon;
  QLabel* m_title;
  QLabel* m_detail;
  QHBoxLayout* m_buttons;
};

}  // namespace handwheel
