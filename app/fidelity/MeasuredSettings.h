// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fidelity/Cases.h"

namespace handwheel {

// Every setting of the program that trades speed for accuracy, with the built-in shapes that it is measured on. Cheap:
// the shapes are made when a case runs.
FidelityRegistry measuredSettings();

// The cases of a setting on a mesh that the user brings; none where the setting has nothing to do with meshes.
std::vector<FidelityCase> casesOnMesh(std::string_view id, const std::string& name, const SoupSource& soup);

}  // namespace handwheel
