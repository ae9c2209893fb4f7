// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/kinds/RigidPartsUi.h"

#include "tools/MeasureTool.h"
#include "viewport/Viewport.h"
#include "viewport/camera/CameraNavigation.h"
#include "viewport/surface/PartsLayer.h"
#include "window/documents/DocumentProperties.h"
#include "window/documents/DocumentTab.h"
#include "window/kinds/RigidPartsHaptics.h"
#include "window/tools/ToolHost.h"

#include <algorithm>
#include <utility>

namespace handwheel {

RigidPartsUi::RigidPartsUi(const WindowContext& parts, std::vector<std::string> groups, StandardView firstView)
    : m_parts(parts),
      m_groups(std::move(groups)),
      m_firstView(firstView),
      m_layer(std::make_shared<PartsLayer>()),
      m_haptics(new RigidPartsHaptics(parts, this)),
      m_panel(new PropertyList(parts.window)) {
  m_parts.viewport.addLayer(m_layer);
  connect(m_panel, &PropertyList::edited, this,
          [this](const std::string& id, const PropertyValue& value, bool stillDragging) {
            if (m_document && !takeEdit(id, value, stillDragging))
              applyEdit(*m_panel, m_document->document, id, value, stillDragging);
          });
}

RigidPartsUi::~RigidPartsUi() {
  setDocument(nullptr);
  m_parts.viewport.removeLayer(*m_layer);
}

std::unique_ptr<DocumentTab> RigidPartsUi::open(std::unique_ptr<Document> document) {
  return std::make_unique<DocumentTab>(std::move(document), *this);
}

void RigidPartsUi::setDocument(DocumentTab* document) {
  if (m_document) {
    m_document->camera = m_parts.viewport.camera();
    m_document->document.disconnect(this);
    m_layer->setParts({});
    m_replaced.reset();
    m_instead.reset();
    m_past.reset();
    m_model.reset();
  }
  m_document = document;
  m_parts.viewport.setViewFrame(document && isOfLathe() ? latheFrame() : Eigen::Quaterniond::Identity());
  if (!document) return feelParts();
  connect(&document->document, &Document::changed, this, &RigidPartsUi::show);
  m_layer->setVisible(document->visible);
  show();
  if (document->camera) {
    m_parts.viewport.setCamera(*document->camera);
  } else {
    m_parts.viewport.setStandardView(m_firstView == StandardView::Lathe && !isOfLathe() ? StandardView::Isometric
                                                                                        : m_firstView);
  }
}

void RigidPartsUi::refreshVisibility() {
  if (!m_document) return;
  m_layer->setVisible(m_document->visible);
  feelParts();
}

void RigidPartsUi::showPreview(const ToolPreview& preview) {
  m_layer->setFaded(preview.parts);
  if (preview.replaced == m_replaced) return;
  m_replaced = preview.replaced;
  if (m_document) showParts();
}

QWidget* RigidPartsUi::panel() {
  return m_panel;
}

std::vector<Hint> RigidPartsUi::hints() {
  return m_parts.tools.hints();
}

bool RigidPartsUi::isSettled() const {
  return m_haptics->isSettled();
}

ToolDescriptor RigidPartsUi::measureParts() const {
  const auto pick = [&viewport = m_parts.viewport](const Ray& ray) -> std::optional<SurfacePoint> {
    const Pick hit = viewport.pickAlong(ray.origin, ray.direction);
    return hit.isNothing() ? std::nullopt : std::optional(SurfacePoint{hit.point});
  };
  return measureToolDescriptor([pick] { return std::make_unique<MeasureTool>(MeasureServices{pick, {}}); });
}

std::vector<QAction*> RigidPartsUi::panelActions() const {
  if (m_parts.isPanelVisible()) return {};
  return {m_parts.showPanel};
}

void RigidPartsUi::showParts() {
  m_layer->setParts((m_past ? m_past : m_replaced ? m_replaced : m_instead ? m_instead : m_model)->parts);
}

void RigidPartsUi::showPast(const std::shared_ptr<const DisplayModel>& model) {
  if (model == m_past) return;
  m_past = model;
  if (m_document) showParts();
}

void RigidPartsUi::showInstead(const std::shared_ptr<const DisplayModel>& model) {
  if (model == m_instead) return;
  m_instead = model;
  if (m_document) showParts();
}

void RigidPartsUi::setFelt(bool isFelt) {
  if (std::exchange(m_isFelt, isFelt) != isFelt) feelParts();
}

void RigidPartsUi::feelParts() {
  const bool isFelt = m_document && m_document->visible && m_isFelt;
  m_haptics->setParts(isFelt ? m_model : nullptr);
}

DisplayModel RigidPartsUi::displayed(const Document& document) const {
  return document.kind().display(*document.snapshot());
}

void RigidPartsUi::show() {
  const Document& document = m_document->document;
  m_model = std::make_shared<const DisplayModel>(displayed(document));
  showParts();
  feelParts();
  refreshPanel();
}

std::vector<Property> RigidPartsUi::panelProperties(const Document& document) const {
  std::vector<Property> shown = listedProperties(document);
  std::erase_if(shown, [this](const Property& property) {
    return std::find(m_groups.begin(), m_groups.end(), property.group) == m_groups.end();
  });
  return shown;
}

void RigidPartsUi::refreshPanel() {
  if (!m_document) return;
  const Document& document = m_document->document;
  m_panel->setLengthUnit(document.displayUnit());
  m_panel->setFolding(foldingGroups(document));
  m_panel->setProperties(panelProperties(document));
  emit stateChanged();
}

}  // namespace handwheel
