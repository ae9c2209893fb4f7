// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/thread/ThreadDesignation.h"

#include "base/NumberText.h"

#include <array>

namespace handwheel {

namespace {

constexpr double kSameAngle = 0.01;  // rad
constexpr double kRounding = 0.01;   // mm, rounding of measurements

// Nominal diameters of ISO 261, first and second choice, mm.
constexpr std::array kNominal{1.0,  1.1,  1.2,  1.4,  1.6,  1.8,  2.0,  2.2,  2.5,  3.0,  3.5,  4.0,  4.5,
                              5.0,  6.0,  7.0,  8.0,  10.0, 12.0, 14.0, 16.0, 18.0, 20.0, 22.0, 24.0, 27.0,
                              30.0, 33.0, 36.0, 39.0, 42.0, 45.0, 48.0, 52.0, 56.0, 60.0, 64.0, 68.0, 72.0,
                              76.0, 80.0, 85.0, 90.0, 95.0, 100., 105., 110., 115., 120., 125., 130., 140.};

// Returns the largest distance of a crest below the nominal diameter: deviation g and 1.6 times the grade 6 (ISO
// 965-1), mm.
double crestTolerance(double pitch) {
  const double grade6 = 0.18 * std::cbrt(pitch * pitch) - 3.15e-3 / std::sqrt(pitch);
  return 0.015 + 0.011 * pitch + 1.6 * grade6;
}

double nominalOf(double major, double pitch, bool isInner) {
  // The roots of a nut are free above the nominal diameter.
  const double below = isInner ? kRounding : crestTolerance(pitch), above = isInner ? 0.25 * pitch : kRounding;
  double nearest = major;
  for (const double nominal : kNominal) {
    const bool isWithin = major >= nominal - below && major <= nominal + above;
    if (isWithin && (nearest == major || std::abs(nominal - major) < std::abs(nearest - major))) nearest = nominal;
  }
  return nearest;
}

std::string mmOf(double value) {
  return roundedText(std::round(value * 100.0) / 100.0, 9);
}

}  // namespace

std::string threadDesignation(const ThreadCut& cut, double major, bool isInner) {
  const std::string pitch = mmOf(cut.pitch), lead = mmOf(cut.lead()), size = mmOf(nominalOf(major, cut.pitch, isInner));
  if (std::abs(cut.angle - M_PI / 3.0) < kSameAngle)
    return "M" + size + "×" + (cut.starts > 1 ? "L" + lead + "P" + pitch : pitch) + (cut.isLeft ? "-LH" : "");
  if (std::abs(cut.angle - M_PI / 6.0) < kSameAngle)
    return "Tr" + size + "×" + (cut.starts > 1 ? lead + "P" + pitch : pitch) + (cut.isLeft ? "LH" : "");
  return "Ø" + mmOf(major) + " thread " + (cut.starts > 1 ? lead + "P" + pitch : pitch) + " " +
         mmOf(cut.angle * 180.0 / M_PI) + "°" + (cut.isLeft ? " LH" : "");
}

}  // namespace handwheel
