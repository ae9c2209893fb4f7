// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/workpiece/LatheDisplay.h"
#include "document/workpiece/ReplayCurves.h"
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

// The dock “Replay”, which plays and scrubs the passes that cut a part. It has a time line with forces, deviation and
// crashes, and can show those of another workpiece below the first. While it is open the view shows the part at the
// chosen time; once it is closed or a tool begins to work, the view shows the present part again. Window thread.
class ReplayDock : public QObject {
  Q_OBJECT

 public:
  ReplayDock(const WindowContext& parts, QObject* parent);

  QAction* action() { return &m_toggle; }
  void setDocument(DocumentTab* document);
  bool isSettled() const { return m_views.isIdle(); }

 signals:
  void message(const handwheel::Message& message);
  // Emits a part that the view shows before all else; null: nothing.
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
  };
  using PlayedPointer = std::shared_ptr<const Played>;
  // Returns null if nothing was cut, or it was cancelled. Any thread.
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
  bool m_wasLive = false;  // the tool was live
  QPointer<QDockWidget> m_dock;
  QPointer<QLabel> m_text;
  QPointer<TimeLinePanel> m_line;
  DocumentTab* m_document = nullptr;
  QPointer<QPushButton> m_compare;
  PlayedPointer m_played, m_other;               // null: none is shown
  std::shared_ptr<const TurnedPart> m_replayed;  // the part of m_played, also while that is being made
  std::unique_ptr<LatheDisplay> m_lathe;         // with the tools of m_played
  JobRunner m_views;
  double m_wanted = 0.0;     // s, time to show
  bool m_isShowing = false;  // a job is making the part of a time
};

}  // namespace handwheel
