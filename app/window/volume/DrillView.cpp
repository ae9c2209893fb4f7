// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/volume/DrillView.h"

#include "audio/MachineSound.h"
#include "controls/ScrolledPanel.h"
#include "controls/SqueezedPage.h"
#include "document/volume/exercise/DrillingDetails.h"
#include "panels/DockTitle.h"
#include "panels/MessageBar.h"
#include "plot/PlotWidget.h"
#include "report/exercise/CurvePlot.h"
#include "theme/Theme.h"
#include "window/tools/ToolHost.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMainWindow>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace handwheel {
namespace {

constexpr int kPlotMs = 100;               // between two pictures of a plot
constexpr int kSoundMs = 60;               // between two states of the sound
constexpr std::size_t kMostShown = 4'000;  // moments in a plot: what a second of drilling adds is drawn in a few ms

// Thins the moments of a long hole, so that the time for a plot is limited.
std::vector<DrillMoment> shownOf(const PagedArray<DrillMoment>& moments) {
  const std::size_t step = moments.size() / kMostShown + 1;
  std::vector<DrillMoment> shown;
  for (std::size_t i = 0; i < moments.size(); i += step) shown.push_back(moments[i]);
  return shown;
}

QString lengthText(double mm) {
  return QLocale().toString(mm, 'f', 1);
}

}  // namespace

QString drillVerdict(const DrillState& hole, bool isDrilling) {
  if (hole.figures.forbidden > 0.0)
    return DrillView::tr("The forbidden region was entered by %1 mm: this attempt has failed")
        .arg(lengthText(hole.figures.forbidden));
  QStringList verdicts;
  if (hole.breakthrough)
    verdicts +=
        (isDrilling ? DrillView::tr("Breakthrough: stop. %1 mm beyond") : DrillView::tr("Breakthrough, %1 mm beyond"))
            .arg(lengthText(hole.figures.plunge));
  if (isBesidePath(hole))
    verdicts +=
        DrillView::tr("%1 mm beside the planned path").arg(lengthText(hole.moments[hole.moments.size() - 1].deviation));
  return verdicts.join(QLatin1Char('\n'));
}

DrillView::DrillView(const WindowContext& parts, QObject* parent) : QObject(parent), m_parts(parts) {
  m_sounding.setInterval(kSoundMs);
  connect(&m_sounding, &QTimer::timeout, this, &DrillView::sound);
}

const HandDrill* DrillView::tool() const {
  return dynamic_cast<const HandDrill*>(m_parts.tools.runner().tool());
}

void DrillView::makeDock() {
  auto* const window = qobject_cast<QMainWindow*>(m_parts.window);
  if (m_dock || !window) return;
  m_dock = new QDockWidget(tr("Drilling"), window);
  m_dock->setObjectName(QStringLiteral("drillDock"));
  m_dock->setAccessibleName(tr("Drilling"));
  m_dock->setTitleBarWidget(new DockTitle(m_dock));
  auto* content = new SqueezedPage(m_dock);
  m_verdict = new QLabel(content);
  m_verdict->setObjectName(QStringLiteral("drillVerdict"));
  m_verdict->setProperty("strong", true);
  m_verdict->setWordWrap(true);
  // Two lines are always reserved, so that changing texts do not move the plots.
  m_verdict->setMinimumHeight(2 * m_verdict->fontMetrics().lineSpacing());
  m_figures = new QLabel(content);
  m_figures->setObjectName(QStringLiteral("drillFigures"));
  m_figures->setProperty("muted", true);
  m_thrust = new PlotWidget(content);
  m_thrust->setObjectName(QStringLiteral("drillThrust"));
  m_torque = new PlotWidget(content);
  m_torque->setObjectName(QStringLiteral("drillTorque"));
  constexpr int kLeastHeight = 260;  // pixels: title, names of the curves and axes take more than a half of it
  m_thrust->setMinimumHeight(kLeastHeight);
  m_torque->setMinimumHeight(kLeastHeight);
  auto* plots = new QHBoxLayout;
  plots->addWidget(m_thrust, 1);
  plots->addWidget(m_torque, 1);
  auto* lines = new QHBoxLayout;
  lines->addWidget(m_verdict, 1);
  lines->addWidget(m_figures);
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(8, 4, 8, 4);
  layout->addLayout(lines);
  layout->addLayout(plots, 1);
  m_dock->setWidget(new ScrolledPanel(content, ScrolledPanel::Directions::Both, m_dock));
  window->addDockWidget(Qt::BottomDockWidgetArea, m_dock);
}

