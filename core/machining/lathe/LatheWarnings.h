// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/CutWarnings.h"
#include "machining/lathe/LatheSetup.h"

namespace handwheel {

// A workshop rule that was broken on a lathe. It contains the time, the tool, and the largest excess.
struct LatheWarning {
  CutWarning warning;
  double time = 0.0;  // s, clock of the machine when the excess began
  std::string tool;   // id of the tool

  bool operator==(const LatheWarning&) const = default;
};

// Returns the drive of a lathe for the rules. Limits that the spindle does not have are infinite.
SpindleDrive driveOf(const LatheSpindle& spindle);
// Returns the torque (N·m) of the spindle at a speed (r/min). The torque is infinite if nothing limits it.
double spindleTorque(const LatheSpindle& spindle, double speed);

// The warnings since a lathe began to run. There is one entry for each time that a rule was broken. A rule that is
// broken again within kApart continues its entry.
class LatheWarnings {
 public:
  static constexpr std::size_t kMost = 1000;  // largest number of recorded warnings
  static constexpr double kApart = 2.0;       // s, shortest time between two entries of a rule

  // Adds the rules that are broken at a time. The times of successive calls must not fall.
  void judge(const std::vector<CutWarning>& broken, double time, const std::string& tool);

  const std::vector<LatheWarning>& all() const { return m_all; }
  std::uint64_t changes() const { return m_changes; }  // number of changes of all()

 private:
  struct Open {
    std::size_t entry = 0;
    double last = 0.0;  // s, time at which the rule was last broken
    bool isOpen = false;
  };
  std::vector<LatheWarning> m_all;
  std::array<Open, kCutRules> m_open;
  std::uint64_t m_changes = 0;
};

}  // namespace handwheel
