// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/Error.h"

namespace handwheel {

const ErrorDescription ErrorCode::Cancelled{.id = "Cancelled", .sentences = {translatable("ErrorText", "cancelled")}};

const ErrorDescription ErrorCode::OutOfMemory{
    .id = "OutOfMemory",
    .sentences = {translatable("ErrorText", "there is not enough memory")},
    .advice = {translatable("ErrorText", "Close other documents or programs, or try a model with fewer triangles.")}};

const ErrorDescription ErrorCode::FileMissing{
    .id = "FileMissing",
    .sentences = {translatable("ErrorText", "there is no such file")},
    .advice = {translatable("ErrorText", "Check the name, and whether the file was moved.")}};

const ErrorDescription ErrorCode::FileUnreadable{
    .id = "FileUnreadable",
    .sentences = {translatable("ErrorText", "the file cannot be read (%1)")},
    .advice = {translatable("ErrorText",
                            "Choose a file that you have permission to read, and check that its disk is connected.")}};

const ErrorDescription ErrorCode::FileEmpty{.id = "FileEmpty",
                                            .sentences = {translatable("ErrorText", "the file is empty")},
                                            .advice = {translatable("ErrorText", "Export or copy the file again.")}};

const ErrorDescription ErrorCode::FileTooLarge{
    .id = "FileTooLarge",
    .sentences = {translatable("ErrorText", "the file is too large (%2 %1, at most %3 can be opened)"),
                  translatable("ErrorText", "the file is too large (more than %3 %1)")},
    .advice = {translatable("ErrorText", "Reduce or split the model in the program that made it.")}};

const ErrorDescription ErrorCode::WriteFailed{
    .id = "WriteFailed",
    .sentences = {translatable("ErrorText", "the file could not be written (%1)")},
    .advice = {
        translatable("ErrorText", "Check the free space and your write permission, or choose another location.")}};

const ErrorDescription ErrorCode::HeaderMalformed{
    .id = "HeaderMalformed",
    .sentences = {translatable("ErrorText", "the header is malformed: %1 is missing")},
    .advice = {translatable("ErrorText",
                            "Export the file again; its beginning is damaged or of a variant that is not supported.")},
    .mayBePartlyReadable = true};

const ErrorDescription ErrorCode::VersionNewer{
    .id = "VersionNewer",
    .sentences = {translatable("ErrorText",
                               "the file has version %1 of the format; this program knows up to version %2")},
    .advice = {translatable("ErrorText", "Open it with a newer version of Handwheel.")}};

const ErrorDescription ErrorCode::DataTruncated{
    .id = "DataTruncated",
    .sentences = {translatable("ErrorText", "the file ends too early (%1: %2 expected, %3 found)"),
                  translatable("ErrorText", "the file ends too early (%1: %3 found)")},
    .advice = {kOpenReadableAdvice},
    .mayBePartlyReadable = true};

const ErrorDescription ErrorCode::CountMismatch{
    .id = "CountMismatch",
    .sentences = {translatable("ErrorText", "the file is inconsistent (%1: %2 expected, %3 found)")},
    .advice = {kOpenReadableAdvice},
    .mayBePartlyReadable = true};

const ErrorDescription ErrorCode::NumberMalformed{.id = "NumberMalformed",
                                                  .sentences = {translatable("ErrorText", "'%1' is not a number")},
                                                  .advice = {kOpenReadableAdvice},
                                                  .mayBePartlyReadable = true};

const ErrorDescription ErrorCode::NumberNotFinite{
    .id = "NumberNotFinite",
    .sentences = {translatable("ErrorText", "the coordinate '%1' is not a finite number")},
    .advice = {kOpenReadableAdvice},
    .mayBePartlyReadable = true};

const ErrorDescription ErrorCode::ElementMalformed{
    .id = "ElementMalformed",
    .sentences = {translatable("ErrorText", "the element '%1' is malformed: %2")},
    .advice = {translatable("ErrorText", "Correct the file at this position, or export it again.")}};

const ErrorDescription ErrorCode::ReferenceMissing{
    .id = "ReferenceMissing",
    .sentences = {translatable("ErrorText", "%1 '%2' was not found in the folder '%3' or in those above it"),
                  translatable("ErrorText", "%1 '%2' is referenced, but cannot be found")},
    .advice = {
        translatable("ErrorText", "Put the folder '%2' into '%3' or a folder above it, and open the file again."),
        translatable("ErrorText", "Put the missing file where it is expected.")}};

const ErrorDescription ErrorCode::ValueOutOfRange{
    .id = "ValueOutOfRange",
    .sentences = {translatable("ErrorText", "%1 cannot be %2; it must lie between %3 and %4")},
    .advice = {translatable("ErrorText", "Enter a value within these limits.")}};

const ErrorDescription ErrorCode::Unsupported{
    .id = "Unsupported",
    .sentences = {translatable("ErrorText", "%1 is not supported")},
    .advice = {translatable("ErrorText", "Export the model in another way or another format.")}};

const ErrorDescription ErrorCode::LibraryFailed{
    .id = "LibraryFailed",
    .sentences = {translatable("ErrorText", "the library %1 failed (%2)")},
    .advice = {translatable("ErrorText", "Export the model in another way or another format.")}};

}  // namespace handwheel
