// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/Viewport.h"

#include "mesh/structure/MeshBounds.h"
#include "viewport/ViewportPrivate.h"

#include <QCoreApplication>
#include <algorithm>
#include <set>

namespace handwheel {

namespace {

constexpr double kFitShare = 0.86;    // of the view, filled by the whole model
constexpr double kFlyToShare = 0.38;  // of the view, filled by what one flies to: its surroundings tell where it is
// A flight never magnifies more than this share of the model's diagonal to the height of the view.
constexpr double kNearestFlight = 0.02;

}  // namespace

Viewport::Private::Private(Viewport* widget)
    : q(widget),
      glWindow(scene.renderer()),
      flight([this](const CameraState& state) { moveTo(state); }),
      preparation({[this](std::size_t block, SurfaceGeometry geometry) {
                     scene.blocks().enqueue(block, std::move(geometry));
                     q->update();
                   },
                   [this](SurfaceGeometry geometry) { scene.blocks().setCoarse(std::move(geometry)); },
                   [this](MeshPreparation::Index built) {
                     index = std::move(built);
                     isIndexAwaited = false;
                     layBrush();
                   },
                   [this] { reportOutOfMemory(); }}),
      partPreparation([this](const PartPreparation::Soup& soup, PartShape shape) { takeShape(soup, std::move(shape)); },
                      [this] { reportOutOfMemory(); }),
      cube(new ViewCube(widget)) {
  camera.orientation = orientationOf(StandardView::Isometric);
  cube->setOrientation(camera.orientation);
  connectCube();
  rest.setSingleShot(true);
  rest.setInterval(200);
  QObject::connect(&rest, &QTimer::timeout, q, [this] { q->update(); });
}

void Viewport::Private::reportOutOfMemory() {
  emit q->graphicsFailed(Viewport::tr("There is not enough memory to draw all of the model."));
}

void Viewport::Private::moveTo(const CameraState& state) {
  camera = state;
  cube->setOrientation(camera.orientation);
  q->update();
  emit q->cameraChanged();
}

void Viewport::Private::flyTo(const CameraState& goal) {
  if (isSeen && q->isVisible()) return flight.start(camera, goal);
  flight.stop();
  moveTo(goal);
}

void Viewport::Private::fitFrom(const Eigen::Quaterniond& orientation) {
  CameraState from = goal();
  from.orientation = orientation;
  fitted = CameraNavigation(from, size()).fitted(scene.outline(), kFitShare, covered);
  flyTo(*fitted);
}

// The blocks whose picture an edit changes: those of the touched faces, and of the faces around their corners, as these
// share normals with them.
std::vector<std::size_t> Viewport::Private::blocksAround(const HalfEdgeMesh& before, const HalfEdgeMesh& after,
                                                         const std::vector<Face>& touched) const {
  const Face perBlock = preparation.blockFaces();
  std::set<std::size_t> blocks;
  for (const Face f : touched) {
    if (f < after.faceSlots()) blocks.insert(f / perBlock);
    for (const HalfEdgeMesh* mesh : {&before, &after}) {
      if (f >= mesh->faceSlots() || !mesh->isProper(f)) continue;
      for (HalfEdge h = 3 * f; h < 3 * f + 3; ++h) {
        for (const HalfEdge g : mesh->fan(h)) blocks.insert(HalfEdgeMesh::face(g) / perBlock);
      }
    }
  }
  return {blocks.begin(), blocks.end()};
}

Viewport::Viewport(QWidget* parent) : QOpenGLWidget(parent), d(std::make_unique<Private>(this)) {
  setMouseTracking(true);
  setFocusPolicy(Qt::ClickFocus);
  // The right button drags; a menu that opens on its press would be in the way.
  setContextMenuPolicy(Qt::PreventContextMenu);
  setMinimumSize(200, 150);
  setObjectName(QStringLiteral("viewport"));
  setAccessibleName(tr("3D view"));
  // The mouse goes on while a frame is drawn: a line drawn with it is made of all places where it was. (Qt's X11 plugin
  // asks for compression when the application starts.)
  QCoreApplication::setAttribute(Qt::AA_CompressHighFrequencyEvents, false);
}

void Viewport::setBlockFaces(Face faces) {
  d->preparation.setBlockFaces(faces);
}

void Viewport::setCoarseTriangles(std::size_t triangles) {
  d->preparation.setCoarseTriangles(triangles);
}

void Viewport::setMesh(const HalfEdgeMesh& mesh) {
  setMesh(mesh, boundsOf(mesh));
}

void Viewport::setMesh(const HalfEdgeMesh& mesh, const Box& bounds) {
  d->index.reset();
  d->isIndexAwaited = true;
  d->hover({});
  d->isSeen = false;
  setSurfaceValues(nullptr, {});
  d->live.reset();
  d->scene.setMesh(mesh, bounds);
  d->preparation.startAll(mesh, d->scene.meshBounds(), d->scene.origin());
  update();
}

void Viewport::updateMesh(const HalfEdgeMesh& mesh, const std::vector<Face>& touched) {
  const std::vector<std::size_t> blocks = d->blocksAround(d->scene.mesh(), mesh, touched);
  d->index.reset();
  d->isIndexAwaited = true;
  d->hover({});
  setSurfaceValues(nullptr, {});
  d->scene.updateMesh(mesh, touched);
  d->preparation.startSome(mesh, d->scene.meshBounds(), d->scene.origin(), blocks);
  update();
}

void Viewport::setSurfaceValues(VertexValues values, const ColourScale& scale) {
  if (!values && !d->values) return;
  const bool isNew = values && values != d->values;
  d->values = std::move(values);
  d->preparation.setValues(d->values);
  if (!d->values) {
    d->scene.blocks().setColourScale(std::nullopt);
    return update();
  }
  setColourScale(scale);
  if (isNew) d->preparation.startAgain(d->scene.mesh(), d->scene.meshBounds(), d->scene.origin());
}

void Viewport::setColourScale(const ColourScale& scale) {
  d->colourScale = scale;
  if (d->values) d->scene.blocks().setColourScale(scale);
  update();
}

void Viewport::clear() {
  d->preparation.cancel();
  d->partPreparation.cancel();
  d->index.reset();
  d->isIndexAwaited = false;
  d->hover({});
  d->polylines.clear();
  d->brush.reset();
  d->brushLine.clear();
  setSurfaceValues(nullptr, {});
  d->live.reset();
  d->scene.clear();
  update();
}

void Viewport::setLoops(std::vector<LoopMark> loops) {
  d->scene.marks().setLoops(std::move(loops));
  update();
}

void Viewport::setFaceMarks(std::vector<FaceMark> marks) {
  d->scene.marks().setFaceMarks(std::move(marks));
  update();
}

void Viewport::setPointMarks(std::vector<PointMark> marks) {
  d->scene.marks().setPointMarks(std::move(marks));
  update();
}

void Viewport::setLineMarks(std::vector<LineMark> marks) {
  d->scene.marks().setLineMarks(std::move(marks));
  update();
}

void Viewport::setSection(std::vector<SectionMark> section) {
  d->scene.marks().setSection(std::move(section));
  update();
}

void Viewport::setPreview(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles) {
  d->scene.marks().setPreview(points, triangles);
  update();
}

void Viewport::setHighlightedLoop(int id) {
  if (id == d->listLoop) return;
  d->listLoop = id;
  d->highlight();
}

void Viewport::setShading(Shading shading) {
  d->shading = shading;
  d->scene.setShading(shading);
  update();
}

Shading Viewport::shading() const {
  return d->shading;
}

void Viewport::setDarkTheme(bool dark) {
  d->scene.setDark(dark);
  d->cube->setColours(d->scene.colours());
  update();
}

void Viewport::setStandardView(StandardView view) {
  d->fitFrom(orientationOf(view));
}

void Viewport::fit() {
  d->fitFrom(d->goal().orientation);
}

void Viewport::setCovered(int pixels) {
  const bool grows = pixels > d->covered;
  d->covered = pixels;
  if (grows && d->fitted == d->goal()) fit();
}

void Viewport::flyTo(const Box& box, const Vec3& outward) {
  if (box.isEmpty()) return;
  CameraState from = d->goal();
  from.orientation = turnedTowards(from.orientation, outward);
  CameraState goal = CameraNavigation(from, d->size()).fitted(cornersOf(box), kFlyToShare, d->covered);
  const Box whole = d->scene.bounds();
  if (!whole.isEmpty()) goal.height = std::max(goal.height, kNearestFlight * whole.diagonal().norm());
  d->flyTo(goal);
}

CameraState Viewport::camera() const {
  return d->goal();
}

void Viewport::setCamera(const CameraState& camera) {
  d->flight.stop();
  d->moveTo(camera);
}

Pick Viewport::pickAlong(const Vec3& origin, const Vec3& direction) const {
  return handwheel::pickAlong(d->pickable(), origin, direction);
}

Pick Viewport::pickAt(const QPointF& position) const {
  return d->pick({position.x(), position.y()});
}

bool Viewport::isPickingReady() const {
  return !d->isIndexAwaited && !d->scene.bounds().isEmpty() && d->scene.parts().missing().empty();
}

QString Viewport::graphicsProblem() const {
  return d->problem;
}

int Viewport::blocksBuilt() const {
  return d->scene.builtCount();
}

int Viewport::framesDrawn() const {
  return d->framesDrawn;
}

Spent Viewport::timeDrawing() const {
  return d->timeDrawing;
}

QSize Viewport::sizeHint() const {
  return {960, 640};
}

}  // namespace handwheel
