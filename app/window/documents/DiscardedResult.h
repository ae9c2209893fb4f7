// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace handwheel {

class Document;
struct Message;

// Returns the message that a result was discarded, as its document was changed meanwhile. job: the name of the job.
Message discardedResultMessage(const QString& job, const Document& document);

}  // namespace handwheel
