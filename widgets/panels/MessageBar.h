// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace handwheel {

// What happened, why, and what to do; with one or two things that can be done at once.
struct Message {
  enum class Weight { Info, Warning, Error };
  Weight weight = Weight::Info;
  QString title;   // what: "scan.stl could not be opened"
  QString detail;  // why
  QString advice;  // what to do
  QString actionText;
  std::function<void()> action;
  QString otherText = {};
  std::function<void()> other = {};
};

// Shows messages above the viewport, the latest first; each stays until it is closed. Nothing waits for them.
class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showMessage(const Message& message);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void showLatest();
  void drawIcon();

  std::vector<Message> m_messages;  // the latest is the last
  QLabel* m_icon;
  QLabel* m_text;
  QLabel* m_more;  // how many others there are
  QPushButton* m_action;
  QPushButton* m_other;
};

}  // namespace handwheel
