// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "document/Operation.h"
#include "document/scene/BodyImport.h"
#include "scene/BodySet.h"

namespace handwheel {

// The operation "body" on a document that holds bodies: adds one, removes it, reads its linked file again or cuts the
// link. A body is named by its name or its number.
const Operation& bodyOperation();

// What is wrong with a combination of values, as a clause; empty when they fit together.
std::string problemOfBodyValues(const OperationValues& values);

// An edit of bodies, with the file that was read for it.
struct BodyChange {
  std::unique_ptr<Edit> edit;  // null: nothing changes
  DocumentFile file = {};      // with damage, losses and notes; empty when none was read
};

// Creates the edit for values that fit together. folder: of the document; empty for one that was never saved. Errors:
// those of readBody(), updatedFromLink(), addBodyEdit(); BodyMissing; NumberMalformed.
Result<BodyChange> bodyChange(const OperationValues& values, const BodySet& bodies, const DocumentKinds& kinds,
                              const std::filesystem::path& folder, Progress progress = {});

}  // namespace handwheel
