// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Translatable.h"

namespace handwheel {

// The names of the built-in materials, in the order of WorkMaterials::standard(). The translation tools collect them
// from this list. They are translated in the context "Property".
inline constexpr const char* kMaterialNames[] = {
    translatable("Property", "Unalloyed steel below 0.25 % C, annealed"),
    translatable("Property", "Unalloyed steel from 0.25 % C, annealed"),
    translatable("Property", "Unalloyed steel below 0.55 % C, quenched and tempered"),
    translatable("Property", "Unalloyed steel from 0.55 % C, annealed"),
    translatable("Property", "Unalloyed steel from 0.55 % C, quenched and tempered"),
    translatable("Property", "Low-alloy steel, annealed"),
    translatable("Property", "Low-alloy steel, quenched and tempered, 930 MPa"),
    translatable("Property", "Low-alloy steel, quenched and tempered, 1000 MPa"),
    translatable("Property", "Low-alloy steel, quenched and tempered, 1200 MPa"),
    translatable("Property", "High-alloy and tool steel, annealed"),
    translatable("Property", "High-alloy and tool steel, quenched and tempered"),
    translatable("Property", "Stainless steel, ferritic or martensitic"),
    translatable("Property", "Stainless steel, martensitic"),
    translatable("Property", "Stainless steel, austenitic"),
    translatable("Property", "Grey cast iron, ferritic-pearlitic"),
    translatable("Property", "Grey cast iron, pearlitic"),
    translatable("Property", "Nodular cast iron, ferritic"),
    translatable("Property", "Nodular cast iron, pearlitic"),
    translatable("Property", "Malleable cast iron, ferritic"),
    translatable("Property", "Malleable cast iron, pearlitic"),
    translatable("Property", "Wrought aluminium alloy"),
    translatable("Property", "Wrought aluminium alloy, cured"),
    translatable("Property", "Cast aluminium alloy to 12 % Si"),
    translatable("Property", "Cast aluminium alloy to 12 % Si, cured"),
    translatable("Property", "Cast aluminium alloy above 12 % Si"),
    translatable("Property", "Free-cutting copper alloy"),
    translatable("Property", "Brass"),
    translatable("Property", "Electrolytic copper"),
    translatable("Property", "Heat-resistant alloy on iron base, annealed"),
    translatable("Property", "Heat-resistant alloy on iron base, cured"),
    translatable("Property", "Heat-resistant alloy on nickel or cobalt base"),
    translatable("Property", "Pure titanium"),
    translatable("Property", "Titanium alloy, alpha and beta"),
    translatable("Property", "Mild steel, 520 MPa"),
    translatable("Property", "Medium steel, 620 MPa"),
    translatable("Property", "Hard steel, 720 MPa"),
    translatable("Property", "Tool steel, 670 MPa"),
    translatable("Property", "Tool steel, 770 MPa"),
    translatable("Property", "Chrome-manganese steel, 770 MPa"),
    translatable("Property", "Chrome-manganese steel, 630 MPa"),
    translatable("Property", "Chrome-molybdenum steel, 730 MPa"),
    translatable("Property", "Chrome-molybdenum steel, 600 MPa"),
    translatable("Property", "Nickel-chrome-molybdenum steel, 900 MPa"),
    translatable("Property", "Nickel-chrome-molybdenum steel, 352 HB"),
    translatable("Property", "Hard cast iron, 46 HRC"),
    translatable("Property", "Meehanite cast iron, 360 MPa"),
    translatable("Property", "Grey cast iron, 200 HB"),
};

}  // namespace handwheel
