// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "globe/window/GlobeUi.h"

#include "PointsLayer.h"
#include "controls/PropertyList.h"
#include "globe/tools/DentTool.h"
#include "globe/tools/GlobePreview.h"
#include "globe/tools/GrowTool.h"
#include "tools/MeasureTool.h"
#include "viewport/Viewport.h"
#include "window/WindowServices.h"
#include "window/documents/DocumentProperties.h"
#include "window/documents/DocumentTab.h"
#include "window/haptics/HapticSceneBuilder.h"
#include "window/tools/ToolHost.h"

namespace handwheel::test {

namespace {

constexpr double kPoleReach = 3.0;  // mm

std::vector<Vec3> pointsOf(const GlobeSurface& surface) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < kGlobePoints; ++i) points.push_back(surface.point(i));
  return points;
}

SnapField polesOf(const GlobeSurface& surface) {
  SnapFeatures poles;
  for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(0, 0, -1)}) poles.addPoint(0, surface.heightTowards(axis) * axis);
  return SnapField(poles);
}

}  // namespace

GlobeUi::GlobeUi(const WindowContext& window, QString sample)
    : m_window(window),
      m_sample(std::move(sample)),
      m_dents(kDentService),
      m_layer(std::make_shared<PointsLayer>()),
      m_panel(new PropertyList(window.window)) {
  m_window.services.add(m_dents, QStringLiteral("Dents of globes"));
  m_window.viewport.addLayer(m_layer);
  connectEdits(
      *m_panel, [this] { return m_document ? &m_document->document : nullptr; }, this);
  connect(&m_window.tools, &ToolHost::updated, this, &GlobeUi::followTool);
}

GlobeUi::~GlobeUi() {
  m_window.viewport.removeLayer(*m_layer);
  m_window.services.remove(m_dents);
}

std::unique_ptr<DocumentTab> GlobeUi::open(std::unique_ptr<Document> document) {
  return std::make_unique<DocumentTab>(std::move(document), *this);
}

void GlobeUi::setDocument(DocumentTab* document) {
  if (m_document) {
    m_document->camera = m_window.viewport.camera();
    m_document->document.disconnect(this);
    m_layer->setPoints({});
  }
  const bool wasShown = std::exchange(m_document, document) != nullptr;
  if (!document) return wasShown ? feel(false) : void();
  connect(&document->document, &Document::changed, this, &GlobeUi::show);
  m_layer->setPoints(pointsOf(globe().surface()));
  m_layer->setVisible(document->visible);
  show();
  if (document->camera) {
    m_window.viewport.setCamera(*document->camera);
  } else {
    m_window.viewport.setStandardView(StandardView::Isometric);
  }
}

void GlobeUi::refreshVisibility() {
  if (!m_document) return;
  m_layer->setVisible(m_document->visible);
  feel(false);
}

GlobeDocument& GlobeUi::globe() const {
  return static_cast<GlobeDocument&>(m_document->document);
}

void GlobeUi::show() {
  showSurface(globe().surface());
  std::vector<Property> shown = globe().properties();
  std::erase_if(shown, [](const Property& property) { return property.group != "Globe"; });
  m_panel->setLengthUnit(globe().displayUnit());
  m_panel->setProperties(shown);
  feel(true);
  emit stateChanged();
}

void GlobeUi::showSurface(const GlobeSurface& surface) {
  m_layer->movePoints(pointsOf(surface));
}

void GlobeUi::showPreview(const ToolPreview& preview) {
  if (!m_document) return;
  const auto* own = dynamic_cast<const GlobePreview*>(preview.ofKind.get());
  if (own || m_isPreviewed) showSurface(own ? own->surface : globe().surface());
  m_isPreviewed = own != nullptr;
}

std::vector<StartAction> GlobeUi::startActions() const {
  return {{"newGlobe", "New &globe", "Start with a globe", panelIcon()},
          {"openGlobe", "Open the sample g&lobe", "A globe", panelIcon(), m_sample,
           StartTile{"globeTile", panelIcon(), "Look at a globe", "It is round, nearly."}}};
}

QWidget* GlobeUi::panel() {
  return m_panel;
}

std::vector<ToolDescriptor> GlobeUi::tools() {
  const auto grow = [this] { return std::make_unique<GrowTool>(globe()); };
  const auto dent = [this] { return std::make_unique<DentTool>(globe(), DentServices{m_window.servoClock, m_dents}); };
  const auto pick = [&view = m_window.viewport](const Ray& ray) -> std::optional<SurfacePoint> {
    const Pick hit = view.pickAlong(ray.origin, ray.direction);
    return hit.isNothing() ? std::nullopt : std::optional(SurfacePoint{hit.point});
  };
  const auto measure = [pick] { return std::make_unique<MeasureTool>(MeasureServices{pick, {}}); };
  return {{"growTool", "Gro&w", "Make it larger", panelIcon(), {}, grow, "grow", {}},
          {"dentTool", "Den&t", "Press dents into it", panelIcon(), {}, dent, "dent", {}},
          measureToolDescriptor(measure)};
}

std::vector<Hint> GlobeUi::hints() {
  return m_window.tools.hints();
}

QString GlobeUi::statistics() const {
  return m_document ? QString::number(globe().surface().radius()) : QString();
}

QString GlobeUi::openedText(const DocumentTab& opened) const {
  return "Opened the globe " + opened.document.name();
}

void GlobeUi::followTool() {
  const auto* const tool = dynamic_cast<const DentTool*>(m_window.tools.runner().tool());
  std::shared_ptr<DentChannel> channel = tool ? tool->channel() : nullptr;
  if (channel == m_dented) return;
  m_dented = std::move(channel);
  if (m_document) feel(true);
}

void GlobeUi::feel(bool isEdit) {
  if (!m_document || !m_document->visible) {
    m_window.touch.setSource(kGlobeSource, {}, isEdit);
    return m_window.touch.setSnap({}, 0.0, isEdit);
  }
  const auto make = [surface = globe().surface(), channel = m_dented](const TouchContext& context) {
    return std::make_unique<GlobeForce>(surface, context.mapping.sceneStiffness(context.touch.stiffness), channel);
  };
  m_window.touch.setSource(kGlobeSource, make, isEdit);
  m_window.touch.setSnap(polesOf(globe().surface()), kPoleReach, isEdit);
}

}  // namespace handwheel::test
