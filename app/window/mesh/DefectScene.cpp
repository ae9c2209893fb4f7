// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/DefectScene.h"

#include "panels/defects/DefectModel.h"
#include "theme/Theme.h"
#include "viewport/Viewport.h"
#include "viewport/surface/MeshLayer.h"
#include "window/mesh/HolePicking.h"
#include "window/mesh/LoopSelection.h"
#include "window/mesh/MeshTab.h"
#include "window/mesh/UnobstructedView.h"

#include <QCursor>
#include <algorithm>

namespace handwheel {

namespace {

// Share of the model's diagonal that the camera shows at least.
constexpr double kLeastBox = 0.08;
// A defect of few triangles has an outline, so that it stands out from others that lie on it.
constexpr std::size_t kMostOutlined = 16;

std::vector<Vec3> pointsOf(const HalfEdgeMesh& mesh, const BoundaryLoop& loop) {
  std::vector<Vec3> points;
  points.reserve(loop.halfEdges.size());
  for (HalfEdge h : loop.halfEdges) points.push_back(mesh.position(mesh.from(h)));
  return points;
}

// The edges of these faces, but none of those that an edit has removed meanwhile.
std::vector<std::pair<Vec3, Vec3>> outlinesOf(const HalfEdgeMesh& mesh, const std::vector<Face>& faces) {
  std::vector<std::pair<Vec3, Vec3>> edges;
  for (const Face f : faces) {
    if (f >= mesh.faceSlots() || !mesh.isLive(f)) continue;
    const TrianglePoints p = mesh.points(f);
    for (std::size_t k = 0; k < 3; ++k) edges.emplace_back(p[k], p[(k + 1) % 3]);
  }
  return edges;
}

std::vector<Face> facesOf(const DefectList& defectList, DefectKind kind) {
  const Defects& defects = defectList.document().defects();
  std::vector<Face> faces;
  switch (kind) {
    case DefectKind::Degenerate:
      return defects.degenerateFaces;
    case DefectKind::Duplicate:
      return defects.duplicateFaces;
    case DefectKind::SelfIntersection:
      if (!defectList.selfIntersections()) return {};
      for (const auto& [a, b] : *defectList.selfIntersections()) faces.insert(faces.end(), {a, b});
      return faces;
    case DefectKind::Flipped:
      return defectList.document().reversedFaces();
    case DefectKind::Inconsistent:
      return defects.inconsistentFaces;
    case DefectKind::InsideOut:
      for (const std::vector<Face>& body : defects.insideOut) faces.insert(faces.end(), body.begin(), body.end());
      return faces;
    case DefectKind::Debris:
      for (std::size_t i : defectList.debris()) {
        faces.insert(faces.end(), defects.components[i].faces.begin(), defects.components[i].faces.end());
      }
      return faces;
    default:
      return {};
  }
}

std::vector<Vec3> vertexPointsOf(const DefectList& defectList, DefectKind kind) {
  const HalfEdgeMesh& mesh = defectList.document().mesh();
  const Defects& defects = defectList.document().defects();
  std::vector<Vec3> points;
  if (kind == DefectKind::NonManifoldVertex) {
    for (Vertex v : defects.nonManifoldVertices) points.push_back(mesh.position(v));
  } else {
    for (const auto& pair : defects.nearVertices) points.push_back(mesh.position(pair.first));
  }
  return points;
}

}  // namespace

DefectScene::DefectScene(Viewport& viewport, MeshLayer& layer, LoopSelection& selection, DefectModel& defects,
                         QObject* parent)
    : QObject(parent), m_viewport(viewport), m_layer(layer), m_selection(selection), m_defects(defects) {
  connect(&m_selection, &LoopSelection::changed, this, &DefectScene::drawLoops);
  connect(&m_selection, &LoopSelection::hoverChanged, this,
          [this] { m_layer.setHighlightedLoop(m_selection.hovered()); });
  connect(&m_defects, &DefectModel::shownChanged, this, [this] {
    drawLoops();
    drawDefects();
  });
  connect(&m_viewport, &Viewport::hovered, this, [this](const Pick& pick) { m_selection.hover(loopAt(pick)); });
  connect(&m_viewport, &Viewport::clicked, this, [this](const Pick& pick) { m_selection.select(loopAt(pick)); });
  connect(&m_viewport, &Viewport::doubleClicked, this, [this](const Pick& pick) { showLoop(loopAt(pick)); });
}

void DefectScene::setDocument(MeshTab* document) {
  if (m_document) {
    m_document->camera = m_viewport.camera();
    m_document->document.disconnect(this);
    m_document->defectList.disconnect(this);
  }
  m_document = document;
  m_chosen.clear();
  if (!document) return m_layer.clear();
  connect(&document->document, &MeshDocument::meshChanged, this,
          [this](const std::vector<Face>& touched) { m_layer.updateMesh(m_document->document.mesh(), touched); });
  connect(&document->defectList, &DefectList::changed, this, [this] {
    drawLoops();
    drawDefects();
  });
  m_layer.setVisible(document->visible);
  m_layer.setMesh(document->document.mesh(), document->document.defects().box);
  drawLoops();
  drawDefects();
  if (document->camera) {
    m_viewport.setCamera(*document->camera);
  } else {
    m_viewport.setStandardView(StandardView::Isometric);
  }
}

int DefectScene::loopAt(const Pick& pick) const {
  if (loopOf(pick) >= 0 || !m_document) return loopOf(pick);
  const CameraState camera = m_viewport.camera();
  if (!pick.isNothing()) return loopAround(m_document->defectList, camera, pick.point, pick.point);
  const QPointF cursor = m_viewport.mapFromGlobal(QPointF(QCursor::pos()));
  const double scale = camera.height / m_viewport.height();  // units of the model to the pixel
  const double right = (cursor.x() - m_viewport.width() / 2.0) * scale;
  const double up = (m_viewport.height() / 2.0 - cursor.y()) * scale;
  return loopAround(m_document->defectList, camera, camera.centre + right * camera.right() + up * camera.up(), {});
}

void DefectScene::refreshVisibility() {
  if (m_document) m_layer.setVisible(m_document->visible);
}

void DefectScene::showLoop(int loop) {
  if (!m_document || loop < 0) return;
  const auto [box, outward] = m_defects.viewTargetOf(m_defects.loopIndex(loop));
  flyTo(box, outward);
}

void DefectScene::showDefect(const QModelIndex& defect) {
  const auto [box, outward] = m_defects.viewTargetOf(defect);
  if (!isWellSeen(m_viewport, box, outward)) flyTo(box, outward);
}

void DefectScene::markChosen(const QModelIndex& defect) {
  std::vector<Face> faces = m_defects.facesOf(defect);
  std::sort(faces.begin(), faces.end());
  if (faces == m_chosen) return;
  m_chosen = std::move(faces);
  drawDefects();
}

bool DefectScene::isChosen(Face f) const {
  return std::binary_search(m_chosen.begin(), m_chosen.end(), f);
}

void DefectScene::flyTo(const Box& box, const Vec3& outward) {
  if (!m_document || box.isEmpty()) return;
  const HalfEdgeMesh& mesh = m_document->document.mesh();
  // A tiny defect is shown with enough around it to see where it is.
  const double least = kLeastBox * m_document->document.defects().box.diagonal().norm();
  const double grow = std::max(0.0, (least - box.diagonal().norm()) / 2.0);
  m_viewport.flyTo(Box(box.min().array() - grow, box.max().array() + grow), unobstructedDirection(mesh, box, outward));
}

void DefectScene::drawLoops() {
  if (!m_document) return;
  const DefectList& defectList = m_document->defectList;
  std::vector<LoopMark> marks;
  for (DefectKind kind : {DefectKind::Hole, DefectKind::KeptOpen}) {
    for (int id : kind == DefectKind::Hole ? defectList.holes() : defectList.keptOpen()) {
      const bool selected = id == m_selection.loop();
      if (!selected && !m_defects.isShown(kind)) continue;
      marks.push_back({id, pointsOf(m_document->document.mesh(), defectList.loop(id)), defectColour(kind), selected});
    }
  }
  m_layer.setLoops(std::move(marks));
}

void DefectScene::drawDefects() {
  if (!m_document) return;
  const DefectList& defectList = m_document->defectList;
  std::vector<FaceMark> faces;
  for (DefectKind kind : {DefectKind::InsideOut, DefectKind::Inconsistent, DefectKind::Debris, DefectKind::Flipped,
                          DefectKind::Degenerate, DefectKind::Duplicate, DefectKind::SelfIntersection}) {
    if (m_defects.isShown(kind)) faces.push_back({facesOf(defectList, kind), defectColour(kind)});
  }
  const QColor accent = themeColours(currentTheme()).accent;
  if (!m_chosen.empty()) {
    for (FaceMark& mark : faces) std::erase_if(mark.faces, [&](Face f) { return isChosen(f); });
    faces.push_back({m_chosen, accent});
  }
  m_layer.setFaceMarks(std::move(faces));

  std::vector<PointMark> points;
  for (DefectKind kind : {DefectKind::NonManifoldVertex, DefectKind::NearVertex}) {
    if (m_defects.isShown(kind)) points.push_back({vertexPointsOf(defectList, kind), defectColour(kind)});
  }
  m_layer.setPointMarks(std::move(points));

  std::vector<LineMark> lines;
  const Defects& defects = m_document->document.defects();
  for (DefectKind kind : {DefectKind::NonManifoldEdge, DefectKind::OneSided}) {
    if (!m_defects.isShown(kind)) continue;
    const HalfEdgeMesh& mesh = m_document->document.mesh();
    LineMark mark{{}, defectColour(kind)};
    for (const auto& [a, b] : kind == DefectKind::OneSided ? defects.nonOrientableEdges : defects.nonManifoldEdges) {
      mark.segments.emplace_back(mesh.position(a), mesh.position(b));
    }
    lines.push_back(std::move(mark));
  }
  if (m_chosen.size() <= kMostOutlined) lines.push_back({outlinesOf(m_document->document.mesh(), m_chosen), accent});
  m_layer.setLineMarks(std::move(lines));
}

}  // namespace handwheel
