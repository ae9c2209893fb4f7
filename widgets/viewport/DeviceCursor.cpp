// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/DeviceCursor.h"

#include <QRadialGradient>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr double kRadius = 8.0;        // logical pixels, at the focus
constexpr double kArrowLength = 72.0;  // pixels at the limit of the force
constexpr double kLeastForce = 1e-3;   // share of the limit; less is no arrow
constexpr double kLeastSize = 0.6, kLargestSize = 1.8;
constexpr double kHeadLength = 10.0, kHeadWidth = 5.0;
constexpr double kGaugeGap = 5.0;  // pixels between ball and gauge
constexpr double kHiddenOpacity = 0.4;

// Returns the size of the cursor. Under parallel projection nothing grows as it comes nearer; the cursor does, as depth
// could not be seen otherwise.
double sizeAt(const Vec3& p, const CameraNavigation& view) {
  const double size = view.isPerspective() ? view.unitsPerPixel() / view.unitsPerPixelAt(p)
                                           : 1.0 + 0.8 * view.depth(p) / view.camera().height;
  return std::isfinite(size) ? std::clamp(size, kLeastSize, kLargestSize) : 1.0;
}

std::optional<Vec2> projected(const Vec3& p, const CameraNavigation& view) {
  if (!p.allFinite() || !view.isBeforeEye(p)) return std::nullopt;
  const Vec2 at = view.toScreen(p);
  return at.cwiseAbs().maxCoeff() < 1e5 ? std::optional(at) : std::nullopt;
}

QPointF pointOf(const Vec2& p) {
  return {p.x(), p.y()};
}

// Returns a colour from calm to the limit: blue over yellow to vermilion, which colour-blind people can distinguish,
// too (Okabe and Ito).
QColor colourOf(double load) {
  const QColor calm(0x00, 0x72, 0xb2), middle(0xe6, 0x9f, 0x00), limit(0xd5, 0x5e, 0x00);
  return load < 0.5 ? mixed(calm, middle, static_cast<float>(2.0 * load))
                    : mixed(middle, limit, static_cast<float>(2.0 * load - 1.0));
}

void paintShadow(QPainter& painter, const CursorLook& look) {
  if (!look.shadow) return;
  const QPointF at = pointOf(*look.shadow);
  painter.setPen(QPen(QColor(0, 0, 0, 90), 1.0, Qt::DotLine));
  if (look.proxy) painter.drawLine(pointOf(*look.proxy), at);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0, 0, 0, 110));
  painter.drawEllipse(at, look.shadowRadius, 0.5 * look.shadowRadius);
}

void paintArrow(QPainter& painter, const CursorLook& look, const SceneColours& colours) {
  if (!look.arrow || !look.proxy) return;
  const Vec2 shaft = *look.arrow - *look.proxy;
  const double length = shaft.norm();
  if (length < 1.0) return;  // its end points to the viewer
  const Vec2 along = shaft / length, across(-along.y(), along.x());
  const double head = std::min(kHeadLength, length);
  const Vec2 neck = *look.arrow - head * along;
  const double half = kHeadWidth * head / kHeadLength;
  const QPolygonF tip{pointOf(*look.arrow), pointOf(neck + half * across), pointOf(neck - half * across)};
  for (const bool isRim : {true, false}) {
    const QColor colour = isRim ? colours.casing : colourOf(look.load);
    painter.setPen(QPen(colour, isRim ? 6.0 : 3.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawLine(pointOf(*look.proxy), pointOf(neck));
    painter.setBrush(colour);
    painter.setPen(QPen(colour, isRim ? 3.0 : 0.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolygon(tip);
  }
}

// Draws the share of the limit once more, as a ring that closes: an arrow towards the viewer, for a push straight into
// the model, is not visible.
void paintGauge(QPainter& painter, const CursorLook& look, const SceneColours& colours) {
  if (!look.proxy || look.load <= 0.0) return;
  const double radius = look.radius + kGaugeGap;
  const QRectF box(pointOf(*look.proxy) - QPointF(radius, radius), QSizeF(2.0 * radius, 2.0 * radius));
  constexpr int kTurn = 360 * 16, kTop = 90 * 16;  // Qt's sixteenths of a degree
  painter.setBrush(Qt::NoBrush);
  for (const bool isRim : {true, false}) {
    const QColor colour = isRim ? colours.casing : colourOf(look.load);
    painter.setPen(QPen(colour, isRim ? 5.0 : 3.0, Qt::SolidLine, Qt::FlatCap));
    painter.drawArc(box, kTop, -static_cast<int>(kTurn * look.load));
  }
}

// Draws a tip that was pushed through the surface: a ring, tied to the proxy.
void paintTip(QPainter& painter, const CursorLook& look, const SceneColours& colours) {
  if (!look.tip || !look.isApart) return;
  painter.setBrush(Qt::NoBrush);
  for (const bool isRim : {true, false}) {
    painter.setPen(QPen(isRim ? colours.casing : colours.accent, isRim ? 3.5 : 1.5));
    if (look.proxy) painter.drawLine(pointOf(*look.proxy), pointOf(*look.tip));
    painter.drawEllipse(pointOf(*look.tip), 0.8 * look.radius, 0.8 * look.radius);
  }
}

void paintProxy(QPainter& painter, const CursorLook& look, const SceneColours& colours) {
  if (!look.proxy) return;
  const QPointF at = pointOf(*look.proxy);
  QRadialGradient ball(at - QPointF(0.35, 0.4) * look.radius, 1.5 * look.radius);
  ball.setColorAt(0.0, mixed(colours.accent, Qt::white, 0.75f));
  ball.setColorAt(1.0, colours.accent);
  painter.setPen(QPen(colours.casing, 1.5));
  painter.setBrush(ball);
  painter.drawEllipse(at, look.radius, look.radius);
}

}  // namespace

Vec3 shadowDirection(const CameraState& camera) {
  return (-camera.towardsViewer() - camera.up()).normalized();
}

CursorLook lookOf(const DeviceCursor& cursor, const CameraNavigation& view) {
  CursorLook look;
  look.proxy = projected(cursor.proxy, view);
  look.tip = projected(cursor.tip, view);
  look.radius = kRadius * sizeAt(cursor.proxy, view);
  look.isApart = look.proxy && look.tip && (*look.proxy - *look.tip).norm() > 1.0;
  if (cursor.shadow) {
    look.shadow = projected(*cursor.shadow, view);
    look.shadowRadius = kRadius * sizeAt(*cursor.shadow, view);
  }
  const double force = cursor.force.stableNorm();
  if (!std::isfinite(force) || !(cursor.limit > 0.0) || !(force > kLeastForce * cursor.limit)) return look;
  look.load = std::min(1.0, force / cursor.limit);
  const double length = kArrowLength * look.load * view.unitsPerPixel();
  look.arrow = projected(cursor.proxy + (length / force) * cursor.force, view);
  return look;
}

void paintCursor(QPainter& painter, const DeviceCursor& cursor, const CameraNavigation& view,
                 const SceneColours& colours) {
  const CursorLook look = lookOf(cursor, view);
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  paintShadow(painter, look);
  if (cursor.isHidden) painter.setOpacity(kHiddenOpacity);
  paintTip(painter, look, colours);
  paintProxy(painter, look, colours);
  painter.setOpacity(1.0);
  paintGauge(painter, look, colours);
  paintArrow(painter, look, colours);
  painter.restore();
}

}  // namespace handwheel
