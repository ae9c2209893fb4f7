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

// Runs one tool at a time on a document. A tool keeps what it previews to itself and makes one edit of it in the end;
// so dropping the tool reverts it, but for what Tool::settle() commits. A tool that throws is dropped, and the
// document's history set back to where it was before the event; so is a tool whose document goes. Window thread.
class ToolRunner : public QObject {
  Q_OBJECT

 public:
  explicit ToolRunner(QObject* parent = nullptr) : QObject(parent) {}
  ~ToolRunner() override { drop(); }  // who wants its work to be kept stops the tool before

  // Starts a tool in place of the previous one. The destructor of a tool must not touch its document, which may be
  // gone.
  void start(std::unique_ptr<Tool> tool, Document& document);
  void stop();

  const Tool* tool() const { return m_tool.get(); }
  Document* document() const { return m_document; }

  // These return Ignored when there is no tool.
  ToolReply pointer(const PointerEvent& event);
  // An action that the tool declares and has enabled; others are ignored.
  ToolReply perform(std::string_view action);
  // Tool::undo().
  ToolReply undo();
  // Tool::resume(), where it is due. To be called with each frame of a tool that is live.
  void resume();
  void setSetting(std::string_view id, const PropertyValue& value);
  // Passes the result of a job to the tool, with the same handling of exceptions as an event.
  void deliver(const std::function<void()>& result);

 signals:
  void updated();                      // what the tool shows or offers may have changed
  void ended();                        // there is no tool now
  void failed(const QString& reason);  // after ended(): the tool threw this

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
  int m_depth = 0;          // of calls into the tool: its own edits come back as documentChanged()
  bool m_isToStop = false;  // as soon as no call is under way
  std::optional<QString> m_failure;
};

}  // namespace handwheel
