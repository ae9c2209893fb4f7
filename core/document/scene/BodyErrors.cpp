// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyErrors.h"

namespace handwheel {

const ErrorDescription BodyError::NameTaken{
    .id = "NameTaken",
    .sentences = {translatable("ErrorText", "something else has the name '%1'")},
    .advice = {translatable("ErrorText", "Choose another name.")}};

const ErrorDescription BodyError::NameUnusable{
    .id = "NameUnusable",
    .sentences = {translatable("ErrorText", "'%1' cannot be a name: it needs one line of 1 to %2 bytes")},
    .advice = {translatable("ErrorText", "Choose another name.")}};

}  // namespace handwheel
