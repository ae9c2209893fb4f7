// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/MeshMessages.h"

#include "document/mesh/MeshDocument.h"
#include "document/mesh/UnitDoubt.h"
#include "text/NoteText.h"
#include "window/documents/FileLoader.h"

#include <QCoreApplication>

namespace handwheel {

namespace {

struct MeshMessagesWords {
  Q_DECLARE_TR_FUNCTIONS(MeshUi)
};

}  // namespace

Message nothingChangedMessage(const MeshDocument& document, const QString& what, const QString& why) {
  return {.weight = Message::Weight::Warning,
          .title = MeshMessagesWords::tr("%1: nothing was changed").arg(what),
          .detail = why,
          .about = &document,
          .isOver = [&document, then = document.revision()] { return document.revision() != then; }};
}

Message partlyChangedMessage(const MeshDocument& document, const QString& what, const QString& how) {
  return {.weight = Message::Weight::Warning,
          .title = MeshMessagesWords::tr("%1: some sheets stay open").arg(what),
          .detail = how + QLatin1Char('.'),
          .about = &document,
          .isOver = [&document, then = document.revision()] { return document.revision() != then; }};
}

std::optional<Message> unitDoubtMessage(const MeshDocument& document) {
  const auto isDoubtful = [&document] { return isUnitDoubtful(document.file(), document.defects().box); };
  if (!isDoubtful()) return std::nullopt;
  return Message{.weight = Message::Weight::Warning,
                 .title = MeshMessagesWords::tr("Is %1 in millimetres?").arg(document.name()),
                 .detail = noteText(unitDoubt(document.defects().box)),
                 .advice = MeshMessagesWords::tr("Lengths, such as a wall thickness, depend on it. Change the unit "
                                                 "before you repair."),
                 .actionText = MeshMessagesWords::tr("Change unit…"),
                 .about = &document,
                 .topic = kOpeningTopic,
                 .isOver = [isDoubtful] { return !isDoubtful(); }};
}

}  // namespace handwheel
