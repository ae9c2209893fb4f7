// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/WorkpieceUi.h"

#include "controls/QuantityText.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/WorkpieceProperties.h"
#include "fidelity/Cases.h"
#include "machining/TurningFidelity.h"
#include "theme/Theme.h"
#include "tools/workpiece/TurnTool.h"
#include "window/WindowServices.h"
#include "window/documents/DocumentTab.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/haptics/HapticSceneBuilder.h"
#include "window/tools/ToolHost.h"

#include <QLocale>
#include <utility>

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

WorkpieceUi::WorkpieceUi(const WindowContext& window) : RigidPartsUi(window, {"Stock"}) {
  connect(&window.tools, &ToolHost::updated, this, &WorkpieceUi::followTool);
}

std::unique_ptr<DocumentTab> WorkpieceUi::open(std::unique_ptr<Document> document) {
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

std::vector<ToolDescriptor> WorkpieceUi::tools() {
  return {{QStringLiteral("turnTool"), tr("&Turn"), tr("Cut the turning part by hand with a round tool"),
           QStringLiteral("turn"), QKeySequence(Qt::Key_V), [this] { return turnTool(); }, "turn", TurnTool::keys()},
          measureParts()};
}

std::unique_ptr<Tool> WorkpieceUi::turnTool() {
  auto& workpiece = static_cast<WorkpieceDocument&>(document()->document);
  const SimulationServices services{parts().servoClock, parts().services.simulation()};
  return std::make_unique<TurnTool>(workpiece, services, parts().fidelity.values().of(turnSpacingSetting()));
}

// The part is felt through the simulation of the tool, as long as there is one.
void WorkpieceUi::followTool() {
  const auto* const tool = dynamic_cast<const TurnTool*>(parts().tools.runner().tool());
  const std::shared_ptr<TurningChannel> channel = tool ? tool->channel() : nullptr;
  const TurningTool settings = tool ? tool->settingsAtDevice() : TurningTool();
  const double base = tool ? tool->base() : 0.0;
  if (channel == m_felt && settings == m_feltSettings && base == m_feltBase) return;
  m_feltSettings = settings;
  setFelt(channel == nullptr);
  const bool isSame = std::exchange(m_felt, channel) == channel, isThere = std::exchange(m_feltBase, base) == base;
  if (!channel) return parts().touch.setSource(kTurningSource, {}, false);
  const auto make = [channel, settings, base](const TouchContext& context) {
    TurningTool inScene = settings;
    inScene.stiffness = context.mapping.sceneStiffness(context.touch.stiffness);
    inScene.resistance = context.mapping.sceneStiffness(settings.resistance);
    return std::make_unique<TurningForce>(channel, inScene, base);
  };
  parts().touch.setSource(kTurningSource, make, isSame && isThere);
}

NextStep WorkpieceUi::nextStep() {
  if (!document() || document()->document.history()->count() > 0) return {};
  const bool isCut = static_cast<const WorkpieceDocument&>(document()->document).workpiece().part != nullptr;
  return {panelIcon(), themeColours(currentTheme()).accent, tr("Stock of %1.").arg(sizeText(document()->document)),
          isCut ? tr("It was cut already, so its size is fixed. “Save as” writes STEP, too.")
                : tr("Its panel takes other sizes, also as “2in” or “50/2”. “Save as” writes STEP, too."),
          panelActions()};
}

QString WorkpieceUi::statistics() const {
  return document() ? sizeText(document()->document) : QString();
}

QString WorkpieceUi::openedText(const DocumentTab& opened) const {
  return tr("Opened %1: stock %2").arg(opened.document.name(), sizeText(opened.document));
}

}  // namespace handwheel
