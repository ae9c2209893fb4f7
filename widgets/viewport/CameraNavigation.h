// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/CameraState.h"
#include "viewport/ViewportTypes.h"

#include <span>

namespace handwheel {

using Vec2 = Eigen::Vector2d;

// Where things of the model appear in the view, and how gestures move the camera. Plain values, nothing is drawn.
// Positions on the screen are in logical pixels from the upper left corner, y down.
class CameraNavigation {
 public:
  // size: width and height of the view in logical pixels; less than one pixel counts as one.
  CameraNavigation(const CameraState& camera, const Vec2& size);

  const CameraState& camera() const { return m_camera; }
  double unitsPerPixel() const { return m_camera.height / m_size.y(); }

  Vec2 toScreen(const Vec3& p) const;
  // How far p lies before the centre of the view, towards the viewer.
  double depth(const Vec3& p) const { return (p - m_camera.centre).dot(m_camera.towardsViewer()); }
  // The point of the plane through the centre of the view that appears at s.
  Vec3 fromScreen(const Vec2& s) const;

  // Turns about the axes of the screen through pivot, which stays where it appears.
  CameraState orbited(const Vec3& pivot, const Vec2& delta) const;
  CameraState panned(const Vec2& delta) const;
  // factor > 1 enlarges; what appears at cursor stays there.
  CameraState zoomedAt(const Vec2& cursor, double factor) const;
  // All points in view, as large as can be. share: the part of the view that they fill, 0…1. covered: pixels at the
  // lower edge that are to stay free, at most half of the view.
  CameraState fitted(std::span<const Vec3> points, double share, double covered = 0.0) const;

 private:
  CameraState m_camera;
  Vec2 m_size;
};

std::array<Vec3, 8> cornersOf(const Box& box);
Eigen::Quaterniond orientationOf(StandardView view);
// The orientation that looks against outward, by the shortest turn from the present one.
Eigen::Quaterniond turnedTowards(const Eigen::Quaterniond& present, const Vec3& outward);
// On the way from a (t = 0) to b (t = 1).
CameraState between(const CameraState& a, const CameraState& b, double t);

}  // namespace handwheel
