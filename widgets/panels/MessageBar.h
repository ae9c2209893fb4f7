// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QFrame>
#include <functional>
#include <vector>

class QLabel;
class QPushButton;

namespace handwheel {

class Document;

// A message to the user with up to two actions. It states the event, its reason, and a remedy.
struct Message {
  enum class Weight { Info, Warning, Error };
  Weight weight = Weight::Info;
  QString title;        // the event: "scan.stl could not be opened"
  QString detail = {};  // the reason
  QString advice = {};  // the remedy
  QString actionText = {};
  std::function<void()> action = {};
  QString otherText = {};
  std::function<void()> other = {};
  const Document* about = nullptr;  // the message is removed with this document; null: it is about no open document
  QString topic = {};               // withdraw() with this topic removes the message; empty: it cannot be withdrawn
  // Shown before others and never removed unread, because something was lost. Where it is about a document, later
  // messages, which answer what the user does there, are shown before it once there was time to read it.
  bool comesFirst = false;
  // The function that is called after changes of `about`, before new messages, and when another document becomes
  // current. If it returns true, the message is removed.
  std::function<bool()> isOver = {};
};

// A bar that shows messages over the upper edge of the viewport. The view does not move when messages appear. The
// messages are not modal, and the latest is shown first. Each message stays until it is closed or its cause is gone. A
// message about a document is visible while that document is current, and also over the document that was current when
// the message arrived, until another one becomes current, so that errors in the background are noticed. It is removed
// with its document. A message about no document is removed when another document becomes current, if there was time to
// read it. A later message with the same title about the same document replaces the earlier one.
class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  // Puts the bar over the upper edge of a sibling, except for the corner on the right with the view cube.
  void lieOver(QWidget* area);
  void showMessage(const Message& message);
  // Sets the current document; null: none.
  void setDocument(const Document* document);
  // Removes the messages about a document that have this topic, because their cause is gone.
  void withdraw(const Document* about, const QString& topic);
  // Removes the messages of a document that is about to close.
  void forget(const Document* document);
  void setReadingTime(int ms) { m_readingTime = ms; }

 protected:
  void changeEvent(QEvent* event) override;
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Entry {
    Message message;
    const Document* arrivedOver;  // the document that was current when the message arrived
    QElapsedTimer since;
  };

  void removeOver();
  bool comesFirst(const Entry& entry) const;
  // Returns the latest visible message, preferably one that comes first; null: no message is visible.
  const Entry* latest() const;
  std::size_t seenCount() const;
  static bool isOver(const Entry& entry);
  bool isSeen(const Entry& entry) const;
  Message takeLatest();  // removes and returns the latest message; there must be one
  void act(std::function<void()> Message::*what);
  void showLatest();
  void showNext();
  void drawIcons();
  void place();

  std::vector<Entry> m_messages;         // messages in the order of their arrival
  const Document* m_document = nullptr;  // the current document
  int m_readingTime = 5000;              // time needed to read a message, ms
  QWidget* m_area = nullptr;  // the sibling that the bar covers; null: a layout determines the position of the bar
  QLabel* m_icon;
  QLabel* m_text;
  // Shows the number of further messages with the icon of the most serious one; a click shows the next one.
  QPushButton* m_more;
  QPushButton* m_action;
  QPushButton* m_other;
};

}  // namespace handwheel
