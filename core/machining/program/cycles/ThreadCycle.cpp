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

void ThreadCycle::pass(ProgramMachine& machine, const ProgramPlace& place, double at) const {
  const double out = isInside ? 1.0 : -1.0;  // away from the axis
  const double direction = endZ > start.y() ? -1.0 : 1.0;
  const double length = direction * taper;
  const double most = peak + depth;
  const double from = start.y() - shift(at), to = endZ + shift(most) - shift(at);
  const auto pointAt = [&](double depthHere, double z) {
    return ProfilePoint(start.x() + out * depthHere + slope * (z - start.y()), z);
  };
  const double passPitch = along * pitch;
  const double alongZ = passPitch / std::hypot(1.0, slope);  // goes on through the tapered ends
  const double taperPitch = taper > 0.0 ? alongZ * std::hypot(taper, depth) / taper : passPitch;
  machine.rapid(pointAt(at - most, from), place);
  double z = from;
  if (taper > 0.0 && hasEntryTaper) {
    machine.thread(pointAt(at - depth, from), taperPitch, place);
    machine.thread(pointAt(at, from - length), taperPitch, place);
    z = from - length;
  } else {
    machine.rapid(pointAt(at, from), place);
  }
  if (taper > 0.0 && hasExitTaper) {
    if (direction * (z - (to + length)) > 0.0) machine.thread(pointAt(at, to + length), passPitch, place);
    machine.thread(pointAt(at - depth, to), taperPitch, place);
  } else {
    machine.thread(pointAt(at, to), passPitch, place);
  }
  machine.rapid(pointAt(at - most, to), place);
}

void ThreadCycle::run(ProgramMachine& machine, const ProgramPlace& place) const {
  const double rough = depth - lastStep;
  double below = firstDepth;
  for (int n = 1; below < rough; ++n) {
    if (n > kMostPasses) refuse(place, "thread", "the thread has too many passes", "Use a larger first depth.");
    pass(machine, place, peak + below);
    const double next = firstDepth * std::pow(n + 1, 1.0 / degression);
    below = std::max(next, below + leastStep);
  }
  if (lastStep > 0.0) pass(machine, place, peak + rough);
  for (int i = 0; i <= springPasses; ++i) pass(machine, place, peak + depth);
  machine.rapid({start.x(), endZ}, place);
}

}  // namespace handwheel
