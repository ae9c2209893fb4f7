// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/target/TargetErrors.h"

namespace handwheel {

const ErrorDescription TargetError::CrossesAxis{
    .id = "CrossesAxis",
    .sentences = {translatable("ErrorText", "the profile crosses the axis at Z %1 mm")},
    .advice = {translatable("ErrorText", "Draw only the half of the section on one side of the axis.")}};

const ErrorDescription TargetError::TouchesAxis{
    .id = "TouchesAxis",
    .sentences = {translatable("ErrorText", "the profile touches the axis at Z %1 mm, so the part would be in pieces")},
    .advice = {translatable("ErrorText", "Import each piece from a file of its own.")}};

const ErrorDescription TargetError::CrossesItself{
    .id = "CrossesItself",
    .sentences = {translatable("ErrorText", "the profile crosses or touches itself at radius %1 mm, Z %2 mm")},
    .advice = {translatable("ErrorText", "Correct the outline there: it must enclose one area.")}};

const ErrorDescription TargetError::NotJoined{
    .id = "NotJoined",
    .sentences = {translatable("ErrorText", "the profile has a gap of %1 mm at radius %2 mm, Z %3 mm")},
    .advice = {translatable("ErrorText", "Join the ends of the lines there.")}};

const ErrorDescription TargetError::NoArea{
    .id = "NoArea",
    .sentences = {translatable("ErrorText", "the profile encloses no material")},
    .advice = {
        translatable("ErrorText", "Draw the outline of the half section, from one end of the part to the other.")}};

const ErrorDescription TargetError::NoProfile{
    .id = "NoProfile",
    .sentences = {translatable("ErrorText", "the file contains no profile")},
    .advice = {
        translatable("ErrorText", "Draw the half section with visible lines, arcs or polylines, outside of blocks.")}};

const ErrorDescription TargetError::SeveralProfiles{
    .id = "SeveralProfiles",
    .sentences = {translatable("ErrorText", "the file contains %1 separate outlines, and a profile is a single one")},
    .advice = {translatable("ErrorText", "Remove frames, dimensions and other views, or join the ends of the lines.")}};

const ErrorDescription TargetError::BinaryDrawing{
    .id = "BinaryDrawing",
    .sentences = {translatable("ErrorText", "it is a binary DXF file, and only those in text can be read")},
    .advice = {translatable("ErrorText", "Save it as ASCII DXF.")}};

const ErrorDescription TargetError::AxisUnknown{
    .id = "AxisUnknown",
    .sentences = {translatable("ErrorText", "the drawing does not show where the axis is")},
    .advice = {translatable("ErrorText", "Draw the axis as a horizontal line with the id or layer 'axis'.")}};

const ErrorDescription TargetError::NoAxis{
    .id = "NoAxis",
    .sentences = {translatable("ErrorText", "the solid has no axis of revolution")},
    .advice = {translatable("ErrorText", "Choose a part that can be turned.")}};

const ErrorDescription TargetError::NotTurned{
    .id = "NotTurned",
    .sentences = {translatable("ErrorText",
                               "it is not a turned part: face %1, a %2 at (%3, %4, %5), does not turn about its axis")},
    .advice = {translatable("ErrorText", "Remove that feature, or choose to ignore what is not turned.")}};

const ErrorDescription TargetError::TooIntricate{
    .id = "TooIntricate",
    .sentences = {translatable("ErrorText", "the outline has too many reversals to be checked")},
    .advice = {translatable("ErrorText", "Draw it with fewer lines, for example without hatching.")}};

const ErrorDescription TargetError::MeshNotTurned{
    .id = "MeshNotTurned",
    .sentences = {translatable(
        "ErrorText", "it is not a turned part: points are %1 mm off circles about an axis, %2 mm is allowed")},
    .advice = {translatable("ErrorText", "Export the part as STEP, or as a finer mesh without other features.")}};

const ErrorDescription TargetError::NotOneSolid{
    .id = "NotOneSolid",
    .sentences = {translatable("ErrorText", "the file contains %1 solids, and a target is a single one")},
    .advice = {translatable("ErrorText", "Save the turned part alone in a file.")}};

}  // namespace handwheel
