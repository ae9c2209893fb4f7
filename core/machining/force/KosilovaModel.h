// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "machining/force/KosilovaTables.h"
#include "machining/force/PowerLaw.h"

namespace handwheel {

// The cutting force law of Kosilova and Meshcheryakov for a material and an edge. The law is F[N] = 10 C t^x s^y v^n K
// (He 2008, eq. 3-5), with depth t, feed s, speed v, and K = Kmp Kφ Kγ Kλ Kr, the factors of material, approach, rake,
// inclination and nose.
class KosilovaModel : public CuttingForceModel {
 public:
  // property: the tensile strength (MPa) or the hardness (HB) of the work, whichever the row uses; 0: the reference
  // value of the row.
  KosilovaModel(const KosilovaTables& tables, const KosilovaRow& row, double property, const CuttingEdge& edge,
                const ThrustSettings& thrust = {});

  CutForces at(const CutConditions& cut) const noexcept override;
  bool covers(const CutConditions& cut) const noexcept override;

  double correction() const { return m_correction; }  // the factor K of the cutting force
  // Returns true if all constants of the cutting force were compared with the handbook.
  bool isVerified() const { return m_isVerified; }
  // Returns true if the feed force and the radial force come from laws of the table.
  bool hasThrustLaws() const { return m_hasThrustLaws; }

 private:
  CuttingEdge m_edge;
  ThrustSettings m_thrust;
  PowerLaw m_cutting, m_radial, m_feed;
  double m_correction;
  bool m_hasThrustLaws;
  bool m_isVerified;
};

}  // namespace handwheel
