// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/Scene.h"

#include <vtkCamera.h>

namespace handwheel {

namespace {

constexpr std::size_t kBrushOutlinePoints = 5000;
constexpr std::size_t kFrameTriangles = 65536;  // that a frame uploads: 10 ms in software
constexpr double kProposedOpacity = 0.5;

// Corners of faces at even intervals.
std::vector<Vec3> sample(const HalfEdgeMesh& mesh) {
  std::vector<Vec3> points;
  const std::size_t step = mesh.faceSlots() / kBrushOutlinePoints + 1;
  for (std::size_t f = 0; f < mesh.faceSlots(); f += step) {
    const auto face = static_cast<Face>(f);
    if (!mesh.isLive(face)) continue;
    for (const Vertex v : mesh.triangle(face)) points.push_back(mesh.position(v));
  }
  return points;
}

}  // namespace

Scene::Scene()
    : m_blocks(m_renderer), m_parts(m_renderer), m_proposed(m_renderer, kProposedOpacity), m_marks(m_renderer) {
  addStudioLights(m_renderer);
  m_renderer->GradientBackgroundOn();
  m_renderer->UseFXAAOn();
  setDark(false);
}

void Scene::clear() {
  m_blocks.clear();
  m_parts.set({});
  m_proposed.set({});
  m_parts.setFaded({});
  m_mesh = {};
  m_meshBounds.setEmpty();
  m_meshOutline.clear();
  m_marks.clear();
  m_marks.setMesh(m_mesh, m_origin);
}

void Scene::setMesh(const HalfEdgeMesh& mesh, const Box& bounds) {
  m_blocks.clear();
  m_mesh = mesh;
  m_meshBounds = bounds;
  m_meshOutline = sample(mesh);
  const Box& near = bounds.isEmpty() ? m_parts.bounds() : bounds;
  setOrigin(near.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(near.center()));
  m_marks.setMesh(m_mesh, m_origin);
}

void Scene::updateMesh(const HalfEdgeMesh& mesh, const std::vector<Face>& touched) {
  m_mesh = mesh;
  m_meshOutline = sample(mesh);
  // Faces that went may leave the bounds too large, which harms nothing; measuring a large mesh anew takes its time.
  for (const Face f : touched) {
    if (f >= mesh.faceSlots() || !mesh.isLive(f)) continue;  // its slot may be gone with it
    for (const Vertex v : mesh.triangle(f)) m_meshBounds.extend(mesh.position(v));
  }
  m_marks.setMesh(m_mesh, m_origin);
}

void Scene::setParts(const std::vector<DisplayPart>& parts) {
  m_parts.set(parts);
  // Blocks of a mesh are built about the origin, which then stays. Parts alone may move far away from it.
  const Box& box = m_parts.bounds();
  if (!m_meshBounds.isEmpty() || box.isEmpty()) return;
  if ((box.center() - m_origin).norm() > box.diagonal().norm()) setOrigin(box.center());
}

void Scene::setOrigin(const Vec3& origin) {
  if (origin == m_origin) return;
  m_origin = origin;
  m_parts.setOrigin(origin);
  m_proposed.setOrigin(origin);
  m_marks.setMesh(m_mesh, origin);
  placeClipPlane();
}

Box Scene::bounds() const {
  return m_meshBounds.merged(m_parts.bounds());
}

std::vector<Vec3> Scene::outline() const {
  std::vector<Vec3> points = m_parts.outline();
  points.insert(points.end(), m_meshOutline.begin(), m_meshOutline.end());
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
  m_marks.setColours(m_style.colours);
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
  m_blocks.setStyle(m_style);
  m_parts.setStyle(m_style);
  m_proposed.setStyle(m_style);
}

bool Scene::takeGeometry() {
  std::size_t taken = 0;
  while (taken < kFrameTriangles) {
    std::size_t some = m_blocks.takeOne();
    if (some == 0) some = m_parts.takeOne();
    if (some == 0) some = m_proposed.takeOne();
    if (some == 0) break;
    taken += some;
  }
  return taken > 0;
}

bool Scene::takeFaces() {
  for (std::size_t taken = 0; taken < kFrameTriangles;) {
    const std::size_t some = m_marks.takeFaces();
    if (some == 0) return false;
    taken += some;
  }
  return m_marks.owesFaces();
}

int Scene::builtCount() const {
  return m_blocks.builtCount() + m_parts.builtCount() + m_proposed.builtCount();
}

void Scene::prepare(const CameraState& camera, const Vec2& size, double pixelRatio) {
  if (pixelRatio != m_style.pixelRatio) {
    m_style.pixelRatio = pixelRatio;
    applyStyle();
  }
  const CameraNavigation view(camera, size);
  placeCamera(view);
  LayerFrame frame;
  frame.pixelRatio = pixelRatio;
  if (view.isPerspective()) {
    frame.shrinkPerPixel = view.unitsPerPixel() / camera.eyeDistance();
    frame.shiftPerPixel = frame.shrinkPerPixel * (camera.eye() - m_origin);
  } else {
    frame.shiftPerPixel = view.unitsPerPixel() * camera.towardsViewer();
  }
  frame.clip = m_clip;
  frame.clip.offset -= m_clip.normal.dot(m_origin);
  m_marks.prepare(frame);
}

void Scene::placeCamera(const CameraNavigation& view) {
  const CameraState& camera = view.camera();
  const Viewpoint viewpoint = view.viewpoint(bounds().merged(m_proposed.bounds()).merged(m_liveBounds));
  const Vec3 eye = viewpoint.position - m_origin;
  const Vec3 focus = eye - viewpoint.farthest * camera.towardsViewer();  // an honest direction, whatever the distance
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
