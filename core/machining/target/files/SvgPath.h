// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Progress.h"
#include "base/Result.h"
#include "machining/target/ProfileSegment.h"

#include <Eigen/Geometry>
#include <string_view>
#include <vector>

namespace handwheel {

// Collects the curves of an SVG drawing in mm. They are transformed from user coordinates.
class SvgCurves {
 public:
  explicit SvgCurves(const Eigen::Affine2d& toMillimetres) : m_to(toMillimetres) {}

  SvgCurves under(const Eigen::Affine2d& inner) const { return SvgCurves(m_to * inner); }
  const Eigen::Affine2d& toMillimetres() const { return m_to; }

  void line(const ProfilePoint& a, const ProfilePoint& b);
  // Adds an arc of an ellipse with the semi-axes rx and ry, of which rx is at the angle `rotation` to x. The arc begins
  // at the parameter `from` of the ellipse and extends by `sweep`. All angles are in radians.
  void arc(const ProfilePoint& centre, double rx, double ry, double rotation, double from, double sweep);
  void cubic(const ProfilePoint& a, const ProfilePoint& b, const ProfilePoint& c, const ProfilePoint& d);

  std::vector<ProfileSegment>& found() { return m_found; }

 private:
  Eigen::Affine2d m_to;
  std::vector<ProfileSegment> m_found;
};

// Reads the curves of the attribute d of a path. If it has an error, the whole file is refused, because half of an
// outline would be wrong. most: limit of the curves; more are refused. Errors: ElementMalformed {"path", what},
// FileTooLarge {segments}, Cancelled.
Status readSvgPath(std::string_view d, std::size_t most, SvgCurves& curves, Progress progress);

// Takes the next number of a list that blanks and commas separate. Returns false at its end, or if there is none.
bool takeSvgNumber(std::string_view& text, double& number);

// Reads the attribute transform. Errors: ElementMalformed {"transform", what}.
Result<Eigen::Affine2d> readSvgTransform(std::string_view text);

}  // namespace handwheel
