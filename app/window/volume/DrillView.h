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

// The presentation of the Drill tool in the window. It consists of the dock with thrust and torque over time, the
// warnings of an exercise, and the sound. It serves all tools that drill, including those for meshes. All functions
// must be called on the window thread.
class DrillView : public QObject {
  Q_OBJECT

 public:
  DrillView(const WindowContext& parts, QObject* parent);

  // Updates the presentation after the tool or its state has changed.
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

  // The messages that were sent about the current hole.
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
  std::shared_ptr<const DrillState> m_shown;  // state that was plotted last
  Warned m_warned;
  bool m_isRunning = false;
};

// Returns a short verdict on the hole. In an exercise, it reports a forbidden region that was entered, a breakthrough,
// or a deviation from the path; otherwise the text is empty. isDrilling: true if the drill can still be stopped.
QString drillVerdict(const DrillState& hole, bool isDrilling);

}  // namespace handwheel
