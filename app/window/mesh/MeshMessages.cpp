// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/mesh/MeshMessages.h"

#include "document/mesh/ImplausibleUnit.h"
#include "document/mesh/MeshDocument.h"
#include "text/ErrorText.h"
#include "text/NoteText.h"
#include "window/documents/FileLoader.h"
#include "window/mesh/repair/RepairJobs.h"

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

Message notDrilledMessage(const MeshDocument& document, const QString& why, std::function<void()> makeVolume) {
  return {.weight = Message::Weight::Warning,
          .title = MeshMessagesWords::tr("The mesh cannot be drilled"),
          .detail = MeshMessagesWords::tr("Why: %1.").arg(why),
          .advice = MeshMessagesWords::tr("A volume of the part can be drilled in any case."),
          .actionText = MeshMessagesWords::tr("Make a volume"),
          .action = std::move(makeVolume),
          .about = &document,
          .isOver = [&document, then = document.revision()] { return document.revision() != then; }};
}

Message changeMessage(const MeshDocument& document, const QString& text, const QString& how) {
  return {.weight = Message::Weight::Info,
          .title = text,
          .detail = how.left(1).toUpper() + how.mid(1) + QLatin1Char('.'),
          .about = &document,
          .isOver = [&document, then = document.revision()] { return document.revision() != then; }};
}

Message partRemovedMessage(const MeshDocument& document, const QString& what, const QString& warning,
                           std::function<void()> undo) {
  return {.weight = Message::Weight::Warning,
          .title = MeshMessagesWords::tr("%1: check what was removed").arg(what),
          .detail = warning,
          .actionText = RepairJobs::tr("Undo"),
          .action = std::move(undo),
          .about = &document,
          .comesFirst = true,
          .isOver = [&document, then = document.revision()] { return document.revision() != then; }};
}

Message piecesDeletedMessage(const MeshDocument& document, std::size_t pieces, std::size_t faces,
                             std::function<void()> undo) {
  return {.weight = Message::Weight::Info,
          .title = RepairJobs::tr("%Ln whole piece(s) deleted", nullptr, static_cast<int>(pieces)),
          .detail = RepairJobs::tr("%Ln triangle(s) were removed from %1.", nullptr, static_cast<int>(faces))
                        .arg(document.name()),
          .actionText = RepairJobs::tr("Undo"),
          .action = std::move(undo),
          .about = &document,
          .isOver = [&document, then = document.revision()] { return document.revision() != then; }};
}

Message jobFailedMessage(const Document& document, const QString& job, const Error& error) {
  const QString advice = error.code == ErrorCode::OutOfMemory
                             ? errorAdvice(error)
                             : RepairJobs::tr("Save your work, and try it on a smaller part or in another way.");
  return {.weight = Message::Weight::Error,
          .title = RepairJobs::tr("%1 failed").arg(job),
          .detail = errorSentence(error),
          .advice = RepairJobs::tr("The document is as it was before. %1").arg(advice),
          .about = &document};
}

std::optional<Message> implausibleUnitMessage(const MeshDocument& document) {
  const auto isImplausible = [&document] { return isUnitImplausible(document.file(), document.defects().box); };
  if (!isImplausible()) return std::nullopt;
  return Message{.weight = Message::Weight::Warning,
                 .title = MeshMessagesWords::tr("Is %1 in millimetres?").arg(document.name()),
                 .detail = noteText(implausibleUnit(document.defects().box)),
                 .advice = MeshMessagesWords::tr("Lengths, such as a wall thickness, depend on it. Change the unit "
                                                 "before you repair."),
                 .actionText = MeshMessagesWords::tr("Change unit…"),
                 .about = &document,
                 .topic = kOpeningTopic,
                 .isOver = [isImplausible] { return !isImplausible(); }};
}

}  // namespace handwheel
