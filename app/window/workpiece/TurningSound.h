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

// The sound of the Turn tool. Spindle speed and force are assumed: the part turns at kSpindle, and the force is that of
// mild steel for the material removed in a second. Window thread.
class TurningSound {
 public:
  static constexpr double kSpindle = 600.0;          // r/min
  static constexpr double kSpecificEnergy = 2000.0;  // N/mm², chip of mild steel

  // To be called some ten times a second. seconds: since the previous call.
  MachineSoundState next(const TurnTool& tool, double seconds);

 private:
  double m_volume = -1.0;  // mm³, volume of the part at the previous call; below 0: none
};

}  // namespace handwheel
