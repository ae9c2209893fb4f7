// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Property.h"
#include "haptics/SceneForces.h"

namespace handwheel {

// How surfaces feel to the hand, whatever document is open and however it is seen: lengths and forces are those at the
// device. Kept in the settings, but for the stiffness.
struct TouchSettings {
  double stiffness = 0.5;  // N/mm: the fidelity setting contact.stiffness, which keeps it (HapticFidelity)
  double damping = 0.0;    // N·s/mm, along the normal
  double friction = 0.0;   // Coulomb's µ

  // What the tool in use takes by a click draws the tip (He 2008, section 3.1).
  bool isSnapping = true;
  SnapShape snapShape = SnapShape::Quadratic;
  SnapMethod snapMethod = SnapMethod::Proxy;
  double snapStiffness = 0.3;  // N/mm
  bool hasRimCurves = false;   // the rim of a hole draws as one curve to slide along, not by points and edges

  bool operator==(const TouchSettings&) const = default;
};

// Those that are kept here; what is missing there or makes no sense is as above.
TouchSettings keptTouch();
void keepTouch(const TouchSettings& touch);

// As a form, and one value of it. Unknown names and values that are no numbers change nothing; others are brought
// between the limits.
std::vector<Property> propertiesOf(const TouchSettings& touch);
void setProperty(TouchSettings& touch, std::string_view id, const PropertyValue& value);

}  // namespace handwheel
