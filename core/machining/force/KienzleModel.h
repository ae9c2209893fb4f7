// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/CuttingEdge.h"
#include "machining/force/PowerLaw.h"

#include <span>
#include <utility>

namespace handwheel {

// The two constants of Kienzle's law, kc = kc11 h^-mc. h is the thickness of the chip in mm.
struct KienzleConstants {
  double kc11 = 0.0;  // N/mm², specific force of a chip 1 mm wide and 1 mm thick
  double mc = 0.0;
  bool operator==(const KienzleConstants&) const = default;
};

// Returns the constants nearest to a table of thickness (mm) and kc (N/mm²), by least squares of the logarithms. The
// table must have two different thicknesses, and only values above zero.
KienzleConstants fittedConstants(std::span<const std::pair<double, double>> table);

// Kienzle's cutting force law for a material and an edge. The force is Fc = kc11 b h^(1-mc) with b = ap / sin κ and h =
// f sin κ for the depth ap, the feed f and the approach angle κ, reduced by 1 % for each degree of rake (Kienzle 1952;
// the rake correction is from Sandvik's handbook). It does not depend on the speed.
class KienzleModel : public CuttingForceModel {
 public:
  KienzleModel(const KienzleConstants& constants, const CuttingEdge& edge, const ThrustSettings& thrust = {});

  CutForces at(const CutConditions& cut) const noexcept override;
  CutForces onDrill(const CutConditions& cut) const noexcept override;
  bool covers(const CutConditions& cut) const noexcept override;

 private:
  KienzleConstants m_constants;
  CuttingEdge m_edge;
  ThrustSettings m_thrust;
  PowerLaw m_cutting;
  double m_thickness;  // ratio of the chip thickness to the feed, sin κ
};

}  // namespace handwheel
