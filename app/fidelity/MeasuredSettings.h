// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fidelity/Cases.h"

namespace handwheel {

// Returns all settings that trade speed for accuracy, with the built-in cases that measure them. The call is cheap
// because the shapes are created when a case runs.
FidelityRegistry measuredSettings();

// Returns the cases of a setting on a mesh of the user. The result is empty if the setting does not concern meshes.
std::vector<FidelityCase> casesOnMesh(std::string_view id, const std::string& name, const SoupSource& soup);

}  // namespace handwheel
