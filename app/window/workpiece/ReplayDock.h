// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/LatheDisplay.h"
#include "document/workpiece/ReplayCurves.h"
#include "document/workpiece/playback/PlayedPart.h"
#include "panels/time/TimeLine.h"
#include "window/JobRunner.h"
#include "window/kinds/KindUi.h"

#include <QAction>
#include <QPointer>
#include <memory>

class QDockWidget;
class QLabel;
class QPushButton;

namespace handwheel {

class TimeLinePanel;
class WorkpieceDocument;
struct TurnedPart;

// The dock “Replay”, which plays and scrubs the passes that cut a part. Its time line shows forces, deviation and
// crashes; those of another workpiece can be shown below for comparison. While the dock is open, the view shows the
// part at the chosen time. When it is closed or a tool begins to work, the view shows the present part again. It must
// be used on the window thread.
class ReplayDock : public QObject {
  Q_OBJECT

 public:
  ReplayDock(const WindowContext& parts, QObject* parent);

  QAction* action() { return &m_toggle; }
  void setDocument(DocumentTab* document);
  bool isSettled() const { return m_views.isIdle(); }

 signals:
  void message(const handwheel::Message& message);
  // Emits the part that the view has to show instead of any other; null: no part.
  void partShown(const std::shared_ptr<const handwheel::DisplayModel>& part);

 private:
  const WorkpieceDocument& workpiece() const;
  void makeDock();
  void open(bool isOpen);
  void prepare();
  // A workpiece with its recording.
  struct Played {
    WorkpieceSnapshot work;
    std::shared_ptr<const ReplayCurves> track;
    TimeLineRecording recording;
    std::shared_ptr<PlayedPart> part;  // the shown part; used by one job at a time
  };
  using PlayedPointer = std::shared_ptr<const Played>;
  // Prepares a workpiece for the replay. Returns null if nothing was cut or if cancelled. May be called on any thread.
  static PlayedPointer playedOf(const QString& name, const WorkpieceSnapshot& work, Progress progress);
  void begin(PlayedPointer played);
  void askForOther();
  void compareWith(const QString& path);
  void beginOther(PlayedPointer other);
  void dropOther();
  void showRecordings();
  void show(double seconds);
  void shown(const std::shared_ptr<DisplayModel>& model, const PassesReplay::Moment& moment);
  void followTool();

  WindowContext m_parts;
  QAction m_toggle;
  bool m_isOpen = false;
  bool m_wasLive = false;  // true: the tool was working (Tool::isLive()) at the previous check
  QPointer<QDockWidget> m_dock;
  QPointer<QLabel> m_text;
  QPointer<TimeLinePanel> m_line;
  DocumentTab* m_document = nullptr;
  QPointer<QPushButton> m_compare;
  PlayedPointer m_played, m_other;               // null: none is shown
  std::shared_ptr<const TurnedPart> m_replayed;  // the part of m_played; set while m_played is still being made
  std::unique_ptr<LatheDisplay> m_lathe;         // the lathe with the tools of m_played
  JobRunner m_views;
  double m_wanted = 0.0;     // s, time to show
  bool m_isShowing = false;  // true: a job is making the part at a time
};

}  // namespace handwheel
