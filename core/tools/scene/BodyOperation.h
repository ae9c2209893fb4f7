// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "document/Edit.h"
#include "document/Operation.h"
#include "document/scene/BodyImport.h"
#include "scene/BodySet.h"

namespace handwheel {

// Returns the operation "body", which edits the bodies of a document. It adds a body, removes one, reads the linked
// file of a body again, links a body to another file or cuts its link. A body is given by its name or its number.
const Operation& bodyOperation();

// Returns the body with this name, or else the body with this number. Errors: BodyMissing; Ambiguous if the text fits
// two bodies.
Result<BodyPointer> bodyCalled(const BodySet& bodies, const std::string& text);

// Returns the fault of a combination of values as a clause; the clause is empty if the values fit together.
std::string problemOfBodyValues(const OperationValues& values);

// An edit of bodies, with the file that was read for it.
struct BodyChange {
  std::unique_ptr<Edit> edit;  // Null: nothing changes
  DocumentFile file = {};      // The file that was read, with damage, losses and notes; empty if no file was read
  std::string name = {};       // Name of the body that changes
};

// Returns true if a file has to be read for these values. Reading may take long.
bool readsFile(const OperationValues& values);

// Returns the new body, or the present body read again from its file, as the values ask. For values that remove a body
// or cut its link, the result is empty. May be called on any thread. folder: the folder of the document; empty if the
// document was never saved. Errors: BodyMissing, Ambiguous, NumberMalformed, and the errors of readBody() and
// updatedFromLink().
Result<ImportedBody> bodyFrom(const OperationValues& values, const BodySet& bodies, const DocumentKinds& kinds,
                              const std::filesystem::path& folder, Progress progress = {});

// Creates the edit for values that fit together. read: the result of bodyFrom(). Errors: BodyMissing, Ambiguous, and
// the errors of addBodyEdit().
Result<BodyChange> bodyChange(const OperationValues& values, const BodySet& bodies, ImportedBody read);

// Creates the edit for values that fit together. This overload calls bodyFrom() itself.
Result<BodyChange> bodyChange(const OperationValues& values, const BodySet& bodies, const DocumentKinds& kinds,
                              const std::filesystem::path& folder, Progress progress = {});

}  // namespace handwheel
