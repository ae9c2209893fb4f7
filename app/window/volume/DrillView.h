// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tools/carving/HandDrill.h"
#include "window/kinds/KindUi.h"

#include <QElapsedTimer>
#include <QPointer>
#include <QTimer>

class QDockWidget;
class QLabel;

namespace handwheel {

class PlotWidget;

// The presentation of the Drill tool in the window. It has the dock with thrust and torque over time, the warnings of
// an exercise, and the sound. It follows whatever tool drills, in meshes, too. Window thread.
class DrillView : public QObject {
  Q_OBJECT

 public:
  DrillView(const WindowContext& parts, QObject* parent);

  // To be called when the tool, or what it shows, has changed.
  void follow();

 signals:
  void message(const handwheel::Message& message);

 private:
  const HandDrill* tool() const;
  void makeDock();
  void show(const HandDrill& tool, const DrillState& hole);
  void plot(const DrillSetup& setup, const DrillState& hole);
  void warn(const HandDrill& tool, const DrillState& hole);
  void sound();

  // What messages were sent about the present hole.
  struct Warned {
    std::size_t moments = 0;
    bool besidePath = false, breakthrough = false, forbidden = false;
  };

  WindowContext m_parts;
  QPointer<QDockWidget> m_dock;
  QLabel* m_verdict = nullptr;
  QLabel* m_figures = nullptr;
  PlotWidget* m_thrust = nullptr;
  PlotWidget* m_torque = nullptr;
  QTimer m_sounding;
  QElapsedTimer m_plotted;
  std::shared_ptr<const DrillState> m_shown;  // plotted last
  Warned m_warned;
  bool m_isRunning = false;
};

// What the hole has come to, in a few words; empty: nothing to say. An exercise says it when the forbidden region was
// entered, the drill is through, or it is beside the path. isDrilling: there is still something to stop.
QString drillVerdict(const DrillState& hole, bool isDrilling);

}  // namespace handwheel
