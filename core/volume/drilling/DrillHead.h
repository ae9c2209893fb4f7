// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/drilling/DrillBit.h"

#include <cmath>

namespace handwheel {

// The shape of a drill, for evaluation at many points. Sines and radii are computed once.
class DrillHead {
 public:
  explicit DrillHead(const DrillBit& tool)
      : m_shape(tool.shape),
        m_isBall(tool.shape == DrillShape::Ball || tool.shape == DrillShape::Burr),
        m_radius(tool.radius()),
        m_reach(tool.reach()),
        m_length(tool.length),
        m_halfWidth(0.5 * tool.width),
        m_sine(std::sin(0.5 * tool.pointAngle)),
        m_cosine(std::cos(0.5 * tool.pointAngle)) {}

  bool isBall() const { return m_isBall; }

  // Returns the depth of a point inside the head, in the unit of the tool. Outside, the result is negative and its
  // magnitude is at most the distance. from: the vector from the centre to the point; axis: unit vector towards the
  // shank.
  double inside(const Vec3& from, const Vec3& axis) const { return row<1>(from, axis, 0.0, 0.0)[0]; }

  // Returns upper bounds of inside() at Count points, each one unit further along x, for a head that moves by at most
  // `across` its axis and `along` it.
  template <int Count>
  Eigen::Array<double, Count, 1> row(const Vec3& from, const Vec3& axis, double across, double along) const {
    using Row = Eigen::Array<double, Count, 1>;
    const double y = from.y(), z = from.z();
    Row x;
    for (int i = 0; i < Count; ++i) x[i] = from.x() + i;
    if (m_isBall) return m_radius + (across + along) - (x * x + (y * y + z * z)).sqrt();
    const Row up = x * axis.x() + (y * axis.y() + z * axis.z());
    const Row offX = x - up * axis.x(), offY = y - up * axis.y(), offZ = z - up * axis.z();
    const Row off = (offX * offX + (offY * offY + offZ * offZ)).sqrt() - across;
    if (m_shape == DrillShape::Saw) return (m_radius - off).min(m_halfWidth - up.abs() + along);
    const Row cone = (up + (m_reach + along)) * m_sine - off * m_cosine;
    return (m_radius - off).min(cone).min(m_length - up + along);
  }

 private:
  DrillShape m_shape;
  bool m_isBall;
  double m_radius, m_reach, m_length, m_halfWidth;
  double m_sine, m_cosine;  // sine and cosine of half the point angle
};

}  // namespace handwheel
