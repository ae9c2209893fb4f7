// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/camera/CameraNavigation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace handwheel {

namespace {

constexpr double kRadiansPerPixel = std::numbers::pi / 500;  // a drag over 500 pixels turns the model half around
// Under perspective, shares of the eye's distance from the focus, and of the farthest drawn distance. Nearer objects
// are not drawn: the depth buffer has 24 bits for all between.
constexpr double kNearestSight = 1e-9;
constexpr double kNearestFocus = 0.05;
constexpr double kNearestShare = 1e-3;
constexpr double kStraightDown = 1e-6;  // a view less inclined than this is one from straight above or below

Eigen::Quaterniond looking(const Vec3& towardsViewer, const Vec3& up) {
  const Vec3 z = towardsViewer.normalized();
  const Vec3 x = up.cross(z).normalized();
  Eigen::Matrix3d axes;
  axes << x, z.cross(x), z;
  return Eigen::Quaterniond(axes);
}

// From straight above or below there is no horizon, and none is missed this near to it.
bool isAlong(const Vec3& outward, const Vec3& up) {
  constexpr double kNearlyAlong = 0.087;  // sine of 5 degrees
  return up.cross(outward).norm() < kNearlyAlong;
}

// Returns the unit vector to the right in a level view against outward, a unit vector. From above or below, it is the
// one nearest to another direction, which is not parallel to outward.
Vec3 levelRight(const Vec3& outward, const Vec3& up, const Vec3& nearest) {
  if (!isAlong(outward, up)) return up.cross(outward).normalized();
  return (nearest - nearest.dot(outward) * outward).normalized();
}

}  // namespace

CameraNavigation::CameraNavigation(const CameraState& camera, const Vec2& size)
    : m_camera(camera), m_size(size.cwiseMax(1.0)) {}

double CameraNavigation::unitsPerPixelAt(const Vec3& p) const {
  return isPerspective() ? unitsPerPixel() * (1.0 - depth(p) / m_camera.eyeDistance()) : unitsPerPixel();
}

bool CameraNavigation::isBeforeEye(const Vec3& p) const {
  return !isPerspective() || depth(p) < (1.0 - kNearestSight) * m_camera.eyeDistance();
}

Vec2 CameraNavigation::toScreen(const Vec3& p) const {
  const Vec3 v = m_camera.orientation.conjugate() * (p - m_camera.centre) / unitsPerPixelAt(p);
  return m_size / 2 + Vec2(v.x(), -v.y());
}

Vec3 CameraNavigation::fromScreen(const Vec2& s) const {
  const Vec2 v = (s - m_size / 2) * unitsPerPixel();
  return m_camera.centre + m_camera.orientation * Vec3(v.x(), -v.y(), 0);
}

ViewRay CameraNavigation::rayAt(const Vec2& s, const Box& box) const {
  const Vec3 atFocus = fromScreen(s), towards = m_camera.towardsViewer();
  if (isPerspective()) {
    const Vec3 eye = m_camera.eye();
    return {eye, (atFocus - eye).normalized(), eye, unitsPerPixel()};
  }
  const double front = box.isEmpty() ? 0.0 : depth(box.center()) + box.diagonal().norm();
  return {atFocus + front * towards, -towards, std::nullopt, unitsPerPixel()};
}

CameraClippingRange CameraNavigation::viewpoint(const Box& box) const {
  // The layers over the model are lifted by a few pixels towards the viewer.
  const double radius = (box.isEmpty() ? 1.0 : box.diagonal().norm()) + 0.1 * m_camera.height;
  const double middle = box.isEmpty() ? 0.0 : depth(box.center());
  const Vec3 towards = m_camera.towardsViewer();
  if (!isPerspective()) return {m_camera.centre + (middle + 2 * radius) * towards, radius, 3 * radius};
  const double focus = m_camera.eyeDistance();
  const double farthest = std::max(focus - middle + radius, focus);
  const double nearest = std::max(focus - middle - radius, std::min(kNearestShare * farthest, kNearestFocus * focus));
  return {m_camera.eye(), nearest, farthest};
}

