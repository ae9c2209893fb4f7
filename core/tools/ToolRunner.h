// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Document.h"
#include "tools/Tool.h"

#include <QObject>
#include <QPointer>
#include <functional>
#include <memory>
#include <string_view>

namespace handwheel {

// Runs one tool at a time on a document. A tool keeps its preview to itself and commits it as one edit in the end.
// Dropping the tool therefore discards its work, except for the commits of Tool::settle(). A tool that throws is
// dropped, and the history of the document is reset to its state before the event; a tool is also dropped if its
// document is deleted. A runner is used on the window thread.
class ToolRunner : public QObject {
  Q_OBJECT

 public:
  explicit ToolRunner(QObject* parent = nullptr) : QObject(parent) {}
  ~ToolRunner() override { drop(); }  // stop the tool first to keep its work

  // Starts a tool instead of the previous one. The destructor of a tool must not touch its document, which may be
  // deleted.
  void start(std::unique_ptr<Tool> tool, Document& document);
  void stop();

  const Tool* tool() const { return m_tool.get(); }
  Document* document() const { return m_document; }

  // Passes an event to the tool. This and the next functions return Ignored if there is no tool.
  ToolReply pointer(const PointerEvent& event);
  // Performs an action that the tool declares and has enabled; others are ignored.
  ToolReply perform(std::string_view action);
  // Calls Tool::undo().
  ToolReply undo();
  // Calls Tool::resume() if it is due. Must be called with each frame that is drawn while Tool::isLive() is true.
  void resume();
  void setSetting(std::string_view id, const PropertyValue& value);
  // Passes the result of a job to the tool, with the same handling of exceptions as an event.
  void deliver(const std::function<void()>& result);

 signals:
  void updated();  // preview or actions of the tool may have changed
  void ended();    // there is no tool now
  // Emitted after ended(). reason: the message of the exception that the tool threw.
  void failed(const QString& reason);

 private:
  template <class Call>
  ToolReply guarded(Call call);
  template <class Call>
  ToolReply attempt(Call call);
  void drop();
  void settle();
  void documentChanged();

  std::unique_ptr<Tool> m_tool;
  QPointer<Document> m_document;
  QMetaObject::Connection m_changed, m_settling, m_destroyed;
  // Number of nested calls into the tool: an edit of its own calls documentChanged() within the call that made it.
  int m_depth = 0;
  bool m_isToStop = false;  // stop when no call is under way
  std::optional<QString> m_failure;
};

}  // namespace handwheel
