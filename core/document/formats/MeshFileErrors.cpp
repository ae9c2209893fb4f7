// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/MeshFileErrors.h"

namespace handwheel {

const ErrorDescription MeshFileError::NothingReadable{
    .id = "NothingReadable",
    .sentences = {translatable("ErrorText", "the file is damaged here, and none of its triangles can be read")},
    .advice = {translatable("ErrorText", "Export or copy the file again.")}};

const ErrorDescription MeshFileError::TextEncoding{
    .id = "TextEncoding",
    .sentences = {translatable("ErrorText", "the text is in %1, which cannot be read")},
    .advice = {translatable("ErrorText", "Save the file as UTF-8 text or in a binary format.")}};

const ErrorDescription MeshFileError::TokenUnexpected{
    .id = "TokenUnexpected",
    .sentences = {translatable("ErrorText", "%1 was expected, '%2' was found"),
                  translatable("ErrorText", "%1 was expected, but nothing follows"),
                  translatable("ErrorText", "'%2' is not valid here")},
    .advice = {kOpenReadableAdvice},
    .mayBePartlyReadable = true};

const ErrorDescription MeshFileError::TypeUnknown{
    .id = "TypeUnknown",
    .sentences = {translatable("ErrorText", "the data type '%1' is not known")},
    .advice = {translatable("ErrorText",
                            "Export the file again; its beginning is damaged or of a variant that is not supported.")}};

const ErrorDescription MeshFileError::IndexOutOfRange{
    .id = "IndexOutOfRange",
    .sentences = {translatable("ErrorText", "a face uses vertex %1, but the file has %2 vertices")},
    .advice = {kOpenReadableAdvice},
    .mayBePartlyReadable = true};

const ErrorDescription MeshFileError::VertexUnreadable{
    .id = "VertexUnreadable",
    .sentences = {translatable("ErrorText", "a face uses vertex %1, which could not be read")},
    .advice = {kOpenReadableAdvice},
    .mayBePartlyReadable = true};

const ErrorDescription MeshFileError::PolygonTooSmall{
    .id = "PolygonTooSmall",
    .sentences = {translatable("ErrorText", "a face has fewer than three corners (%1)")},
    .advice = {kOpenReadableAdvice},
    .mayBePartlyReadable = true};

const ErrorDescription MeshFileError::PolygonTooComplex{
    .id = "PolygonTooComplex",
    .sentences = {translatable("ErrorText", "a face with %1 corners was triangulated as if it were convex")},
    .advice = {translatable("ErrorText", "Check the shape of that face, or export the model as triangles.")}};

}  // namespace handwheel