CameraState CameraNavigation::orbited(const Vec3& pivot, const Vec2& delta) const {
  const double length = delta.norm();
  if (length == 0) return m_camera;
  // The camera turns against the drag, so that the model follows the cursor.
  const Vec3 axis = m_camera.orientation * Vec3(-delta.y() / length, -delta.x() / length, 0);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(length * kRadiansPerPixel, axis));
  return turnedAbout(m_camera, pivot, (turn * m_camera.orientation).normalized());
}

CameraState CameraNavigation::movedByHand(const Vec3& pivot, const Vec2& shift, const Vec3& turn) const {
  const double angle = turn.norm();
  CameraState c = m_camera;
  if (angle > 0) {
    const Eigen::Quaterniond back(Eigen::AngleAxisd(-angle, turn / angle));  // the camera turns against the model
    c = turnedAbout(m_camera, pivot, (m_camera.orientation * back).normalized());
  }
  c.centre -= c.height * (c.orientation * Vec3(shift.x(), shift.y(), 0));
  return c;
}

CameraState CameraNavigation::panned(const Vec2& delta, const Vec3& grabbed) const {
  CameraState c = m_camera;
  const Vec2 v = (isBeforeEye(grabbed) ? unitsPerPixelAt(grabbed) : unitsPerPixel()) * delta;
  c.centre += m_camera.orientation * Vec3(-v.x(), v.y(), 0);
  return c;
}

CameraState CameraNavigation::zoomedAbout(const Vec3& fixed, double factor) const {
  CameraState c = m_camera;
  c.height /= factor;
  c.centre = fixed + (c.centre - fixed) / factor;
  return c;
}

CameraState CameraNavigation::fitted(std::span<const Vec3> points, double share, double covered) const {
  if (points.empty()) return m_camera;
  const double free = std::max(m_size.y() - covered, m_size.y() / 2);  // pixels of height
  return isPerspective() ? fittedPerspective(points, share, free) : fittedParallel(points, share, free);
}

CameraState CameraNavigation::fittedParallel(std::span<const Vec3> points, double share, double free) const {
  Box inView;  // along the axes of the view
  for (const Vec3& p : points) inView.extend(m_camera.orientation.conjugate() * p);
  const Vec3 extent = inView.sizes();
  const double height = std::max(extent.y() * m_size.y() / free, extent.x() * m_size.y() / m_size.x()) / share;
  CameraState c = m_camera;
  // A single point has no extent; any magnification is as good then.
  c.height = height > 0 ? height : 1.0;
  c.centre = c.orientation * inView.center() - c.up() * (c.height * (m_size.y() - free) / 2 / m_size.y());
  return c;
}

// The eye comes as near as the four planes through it that bound the free part of the view allow: each of them is
// pushed by the point that lies farthest out along it, and two opposite planes meet where the eye must be.
CameraState CameraNavigation::fittedPerspective(std::span<const Vec3> points, double share, double free) const {
  const double edge = std::tan(kFieldOfView / 2.0);  // half of the view's height, at distance 1
  const double raised = edge * (1.0 - free / m_size.y());
  const Vec2 slope = Vec2(edge * m_size.x() / m_size.y(), edge - raised) * share;
  Vec2 most = Vec2::Constant(-std::numeric_limits<double>::infinity()), least = most;
  Box inView;
  for (const Vec3& p : points) {
    const Vec3 v = m_camera.orientation.conjugate() * (p - points[0]);
    const Vec2 level(v.x(), v.y() + raised * v.z());  // seen with the middle of the free part as that of the view
    most = most.cwiseMax(level + slope * v.z());
    least = least.cwiseMax(slope * v.z() - level);
    inView.extend(v);
  }
  const double depth = inView.sizes().z();
  const Vec2 needed = (most + least).cwiseQuotient(2.0 * slope);
  const double eye = std::max(needed.maxCoeff(), inView.max().z() + kNearestFocus * depth);
  const Vec2 level = (most - least) / 2.0;
  const double distance = eye - inView.center().z();
  CameraState c = m_camera;
  c.height = distance > 0 ? 2.0 * edge * distance : 1.0;
  c.centre = points[0];
  // A single point has no extent; any magnification is as good then.
  if (distance > 0) c.centre += c.orientation * Vec3(level.x(), level.y() - raised * eye, inView.center().z());
  return c;
}

