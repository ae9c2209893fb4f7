// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "document/Operation.h"
#include "document/scene/BodyImport.h"
#include "scene/BodySet.h"

namespace handwheel {

// Returns the operation "body", which edits the bodies of a document. It adds one, removes it, reads its linked file
// again, links it to another or cuts the link. A body is given by its name or its number.
const Operation& bodyOperation();

// Returns the body with this name, or else this number. Errors: BodyMissing; Ambiguous if these are two.
Result<BodyPointer> bodyCalled(const BodySet& bodies, const std::string& text);

// Returns the fault of a combination of values, as a clause; empty if they fit together.
std::string problemOfBodyValues(const OperationValues& values);

// An edit of bodies, with the file that was read for it.
struct BodyChange {
  std::unique_ptr<Edit> edit;  // Null: nothing changes
  DocumentFile file = {};      // With damage, losses and notes; empty if none was read
  std::string name = {};       // Name of the body that changes
};

// Returns true if a file has to be read for the values, which may take long.
bool readsFile(const OperationValues& values);

// Returns the body that the values make, or read anew for the present one; an empty one for other values. Any thread.
// folder: of the document; empty for one that was never saved. Errors: those of readBody(), updatedFromLink();
// BodyMissing, Ambiguous; NumberMalformed.
Result<ImportedBody> bodyFrom(const OperationValues& values, const BodySet& bodies, const DocumentKinds& kinds,
                              const std::filesystem::path& folder, Progress progress = {});

// Creates the edit for values that fit together, with the result of bodyFrom(). Errors: BodyMissing, Ambiguous; those
// of addBodyEdit().
Result<BodyChange> bodyChange(const OperationValues& values, const BodySet& bodies, ImportedBody read);

// Calls bodyFrom() and the function above.
Result<BodyChange> bodyChange(const OperationValues& values, const BodySet& bodies, const DocumentKinds& kinds,
                              const std::filesystem::path& folder, Progress progress = {});

}  // namespace handwheel
