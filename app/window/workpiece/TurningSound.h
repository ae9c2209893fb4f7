// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sound/MachineSoundSynthesizer.h"

#include <QElapsedTimer>

namespace handwheel {

class ManualLatheTool;
class TurnTool;

// Returns the present sound of a manual lathe.
MachineSoundState soundOf(const ManualLatheTool& lathe);

// The sound of the Turn tool. The spindle speed and the force are assumptions. The part turns at kSpindle, and the
// force is that of mild steel at the present rate of removal. It must be used on the window thread.
class TurningSound {
 public:
  static constexpr double kSpindle = 600.0;          // r/min
  static constexpr double kSpecificEnergy = 2000.0;  // N/mm², chip of mild steel

  // Returns the present sound of the tool. The caller must call it some ten times a second. seconds: the time since the
  // previous call.
  MachineSoundState next(const TurnTool& tool, double seconds);

 private:
  double m_volume = -1.0;  // mm³, volume of the part at the previous call; below 0: none
};

}  // namespace handwheel
