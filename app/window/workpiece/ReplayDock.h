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

// The dock “Replay”, which plays and scrubs the passes that cut a part. On a time line with forces, deviation and
// crashes; those of another workpiece, too, which the view shows below the first. As long as it is open the view shows
// the part as it was; closed, or when a tool begins to work, it shows the present again. Window thread.
class ReplayDock : public QObject {
  Q_OBJECT

 public:
  ReplayDock(const WindowContext& parts, QObject* parent);

  QAction* action() { return &m_toggle; }
  void setDocument(DocumentTab* document);
  bool isSettled() const { return m_views.isIdle(); }

 signals:
  void message(const handwheel::Message& message);
  // What the view is to show before all else; null: nothing.
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
  // Null: nothing was cut, or it was cancelled. Any thread.
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
  bool m_wasLive = false;  // the tool
  QPointer<QDockWidget> m_dock;
  QPointer<QLabel> m_text;
  QPointer<TimeLinePanel> m_line;
  DocumentTab* m_document = nullptr;
  QPointer<QPushButton> m_compare;
  PlayedPointer m_played, m_other;               // null: none is shown
  std::shared_ptr<const TurnedPart> m_replayed;  // the part that m_played is, or will be, of
  std::unique_ptr<LatheDisplay> m_lathe;         // with the tools of m_played
  JobRunner m_views;
  double m_wanted = 0.0;     // s, that is to be shown
  bool m_isShowing = false;  // a job makes the part of a time
};

}  // namespace handwheel
