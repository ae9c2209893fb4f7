// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/LatheView.h"

#include "machining/force/TrainedForceModel.h"
#include "machining/lathe/LatheJson.h"
#include "panels/DockTitle.h"
#include "simulation/turning/LatheForce.h"
#include "tools/workpiece/ManualLatheTool.h"
#include "window/WindowServices.h"
#include "window/haptics/HapticSceneBuilder.h"
#include "window/tools/ToolHost.h"
#include "window/workpiece/LathePanel.h"

#include <QDockWidget>
#include <QMainWindow>
#include <utility>

namespace handwheel {

namespace {
constexpr int kRefreshMs = 50;
}

LatheView::LatheView(const WindowContext& window, QObject* parent) : QObject(parent), m_window(window) {
  connect(&window.tools, &ToolHost::updated, this, &LatheView::follow);
  m_refresh.setInterval(kRefreshMs);
  connect(&m_refresh, &QTimer::timeout, this, &LatheView::refresh);
}

LatheView::~LatheView() = default;

std::unique_ptr<Tool> LatheView::make(WorkpieceDocument& document, double spacing) {
  const SimulationServices services{m_window.servoClock, m_window.services.simulation()};
  auto made = std::make_unique<ManualLatheTool>(document, services, spacing, shippedLatheTools());
  m_made = made.get();
  return made;
}

ManualLatheTool* LatheView::tool() const {
  return m_made && m_window.tools.runner().tool() == m_made ? m_made : nullptr;
}

void LatheView::makeDock() {
  auto* const window = qobject_cast<QMainWindow*>(m_window.window);
  if (m_dock || !window) return;
  m_dock = new QDockWidget(tr("Lathe"), window);
  m_dock->setObjectName(QStringLiteral("latheDock"));
  m_dock->setTitleBarWidget(new DockTitle(m_dock));
  m_panel = new LathePanel(m_dock);
  m_dock->setWidget(m_panel);
  window->addDockWidget(Qt::BottomDockWidgetArea, m_dock);
  connect(m_panel, &LathePanel::commanded, this, [this](const LatheCommand& command) {
    if (ManualLatheTool* const lathe = tool()) m_window.tools.runner().deliver([&] { lathe->command(command); });
  });
  connect(m_panel, &LathePanel::touchOffRequested, this, [this](bool isX, double value) {
    if (ManualLatheTool* const lathe = tool()) m_window.tools.runner().deliver([&] { lathe->touchOff(isX, value); });
  });
}

void LatheView::follow() {
  const bool isRunning = isOn();
  if (isRunning) makeDock();
  if (m_dock && isRunning != m_refresh.isActive()) m_dock->setVisible(isRunning);
  if (isRunning && !m_refresh.isActive()) m_refresh.start();
  if (!isRunning) m_refresh.stop();
  feel();
}

// The end of a pass, and what moves by itself.
void LatheView::refresh() {
  ManualLatheTool* const lathe = tool();
  if (!lathe || !m_panel) return;
  const auto now = lathe->moment();
  if (now->isCut && (now->sinceCut >= ManualLatheTool::kIdle || now->isFull))
    m_window.tools.runner().deliver([&] { lathe->endPass(); });
  if (!tool()) return;  // it failed
  if (std::exchange(m_wasLive, lathe->isLive()) != lathe->isLive()) m_window.tools.refresh();
  m_panel->show(*lathe);
}

void LatheView::feel() {
  const ManualLatheTool* const lathe = tool();
  const std::shared_ptr<LatheChannel> channel = lathe ? lathe->channel() : nullptr;
  if (std::exchange(m_felt, channel) == channel) return;
  if (!channel) return m_window.touch.setSource(kLatheSource, {}, false);
  if (!m_law) m_law = std::make_shared<const TrainedForceModel>(shippedForceModel());
  const auto make = [channel, law = m_law, base = lathe->base()](const TouchContext& context) {
    LatheTouch touch;
    touch.stiffness = context.mapping.sceneStiffness(context.touch.stiffness);
    touch.plane = 0.5 * touch.stiffness;
    return std::make_unique<LatheForce>(channel, law, touch, base);
  };
  m_window.touch.setSource(kLatheSource, make, false);
}

}  // namespace handwheel
