// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QPointer>

class QLabel;
class QPushButton;

namespace handwheel {

class MessageBar;

// A banner over the view while that shows the simulated cut of a program. It says that the document does not have the
// cut yet. It lies below the messages of the window. Window thread.
class SimulationBanner : public QFrame {
  Q_OBJECT

 public:
  explicit SimulationBanner(QWidget* view);

  // isCuttable: the program touches the part; why: tool tip of the button.
  void showFor(bool isCuttable, const QString& why);

 signals:
  void cutRequested();
  void leaveRequested();  // show the part of the document

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