void DrillView::follow() {
  const HandDrill* const now = tool();
  const bool isRunning = now != nullptr;
  if (std::exchange(m_isRunning, isRunning) != isRunning) {
    if (isRunning) makeDock();
    if (m_dock) m_dock->setVisible(isRunning);
    m_shown.reset();
    m_warned = {};
    isRunning ? m_sounding.start() : m_sounding.stop();
  }
  if (!now || !m_dock) return;
  if (const auto hole = now->hole()) {
    show(*now, *hole);
  } else if (!m_shown || !m_shown->moments.empty()) {
    show(*now, DrillState());
    m_figures->clear();
    m_shown = std::make_shared<DrillState>();
  }
}

// The text is updated immediately, the plots about ten times a second and at the end.
void DrillView::show(const HandDrill& tool, const DrillState& hole) {
  warn(tool, hole);
  const QString verdict = drillVerdict(hole, tool.isLive());
  const ThemeColours colours = themeColours(currentTheme());
  const QColor colour = hole.figures.forbidden > 0.0 ? colours.error : colours.warning;
  m_verdict->setStyleSheet(verdict.isEmpty() ? QString() : QStringLiteral("color: %1").arg(colour.name()));
  m_verdict->setText(!verdict.isEmpty() ? verdict
                     : tool.isLive()    ? tr("Drilling…")
                                        : tr("Hold the button on the part to drill"));
  const QLocale locale;
  if (!hole.moments.empty()) {
    const DrillMoment& moment = hole.moments[hole.moments.size() - 1];
    m_figures->setText(tr("%1 mm deep, %2 N, %3 N·mm, +%4 K (estimate)")
                           .arg(lengthText(moment.holeDepth), locale.toString(moment.thrust, 'f', 1),
                                locale.toString(moment.torque, 'f', 0), locale.toString(moment.temperature, 'f', 0)));
  }
  const bool isDue = !m_plotted.isValid() || m_plotted.elapsed() >= kPlotMs || !tool.isLive();
  const std::size_t plotted = m_shown ? m_shown->moments.size() : 0;
  if (!isDue || (m_shown && plotted == hole.moments.size())) return;
  m_plotted.restart();
  plot(tool.setup(), hole);
}

void DrillView::plot(const DrillSetup& setup, const DrillState& hole) {
  const std::vector<DrillMoment> moments = shownOf(hole.moments);
  m_thrust->setPlot(plotOf(thrustCurve(setup, moments)));
  m_torque->setPlot(plotOf(torqueCurve(setup, moments)));
  m_shown = std::make_shared<DrillState>(hole);
}

// Each warning appears once per hole, and only in an exercise, where it costs marks.
void DrillView::warn(const HandDrill& tool, const DrillState& hole) {
  if (hole.moments.size() < m_warned.moments) m_warned = {};
  m_warned.moments = hole.moments.size();
  if (!tool.isWorkOnExercise()) return;
  if (hole.figures.forbidden > 0.0 && !std::exchange(m_warned.forbidden, true))
    emit message({Message::Weight::Error, tr("The attempt has failed"), tr("The drill entered the forbidden region."),
                  tr("Undo the hole to try again, and stop at the breakthrough. The report lists this try.")});
  if (isBesidePath(hole) && !std::exchange(m_warned.besidePath, true))
    emit message({Message::Weight::Warning, tr("Beside the planned path"),
                  tr("The drill is more than %1 mm away from it.").arg(lengthText(hole.plan->tolerance)),
                  tr("Release the button, undo the hole, and begin where the green rod meets the surface.")});
  if (hole.breakthrough && !std::exchange(m_warned.breakthrough, true))
    emit message({Message::Weight::Info, tr("Breakthrough"),
                  tr("The drill is through after %1 s.").arg(lengthText(*hole.breakthrough)),
                  tr("Release the button now: each further millimetre counts.")});
}

// Only while it drills: the sound fades out by itself. The louder the larger the thrust.
void DrillView::sound() {
  const HandDrill* const now = tool();
  if (!now || !now->isLive()) return;
  const auto hole = now->hole();
  const DrillSetup setup = now->setup();
  const double turns = std::abs(setup.spindle) / (2.0 * M_PI);  // 1/s
  MachineSoundState state;
  state.spindleSpeed = 60.0 * turns;
  state.cuttingSpeed = M_PI * setup.tool.diameter * state.spindleSpeed / 1000.0;
  if (hole && !hole->moments.empty()) {
    state.force = hole->thrust;
    if (turns > 0.0) state.chipThickness = hole->moments[hole->moments.size() - 1].feed / turns;
  }
  m_parts.sound.setState(state);
}

}  // namespace handwheel
