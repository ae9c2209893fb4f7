// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene/BodyErrors.h"

namespace handwheel {

const ErrorDescription BodyError::BodyMissing{
    .id = "BodyMissing",
    .sentences = {translatable("ErrorText", "the document has no body '%1'")},
    .advice = {translatable("ErrorText", "Give the name or number of an existing body; 'inspect' lists them.")}};

const ErrorDescription BodyError::Ambiguous{
    .id = "BodyAmbiguous",
    .sentences = {translatable("ErrorText", "'%1' is the name of body %2, and the number of another")},
    .advice = {translatable("ErrorText", "Give the name of the other body, or rename body %2.")}};

const ErrorDescription BodyError::NotLinked{
    .id = "NotLinked",
    .sentences = {translatable("ErrorText", "the body '%1' is not linked to a file")},
    .advice = {translatable("ErrorText", "Only a linked body can be read again; add the file as a new one.")}};

const ErrorDescription BodyError::LinkedFileGone{
    .id = "LinkedFileGone",
    .sentences = {translatable("ErrorText", "the linked file %1 is missing")},
    .advice = {translatable("ErrorText", "Put it back, or add the file from where it is now.")}};

const ErrorDescription BodyError::TooManyBodies{
    .id = "TooManyBodies",
    .sentences = {translatable("ErrorText", "a document can contain at most %1 bodies")},
    .advice = {translatable("ErrorText", "Remove bodies, or add several as one file.")}};

const ErrorDescription BodyError::TooManyTriangles{
    .id = "TooManyTriangles",
    .sentences = {translatable("ErrorText", "the bodies would have %1 triangles, and a document can contain %2")},
    .advice = {translatable("ErrorText", "Reduce the mesh before adding it ('handwheel decimate').")}};

const ErrorDescription BodyError::NameTaken{.id = "NameTaken",
                                            .sentences = {translatable("ErrorText", "the name '%1' is already in use")},
                                            .advice = {translatable("ErrorText", "Choose another name.")}};

const ErrorDescription BodyError::NameUnusable{
    .id = "NameUnusable",
    .sentences = {translatable("ErrorText", "'%1' is not a valid name: a name is one line of 1 to %2 bytes")},
    .advice = {translatable("ErrorText", "Choose another name.")}};

}  // namespace handwheel
