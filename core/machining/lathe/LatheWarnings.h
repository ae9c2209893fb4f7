// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/TurnedProfile.h"
#include "machining/force/CutWarnings.h"
#include "machining/lathe/LatheSetup.h"

namespace handwheel {

// A workshop rule that was broken on a lathe. With the time since when, the tool, and by how much at worst.
struct LatheWarning {
  CutWarning warning;
  double time = 0.0;  // s, of the machine, when it began
  std::string tool;   // id

  bool operator==(const LatheWarning&) const = default;
};

// The drive of a lathe as the rules see it; a limit that it does not have is infinite.
SpindleDrive driveOf(const LatheSpindle& spindle);
// The torque that the spindle has at a speed (r/min), N·m; infinite where nothing limits it.
double spindleTorque(const LatheSpindle& spindle, double speed);

// A part in the jaws as a beam that gives way as much as the part does at this place (mm, z): the shaft of one diameter
// with the same ∫ (place - s)² / I(s) ds from the jaws on. It ends where the material does. O(samples).
SlenderWork beamOf(const TurnedProfile& part, double grip, double place);

// What was warned of since a lathe began to run. One entry for each time that a rule was broken: what is broken again
// within kApart goes on.
class LatheWarnings {
 public:
  static constexpr std::size_t kMost = 1000;  // that are recorded
  static constexpr double kApart = 2.0;       // s

  // Times never fall.
  void judge(const std::vector<CutWarning>& broken, double time, const std::string& tool);

  const std::vector<LatheWarning>& all() const { return m_all; }
  std::uint64_t changes() const { return m_changes; }  // how often all() has changed

 private:
  struct Open {
    std::size_t entry = 0;
    double last = 0.0;  // s, broken last
    bool isOpen = false;
  };
  std::vector<LatheWarning> m_all;
  std::array<Open, kCutRules> m_open;
  std::uint64_t m_changes = 0;
};

}  // namespace handwheel
