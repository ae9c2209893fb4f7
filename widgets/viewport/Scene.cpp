// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/Scene.h"

#include <vtkCamera.h>

namespace handwheel {

namespace {

constexpr std::size_t kOutlinePoints = 5000;

// Corners of faces at even intervals.
std::vector<Vec3> sample(const HalfEdgeMesh& mesh) {
  std::vector<Vec3> points;
  const std::size_t step = mesh.faceSlots() / kOutlinePoints + 1;
  for (std::size_t f = 0; f < mesh.faceSlots(); f += step) {
    const auto face = static_cast<Face>(f);
    if (!mesh.isLive(face)) continue;
    for (const Vertex v : mesh.triangle(face)) points.push_back(mesh.position(v));
  }
  return points;
}

}  // namespace

Scene::Scene() : m_blocks(m_renderer), m_marks(m_renderer) {
  addStudioLights(m_renderer);
  m_renderer->GradientBackgroundOn();
  m_renderer->UseFXAAOn();
  m_renderer->GetActiveCamera()->ParallelProjectionOn();
  setDark(false);
}

void Scene::clear() {
  m_blocks.clear();
  m_mesh = {};
  m_bounds.setEmpty();
  m_outline.clear();
  m_marks.setMesh(m_mesh, m_origin);
  m_marks.setLoops({});
  m_marks.setFaceMarks({});
  m_marks.setPointMarks({});
  m_marks.setLineMarks({});
  m_marks.setPreview({}, {});
}

void Scene::setMesh(const HalfEdgeMesh& mesh, const Box& bounds) {
  m_blocks.clear();
  m_mesh = mesh;
  m_bounds = bounds;
  m_outline = sample(mesh);
  m_origin = m_bounds.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(m_bounds.center());
  m_marks.setMesh(m_mesh, m_origin);
}

void Scene::updateMesh(const HalfEdgeMesh& mesh, const std::vector<Face>& touched) {
  m_mesh = mesh;
  m_outline = sample(mesh);
  // Faces that went may leave the bounds too large, which harms nothing; measuring a large mesh anew takes its time.
  for (const Face f : touched) {
    if (f >= mesh.faceSlots() || !mesh.isLive(f)) continue;  // its slot may be gone with it
    for (const Vertex v : mesh.triangle(f)) m_bounds.extend(mesh.position(v));
  }
  m_marks.setMesh(m_mesh, m_origin);
}

void Scene::setDark(bool dark) {
  m_colours = sceneColours(dark);
  const QColor &top = m_colours.backgroundTop, &bottom = m_colours.backgroundBottom;
  m_renderer->SetBackground(bottom.redF(), bottom.greenF(), bottom.blueF());
  m_renderer->SetBackground2(top.redF(), top.greenF(), top.blueF());
  m_blocks.setColours(m_colours);
  m_marks.setColours(m_colours);
}

void Scene::prepare(const CameraState& camera, const Vec2& size, double pixelRatio) {
  placeCamera(camera);
  m_blocks.setPixelRatio(pixelRatio);
  LayerFrame frame;
  frame.pixelRatio = pixelRatio;
  frame.unitsPerPixel = CameraNavigation(camera, size).unitsPerPixel();
  frame.towardsViewer = camera.towardsViewer();
  m_marks.prepare(frame);
}

void Scene::placeCamera(const CameraState& camera) {
  // Everything that is drawn, lifted layers and previews included, lies within this of the middle of the model.
  const double radius = (m_bounds.isEmpty() ? 1.0 : m_bounds.diagonal().norm()) + 0.1 * camera.height;
  const Vec3 towards = camera.towardsViewer();
  const Vec3 centre = camera.centre - m_origin;
  const double middle = m_bounds.isEmpty() ? 0.0 : (m_bounds.center() - camera.centre).dot(towards);
  const double distance = middle + 2 * radius;
  const Vec3 eye = centre + distance * towards;
  const Vec3 focus = eye - 2 * radius * towards;  // an honest direction, whatever the distance
  const Vec3 up = camera.up();
  vtkCamera* c = m_renderer->GetActiveCamera();
  c->SetPosition(eye.x(), eye.y(), eye.z());
  c->SetFocalPoint(focus.x(), focus.y(), focus.z());
  c->SetViewUp(up.x(), up.y(), up.z());
  c->SetParallelScale(camera.height / 2);
  c->SetClippingRange(radius, 3 * radius);
}

}  // namespace handwheel
