// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/ViewportPrivate.h"

#include <QMouseEvent>
#include <QPointingDevice>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kDragThreshold = 4.0;     // logical pixels; less is a click
constexpr double kZoomPerDegree = 1.0119;  // a notch of 15° magnifies by 1.19
constexpr double kZoomPerPixel = 1.006;    // by dragging: 115 pixels magnify by 2
constexpr double kNearestZoom = 1e-5;      // height of the view over the model's diagonal
constexpr double kFarthestZoom = 50.0;

Vec2 toVec2(const QPointF& p) {
  return {p.x(), p.y()};
}

bool isSame(const Pick& a, const Pick& b) {
  return a.layer == b.layer && (a.isNothing() || a.element == b.element);
}

Qt::CursorShape cursorOf(NavigationGesture gesture) {
  switch (gesture) {
    case NavigationGesture::Orbit:
      return Qt::ClosedHandCursor;
    case NavigationGesture::Pan:
      return Qt::SizeAllCursor;
    case NavigationGesture::Zoom:
      return Qt::SizeVerCursor;
    case NavigationGesture::None:
      break;
  }
  return Qt::ArrowCursor;
}

}  // namespace

Pick Viewport::Private::pick(const Vec2& cursor) const {
  return handwheel::pickAt(scene.pickable(), navigation(), cursor);
}

// The point under the cursor stays there. On the background: the point in the middle of the view, else the model's
// middle.
Vec3 Viewport::Private::orbitPivot(const Pick& underCursor) const {
  if (!underCursor.isNothing()) return underCursor.point;
  const Pick middle = pick(size() / 2);
  if (!middle.isNothing()) return middle.point;
  const Box box = scene.bounds();
  return box.isEmpty() ? camera.centre : Vec3(box.center());
}

bool Viewport::Private::offer(PointerInput::Kind kind, const QSinglePointEvent& event, double wheel) const {
  if (!sink) return false;
  const auto time =
      event.timestamp() > 0 ? std::optional(static_cast<double>(event.timestamp()) / 1000.0) : std::nullopt;
  using Pen = QPointingDevice::PointerType;
  const bool isPen = event.pointerType() == Pen::Pen || event.pointerType() == Pen::Eraser;
  return sink({kind, event.position(), event.button(), event.buttons(), event.modifiers(), wheel, time,
               isPen ? pressure : std::nullopt});
}

void Viewport::Private::press(const QMouseEvent& event) {
  isClick = !followed;
  if (isClick) {
    flight.stop();
    pressed = last = toVec2(event.position());
    const Pick under = pick(pressed);
    isOnBackground = under.isNothing();
    pivot = orbitPivot(under);
  }
  followed |= event.button();
  intended = gestureFor(preset, followed, event.modifiers(), isOnBackground);
  if (gesture != NavigationGesture::None) startGesture(intended);
}

void Viewport::Private::follow(const QMouseEvent& event) {
  const Vec2 cursor = toVec2(event.position());
  if (followed) return dragTo(cursor);
  const bool isTaken = offer(PointerInput::Kind::Move, event);
  if (isTaken || taken) return hover({});
  if (!flight.isUnderWay()) hover(pick(cursor));
}

void Viewport::Private::release(const QMouseEvent& event) {
  const Vec2 cursor = toVec2(event.position());
  followed &= ~Qt::MouseButtons(event.button());
  const bool wasClick = isClick && gesture == NavigationGesture::None;
  isClick = false;
  intended = gestureFor(preset, followed, event.modifiers(), isOnBackground);
  if (gesture != NavigationGesture::None) startGesture(intended);
  if (followed) return;
  const Pick under = pick(cursor);
  hover(under);
  if (!wasClick || (cursor - pressed).norm() >= kDragThreshold || offer(PointerInput::Kind::Click, event)) return;
  if (event.button() == Qt::LeftButton) emit q->clicked(under, event.modifiers());
}

void Viewport::Private::startGesture(NavigationGesture next) {
  gesture = next;
  next == NavigationGesture::None ? q->unsetCursor() : q->setCursor(cursorOf(next));
  q->update();  // at rest, in full detail
}

