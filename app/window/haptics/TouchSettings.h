// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Property.h"
#include "haptics/scene/SnapForce.h"

namespace handwheel {

// The haptic properties of surfaces. They do not depend on the document or the view, because lengths and forces are
// measured at the device. They are stored in the settings, except for the stiffness.
struct TouchSettings {
  double stiffness = 0.5;  // N/mm; stored as the fidelity setting contact.stiffness (see HapticFidelity)
  double damping = 0.0;    // N·s/mm, along the surface normal
  double friction = 0.0;   // coefficient of Coulomb friction

  // If true, the features that the active tool can pick attract the tip (He 2008, section 3.1.1).
  bool isSnapping = true;
  SnapShape snapShape = SnapShape::Quadratic;
  SnapMethod snapMethod = SnapMethod::Proxy;
  double snapStiffness = 0.3;      // N/mm
  bool hasBoundaryCurves = false;  // the rim of a hole attracts as one curve, not by separate points and edges

  bool operator==(const TouchSettings&) const = default;
};

// Loads the stored touch settings. Missing or invalid values get the defaults of TouchSettings.
TouchSettings loadTouch();
// Stores the touch settings.
void storeTouch(const TouchSettings& touch);

// Returns the touch settings as properties for a form.
std::vector<Property> propertiesOf(const TouchSettings& touch);
// Changes one touch setting by its property id. Unknown ids and values of the wrong type are ignored; numbers are
// clamped to their limits.
void setProperty(TouchSettings& touch, std::string_view id, const PropertyValue& value);

}  // namespace handwheel
