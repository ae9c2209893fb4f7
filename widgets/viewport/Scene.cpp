// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/Scene.h"

#include "viewport/DepthOffsetActor.h"
#include "viewport/LayerFrame.h"

#include <vtkCamera.h>
#include <algorithm>

namespace handwheel {

namespace {

constexpr std::size_t kFrameTriangles = 65536;  // uploaded per frame: 10 ms in software

}  // namespace

Scene::Scene() {
  addStudioLights(m_renderer);
  m_renderer->GradientBackgroundOn();
  m_renderer->UseFXAAOn();
  setDark(false);
}

Scene::~Scene() {
  for (const auto& layer : m_layers) layer->detach();
}

void Scene::add(std::shared_ptr<ViewLayer> layer, ViewLayer::Listener listener) {
  layer->attach(m_renderer, std::move(listener));
  layer->setStyle(m_style);
  m_layers.push_back(std::move(layer));
}

void Scene::remove(const ViewLayer& layer) {
  const auto found =
      std::find_if(m_layers.begin(), m_layers.end(), [&](const auto& each) { return each.get() == &layer; });
  if (found == m_layers.end()) return;
  (*found)->detach();
  m_layers.erase(found);
}

std::vector<ViewLayer*> Scene::visible() const {
  std::vector<ViewLayer*> layers;
  for (const auto& layer : m_layers) {
    if (layer->isVisible()) layers.push_back(layer.get());
  }
  return layers;
}

Pickable Scene::pickable() const {
  const std::vector<ViewLayer*> layers = visible();
  return {{layers.begin(), layers.end()}, m_clip};
}

bool Scene::isSearchable() const {
  const std::vector<ViewLayer*> layers = visible();
  return std::all_of(layers.begin(), layers.end(), [](const ViewLayer* layer) { return layer->isSearchable(); });
}

void Scene::setHovered(const Pick& pick) {
  for (const auto& layer : m_layers)
    layer->setHovered(layer.get() == pick.layer ? std::optional(pick.element) : std::nullopt);
}

Box Scene::bounds() const {
  return pickable().bounds();
}

std::vector<Vec3> Scene::outline() const {
  std::vector<Vec3> points;
  for (const ViewLayer* layer : visible()) {
    const std::vector<Vec3> some = layer->outline();
    points.insert(points.end(), some.begin(), some.end());
  }
  return points;
}

void Scene::setShading(Shading shading) {
  m_style.shading = shading;
  applyStyle();
}

void Scene::setDark(bool dark) {
  m_style.colours = sceneColours(dark);
  const QColor &top = m_style.colours.backgroundTop, &bottom = m_style.colours.backgroundBottom;
  m_renderer->SetBackground(bottom.redF(), bottom.greenF(), bottom.blueF());
  m_renderer->SetBackground2(top.redF(), top.greenF(), top.blueF());
  applyStyle();
}

void Scene::setClipPlane(const ClipPlane& plane) {
  const bool isSwitched = plane.on != m_clip.on;
  m_clip = plane;
  placeClipPlane();
  if (!isSwitched) return;
  m_style.clip = plane.on ? m_clipPlane.GetPointer() : nullptr;
  applyStyle();
}

void Scene::placeClipPlane() {
  setPlane(m_clipPlane, m_clip.normal, m_clip.offset * m_clip.normal - m_origin);
}

void Scene::applyStyle() {
  for (const auto& layer : m_layers) layer->setStyle(m_style);
}

bool Scene::uploadPendingGeometry() {
  std::size_t taken = 0;
  for (ViewLayer* layer : visible()) {
    while (taken < kFrameTriangles) {
      const std::size_t some = layer->takePiece();
      if (some == 0) break;
      taken += some;
    }
  }
  return taken > 0;
}

bool Scene::takeMarks() {
  std::size_t taken = 0;
  bool isSomeLeft = false;
  for (ViewLayer* layer : visible()) {
    while (taken < kFrameTriangles) {
      const std::size_t some = layer->takeMarks();
      if (some == 0) break;
      taken += some;
    }
    isSomeLeft = isSomeLeft || layer->owesMarks();
  }
  return isSomeLeft;
}

void Scene::finish() {
  for (ViewLayer* layer : visible()) layer->finish();
  while (uploadPendingGeometry() || takeMarks()) {
  }
}

void Scene::setCoarseShown(bool isReduced) {
  for (const auto& layer : m_layers) layer->setCoarseShown(isReduced);
}

int Scene::builtCount() const {
  int built = 0;
  for (const auto& layer : m_layers) built += layer->builtCount();
  return built;
}

void Scene::prepare(const CameraState& camera, const Vec2& size, double pixelRatio) {
  placeOrigin();
  if (pixelRatio != m_style.pixelRatio) {
    m_style.pixelRatio = pixelRatio;
    applyStyle();
  }
  const CameraNavigation view(camera, size);
  placeCamera(view);
  LayerFrame frame;
  frame.origin = m_origin;
  frame.pixelRatio = pixelRatio;
  if (view.isPerspective()) {
    frame.shrinkPerPixel = view.unitsPerPixel() / camera.eyeDistance();
    frame.shiftPerPixel = frame.shrinkPerPixel * (camera.eye() - m_origin);
  } else {
    frame.shiftPerPixel = view.unitsPerPixel() * camera.towardsViewer();
  }
  frame.clip = m_clip;
  frame.clip.offset -= m_clip.normal.dot(m_origin);
  for (ViewLayer* layer : visible()) layer->prepare(frame);
}

void Scene::paintOver(QPainter& painter, const QSizeF& size, LengthUnit unit) const {
  for (const ViewLayer* layer : visible()) layer->paintOver(painter, size, unit, colours());
}

// Moves the origin near the model if it has moved far away, because single precision suffices only near the origin.
void Scene::placeOrigin() {
  const Box box = bounds();
  const bool isNear = m_isPlaced && !box.isEmpty() && (box.center() - m_origin).norm() <= box.diagonal().norm();
  m_isPlaced = !box.isEmpty();
  if (isNear || !m_isPlaced) return;
  m_origin = box.center();
  placeClipPlane();
}

void Scene::placeCamera(const CameraNavigation& view) {
  const CameraState& camera = view.camera();
  Box drawn;
  for (const ViewLayer* layer : visible()) drawn.extend(layer->drawnBounds());
  const CameraClippingRange viewpoint = view.viewpoint(drawn);
  const Vec3 eye = viewpoint.position - m_origin;
  const Vec3 focus = eye - viewpoint.farthest * camera.towardsViewer();  // a valid direction at any distance
  const Vec3 up = camera.up();
  vtkCamera* c = m_renderer->GetActiveCamera();
  c->SetPosition(eye.x(), eye.y(), eye.z());
  c->SetFocalPoint(focus.x(), focus.y(), focus.z());
  c->SetViewUp(up.x(), up.y(), up.z());
  c->SetParallelProjection(!view.isPerspective());
  c->SetParallelScale(camera.height / 2);
  c->SetViewAngle(kFieldOfView / kRadiansPerDegree);
  c->SetClippingRange(viewpoint.nearest, viewpoint.farthest);
}

}  // namespace handwheel
