// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/volume/exercise/DrilledHolePicture.h"

#include "volume/VolumeSampler.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace handwheel {
namespace {

constexpr int kHoleWidth = 960, kHoleHeight = 720;                         // pixels
constexpr double kPlannedWidth = 5.0, kDashWidth = 2.0, kPathWidth = 3.0;  // pixels
constexpr double kLeastDeviation = 1e-3;                                   // mm; what is less has no direction

// A plane through the planned line, in mm: x across it, y along it from the entry.
struct HoleSection {
  Vec3 origin, across, along;

  QPointF at(const Vec3& p) const { return {(p - origin).dot(across), (p - origin).dot(along)}; }
  Vec3 pointAt(double x, double y) const { return origin + x * across + y * along; }
};

// The position of the head in a cycle: its centre, and its foremost point. A saw moves across its axis: its centre is
// used for both.
struct HeadPosition {
  HeadPosition(const DrillBit& tool, const DrillPose& pose)
      : centre(pose.position()),
        tip(tool.shape == DrillShape::Saw ? centre : Vec3(centre - tool.reach() * pose.direction())) {}
  Vec3 centre, tip;
};

// Calls visit(index of the hole, moment, position of the head) for each cycle.
template <class Visit>
void forEachPosition(const DrilledHoles& holes, const DrillReview& review, const Visit& visit) {
  std::size_t moment = 0;
  for (std::size_t hole = 0; hole < holes.size(); ++hole)
    for (std::size_t i = 0; i < holes[hole]->poses.size() && moment < review.moments.size(); ++i, ++moment)
      visit(hole, review.moments[moment], HeadPosition(holes[hole]->setup.tool, holes[hole]->poses[i]));
}

HoleSection sectionOf(const DrillingTask& task, const DrilledHoles& holes, const DrillReview& review) {
  const DrillPlan& plan = task.plan;
  Vec3 furthest = Vec3::Zero();
  forEachPosition(holes, review, [&](std::size_t, const DrillMoment& moment, const HeadPosition& head) {
    if (!moment.isCutting) return;
    for (const Vec3& p : {head.centre, head.tip}) {
      const Vec3 from = p - plan.entry, beside = from - from.dot(plan.direction) * plan.direction;
      if (beside.squaredNorm() > furthest.squaredNorm()) furthest = beside;
    }
  });
  const bool hasSide = furthest.norm() > kLeastDeviation;
  return {plan.entry, hasSide ? Vec3(furthest.normalized()) : plan.direction.unitOrthogonal(), plan.direction};
}

// Returns the area of the picture, in mm of the section: all positions of the head where it removed material, and some
// material around them, in the aspect ratio of the picture.
QRectF shownOf(const DrillingTask& task, const HoleSection& section, const DrilledHoles& holes,
               const DrillReview& review) {
  const double r = task.tool.radius(), margin = task.tool.diameter;
  QRectF box(-r, -2.0 * r, 2.0 * r, 6.0 * r);
  forEachPosition(holes, review, [&](std::size_t, const DrillMoment& moment, const HeadPosition& head) {
    if (!moment.isCutting) return;
    for (const Vec3& p : {head.centre, head.tip}) {
      const QPointF at = section.at(p);
      box |= QRectF(at.x() - r, at.y() - r, 2.0 * r, 2.0 * r);
    }
  });
  box.adjust(-margin, -margin, margin, margin);
  const double wider = 0.5 * std::max(box.height() * kHoleWidth / kHoleHeight - box.width(), 0.0);
  box.adjust(-wider, 0.0, wider, 0.0);
  const double higher = 0.5 * std::max(box.width() * kHoleHeight / kHoleWidth - box.height(), 0.0);
  return box.adjusted(0.0, -higher, 0.0, higher);
}

// The forbidden balls, cut by the section.
struct HoleCircle {
  QPointF centre;
  double squaredRadius;

