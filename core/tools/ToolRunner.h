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

// Runs one tool at a time on a document. A tool keeps its preview to itself and makes one edit of it in the end; so
// dropping the tool reverts it, except for the commits of Tool::settle(). A tool that throws is dropped, and the
// document's history reset to its state before the event; a tool is also dropped if its document is deleted. Window
// thread.
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
  // Calls Tool::resume() if it is due. Must be called with each frame of a tool that is live.
  void resume();
  void setSetting(std::string_view id, const PropertyValue& value);
  // Passes the result of a job to the tool, with the same handling of exceptions as an event.
  void deliver(const std::function<void()>& result);

 signals:
  void updated();                      // preview or actions of the tool may have changed
  void ended();                        // there is no tool now
  void failed(const QString& reason);  // after ended(): the exception of the tool

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
  int m_depth = 0;          // nesting of calls into the tool: its own edits come back as documentChanged()
  bool m_isToStop = false;  // stop when no call is under way
  std::optional<QString> m_failure;
};

}  // namespace handwheel
