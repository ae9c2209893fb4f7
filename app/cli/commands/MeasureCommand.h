// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/DocumentKind.h"

namespace handwheel {

// Syntax of "handwheel measure", which measures the errors and costs of the accuracy settings.
CommandSpec measureSpec();
int runMeasure(const Arguments& arguments, const DocumentKinds& kinds);

}  // namespace handwheel
