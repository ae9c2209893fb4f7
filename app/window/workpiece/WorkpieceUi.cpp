// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/WorkpieceUi.h"

#include "controls/QuantityText.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/WorkpieceProperties.h"
#include "fidelity/Cases.h"
#include "theme/Theme.h"
#include "window/documents/OpenDocument.h"
#include "window/fidelity/FidelityChoice.h"

#include <QLocale>

namespace handwheel {

namespace {

// "⌀ 50 mm × 100 mm"
QString sizeText(const Document& document) {
  const WorkpieceSnapshot& workpiece = static_cast<const WorkpieceDocument&>(document).workpiece();
  const LengthUnit unit = document.displayUnit();
  return QStringLiteral("⌀ %1 × %2")
      .arg(quantityText(workpiece.stock.diameter, Quantity::Length, unit, QLocale()),
           quantityText(workpiece.stock.length, Quantity::Length, unit, QLocale()));
}

}  // namespace

WorkpieceUi::WorkpieceUi(const WindowContext& parts) : RigidPartsUi(parts, {"Stock"}) {}

std::unique_ptr<OpenDocument> WorkpieceUi::open(std::unique_ptr<Document> document) {
  if (document->file().path.empty()) {
    const auto& blank = static_cast<const WorkpieceDocument&>(*document).workpiece();
    const double chord = parts().fidelity.values().of(chordSetting());
    auto begun = std::make_shared<const WorkpieceSnapshot>(withValue(blank, WorkpieceField::Chord, chord));
    document = document->kind().make({&document->kind(), document->file(), std::move(begun)});
  }
  return RigidPartsUi::open(std::move(document));
}

std::vector<StartAction> WorkpieceUi::startActions() const {
  return {{QStringLiteral("newWorkpiece"), tr("&New workpiece"), tr("Start with a cylinder to be turned"), panelIcon()},
          {QStringLiteral("openShaftSample"), tr("Open the sample s&haft"), tr("Open the sample shaft for the lathe"),
           panelIcon(), QStringLiteral("shaft-stock.handwheel"),
           StartTile{QStringLiteral("latheTile"), panelIcon(), tr("Lathe exercise"),
                     tr("A shaft for the lathe. Give it its size, save it as STEP.")}}};
}

NextStep WorkpieceUi::nextStep() {
  if (!document() || document()->document.history()->count() > 0) return {};
  return {panelIcon(), themeColours(currentTheme()).accent, tr("Stock of %1.").arg(sizeText(document()->document)),
          tr("Its panel takes other sizes, also as “2in” or “50/2”. “Save as” writes STEP, too."), panelActions()};
}

QString WorkpieceUi::statistics() const {
  return document() ? sizeText(document()->document) : QString();
}

QString WorkpieceUi::openedText(const OpenDocument& opened) const {
  return tr("Opened %1: stock %2").arg(opened.document.name(), sizeText(opened.document));
}

}  // namespace handwheel
