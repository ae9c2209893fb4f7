// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/mesh/ScriptErrors.h"

namespace handwheel {

const ErrorDescription ScriptError::Malformed{
    .id = "StepMalformed",
    .sentences = {translatable("ErrorText", "the step cannot be done: %1")},
    .advice = {translatable("ErrorText",
                            "'handwheel help edit' lists the steps; loops are numbered as in 'handwheel inspect'.")}};

}  // namespace handwheel
