// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/CameraState.h"
#include "viewport/ViewportTypes.h"

#include <span>

namespace handwheel {

using Vec2 = Eigen::Vector2d;

// Where a renderer places its camera, and between which distances from there it must draw.
struct Viewpoint {
  Vec3 position;
  double nearest;
  double farthest;
};

// Where things of the model appear in the view, and how gestures move the camera. Plain values, nothing is drawn.
// Positions on the screen are in logical pixels from the upper left corner, y down.
class CameraNavigation {
 public:
  // size: width and height of the view in logical pixels; less than one pixel counts as one.
  CameraNavigation(const CameraState& camera, const Vec2& size);

  const CameraState& camera() const { return m_camera; }
  bool isPerspective() const { return m_camera.projection == Projection::Perspective; }
  // Model units (mm) to a pixel: at the focus, and where p is.
  double unitsPerPixel() const { return m_camera.height / m_size.y(); }
  double unitsPerPixelAt(const Vec3& p) const;

  // False for what is beside or behind the eye, and so nowhere on the screen.
  bool isBeforeEye(const Vec3& p) const;
  // p must be before the eye.
  Vec2 toScreen(const Vec3& p) const;
  // How far p lies before the plane through the focus, towards the viewer.
  double depth(const Vec3& p) const { return (p - m_camera.centre).dot(m_camera.towardsViewer()); }
  // The point of the plane through the focus that appears at s.
  Vec3 fromScreen(const Vec2& s) const;
  // The line of sight at s. Begins at the eye; under parallel projection before the box.
  ViewRay rayAt(const Vec2& s, const Box& box) const;
  // So that everything within radius of the middle of the box is drawn, unless it is very close to the eye.
  Viewpoint viewpoint(const Box& box) const;

  // Turns about the axes of the screen through pivot, which stays where it appears.
  CameraState orbited(const Vec3& pivot, const Vec2& delta) const;
  // What appears where the point grabbed does moves by delta.
  CameraState panned(const Vec2& delta, const Vec3& grabbed) const;
  CameraState panned(const Vec2& delta) const { return panned(delta, m_camera.centre); }
  // factor > 1 enlarges, and takes the eye nearer; the point stays where it appears.
  CameraState zoomedAbout(const Vec3& fixed, double factor) const;
  CameraState zoomedAt(const Vec2& cursor, double factor) const { return zoomedAbout(fromScreen(cursor), factor); }
  // All points in view, as large as can be. share: the part of the view that they fill, 0…1. covered: pixels at the
  // lower edge that are to stay free, at most half of the view.
  CameraState fitted(std::span<const Vec3> points, double share, double covered = 0.0) const;

 private:
  CameraState fittedParallel(std::span<const Vec3> points, double share, double free) const;
  CameraState fittedPerspective(std::span<const Vec3> points, double share, double free) const;

  CameraState m_camera;
  Vec2 m_size;
};

std::array<Vec3, 8> cornersOf(const Box& box);
Eigen::Quaterniond orientationOf(StandardView view);
// The upright view against outward: z up, and from straight above or below as StandardView has it. outward need not be
// of unit length; zero, or what is not finite, gives the isometric view.
Eigen::Quaterniond uprightTowards(const Vec3& outward);
// The orientation that looks against outward, by the shortest turn from the present one.
Eigen::Quaterniond turnedTowards(const Eigen::Quaterniond& present, const Vec3& outward);
// Turned into this orientation about pivot, which stays where it appears.
CameraState turnedAbout(const CameraState& camera, const Vec3& pivot, const Eigen::Quaterniond& orientation);
// On the way from a (t = 0) to b (t = 1).
CameraState between(const CameraState& a, const CameraState& b, double t);

}  // namespace handwheel
