// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace handwheel {

class Document;

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
  const Document* about = nullptr;  // the message goes with it; null: it concerns the program
};

// Shows messages above the viewport, the latest first; each stays until it is closed. Nothing waits for them. A message
// about a document is seen while that document is in view, and also over the one that was in view when it arrived, so
// that what went wrong in the background is noticed; it ends with its document.
class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  void showMessage(const Message& message);
  // The one in view; null: none.
  void setDocument(const Document* document);
  // It is about to close: its messages go.
  void forget(const Document* document);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Entry {
    Message message;
    const Document* arrivedOver;  // in view then
  };

  const Entry* latest() const;  // of those to be seen now; null: none
  std::size_t seenCount() const;
  bool isSeen(const Entry& entry) const;
  Message takeLatest();
  void showLatest();
  void drawIcon();

  std::vector<Entry> m_messages;         // the latest is the last
  const Document* m_document = nullptr;  // in view
  QLabel* m_icon;
  QLabel* m_text;
  QLabel* m_more;  // how many others there are
  QPushButton* m_action;
  QPushButton* m_other;
};

}  // namespace handwheel
