// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/force/ForceErrors.h"

namespace handwheel {

const ErrorDescription ForceErrors::ColumnMissing{
    .id = "ColumnMissing",
    .sentences = {translatable("ErrorText", "the table has no column for the %1")},
    .advice = {translatable("ErrorText", "Its first line has to name the columns; this one may be called %2.")}};

const ErrorDescription ForceErrors::ColumnTwice{
    .id = "ColumnTwice",
    .sentences = {translatable("ErrorText", "the table has two columns for the %1")},
    .advice = {translatable("ErrorText", "Remove one of them.")}};

const ErrorDescription ForceErrors::DiameterNeeded{
    .id = "DiameterNeeded",
    .sentences = {translatable("ErrorText", "the table gives the spindle speed only, and no cutting speed")},
    .advice = {translatable(
        "ErrorText", "Say the diameter of the work (on the command line: --diameter), or add a column v in m/min.")}};

const ErrorDescription ForceErrors::TooFewCuts{
    .id = "TooFewCuts",
    .sentences = {translatable("ErrorText", "there are %1 different cuts, and a model needs at least %2")},
    .advice = {
        translatable("ErrorText", "Add measurements at other depths, feeds and speeds, made with a sharp tool.")}};

const ErrorDescription ForceErrors::MaterialUnknown{
    .id = "MaterialUnknown",
    .sentences = {translatable("ErrorText", "there is no work material '%1'")},
    .advice = {translatable("ErrorText", "See the list of materials (on the command line: handwheel force --list).")}};

}  // namespace handwheel
