// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/LatheDisplay.h"
#include "machining/PassesReplay.h"
#include "window/kinds/KindUi.h"

#include <QAction>
#include <QPointer>
#include <memory>

class QDockWidget;
class QLabel;

namespace handwheel {

class TimeLinePanel;
class WorkpieceDocument;
struct TimeLineRecording;
struct TurnedPart;

// The dock “Replay”: plays and scrubs the passes that cut a part on a time line. As long as it is open the view shows
// the part as it was; closed, or when a tool begins to work, it shows the present again. Window thread.
class ReplayDock : public QObject {
  Q_OBJECT

 public:
  ReplayDock(const WindowContext& parts, QObject* parent);

  QAction* action() { return &m_toggle; }
  void setDocument(DocumentTab* document);

 signals:
  // What the view is to show before all else; null: nothing.
  void partShown(const std::shared_ptr<const handwheel::DisplayModel>& part);

 private:
  const WorkpieceDocument& workpiece() const;
  void makeDock();
  void open(bool isOpen);
  void prepare();
  void begin(const std::shared_ptr<const PassesReplay>& replay);
  void show(double seconds);
  void followTool();
  TimeLineRecording recordingOf(const PassesReplay& replay) const;

  WindowContext m_parts;
  QAction m_toggle;
  bool m_isOpen = false;
  bool m_wasLive = false;  // the tool
  QPointer<QDockWidget> m_dock;
  QPointer<QLabel> m_text;
  QPointer<TimeLinePanel> m_line;
  DocumentTab* m_document = nullptr;
  std::shared_ptr<const PassesReplay> m_replay;  // null: none is shown
  std::shared_ptr<const TurnedPart> m_replayed;  // the part that m_replay is of
  std::unique_ptr<LatheDisplay> m_lathe;         // with the tools of m_replay
};

}  // namespace handwheel
