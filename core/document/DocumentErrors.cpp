// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/DocumentErrors.h"

namespace handwheel {

const ErrorDescription DocumentError::FormatUnknown{
    .id = "FormatUnknown",
    .sentences = {translatable("ErrorText", "this is not a file that Handwheel can read")},
    .advice = {translatable("ErrorText", "Handwheel reads files that end in %1."),
               translatable("ErrorText", "Choose another file.")},
    .alternatives = 0};

const ErrorDescription DocumentError::ExtensionUnknown{
    .id = "ExtensionUnknown",
    .sentences = {translatable("ErrorText", "the extension '%1' is not a format that this can be written in"),
                  translatable("ErrorText", "the file name has no extension to specify the format")},
    .advice = {translatable("ErrorText", "Use a name that ends in %2.")},
    .alternatives = 1};

const ErrorDescription DocumentError::ChangedOnDisk{
    .id = "ChangedOnDisk",
    .sentences = {translatable("ErrorText", "another program has changed the file since it was opened")},
    .advice = {translatable("ErrorText",
                            "Save under another name to keep both, or replace the version of the other program.")}};

const ErrorDescription DocumentError::OpenElsewhere{
    .id = "OpenElsewhere",
    .sentences = {translatable("ErrorText", "the file is open in another tab, and would be replaced")},
    .advice = {translatable("ErrorText", "Choose another name, or close the other tab first.")}};

const ErrorDescription DocumentError::ReplacesLinked{
    .id = "ReplacesLinked",
    .sentences = {translatable("ErrorText",
                               "a body of the document is linked to this file, which would be overwritten")},
    .advice = {translatable("ErrorText", "Write to another file, or unlink the body first.")}};

const ErrorDescription DocumentError::KindUnknown{
    .id = "KindUnknown",
    .sentences = {translatable("ErrorText",
                               "the file contains a '%1', a kind of document that this program does not know")},
    .advice = {translatable("ErrorText", "Open it with a newer version of Handwheel.")}};

const ErrorDescription DocumentError::CheckFailed{
    .id = "CheckFailed",
    .sentences = {translatable("ErrorText", "the written file did not pass verification (%1), so it was discarded")},
    .advice = {translatable(
        "ErrorText", "An existing file of that name was not changed. Save in another format, for example PLY.")}};

}  // namespace handwheel
