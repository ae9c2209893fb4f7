// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QPointer>

class QLabel;
class QPushButton;

namespace handwheel {

class MessageBar;

// A banner over the view while the view shows the simulated cut of a program. It tells the user that the document does
// not contain the cut yet. It lies below the messages of the window. It must be used on the window thread.
class SimulationBanner : public QFrame {
  Q_OBJECT

 public:
  explicit SimulationBanner(QWidget* view);

  // Shows the banner. isCuttable: true if the program touches the part; why: the tool tip of the button.
  void showFor(bool isCuttable, const QString& why);

 signals:
  void cutRequested();
  void leaveRequested();  // request to show the part of the document

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void reposition();

  QLabel* m_text;
  QPushButton* m_cut;
  QPointer<MessageBar> m_messages;  // null: the window has none
};

}  // namespace handwheel
