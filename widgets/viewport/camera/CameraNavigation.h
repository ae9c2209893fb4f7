// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "viewport/ViewportTypes.h"
#include "viewport/camera/CameraState.h"

#include <span>

namespace handwheel {

using Vec2 = Eigen::Vector2d;

// The position of a renderer's camera, with the distances of its near and far planes.
struct CameraClippingRange {
  Vec3 position;
  double nearest;
  double farthest;
};

// Projects points to the view and computes the camera moves of gestures. It only computes, and draws nothing. Positions
// on the screen are in logical pixels from the upper left corner, with y downwards.
class CameraNavigation {
 public:
  // size: the width and height of the view in logical pixels. Values below one pixel count as one pixel.
  CameraNavigation(const CameraState& camera, const Vec2& size);

  const CameraState& camera() const { return m_camera; }
  bool isPerspective() const { return m_camera.projection == Projection::Perspective; }
  // Return the number of model units (mm) per pixel at the focus and at p.
  double unitsPerPixel() const { return m_camera.height / m_size.y(); }
  double unitsPerPixelAt(const Vec3& p) const;

  // Returns false for points beside or behind the eye, which are not on the screen.
  bool isBeforeEye(const Vec3& p) const;
  // Projects a point, which must be in front of the eye.
  Vec2 toScreen(const Vec3& p) const;
  // Returns the distance of p from the plane through the focus, positive towards the viewer.
  double depth(const Vec3& p) const { return (p - m_camera.centre).dot(m_camera.towardsViewer()); }
  // Returns the point of the plane through the focus that appears at s.
  Vec3 fromScreen(const Vec2& s) const;
  // Returns the pick ray through s. The ray starts at the eye, or under parallel projection in front of the box.
  ViewRay rayAt(const Vec2& s, const Box& box) const;
  // Returns a camera whose clipping range contains the bounding sphere of the box, except for parts very close to the
  // eye or behind it.
  CameraClippingRange viewpoint(const Box& box) const;

  // Rotates about the screen axes through pivot, which keeps its screen position.
  CameraState orbited(const Vec3& pivot, const Vec2& delta) const;
  // Moves the camera so that the model turns by the rotation vector `turn` about pivot, which keeps its screen
  // position, and then moves by `shift` on the screen. Vectors are in the axes of the view (x right, y up, z towards
  // the viewer). shift: in units of the height of the view.
  CameraState movedByHand(const Vec3& pivot, const Vec2& shift, const Vec3& turn) const;
  // Moves the camera so that the grabbed point moves by delta on the screen.
  CameraState panned(const Vec2& delta, const Vec3& grabbed) const;
  CameraState panned(const Vec2& delta) const { return panned(delta, m_camera.centre); }
  // Zooms about a point, which keeps its screen position. factor > 1 enlarges, and moves the eye nearer.
  CameraState zoomedAbout(const Vec3& fixed, double factor) const;
  CameraState zoomedAt(const Vec2& cursor, double factor) const { return zoomedAbout(fromScreen(cursor), factor); }
  // Fits all points into the view, as large as possible. share: the fraction of the view that they fill, 0…1. covered:
  // the number of pixels at the lower edge to keep free, at most half of the view.
  CameraState fitted(std::span<const Vec3> points, double share, double covered = 0.0) const;

 private:
  CameraState fittedParallel(std::span<const Vec3> points, double share, double free) const;
  CameraState fittedPerspective(std::span<const Vec3> points, double share, double free) const;

  CameraState m_camera;
  Vec2 m_size;
};

// Returns the corners of a box.
std::array<Vec3, 8> cornersOf(const Box& box);
// Returns the orientation of a standard view.
Eigen::Quaterniond orientationOf(StandardView view);
// Returns the rotation from the standard sides to the sides of a lathe, as its operator sees them. Right is along the
// axis z, away from the chuck; the front is the side of the tool, along x; the top is along -y.
Eigen::Quaterniond latheFrame();
// Returns the orientation that looks against outward, with z up. From straight above or below, it is the orientation of
// the standard view. outward: not necessarily of unit length; zero, or a vector that is not finite, gives the isometric
// view.
Eigen::Quaterniond uprightTowards(const Vec3& outward);
// Returns the orientation that looks against outward, with the horizon as in the present one: level if it is level,
// and rolled as much if the user has rolled it. From above or below, where there is no horizon, the right side of the
// present view stays at the right. up: unit vector to the top of the standard views. outward: as for uprightTowards(),
// but zero gives the present orientation.
Eigen::Quaterniond turnedTowards(const Eigen::Quaterniond& present, const Vec3& outward, const Vec3& up);
// Rotates the camera to an orientation about pivot, which keeps its screen position.
CameraState turnedAbout(const CameraState& camera, const Vec3& pivot, const Eigen::Quaterniond& orientation);
// Interpolates between the cameras a (t = 0) and b (t = 1).
CameraState between(const CameraState& a, const CameraState& b, double t);

}  // namespace handwheel
