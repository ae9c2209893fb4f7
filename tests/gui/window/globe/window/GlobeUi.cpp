// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "globe/window/GlobeUi.h"

#include "PointsLayer.h"
#include "controls/property/PropertyList.h"
#include "document/scene/BodyProperties.h"
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

// Those of all visible bodies, in the scene.
std::vector<Vec3> shownPoints(const BodySet& bodies) {
  std::vector<Vec3> points;
  for (const BodyPointer& body : bodies) {
    for (std::size_t i = 0; body->visible && i < kGlobePoints; ++i)
      points.push_back(body->pose * pointsOf(*body).point(i));
  }
  return points;
}

SnapField polesOf(const GlobeDocument& globe) {
  SnapFeatures poles;
  for (const Vec3& axis : {Vec3(0, 0, 1), Vec3(0, 0, -1)})
    poles.addPoint(0, globe.pose() * Vec3(globe.surface().heightTowards(axis) * axis));
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
  m_layer->setPoints(shownPoints(globe().bodies()));
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
  showBodies(globe().bodies());
  std::vector<Property> shown = globe().properties();
  std::erase_if(shown,
                [](const Property& property) { return property.id != "radius" && !bodyOfProperty(property.id); });
  m_panel->setLengthUnit(globe().displayUnit());
  m_panel->setProperties(shown);
  feel(true);
  emit stateChanged();
}

void GlobeUi::showBodies(const BodySet& bodies) {
  std::vector<Vec3> points = shownPoints(bodies);
  if (points.size() == m_layer->points().size())
    m_layer->movePoints(std::move(points));
  else
    m_layer->setPoints(std::move(points));
}

void GlobeUi::showPreview(const ToolPreview& preview) {
  if (!m_document) return;
  const auto* own = dynamic_cast<const GlobePreview*>(preview.ofKind.get());
  if (own || m_isPreviewed) showBodies(own ? withGlobe(globe().bodies(), own->surface) : globe().bodies());
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
  const auto dent = [this] {
    return std::make_unique<DentTool>(globe(), SimulationServices{m_window.servoClock, m_dents});
  };
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
  const auto make = [surface = globe().surface(), pose = globe().pose(),
                     channel = m_dented](const TouchContext& context) {
    return std::make_unique<GlobeForce>(surface, pose, context.mapping.sceneStiffness(context.touch.stiffness),
                                        channel);
  };
  m_window.touch.setSource(kGlobeSource, make, isEdit);
  m_window.touch.setSnap(polesOf(globe()), kPoleReach, isEdit);
}

}  // namespace handwheel::test
