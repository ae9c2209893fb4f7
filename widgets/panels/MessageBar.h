// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <functional>

class QLabel;
class QPushButton;

namespace handwheel {

// What happened, why, and what to do; with one thing that can be done at once.
struct Message {
  enum class Weight { Info, Warning, Error };
  Weight weight = Weight::Info;
  QString title;   // what: "scan.stl could not be opened"
  QString detail;  // why
  QString advice;  // what to do
  QString actionText;
  std::function<void()> action;
};

// Shows one message above the viewport until it is closed or the next one comes. Nothing waits for it.
class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showMessage(const Message& message);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void drawIcon();

  Message::Weight m_weight = Message::Weight::Info;
  QLabel* m_icon;
  QLabel* m_text;
  QPushButton* m_action;
  std::function<void()> m_run;
};

}  // namespace handwheel
