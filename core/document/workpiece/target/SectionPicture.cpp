// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/target/SectionPicture.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr int kSectionWidth = 1280, kSectionHeight = 960, kSectionMargin = 16;  // in pixels
constexpr double kOutlineWidth = 2.0;                                           // pixels
constexpr QColor kInBoth(0xba, 0xbd, 0xb6), kLeftOver(0x34, 0x65, 0xa4), kCutTooDeep(0xcc, 0x00, 0x00);

// The upper half of a part in (z, -r), a polygon for each of its pieces.
QPainterPath halfOf(const TurnedProfile& part) {
  QPainterPath path;
  for (std::size_t first = 0, last = 0; first < part.size(); first = last + 1) {
    last = first;
    QPolygonF piece;
    for (; last < part.size() && part.hasMaterial(last); ++last) piece.append({part.z(last), -part.radius(last)});
    for (std::size_t i = last; i-- > first;) piece.append({part.z(i), -part.inner(i)});
    if (last - first > 1) path.addPolygon(piece);
  }
  return path;
}

QPainterPath halfOf(std::span<const ProfilePoint> target) {
  QPolygonF outline;
  for (const ProfilePoint& p : target) outline.append({p.y(), -p.x()});
  QPainterPath path;
  path.addPolygon(outline);
  return path;
}

// Paints in the coordinates of the halves. The bar behind the target is neither left over nor in it.
void paintHalf(QPainter& painter, const QPainterPath& part, const QPainterPath& target) {
  if (target.isEmpty()) return painter.fillPath(part, kInBoth);
  painter.fillPath(target, kCutTooDeep);
  painter.fillPath(part, kLeftOver);
  painter.save();
  painter.setClipPath(target);
  painter.fillPath(part, kInBoth);
  QRectF behind = part.boundingRect();
  behind.setRight(std::max(behind.left(), target.boundingRect().left()));
  painter.setClipRect(behind);
  painter.fillPath(part, kInBoth);
  painter.restore();
  QPen pen(Qt::black, kOutlineWidth);
  pen.setCosmetic(true);
  painter.strokePath(target, pen);
}

}  // namespace

QImage sectionPicture(const TurnedProfile& part, std::span<const ProfilePoint> target) {
  const QPainterPath work = halfOf(part), wanted = halfOf(target);
  const QRectF box = work.boundingRect() | wanted.boundingRect();
  const double radius = std::max(-box.top(), 1e-3);  // mm
  const double scale = std::min((kSectionWidth - 2 * kSectionMargin) / std::max(box.width(), 1e-3),
                                (0.5 * kSectionHeight - kSectionMargin) / radius);
  const int half = kSectionMargin + static_cast<int>(std::ceil(scale * radius));
  QImage picture(kSectionWidth, 2 * half, QImage::Format_RGB32);
  picture.fill(Qt::white);
  QPainter painter(&picture);
  for (const double side : {1.0, -1.0}) {
    painter.setTransform(QTransform(scale, 0, 0, side * scale, 0.5 * kSectionWidth - scale * box.center().x(), half));
    paintHalf(painter, work, wanted);
  }
  painter.end();
  // A byte for each pixel: a class has many parts.
  return picture.convertToFormat(
      QImage::Format_Indexed8, {qRgb(255, 255, 255), kInBoth.rgb(), kLeftOver.rgb(), kCutTooDeep.rgb(), qRgb(0, 0, 0)});
}

std::vector<ProfilePoint> halfSectionOf(const TargetProfile& target) {
  constexpr int kOfArc = 32;
  std::vector<ProfilePoint> line{target.segments().front().from};
  for (const ProfileSegment& s : target.segments()) {
    const int pieces = s.isArc() ? kOfArc : 1;
    for (int k = 1; k <= pieces; ++k) line.push_back(s.at(static_cast<double>(k) / pieces));
  }
  return line;
}

QImage targetInBar(const StockCylinder& stock, const TargetProfile& target) {
  constexpr double kBarSamples = 500.0;  // samples of a bar, which only the picture uses
  return sectionPicture(TurnedProfile(stock, stock.length / kBarSamples), halfSectionOf(target.moved(-stock.position)));
}

}  // namespace handwheel
