// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/workpiece/WorkpieceErrors.h"

namespace handwheel {

const ErrorDescription WorkpieceError::SizeFixed{
    .id = "SizeFixed",
    .sentences = {translatable("ErrorText", "the bar was cut already, so its size cannot change")},
    .advice = {translatable("ErrorText", "Undo the passes to change the size, or begin with a new workpiece.")}};

const ErrorDescription WorkpieceError::SeveralPieces{
    .id = "SeveralPieces",
    .sentences = {translatable("ErrorText", "the part is in %1 pieces, and the file can contain only one solid")},
    .advice = {translatable("ErrorText", "Undo the pass that separated it, or export triangles, for example STL.")}};

const ErrorDescription WorkpieceError::ClosedHollow{
    .id = "ClosedHollow",
    .sentences = {translatable("ErrorText", "the part has %1 closed hollows, which the file cannot contain")},
    .advice = {translatable("ErrorText", "Bore the part open from an end, or export triangles, for example STL.")}};

}  // namespace handwheel
