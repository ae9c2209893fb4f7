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

// A message to the user with up to two actions. It gives the event, its reason, and a remedy.
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
  const Document* about = nullptr;    // removed with this document; null: about no open document
  QString topic = {};                 // withdraw() with this topic removes it; empty: it cannot be withdrawn
  bool comesFirst = false;            // shown before others, and not removed unread: data may be lost
  std::function<bool()> isOver = {};  // called after changes of `about` and before new messages; true: removed
};

// Shows messages over the upper edge of the viewport. The view does not change; the latest message is first. They are
// not modal. Each stays until it is closed. A message about a document is visible while that document is current, and
// also over the one that was current when it arrived, so that errors in the background are noticed; it is removed with
// its document. A message about no document is removed when another document becomes current and there was time to read
// it. A later message with the same title about the same document replaces the earlier one: its cause may be mended.
class MessageBar : public QFrame {
  Q_OBJECT

 public:
  explicit MessageBar(QWidget* parent = nullptr);

  // Puts the bar over the upper edge of a sibling, except for the corner on the right with the view cube.
  void lieOver(QWidget* area);
  void showMessage(const Message& message);
  // Sets the current document; null: none.
  void setDocument(const Document* document);
  // Removes the messages about a document that have this topic, because their reason is gone.
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
    const Document* arrivedOver;  // the current document at that time
    QElapsedTimer since;
  };

  void removeOver();
  const Entry* latest() const;  // the latest visible message, one that comes first if any; null: none
  std::size_t seenCount() const;
  bool isSeen(const Entry& entry) const;
  Message takeLatest();  // there must be one
  void act(std::function<void()> Message::*what);
  void showLatest();
  void showNext();
  void drawIcon();
  void place();

  std::vector<Entry> m_messages;         // the latest last
  const Document* m_document = nullptr;  // the current document
  int m_readingTime = 5000;              // ms
  QWidget* m_area = nullptr;             // the sibling below it; null: a layout determines its position
  QLabel* m_icon;
  QLabel* m_text;
  QPushButton* m_more;  // the number of further messages; shows the next
  QPushButton* m_action;
  QPushButton* m_other;
};

}  // namespace handwheel
