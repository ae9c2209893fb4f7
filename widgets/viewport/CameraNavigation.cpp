// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/CameraNavigation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace handwheel {

namespace {

constexpr double kRadiansPerPixel = std::numbers::pi / 500;  // a drag over 500 pixels turns the model half around

Eigen::Quaterniond looking(const Vec3& towardsViewer, const Vec3& up) {
  const Vec3 z = towardsViewer.normalized();
  const Vec3 x = up.cross(z).normalized();
  Eigen::Matrix3d axes;
  axes << x, z.cross(x), z;
  return Eigen::Quaterniond(axes);
}

}  // namespace

CameraNavigation::CameraNavigation(const CameraState& camera, const Vec2& size)
    : m_camera(camera), m_size(size.cwiseMax(1.0)) {}

Vec2 CameraNavigation::toScreen(const Vec3& p) const {
  const Vec3 v = m_camera.orientation.conjugate() * (p - m_camera.centre) / unitsPerPixel();
  return m_size / 2 + Vec2(v.x(), -v.y());
}

Vec3 CameraNavigation::fromScreen(const Vec2& s) const {
  const Vec2 v = (s - m_size / 2) * unitsPerPixel();
  return m_camera.centre + m_camera.orientation * Vec3(v.x(), -v.y(), 0);
}

CameraState CameraNavigation::orbited(const Vec3& pivot, const Vec2& delta) const {
  const double length = delta.norm();
  if (length == 0) return m_camera;
  // The camera turns against the drag, so that the model follows the cursor.
  const Vec3 axis = m_camera.orientation * Vec3(-delta.y() / length, -delta.x() / length, 0);
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(length * kRadiansPerPixel, axis));
  CameraState c = m_camera;
  c.orientation = (turn * c.orientation).normalized();
  c.centre = pivot + turn * (c.centre - pivot);
  return c;
}

CameraState CameraNavigation::panned(const Vec2& delta) const {
  CameraState c = m_camera;
  c.centre = fromScreen(m_size / 2 - delta);
  return c;
}

CameraState CameraNavigation::zoomedAt(const Vec2& cursor, double factor) const {
  CameraState c = m_camera;
  const Vec3 fixed = fromScreen(cursor);
  c.height /= factor;
  c.centre = fixed + (c.centre - fixed) / factor;
  return c;
}

CameraState CameraNavigation::fitted(std::span<const Vec3> points, double share, double covered) const {
  if (points.empty()) return m_camera;
  Box inView;  // along the axes of the view
  for (const Vec3& p : points) inView.extend(m_camera.orientation.conjugate() * p);
  const Vec3 extent = inView.sizes();
  const double free = std::max(m_size.y() - covered, m_size.y() / 2);  // pixels of height
  const double height = std::max(extent.y() * m_size.y() / free, extent.x() * m_size.y() / m_size.x()) / share;
  CameraState c = m_camera;
  // A single point has no extent; any magnification is as good then.
  c.height = height > 0 ? height : 1.0;
  c.centre = c.orientation * inView.center() - c.up() * (c.height * (m_size.y() - free) / 2 / m_size.y());
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
    case StandardView::Isometric:
      break;
  }
  return looking(x - y + z, z);
}

Eigen::Quaterniond turnedTowards(const Eigen::Quaterniond& present, const Vec3& outward) {
  if (!(outward.squaredNorm() > 0) || !outward.allFinite()) return present;
  const Vec3 from = present * Vec3::UnitZ();
  const Vec3 to = outward.normalized();
  // To the opposite side every way is equally short: turn about the upright of the screen.
  if (from.dot(to) < -0.9999) return Eigen::AngleAxisd(std::numbers::pi, present * Vec3::UnitY()) * present;
  return (Eigen::Quaterniond::FromTwoVectors(from, to) * present).normalized();
}

CameraState between(const CameraState& a, const CameraState& b, double t) {
  if (t >= 1) return b;
  CameraState c;
  c.orientation = a.orientation.slerp(t, b.orientation).normalized();
  c.height = a.height * std::pow(b.height / a.height, t);
  // The centre moves in step with the magnification: then its speed on the screen is even.
  const double ratio = b.height / a.height;
  const double share = std::abs(ratio - 1) < 1e-6 ? t : (c.height / a.height - 1) / (ratio - 1);
  c.centre = a.centre + (b.centre - a.centre) * share;
  return c;
}

}  // namespace handwheel
