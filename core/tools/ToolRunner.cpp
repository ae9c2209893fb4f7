// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/ToolRunner.h"

#include <cassert>
#include <exception>
#include <utility>

namespace handwheel {

void ToolRunner::start(std::unique_ptr<Tool> tool, Document& document) {
  assert(m_depth == 0 && tool);
  stop();
  m_tool = std::move(tool);
  m_document = &document;
  m_isToStop = false;
  m_tool->whenUpdated([this] { emit updated(); });
  m_changed = connect(&document, &Document::changed, this, &ToolRunner::documentChanged);
  m_settling = connect(&document, &Document::settling, this, &ToolRunner::settle);
  m_destroyed = connect(&document, &QObject::destroyed, this, &ToolRunner::stop);
  emit updated();
}

void ToolRunner::stop() {
  if (!m_tool) return;
  if (m_depth > 0) {  // the tool requests it itself, or its own edit led here
    m_isToStop = true;
    return;
  }
  if (!m_document) return drop();
  guarded([] { return ToolReply::Finished; });
}

void ToolRunner::drop() {
  if (!m_tool) return;
  disconnect(m_changed);
  disconnect(m_settling);
  disconnect(m_destroyed);
  m_tool.reset();
  m_document.clear();
  emit ended();
}

// Runs a call into the tool. A failure in it, or in a nested call, is handled after the outermost one has returned:
// until then the tool must live.
template <class Call>
ToolReply ToolRunner::guarded(Call call) {
  if (!m_tool || m_isToStop) return ToolReply::Ignored;
  const int before = m_document->history()->index();
  ++m_depth;
  const ToolReply reply = attempt(call);
  const bool isEnding = m_depth == 1 && (reply == ToolReply::Finished || m_isToStop);
  if (isEnding && !m_failure && m_document) attempt([this] { return m_tool->settle(), ToolReply::Finished; });
  --m_depth;
  if (m_depth > 0) return reply;
  if (m_failure) {
    disconnect(m_changed);
    if (m_document) m_document->history()->setIndex(before);
    const QString reason = *std::exchange(m_failure, std::nullopt);
    drop();
    emit failed(reason);
  } else if (isEnding || m_isToStop) {
    drop();
  } else {
    emit updated();
  }
  return reply;
}

template <class Call>
ToolReply ToolRunner::attempt(Call call) {
  try {
    return call();
  } catch (const std::exception& exception) {
    m_failure = QString::fromLocal8Bit(exception.what());
  } catch (...) {
    m_failure = QStringLiteral("unknown exception");
  }
  m_isToStop = true;
  return ToolReply::Used;
}

ToolReply ToolRunner::pointer(const PointerEvent& event) {
  return guarded([&] { return m_tool->pointer(event); });
}

ToolReply ToolRunner::perform(std::string_view action) {
  return guarded([&] {
    for (const ToolAction& declared : m_tool->actions())
      if (declared.enabled && !action.empty() && declared.id == action) return m_tool->perform(action);
    return ToolReply::Ignored;
  });
}

ToolReply ToolRunner::undo() {
  return guarded([&] { return m_tool->undo(); });
}

void ToolRunner::resume() {
  if (m_tool && m_tool->isDue()) guarded([&] { return m_tool->resume(); });
}

void ToolRunner::setSetting(std::string_view id, const PropertyValue& value) {
  guarded([&] {
    m_tool->setSetting(id, value);
    return ToolReply::Used;
  });
}

void ToolRunner::deliver(const std::function<void()>& result) {
  guarded([&] {
    result();
    return ToolReply::Used;
  });
}

void ToolRunner::settle() {
  guarded([&] { return m_tool->settle(), ToolReply::Used; });
}

void ToolRunner::documentChanged() {
  guarded([&] {
    m_tool->documentChanged();
    return ToolReply::Used;
  });
}

}  // namespace handwheel
