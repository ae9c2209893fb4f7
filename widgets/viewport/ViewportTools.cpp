// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/BrushOutline.h"
#include "viewport/ViewportPrivate.h"

namespace handwheel {

namespace {

constexpr double kCubeTurn = 2.5;  // the cube is small: dragging it turns faster than dragging the model
// Pixels: a proxy that touches lies on the surface only within rounding.
constexpr double kLifted = 0.5;
constexpr double kHidden = 4.0;

}  // namespace

// A tool may set all that it shows with each move of the mouse: equal values cost no frame.

void Viewport::setPolylines(std::vector<std::vector<Vec3>> lines) {
  if (lines == d->polylines) return;
  d->polylines = std::move(lines);
  update();
}

void Viewport::setBrush(const std::optional<BrushCircle>& brush) {
  if (brush == d->brush) return;
  d->brush = brush;
  d->layBrush();
}

void Viewport::Private::layBrush() {
  if (!brush) {
    if (brushLine.empty()) return;
    brushLine.clear();
  } else {
    brushLine = brushOutline(scene.pickable(), *brush, camera.towardsViewer());
  }
  q->update();
}

void Viewport::setDeviceCursor(const std::optional<DeviceCursor>& cursor) {
  std::optional<DeviceCursor> cast = cursor;
  if (cast) d->cast(*cast);
  if (cast == d->deviceCursor) return;
  d->deviceCursor = cast;
  QOpenGLWidget::update();
}

// Both rays are found in microseconds.
void Viewport::Private::cast(DeviceCursor& shown) const {
  if (!shown.proxy.allFinite()) return;
  const Vec3 light = shadowDirection(camera);
  const Pick below = q->pickAlong(shown.proxy - kLifted * navigation().unitsPerPixelAt(shown.proxy) * light, light);
  if (!below.isNothing()) shown.shadow = below.point;
  if (!navigation().isBeforeEye(shown.proxy)) return;
  const ViewRay pickRay = navigation().rayAt(navigation().toScreen(shown.proxy), scene.bounds());
  const Pick before = q->pickAlong(pickRay.origin, pickRay.direction);
  const double slack = kHidden * navigation().unitsPerPixelAt(shown.proxy);
  shown.isHidden = !before.isNothing() && (shown.proxy - before.point).dot(pickRay.direction) > slack;
}

ViewRay Viewport::rayAt(const QPointF& position) const {
  return d->navigation().rayAt({position.x(), position.y()}, d->scene.bounds());
}

Box Viewport::bounds() const {
  return d->scene.bounds();
}

void Viewport::setClipPlane(const ClipPlane& plane) {
  if (plane == clipPlane()) return;
  d->scene.setClipPlane(plane);
  update();
  emit clipPlaneChanged();
}

const ClipPlane& Viewport::clipPlane() const {
  return d->scene.clipPlane();
}

void Viewport::setProjection(Projection projection) {
  CameraState camera = d->goal();
  camera.projection = projection;
  setCamera(camera);
}

void Viewport::setNavigationPreset(NavigationPreset preset) {
  d->preset = preset;
}

NavigationPreset Viewport::navigationPreset() const {
  return d->preset;
}

std::vector<std::pair<QString, QString>> Viewport::navigationHints() const {
  return handwheel::navigationHints(d->preset);
}

void Viewport::setDisplayUnit(LengthUnit unit) {
  d->unit = unit;
  update();
}

void Viewport::setViewCubeVisible(bool visible) {
  d->cube->setVisible(visible);
}

void Viewport::setOfPatient(bool isPatient) {
  d->cube->setPatient(isPatient);
}

void Viewport::Private::connectCube() {
  connect(cube, &ViewCube::chosen, q, [this](const CubeRegion& region) { lookFrom(region); });
  connect(cube, &ViewCube::stepped, q, [this](int around, int up) {
    lookFrom(steppedFrom(regionFacing(inViewFrame(goal().orientation)), around, up));
  });
  connect(cube, &ViewCube::entered, q, [this] { hover({}); });
  connect(cube, &ViewCube::dragStarted, q, [this] {
    flight.stop();
    pivot = orbitPivot({});
    gesture = NavigationGesture::Orbit;
  });
  connect(cube, &ViewCube::dragged, q, [this](const QPointF& delta) {
    moveTo(navigation().orbited(pivot, kCubeTurn * Vec2(delta.x(), delta.y())));
  });
  connect(cube, &ViewCube::dragEnded, q, [this] { startGesture(NavigationGesture::None); });
}

// The middle of the view stays there, in its size.
void Viewport::Private::lookFrom(const CubeRegion& region) {
  flyTo(turnedAbout(goal(), orbitPivot({}), viewFrame * uprightTowards(region.cast<double>())));
}

}  // namespace handwheel
