// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sound/MachineSoundSynthesizer.h"

#include <QElapsedTimer>

namespace handwheel {

class ManualLatheTool;
class TurnTool;

// The present sound of a manual lathe.
MachineSoundState soundOf(const ManualLatheTool& lathe);

// What the Turn tool sounds like. It knows neither spindle nor force: the part turns at kSpindle, and the force is that
// of mild steel for the material that leaves in a second. Window thread.
class TurningSound {
 public:
  static constexpr double kSpindle = 600.0;          // r/min
  static constexpr double kSpecificEnergy = 2000.0;  // N/mm²: of the chip, mild steel

  // To be asked some ten times in a second. seconds: since the last time.
  MachineSoundState next(const TurnTool& tool, double seconds);

 private:
  double m_volume = -1.0;  // mm³, of the part the last time; below 0: none
};

}  // namespace handwheel
