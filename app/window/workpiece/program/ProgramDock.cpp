// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/program/ProgramDock.h"

#include "controls/ScrolledPanel.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/target/TargetPosition.h"
#include "panels/DockTitle.h"
#include "panels/MessageBar.h"
#include "viewport/Viewport.h"
#include "viewport/path/PathLayer.h"
#include "window/ActionToolTip.h"
#include "window/documents/DocumentTab.h"
#include "window/kinds/KindPanel.h"
#include "window/workpiece/TextOutlines.h"
#include "window/workpiece/ZeroSymbol.h"
#include "window/workpiece/program/ProgramFile.h"
#include "window/workpiece/program/ProgramSession.h"
#include "window/workpiece/program/SimulationBanner.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QStackedWidget>
#include <algorithm>
#include <utility>

namespace handwheel {

namespace {
constexpr int kUsualWidth = 420;  // pixels
}

ProgramDock::ProgramDock(const WindowContext& parts, QObject* parent)
    : QObject(parent),
      m_parts(parts),
      m_toggle(tr("&Program"), this),
      m_banner(new SimulationBanner(&parts.viewport)),
      m_layer(std::make_shared<PathLayer>()),
      m_zeroLayer(std::make_shared<PathLayer>()) {
  prepare(m_toggle, "programDockToggle", "program", tr("Run lathe programs on the part, and write them"));
  m_toggle.setCheckable(true);
  m_toggle.setShortcut(QKeySequence(Qt::Key_G));
  for (const auto& layer : {m_layer, m_zeroLayer}) m_parts.viewport.addLayer(layer);
  connect(m_banner, &SimulationBanner::cutRequested, this, [this] {
    if (ProgramSession* const session = present()) session->cut();
  });
  connect(m_banner, &SimulationBanner::leaveRequested, this, [this] {
    if (ProgramSession* const session = present()) session->leave();
  });
  connect(&m_toggle, &QAction::triggered, this, &ProgramDock::open);
  connect(&parts.viewport, &Viewport::cameraChanged, this, [this] { showZero(m_isOpen && m_document && present()); });
}

ProgramDock::~ProgramDock() {
  for (const auto& layer : {m_layer, m_zeroLayer}) m_parts.viewport.removeLayer(*layer);
}

void ProgramDock::makeDock() {
  auto* const window = qobject_cast<QMainWindow*>(m_parts.window);
  if (m_dock || !window) return;
  m_dock = new QDockWidget(tr("Program"), window);
  m_dock->setObjectName(QStringLiteral("programDock"));
  m_dock->setAccessibleName(m_dock->windowTitle());
  m_dock->setTitleBarWidget(new DockTitle(m_dock));
  m_pages = new QStackedWidget(m_dock);
  m_dock->setWidget(new ScrolledPanel(m_pages, ScrolledPanel::Directions::Both, m_dock));
  window->addDockWidget(Qt::RightDockWidgetArea, m_dock);
  if (auto* kind = window->findChild<QDockWidget*>(QStringLiteral("kindDock"))) window->tabifyDockWidget(kind, m_dock);
  window->resizeDocks({m_dock}, {kUsualWidth}, Qt::Horizontal);
  connect(m_dock, &QDockWidget::visibilityChanged, this, [this](bool isVisible) {
    m_toggle.setChecked(isVisible);
    // Raises the panel of the part before the other panels behind it.
    if (std::exchange(m_isInFront, isVisible) && m_dock->isHidden()) raiseKindPanel(m_parts);
    if (!m_document || !m_dock->isHidden()) return;  // another dock covers it, or no workpiece is shown
    m_isOpen = false;
    show();
  });
}

void ProgramDock::open(bool isOpen) {
  m_isOpen = isOpen;
  follow();
  if (m_dock && isOpen) m_dock->raise();
}

ProgramSession* ProgramDock::present() {
  const auto found = m_sessions.find(m_document);
  return found == m_sessions.end() ? nullptr : found->second.get();
}

void ProgramDock::setDocument(DocumentTab* document) {
  if (m_document) disconnect(&m_document->document, &Document::changed, this, &ProgramDock::show);
  m_document = document;
  if (document) connect(&document->document, &Document::changed, this, &ProgramDock::show);  // the zero moves with it
  follow();
}

void ProgramDock::forget(DocumentTab* document) {
  m_sessions.erase(document);
}

void ProgramDock::setVisible(bool isVisible) {
  m_isVisible = isVisible;
  for (const auto& layer : {m_layer, m_zeroLayer}) layer->setVisible(isVisible);
  show();
}

bool ProgramDock::isSettled() const {
  return std::all_of(m_sessions.begin(), m_sessions.end(), [](const auto& each) { return each.second->isSettled(); });
}

void ProgramDock::follow() {
  const bool isShown = m_document && m_isOpen;
  if (isShown) {
    makeDock();
    std::unique_ptr<ProgramSession>& session = m_sessions[m_document];
    if (!session) {
      session = std::make_unique<ProgramSession>(m_parts, *m_document, this);
      m_pages->addWidget(session->panel());
      connect(session.get(), &ProgramSession::pictureChanged, this, &ProgramDock::show);
      connect(session.get(), &ProgramSession::message, this, &ProgramDock::message);
    }
    m_pages->setCurrentWidget(session->panel());
  }
  if (m_dock && m_dock->isHidden() == isShown) m_dock->setVisible(isShown);
  show();
}

void ProgramDock::show() {
  const ProgramSession* const session = m_isOpen && m_document ? present() : nullptr;
  const ProgramPicture picture = session ? session->picture() : ProgramPicture();
  m_layer->setLines(picture.lines);
  m_layer->setTool(picture.tool);
  showZero(session != nullptr);
  showBanner(session);
  emit partShown(picture.part);
}

void ProgramDock::showBanner(const ProgramSession* session) {
  if (!m_banner) return;
  if (session && m_isVisible && session->isSimulated())
    m_banner->showFor(session->isCuttable(), session->cuttingTip());
  else
    m_banner->hide();
}

// Shows the zero on the axis, at the finished face or the end of the bar.
void ProgramDock::showZero(bool isShown) {
  constexpr double kSize = 0.06;  // share of the diameter of the bar
  std::pair<double, double> zero;
  if (isShown) {
    const WorkpieceSnapshot& workpiece = static_cast<const WorkpieceDocument&>(m_document->document).workpiece();
    zero = {programZero(workpiece), kSize * workpiece.stock.diameter};
  }
  const bool isFromBehind = isBehindLathe(m_parts.viewport.camera());
  const bool isAsSeen = std::exchange(m_isFromBehind, isFromBehind) == isFromBehind;
  if (std::exchange(m_zero, zero) == zero && isAsSeen) return;
  m_zeroLayer->setLines(isShown ? zeroSymbol(zero.first, zero.second, tr("Program zero"), m_isFromBehind) : nullptr);
}

bool ProgramDock::take(const QString& path) {
  if (!m_document || !isProgramName(path)) return false;
  open(true);
  present()->read(path);
  return true;
}

QString ProgramDock::unsavedOf(const DocumentTab& document) const {
  const auto found = m_sessions.find(&document);
  return found != m_sessions.end() && found->second->isUnsaved() ? found->second->fileName() : QString();
}

void ProgramDock::saveOf(const DocumentTab& document, std::function<void(bool)> ended) {
  const auto found = m_sessions.find(&document);
  if (found == m_sessions.end()) return ended(true);
  found->second->save(std::move(ended));
}

}  // namespace handwheel
