// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"

namespace handwheel {

class DocumentKinds;

// "edit": does to a mesh what the window does, step by step (tools/mesh/MeshSteps.h).
CommandSpec editSpec();
int runEdit(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