void Viewport::Private::dragTo(const Vec2& cursor) {
  if (gesture == NavigationGesture::None && (cursor - pressed).norm() >= kDragThreshold) {
    isClick = false;
    if (intended != NavigationGesture::None) {
      hover({});
      startGesture(intended);
    }
  }
  const Vec2 delta = cursor - last;
  last = cursor;
  if (gesture == NavigationGesture::Orbit) moveTo(navigation().orbited(pivot, delta));
  if (gesture == NavigationGesture::Pan) moveTo(navigation().panned(delta, pivot));
  if (gesture == NavigationGesture::Zoom) {
    zoomAbout(isOnBackground ? navigation().fromScreen(pressed) : pivot, std::pow(kZoomPerPixel, -delta.y()));
  }
}

void Viewport::Private::zoomAbout(const Vec3& fixed, double factor) {
  const Box box = scene.bounds();
  const double diagonal = box.isEmpty() ? 1.0 : box.diagonal().norm();
  const double height = camera.height;
  // The limits never pull back a camera that something else has placed beyond them.
  const double nearest = std::min(height, kNearestZoom * diagonal),
               farthest = std::max(height, kFarthestZoom * diagonal);
  const double goal = std::clamp(height / factor, nearest, farthest);
  moveTo(navigation().zoomedAbout(fixed, height / goal));
}

void Viewport::Private::hover(const Pick& pick) {
  const bool isNew = !isSame(pick, hovered);
  if (!isNew && pick.isNothing()) return;
  hovered = pick;
  if (isNew) {
    scene.setHovered(hovered);
    q->update();
    if (gesture == NavigationGesture::None) hovered.isNear ? q->setCursor(Qt::PointingHandCursor) : q->unsetCursor();
  }
  emit q->hovered(hovered);
}

void Viewport::setPointerSink(std::function<bool(const PointerInput&)> sink) {
  d->sink = std::move(sink);
  d->taken = {};
}

void Viewport::mousePressEvent(QMouseEvent* event) {
  if (d->offer(PointerInput::Kind::Press, *event)) {
    d->taken |= event->button();
  } else {
    d->press(*event);
  }
}

void Viewport::mouseMoveEvent(QMouseEvent* event) {
  d->follow(*event);
}

void Viewport::mouseReleaseEvent(QMouseEvent* event) {
  if (d->taken & event->button()) {
    d->taken &= ~Qt::MouseButtons(event->button());
    d->offer(PointerInput::Kind::Release, *event);
  } else if (d->followed & event->button()) {
    d->release(*event);
  }
}

void Viewport::mouseDoubleClickEvent(QMouseEvent* event) {
  if (d->offer(PointerInput::Kind::DoubleClick, *event)) {
    d->taken |= event->button();
  } else if (event->button() != Qt::LeftButton) {
    d->press(*event);  // the camera is often grabbed twice in a row
  } else {
    // Its release is not to count as a click again: the button is not followed.
    emit doubleClicked(d->pick(toVec2(event->position())));
  }
}

void Viewport::wheelEvent(QWheelEvent* event) {
  const double degrees = event->angleDelta().y() / 8.0;
  if (degrees == 0) return;
  event->accept();
  if (d->offer(PointerInput::Kind::Wheel, *event, degrees)) return;
  d->flight.stop();
  d->rest.start();
  const Vec2 cursor = toVec2(event->position());
  const Pick under = d->pick(cursor);
  const double enlarging = wheelAwayEnlarges(d->preset) ? degrees : -degrees;
  d->zoomAbout(under.isNothing() ? d->navigation().fromScreen(cursor) : under.point,
               std::pow(kZoomPerDegree, enlarging));
}

// An event that is not accepted comes once more as an event of the mouse, by the same pen.
void Viewport::tabletEvent(QTabletEvent* event) {
  const bool hasPressure = event->pointingDevice()->capabilities().testFlag(QInputDevice::Capability::Pressure);
  d->pressure = hasPressure ? std::optional(event->pressure()) : std::nullopt;
  event->ignore();
}

void Viewport::leaveEvent(QEvent* event) {
  QOpenGLWidget::leaveEvent(event);
  if (d->sink) d->sink({PointerInput::Kind::Leave, {}, Qt::NoButton, {}, {}, 0.0});
  d->hover({});
}

}  // namespace handwheel
