// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "builtin/BuiltInKinds.h"

namespace handwheel::test {

// Returns the registration of a kind of document that the program does not have. sample: a file of that kind.
KindRegistration globeRegistration(const QString& sample = {});

// Returns the kinds of the program and the kind of globes.
std::vector<KindRegistration> kindsWithGlobe(const QString& sample = {});

}  // namespace handwheel::test
