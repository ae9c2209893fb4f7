// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/ViewportPrivate.h"

#include <QMouseEvent>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kDragThreshold = 4.0;     // logical pixels; less is a click
constexpr double kZoomPerDegree = 1.0119;  // a notch of 15° magnifies by 1.19
constexpr double kNearestZoom = 1e-5;      // height of the view over the model's diagonal
constexpr double kFarthestZoom = 50.0;

Vec2 toVec2(const QPointF& p) {
  return {p.x(), p.y()};
}

bool isSame(const Pick& a, const Pick& b) {
  return a.loop == b.loop && a.face == b.face;
}

}  // namespace

Pick Viewport::Private::pick(const Vec2& cursor) const {
  return index ? handwheel::pickAt(*index, scene.loops(), navigation(), cursor) : Pick{};
}

// What is under the cursor stays there. On the background: what is in the middle of the view, else the model's middle.
Vec3 Viewport::Private::orbitPivot(const Pick& underCursor) const {
  if (!underCursor.isNothing()) return underCursor.point;
  const Pick middle = pick(size() / 2);
  if (!middle.isNothing()) return middle.point;
  return scene.bounds().isEmpty() ? camera.centre : Vec3(scene.bounds().center());
}

void Viewport::Private::press(const QMouseEvent& event) {
  if (button != Qt::NoButton) return;
  flight.stop();
  button = event.button();
  pressed = last = toVec2(event.position());
  const Pick under = pick(pressed);
  const bool turns = button == Qt::MiddleButton ||
                     (button == Qt::LeftButton && (under.isNothing() || (event.modifiers() & Qt::AltModifier)));
  const bool pans =
      button == Qt::RightButton || (button == Qt::MiddleButton && (event.modifiers() & Qt::ShiftModifier));
  intended = pans ? Drag::Pan : turns ? Drag::Orbit : Drag::None;
  if (intended == Drag::Orbit) pivot = orbitPivot(under);
}

void Viewport::Private::dragTo(const Vec2& cursor) {
  if (drag == Drag::None && intended != Drag::None && (cursor - pressed).norm() >= kDragThreshold) {
    drag = intended;
    hover({});
    q->setCursor(drag == Drag::Pan ? Qt::SizeAllCursor : Qt::ClosedHandCursor);
  }
  if (drag == Drag::Orbit) moveTo(navigation().orbited(pivot, cursor - last));
  if (drag == Drag::Pan) moveTo(navigation().panned(cursor - last));
  last = cursor;
}

void Viewport::Private::endDrag() {
  button = Qt::NoButton;
  intended = Drag::None;
  if (drag == Drag::None) return;
  drag = Drag::None;
  q->unsetCursor();
  q->update();  // in full detail
}

void Viewport::Private::hover(const Pick& pick) {
  const bool isNew = !isSame(pick, hovered);
  if (!isNew && pick.isNothing()) return;
  hovered = pick;
  if (isNew) {
    scene.marks().setHovered(listLoop, hovered.loop, hovered.face);
    if (drag == Drag::None) hovered.loop >= 0 ? q->setCursor(Qt::PointingHandCursor) : q->unsetCursor();
    q->update();
  }
  emit q->hovered(hovered);
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  d->press(*event);
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  const Vec2 cursor = toVec2(event->position());
  if (d->button != Qt::NoButton) return d->dragTo(cursor);
  if (!d->flight.isUnderWay()) d->hover(d->pick(cursor));
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != d->button) return;
  const Vec2 cursor = toVec2(event->position());
  const bool isClick = d->button == Qt::LeftButton && (cursor - d->pressed).norm() < kDragThreshold;
  const bool wasDragged = d->drag != Drag::None;
  d->endDrag();
  const Pick pick = d->pick(cursor);
  d->hover(pick);
  if (isClick && !wasDragged) emit clicked(pick, event->modifiers());
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  // Its release is not to count as a click again: no button is being followed.
  if (event->button() == Qt::LeftButton) emit doubleClicked(d->pick(toVec2(event->position())));
}

void Viewport::wheelEvent(QWheelEvent* event) {
  const double degrees = event->angleDelta().y() / 8.0;
  if (degrees == 0) return;
  d->flight.stop();
  const double diagonal = d->scene.bounds().isEmpty() ? 1.0 : d->scene.bounds().diagonal().norm();
  const double height = d->camera.height;
  // The limits never pull back a camera that something else has placed beyond them.
  const double nearest = std::min(height, kNearestZoom * diagonal),
               farthest = std::max(height, kFarthestZoom * diagonal);
  const double goal = std::clamp(height / std::pow(kZoomPerDegree, degrees), nearest, farthest);
  d->rest.start();
  d->moveTo(d->navigation().zoomedAt(toVec2(event->position()), height / goal));
  event->accept();
}

void Viewport::leaveEvent(QEvent* event) {
  QOpenGLWidget::leaveEvent(event);
  d->hover({});
}

}  // namespace handwheel
