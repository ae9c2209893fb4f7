// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/cycles/ThreadCycle.h"

#include <algorithm>
#include <cmath>

namespace handwheel {

namespace {

constexpr int kMostPasses = 100'000;

}  // namespace

double ThreadCycle::shift(double at) const {
  const double direction = endZ > start.y() ? -1.0 : 1.0;
  return direction * (at - peak) * std::tan(angle * M_PI / 180.0);
}

void ThreadCycle::pass(ProgramMachine& machine, const SourceLocation& location, double at) const {
  const double out = isInside ? 1.0 : -1.0;  // away from the axis
  const double direction = endZ > start.y() ? -1.0 : 1.0;
  const double length = direction * taper;
  const double most = peak + depth;
  const double from = start.y() - shift(at), to = endZ + shift(most) - shift(at);
  const auto pointAt = [&](double depthHere, double z) {
    return ProfilePoint(start.x() + out * depthHere + slope * (z - start.y()), z);
  };
  const double passPitch = along * pitch;
  const double alongZ = passPitch / std::hypot(1.0, slope);  // continues through the tapered ends
  const double taperPitch = taper > 0.0 ? alongZ * std::hypot(taper, depth) / taper : passPitch;
  machine.rapid(pointAt(at - most, from), location);
  double z = from;
  if (taper > 0.0 && hasEntryTaper) {
    machine.thread(pointAt(at - depth, from), taperPitch, location);
    machine.thread(pointAt(at, from - length), taperPitch, location);
    z = from - length;
  } else {
    machine.rapid(pointAt(at, from), location);
  }
  if (taper > 0.0 && hasExitTaper) {
    if (direction * (z - (to + length)) > 0.0) machine.thread(pointAt(at, to + length), passPitch, location);
    machine.thread(pointAt(at - depth, to), taperPitch, location);
  } else {
    machine.thread(pointAt(at, to), passPitch, location);
  }
  machine.rapid(pointAt(at - most, to), location);
}

void ThreadCycle::run(ProgramMachine& machine, const SourceLocation& location) const {
  const double rough = depth - lastStep;
  double below = firstDepth;
  for (int n = 1; below < rough; ++n) {
    if (n > kMostPasses) refuse(location, "thread", "the thread has too many passes", "Use a larger first depth.");
    pass(machine, location, peak + below);
    const double next = firstDepth * std::pow(n + 1, 1.0 / degression);
    below = std::max(next, below + leastStep);
  }
  if (lastStep > 0.0) pass(machine, location, peak + rough);
  for (int i = 0; i <= springPasses; ++i) pass(machine, location, peak + depth);
  machine.rapid({start.x(), endZ}, location);
}

}  // namespace handwheel
