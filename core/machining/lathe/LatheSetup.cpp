// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/LatheSetup.h"

#include "machining/force/CuttingFeel.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

bool isBetween(double value, double least, double largest) {
  return value >= least && value <= largest;  // false for NaN
}

bool isSize(double value) {
  return isBetween(value, 0.0, LatheSetup::kLargest);
}

bool isPosition(const ProfilePoint& p) {
  return isBetween(p.x(), -LatheSetup::kLargest, LatheSetup::kLargest) &&
         isBetween(p.y(), -LatheSetup::kLargest, LatheSetup::kLargest);
}

bool isSoundDial(const LatheDial& dial) {
  return dial.divisions >= 1 && dial.divisions <= 10'000 && isBetween(dial.perDivision, 1e-6, 1e3) &&
         isSize(dial.backlash) && isBetween(dial.least, -LatheSetup::kLargest, LatheSetup::kLargest) &&
         isBetween(dial.largest, dial.least, LatheSetup::kLargest);
}

// Returns the displacement of the tool post for a travel of the slides.
ProfilePoint postAt(const LatheSetup& setup, const std::array<double, kLatheAxes>& slides) {
  const double angle = setup.compoundAngle * M_PI / 180.0;
  const double compound = slides[static_cast<std::size_t>(LatheAxis::Compound)];
  return {slides[static_cast<std::size_t>(LatheAxis::Cross)] + compound * std::sin(angle),
          slides[static_cast<std::size_t>(LatheAxis::Carriage)] + compound * std::cos(angle)};
}

}  // namespace

bool LatheSetup::isSound() const {
  const double sizes[] = {chuck.diameter,       chuck.length,
                          chuck.jawLength,      chuck.jawHeight,
                          chuck.jawWidth,       chuck.grip,
                          tailstock.position,   tailstock.quillDiameter,
                          tailstock.bodyRadius, spindle.leastSpeed,
                          spindle.power,        spindle.torque,
                          depthLimit,           handFeed};
  return std::all_of(std::begin(sizes), std::end(sizes), isSize) &&
         std::all_of(dials.begin(), dials.end(), isSoundDial) &&
         std::all_of(stations.begin(), stations.end(),
                     [](const LatheSlot& slot) { return isPosition(slot.position) && isPosition(slot.offset); }) &&
         isBetween(spindle.largestSpeed, spindle.leastSpeed, kLargest) && isBetween(spindle.speed, 0.0, kLargest) &&
         isBetween(spindle.acceleration, 1.0, 1e6) && isBetween(compoundAngle, -90.0, 90.0) &&
         isBetween(leadScrewPitch, 0.1, 100.0) && isBetween(rapidSpeed, 0.1, 1e3) &&
         isBetween(wear, 0.0, CuttingFeel::kMostWear) && isBetween(handSpeed, 0.1, 1e3) && !stations.empty() &&
         stations.size() <= kMostSlots && allowed.size() <= kMostAllowed;
}

LatheSetup defaultLatheSetup(const StockCylinder& stock) {
  LatheSetup setup;
  const double radius = 0.5 * stock.diameter;
  setup.chuck.grip = std::min(20.0, 0.3 * stock.length);
  setup.chuck.diameter = std::max(125.0, 2.0 * (radius + 30.0));
  setup.tailstock.position = stock.length + 150.0;
  const char* const tools[] = {"right-roughing", "right-finishing", "left-roughing", "parting-3",
                               "threading-60",   "boring-12",       "form-radius-4", "grooving-2",
                               "file-flat",      "paper-120",       "paper-400",     "disk-100"};
  static_assert(std::size(tools) <= LatheSetup::kMostSlots);
  // The tips of the tools of a post are at different positions, so they have to be touched off.
  for (std::size_t i = 0; i < std::size(tools); ++i) {
    const double away = static_cast<double>(i);
    setup.stations.push_back({tools[i], {0.37 * away, -0.23 * away}});
  }
  const double reach = std::max(200.0, stock.length + radius) + 300.0;
  for (const LatheAxis axis : {LatheAxis::Carriage, LatheAxis::Cross}) {
    setup.dials[static_cast<std::size_t>(axis)].least = axis == LatheAxis::Cross ? -50.0 : -reach;
    setup.dials[static_cast<std::size_t>(axis)].largest = reach;
  }
  setup.dials[static_cast<std::size_t>(LatheAxis::Compound)].least = -60.0;
  setup.dials[static_cast<std::size_t>(LatheAxis::Compound)].largest = 60.0;
  return setup;
}

ProfilePoint tipAt(const LatheSetup& setup, const LatheSlot& slot, const std::array<double, kLatheAxes>& slides) {
  return postAt(setup, slides) + slot.position;
}

ProfilePoint readoutAt(const LatheSetup& setup, const LatheSlot& slot, const std::array<double, kLatheAxes>& slides) {
  return postAt(setup, slides) + slot.offset;
}

LatheSlot touchedOff(const LatheSetup& setup, LatheSlot slot, const std::array<double, kLatheAxes>& slides,
                     bool isRadius, double value) {
  const Eigen::Index i = isRadius ? 0 : 1;
  if (!std::isfinite(value)) return slot;
  slot.offset[i] = value - postAt(setup, slides)[i];
  slot.hasOffset[i] = true;
  return slot;
}

}  // namespace handwheel