  bool contains(double x, double y) const {
    return std::pow(x - centre.x(), 2) + std::pow(y - centre.y(), 2) < squaredRadius;
  }
};

std::vector<HoleCircle> circlesOf(const DrillPlan& plan, const HoleSection& section) {
  const Vec3 normal = section.across.cross(section.along);
  std::vector<HoleCircle> circles;
  for (const SolidBall& ball : plan.forbidden) {
    const double beside = (ball.centre - section.origin).dot(normal);
    const double squared = ball.radius * ball.radius - beside * beside;
    if (squared > 0.0) circles.push_back({section.at(ball.centre), squared});
  }
  return circles;
}

// False: cancelled.
bool paintMaterial(QImage& picture, const DrillingTask& task, const HoleSection& section, const QRectF& shown,
                   const DrillReview& review, Progress progress) {
  const VolumeSampler before(task.volume()), after(review.left);
  const std::vector<HoleCircle> circles = circlesOf(task.plan, section);
  const double planned = task.tool.radius() + task.plan.tolerance, pixel = shown.width() / kHoleWidth;
  for (int row = 0; row < kHoleHeight; ++row) {
    if (progress.cancelled()) return false;
    progress.set(static_cast<double>(row) / kHoleHeight);
    auto* const line = reinterpret_cast<QRgb*>(picture.scanLine(row));
    const double y = shown.top() + (row + 0.5) * pixel;
    for (int column = 0; column < kHoleWidth; ++column) {
      const double x = shown.left() + (column + 0.5) * pixel;
      const Vec3 p = section.pointAt(x, y);
      const bool isForbidden =
          std::any_of(circles.begin(), circles.end(), [&](const HoleCircle& c) { return c.contains(x, y); });
      if (after.depthAt(p).depth > 0.0)
        line[column] = isForbidden ? HoleColours::kLeftForbidden : HoleColours::kLeft;
      else if (before.depthAt(p).depth > 0.0)
        line[column] = isForbidden || std::abs(x) > planned ? HoleColours::kBeside : HoleColours::kDrilled;
      else
        line[column] = isForbidden ? HoleColours::kForbidden : HoleColours::kAir;
    }
  }
  return true;
}

QPen linePen(QRgb colour, double width, Qt::PenStyle style = Qt::SolidLine) {
  QPen pen(QColor(colour), width, style, Qt::FlatCap);
  pen.setCosmetic(true);
  return pen;
}

// In the coordinates of the section.
void paintPlan(QPainter& painter, const DrillPlan& plan, const QRectF& shown) {
  painter.setPen(linePen(HoleColours::kPlanned, kPlannedWidth));
  painter.drawLine(QPointF(0.0, shown.top()), QPointF(0.0, shown.bottom()));
  painter.setPen(linePen(HoleColours::kPlanned, kDashWidth, Qt::DashLine));
  for (const double x : {-plan.tolerance, plan.tolerance})
    if (x > shown.left() && x < shown.right()) painter.drawLine(QPointF(x, shown.top()), QPointF(x, shown.bottom()));
}

// Returns the path of the tip in each hole, from the first to the last position at which material was removed. Parts
// far outside the picture are left out.
std::vector<QPolygonF> pathsOf(const HoleSection& section, const QRectF& shown, const DrilledHoles& holes,
                               const DrillReview& review) {
  constexpr std::size_t kMostPoints = 4'000;
  const std::size_t step = review.moments.size() / kMostPoints + 1;
  const QRectF reach = shown.adjusted(-shown.width(), -shown.height(), shown.width(), shown.height());
  std::vector<QPolygonF> paths;
  std::optional<std::size_t> current;
  QPolygonF path, uncertain;  // uncertain: not confirmed by a later removal
  std::size_t count = 0;
  const auto end = [&] {
    if (path.size() > 1) paths.push_back(path);
    path.clear();
    uncertain.clear();
  };
  forEachPosition(holes, review, [&](std::size_t hole, const DrillMoment& moment, const HeadPosition& head) {
    if (current != hole) end();
    current = hole;
    const QPointF at = section.at(head.tip);
    if (!reach.contains(at)) return end();
    if (path.isEmpty() && !moment.isCutting) return;
    if (count++ % step == 0 || path.isEmpty()) uncertain.append(at);
    if (!moment.isCutting) return;
    path += uncertain;
    uncertain.clear();
  });
  end();
  return paths;
}

}  // namespace

QImage holePicture(const DrillingTask& task, const DrilledHoles& holes, const DrillReview& review, Progress progress) {
  const HoleSection section = sectionOf(task, holes, review);
  const QRectF shown = shownOf(task, section, holes, review);
  QImage picture(kHoleWidth, kHoleHeight, QImage::Format_RGB32);
  if (!paintMaterial(picture, task, section, shown, review, progress)) return {};
  QPainter painter(&picture);
  const double scale = kHoleWidth / shown.width();
  painter.setTransform(QTransform(scale, 0, 0, scale, -scale * shown.left(), -scale * shown.top()));
  paintPlan(painter, task.plan, shown);
  painter.setPen(linePen(HoleColours::kPath, kPathWidth));
  for (const QPolygonF& path : pathsOf(section, shown, holes, review)) painter.drawPolyline(path);
  painter.end();
  // A byte for each pixel: a class has many holes.
  return picture.convertToFormat(
      QImage::Format_Indexed8,
      {HoleColours::kAir, HoleColours::kLeft, HoleColours::kDrilled, HoleColours::kBeside, HoleColours::kForbidden,
       HoleColours::kLeftForbidden, HoleColours::kPlanned, HoleColours::kPath});
}

}  // namespace handwheel
