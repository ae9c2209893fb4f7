// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/documents/DiscardedResult.h"

#include "document/Document.h"
#include "panels/MessageBar.h"

#include <QCoreApplication>

namespace handwheel {

namespace {
struct DiscardedResultWords {
  Q_DECLARE_TR_FUNCTIONS(DiscardedResult)
};
}  // namespace

Message discardedResultMessage(const QString& job, const Document& document) {
  Message said{Message::Weight::Warning, DiscardedResultWords::tr("“%1” has changed nothing").arg(job),
               DiscardedResultWords::tr("%1 was changed meanwhile, and the result was for its state before.")
                   .arg(document.name()),
               DiscardedResultWords::tr("Start it again if it is still wanted.")};
  said.about = &document;
  return said;
}

}  // namespace handwheel