std::array<Vec3, 8> cornersOf(const Box& box) {
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i) corners[i] = box.corner(static_cast<Box::CornerType>(i));
  return corners;
}

Eigen::Quaterniond orientationOf(StandardView view) {
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
  switch (view) {
    case StandardView::Front:
      return looking(-y, z);
    case StandardView::Back:
      return looking(y, z);
    case StandardView::Left:
      return looking(-x, z);
    case StandardView::Right:
      return looking(x, z);
    case StandardView::Top:
      return looking(z, y);
    case StandardView::Bottom:
      return looking(-z, -y);
    case StandardView::Lathe:
      return looking(x - 0.7 * y + 0.35 * z, (x - 0.7 * y).cross(z));  // makes the axis level
    case StandardView::Isometric:
      break;
  }
  return looking(x - y + z, z);
}

Eigen::Quaterniond latheFrame() {
  Eigen::Matrix3d frame;
  frame << Vec3::UnitZ(), -Vec3::UnitX(), -Vec3::UnitY();  // right, back and top
  return Eigen::Quaterniond(frame);
}

Eigen::Quaterniond uprightTowards(const Vec3& outward) {
  if (!(outward.squaredNorm() > 0) || !outward.allFinite()) return orientationOf(StandardView::Isometric);
  const Vec3 z = outward.normalized();
  if (z.head<2>().norm() > kStraightDown) return looking(z, Vec3::UnitZ());
  return looking(z, z.z() > 0 ? Vec3::UnitY() : Vec3(-Vec3::UnitY()));
}

Eigen::Quaterniond turnedTowards(const Eigen::Quaterniond& present, const Vec3& outward, const Vec3& up) {
  if (!(outward.squaredNorm() > 0) || !outward.allFinite()) return present;
  const Vec3 from = present * Vec3::UnitZ(), right = present * Vec3::UnitX();
  const Vec3 to = outward.normalized();
  const Vec3 level = levelRight(from, up, right);
  const double roll = isAlong(from, up) ? 0.0 : std::atan2(level.cross(right).dot(from), level.dot(right));
  const Vec3 x = Eigen::AngleAxisd(roll, to) * levelRight(to, up, level);
  Eigen::Matrix3d axes;
  axes << x, to.cross(x), to;
  return Eigen::Quaterniond(axes).normalized();
}

CameraState turnedAbout(const CameraState& camera, const Vec3& pivot, const Eigen::Quaterniond& orientation) {
  CameraState c = camera;
  c.orientation = orientation;
  c.centre = pivot + orientation * (camera.orientation.conjugate() * (camera.centre - pivot));
  return c;
}

CameraState between(const CameraState& a, const CameraState& b, double t) {
  if (t >= 1) return b;
  CameraState c = b;
  c.orientation = a.orientation.slerp(t, b.orientation).normalized();
  c.height = a.height * std::pow(b.height / a.height, t);
  // The centre moves in step with the magnification: then its speed on the screen is even.
  const double ratio = b.height / a.height;
  const double share = std::abs(ratio - 1) < 1e-6 ? t : (c.height / a.height - 1) / (ratio - 1);
  c.centre = a.centre + (b.centre - a.centre) * share;
  return c;
}

}  // namespace handwheel
