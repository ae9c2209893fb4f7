// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "volume/clay/ClayDab.h"

#include <array>
#include <optional>

namespace handwheel {

// The brush settings that depend on the pressure of a pen or device.
enum class ClayPressure { Nothing, Strength, Radius, Both };

// The settings of a clay tool.
struct ClayBrush {
  ClayAction action = ClayAction::Carve;
  double radius = 5.0;                                  // mm
  double strength = 0.5;                                // ClayDab::strength
  double falloff = 1.0;                                 // ClayDab::falloff
  std::array<bool, 3> isMirrored{false, false, false};  // mirrored across x, y, z
  Vec3 mirror = Vec3::Zero();                           // mm, a point on the planes of symmetry
  std::shared_ptr<const ClayStamp> stamp = nullptr;     // ClayDab::stamp
  ClayPressure pressure = ClayPressure::Nothing;
  double turn = 0.0;  // rad, rotation of the stamp, anticlockwise as seen from outside

  bool operator==(const ClayBrush&) const = default;

  // Returns the brush at a fraction of the full pressure, which is clamped to 0…1. The radius is at least a tenth of
  // the full radius.
  ClayBrush at(double share) const;
};

// Divides a brush stroke into dabs on a volume. There is a dab at the first position and one after each fixed fraction
// of the radius. While the brush rests, there are several dabs a second if its action has an effect at rest. Stamps
// follow one another side by side. Brushes that add, carve or mask are swept between positions.
class ClayStroke {
 public:
  explicit ClayStroke(const ClayBrush& brush) : m_brush(brush) {}

  // Adds the next position of the brush, mm, and its time, s, and appends the resulting dabs to dabs(). normal: the
  // surface normal at the position, for actions along the normal. Positions that are not finite are ignored. pressure:
  // 0 to 1.
  void move(const Vec3& position, double time, const Vec3& normal, double pressure = 1.0);

  // Returns the dabs to be applied, in order; the caller removes those that it has applied.
  std::vector<ClayDab>& dabs() { return m_dabs; }

 private:
  static constexpr double kSpacing = 0.2;  // distance between dabs, as a fraction of the radius
  // distance between dabs that move material, as a fraction of the radius; also the least length of a sweep
  static constexpr double kMoveSpacing = 0.05;
  static constexpr double kStampSpacing = 1.4142;  // distance between stamps, in radii: a stamp's side
  static constexpr double kSweep = 2.0;            // largest length of a sweep, in radii
  static constexpr double kRestPeriod = 0.05;      // s, period of dabs at rest
  static constexpr std::size_t kMostAtOnce = 2000;

  void add(const ClayBrush& brush, const Vec3& centre, const Vec3& displacement, const Vec3& normal);
  void turnStamp(ClayDab& dab) const;

  ClayBrush m_brush;
  std::optional<Vec3> m_last;  // position of the last dab
  double m_lastTime = 0.0;
  std::vector<ClayDab> m_dabs;
};

}  // namespace handwheel
