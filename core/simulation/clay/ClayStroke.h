// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/clay/ClayDab.h"

#include <array>
#include <optional>

namespace handwheel {

// What the pressure of a pen, or of the hand at a device, changes.
enum class ClayPressure { Nothing, Strength, Radius, Both };

// A clay tool as it is set.
struct ClayBrush {
  ClayAction action = ClayAction::Carve;
  double radius = 5.0;                                  // mm
  double strength = 0.5;                                // as that of ClayDab
  double falloff = 1.0;                                 // as that of ClayDab
  std::array<bool, 3> isMirrored{false, false, false};  // across x, y, z
  Vec3 mirror = Vec3::Zero();                           // mm, on the planes of symmetry
  std::shared_ptr<const ClayStamp> stamp = nullptr;     // as that of ClayDab
  ClayPressure pressure = ClayPressure::Nothing;
  double turn = 0.0;  // radian, that the stamp is turned by, seen from outside anticlockwise

  bool operator==(const ClayBrush&) const = default;

  // The brush as it works under a share of the full pressure, from 0 to 1; others count as the nearest of these. A
  // tenth of the radius is left at least.
  ClayBrush at(double share) const;
};

// The places at which a brush stroke acts on a volume. At once where it is pressed, then whenever it has gone a share
// of its radius, and some times a second where it rests and this does something. Stamps follow one another side by
// side. What adds, carves or masks is swept from one place to the next.
class ClayStroke {
 public:
  explicit ClayStroke(const ClayBrush& brush) : m_brush(brush) {}

  // The next place of the brush, mm, and its time, s. normal: of the surface there, for what acts along it. Adds to
  // dabs() what it does there. Places that are not finite are left out. pressure: 0 to 1.
  void move(const Vec3& place, double time, const Vec3& normal, double pressure = 1.0);

  // What is to be applied, in order; who has applied some takes them out.
  std::vector<ClayDab>& dabs() { return m_dabs; }

 private:
  static constexpr double kSpacing = 0.2;          // of the radius, between dabs
  static constexpr double kMoveSpacing = 0.05;     // of those that move material along, and the least way of a sweep
  static constexpr double kStampSpacing = 1.4142;  // the side of a stamp
  static constexpr double kSweep = 2.0;            // of the radius, at most at once
  static constexpr double kRestPeriod = 0.05;      // s
  static constexpr std::size_t kMostAtOnce = 2000;

  void add(const ClayBrush& brush, const Vec3& centre, const Vec3& way, const Vec3& normal);
  void turnStamp(ClayDab& dab) const;

  ClayBrush m_brush;
  std::optional<Vec3> m_last;  // where the last dab was
  double m_lastTime = 0.0;
  std::vector<ClayDab> m_dabs;
};

}  // namespace handwheel
