// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <functional>
#include <vector>

class QAction;
class QGridLayout;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace handwheel {

// A suggested next step with its actions.
struct Suggestion {
  QString icon;
  QColor colour;
  QString title;
  QString detail;
  std::vector<QAction*> actions;
  bool isFirstObvious = true;  // true: the first action is emphasised, because most users want it
  // The function that is called when the pointer or the focus comes to the button of an action, or leaves it. It may be
  // empty.
  std::function<void(const QAction* action, bool isPointed)> pointed = {};

  bool isEmpty() const { return title.isEmpty(); }
};

// A card over the lower edge of the viewport with the suggested next step. The card is wide and low. It can be folded
// to one line with the first action, and then stays folded for the following steps of all documents.
class SuggestionCard : public QFrame {
  Q_OBJECT

 public:
  explicit SuggestionCard(QWidget* over);

  void showStep(const Suggestion& step);  // hides the card if the step is empty

 signals:
  void dismissed();
  // Emitted with the number of pixels at the lower edge that the card covers; 0 when it is hidden.
  void covers(int pixels);

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void setFolded(bool folded);
  void showButtons();
  int widthIn(const QSize& room) const;
  void place();

  Suggestion m_step;
  bool m_isFolded = false;
  QLabel* m_icon;
  QLabel* m_title;
  QLabel* m_detail;
  QToolButton* m_fold;
  QHBoxLayout* m_first;    // contains the first action, in the line of the title; for a folded card
  QGridLayout* m_buttons;  // contains all actions; for an unfolded card
};

}  // namespace handwheel
