// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/workpiece/WorkpieceUi.h"

#include "controls/QuantityText.h"
#include "controls/ScrolledPanel.h"
#include "document/workpiece/TurnedPartDisplay.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/WorkpieceProperties.h"
#include "document/workpiece/exercise/AssignedTask.h"
#include "document/workpiece/exercise/TurningMeasurements.h"
#include "fidelity/Cases.h"
#include "machining/TurningFidelity.h"
#include "panels/MessageBar.h"
#include "theme/Theme.h"
#include "tools/workpiece/ManualLatheTool.h"
#include "tools/workpiece/TurnTool.h"
#include "viewport/Viewport.h"
#include "viewport/camera/CameraNavigation.h"
#include "viewport/surface/PartsLayer.h"
#include "window/JobRunner.h"
#include "window/WindowServices.h"
#include "window/documents/DocumentTab.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/haptics/HapticSceneBuilder.h"
#include "window/tools/ToolHost.h"
#include "window/workpiece/program/ProgramFile.h"

#include <QFileInfo>
#include <QLocale>
#include <QSplitter>
#include <algorithm>
#include <cmath>
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

std::size_t passesOf(const Document& document) {
  const auto& part = static_cast<const WorkpieceDocument&>(document).workpiece().part;
  return part ? part->passes.size() : 0;
}

// Returns a function that tells whether the last pass of a document was undone, as long as the document is open.
std::function<bool()> isUndone(const Document& document) {
  return [&document, passes = passesOf(document)] { return passesOf(document) < passes; };
}

// Returns true if the ends of a bar, and so the whole bar, are within the view.
bool isInView(const Viewport& view, const StockCylinder& stock) {
  constexpr int kSides = 64;
  const CameraNavigation navigation(view.camera(), {view.width(), view.height()});
  for (int i = 0; i < 2 * kSides; ++i) {
    const double angle = 2.0 * M_PI * (i / 2) / kSides, r = 0.5 * stock.diameter;
    const Vec3 p(r * std::cos(angle), r * std::sin(angle), stock.position + (i % 2 == 0 ? 0.0 : stock.length));
    if (!navigation.isBeforeEye(p)) return false;
    const Vec2 at = navigation.toScreen(p);
    if (!(at.x() >= 0.0 && at.x() <= view.width() && at.y() >= 0.0 && at.y() <= view.height())) return false;
  }
  return true;
}

}  // namespace

WorkpieceUi::WorkpieceUi(const WindowContext& window)
    : RigidPartsUi(window, {"Stock"}, StandardView::Lathe),
      m_target(window, this),
      m_dimensions(window, this),
      m_lathe(window, this),
      m_thread(window, this),
      m_program(window, this),
      m_replay(window, this),
      m_panel(makePanel()),
      m_loads(JobRunner::Policy::Latest, window.pool),
      m_sections(JobRunner::Policy::Latest, window.pool) {
  layer().setFaintGroup(kPartedGroup);
  connect(&m_target, &TargetActions::message, this, &KindUi::message);
  connect(&m_thread, &ThreadAction::message, this, &KindUi::message);
  connect(&m_target, &TargetActions::shownChanged, this, [this] {
    if (this->document()) show();
  });
  connect(&m_lathe, &LatheView::message, this, &KindUi::message);
  connect(&m_program, &ProgramDock::message, this, &KindUi::message);
  connect(&m_program, &ProgramDock::partShown, this, &WorkpieceUi::showInstead);
  connect(&m_replay, &ReplayDock::message, this, &KindUi::message);
  connect(&m_replay, &ReplayDock::partShown, this, &WorkpieceUi::showPast);
  connect(&window.tools, &ToolHost::updated, this, &WorkpieceUi::followTool);
  // When the tool shows the change, too, and it is in the history.
  connect(this, &KindUi::stateChanged, this, &WorkpieceUi::followSize, Qt::QueuedConnection);
  connect(this, &KindUi::stateChanged, this, &WorkpieceUi::tellParted, Qt::QueuedConnection);
  connect(this, &KindUi::stateChanged, this, &WorkpieceUi::explainLocks, Qt::QueuedConnection);
  connect(this, &KindUi::stateChanged, this, &WorkpieceUi::watchLoads, Qt::QueuedConnection);
  connect(this, &KindUi::stateChanged, this, &WorkpieceUi::prepareSection, Qt::QueuedConnection);
}

// The properties of the stock, and below them the target and the measured dimensions.
QWidget* WorkpieceUi::makePanel() {
  auto* panel = new QSplitter(Qt::Vertical, parts().window);
  panel->setObjectName(QStringLiteral("workpiecePanel"));
  panel->setChildrenCollapsible(false);
  panel->addWidget(RigidPartsUi::panel());
  panel->addWidget(new ScrolledPanel(m_target.panel(), ScrolledPanel::Directions::Vertical));
  panel->setStretchFactor(1, 2);
  return panel;
}

void WorkpieceUi::setDocument(DocumentTab* document) {
  m_replay.setDocument(document);
  m_target.setDocument(document);
  m_dimensions.setDocument(document);
  m_thread.setDocument(document);
  RigidPartsUi::setDocument(document);
  m_program.setDocument(document);
}

void WorkpieceUi::refreshVisibility() {
  RigidPartsUi::refreshVisibility();
  m_target.setVisible(document() && document()->visible);
  m_program.setVisible(document() && document()->visible);
  m_dimensions.setVisible(document() && document()->visible);
}

void WorkpieceUi::forget(DocumentTab* document) {
  m_loads.forget(&document->document);
  m_sections.forget(&document->document);
  m_loadedParts.erase(document);
  if (m_parted == document) {
    m_parted = nullptr;
    m_partedPart.reset();
  }
  m_program.forget(document);
}

DisplayModel WorkpieceUi::displayed(const Document& document) const {
  auto coloured = m_target.display(static_cast<const WorkpieceDocument&>(document).workpiece());
  return coloured ? std::move(*coloured) : RigidPartsUi::displayed(document);
}

// A new bar has the chord tolerance of this machine. The work of an exercise and recovered documents have their own.
std::unique_ptr<DocumentTab> WorkpieceUi::open(std::unique_ptr<Document> document) {
  const WorkpieceSnapshot& blank = static_cast<const WorkpieceDocument&>(*document).workpiece();
  if (document->file().path.empty() && !blank.part && blank.chord == WorkpieceSnapshot().chord) {
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
           StartTile{QStringLiteral("latheTile"), panelIcon(), tr("Turn a sample bar"),
                     tr("Opens a sample bar. Cut it to a shaft by hand, save it as STEP.")}}};
}

std::vector<ToolDescriptor> WorkpieceUi::tools() {
  return {{QStringLiteral("turnTool"), tr("&Turn"), tr("Cut the turning part by hand with a round tool"),
           QStringLiteral("turn"), QKeySequence(Qt::Key_V), [this] { return turnTool(); }, "turn", TurnTool::keys()},
          {QStringLiteral("latheTool"), tr("&Lathe"), tr("Work the part on a manual lathe with handwheels and levers"),
           QStringLiteral("turn"), QKeySequence(Qt::SHIFT | Qt::Key_V), [this] { return latheTool(); }, "lathe",
           ManualLatheTool::keys()},
          measureParts()};
}

std::unique_ptr<Tool> WorkpieceUi::turnTool() {
  auto& workpiece = static_cast<WorkpieceDocument&>(document()->document);
  const SimulationServices services{parts().servoClock, parts().services.simulation()};
  const FidelityValues& values = parts().fidelity.values();
  const auto task = assignedTask(workpiece.file().assigned);
  const TurnTool::Start start{values.of(turnSpacingSetting()),
                              static_cast<TurningMethod>(static_cast<int>(values.of(turnMethodSetting()))),
                              values.of(turnResolutionSetting()),
                              task && !task->tools.empty() ? task->tools.front().noseRadius : TurningTool().noseRadius,
                              task ? task->lathe.largestFeed : 0.0};
  return std::make_unique<TurnTool>(workpiece, services, start);
}

std::unique_ptr<Tool> WorkpieceUi::latheTool() {
  return m_lathe.make(static_cast<WorkpieceDocument&>(document()->document));
}

// The part is felt through the simulation of the tool, as long as there is one.
void WorkpieceUi::followTool() {
  const auto* const tool = dynamic_cast<const TurnTool*>(parts().tools.runner().tool());
  if (tool) warnOfFeed(*tool);
  const std::shared_ptr<TurningChannel> channel = tool ? tool->channel() : nullptr;
  const TurningTool settings = tool ? tool->settingsAtDevice() : TurningTool();
  const double base = tool ? tool->base() : 0.0;
  if (const bool isLathe = m_lathe.isOn(); std::exchange(m_isLathe, isLathe) != isLathe) setFelt(!isLathe && !channel);
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

// Once for each pass: it counts when the work is marked.
void WorkpieceUi::warnOfFeed(const TurnTool& tool) {
  const std::size_t passes = passesOf(document()->document);
  if (std::exchange(m_passes, passes) >= passes || !tool.tooFast()) return;
  const QLocale locale;
  Message fast{Message::Weight::Warning, tr("Too fast"),
               tr("The feed of this pass was up to %1 mm per revolution; at most %2 is allowed.")
                   .arg(locale.toString(*tool.tooFast(), 'f', 1), locale.toString(tool.largestFeed())),
               tr("Undo it, and drag more slowly: f at the pointer is the feed.")};
  fast.about = &document()->document;
  fast.isOver = isUndone(document()->document);
  emit message(fast);
}

// Computes the loads of new passes on the lathe of the exercise, by the law of its marks; on a worker thread after
// each.
void WorkpieceUi::watchLoads() {
  if (!document()) return;
  const WorkpieceSnapshot& workpiece = static_cast<const WorkpieceDocument&>(document()->document).workpiece();
  const auto passesOf = [](const TurnedPart* part) { return part ? part->passes.size() : 0; };
  // After undo, or when a document is shown for the first time, no pass is new.
  auto& loaded = m_loadedParts.emplace(document(), workpiece.part).first->second;
  if (passesOf(workpiece.part.get()) <= passesOf(loaded.get())) loaded = workpiece.part;
  const auto task = loaded == workpiece.part ? nullptr : assignedTask(document()->document.file().assigned);
  if (!task) return;
  Job job;
  job.name = tr("Checking force and power");
  job.document = &document()->document;
  job.work = [this, task, workpiece, before = loaded, document = document()](Progress progress) -> Job::Finish {
    const auto peaks = peakLoads(*task, workpiece, before.get(), progress);
    if (!peaks) return {};
    return [this, task, document, part = workpiece.part, found = *peaks] {
      // Undone or cut on since: the part of now is looked at by its own job.
      if (static_cast<const WorkpieceDocument&>(document->document).workpiece().part != part) return;
      m_loadedParts[document] = part;
      warnOfLoads(document, *task, found.first, found.second);
    };
  };
  m_loads.start(std::move(job));
}

// The properties show the volume of the section as soon as it is known.
void WorkpieceUi::prepareSection() {
  if (!document()) return;
  const auto part = static_cast<const WorkpieceDocument&>(document()->document).workpiece().part;
  if (!part || part->profile.section()->isKnown()) return;
  Job job;
  job.name = tr("Measuring the part");
  job.document = &document()->document;
  job.work = [this, source = part->profile.section()](Progress progress) -> Job::Finish {
    if (!source->prepare(progress)) return {};
    return [this] { emit stateChanged(); };
  };
  m_sections.start(std::move(job));
}

// Once for each pass; it goes with the next one, or when it is undone.
void WorkpieceUi::warnOfLoads(DocumentTab* loaded, const TurningTask& task, double force, double power) {
  const QLocale locale;
  QStringList lines;
  if (force > task.forceLimit)
    lines << tr("The resultant force of this pass was up to %1 N; the lathe of the exercise allows %2 N.")
                 .arg(locale.toString(force, 'f', 0), locale.toString(task.forceLimit, 'f', 0));
  if (power > task.powerLimit)
    lines << tr("The motor power of this pass was up to %1 kW; the lathe of the exercise has %2 kW.")
                 .arg(locale.toString(power, 'f', 2), locale.toString(task.powerLimit, 'f', 2));
  if (lines.isEmpty()) return;
  const AssignedExercise& exercise = loaded->document.file().assigned;
  const bool lowersMarks = (force > task.forceLimit && isMarked(exercise, "force")) ||
                           (power > task.powerLimit && isMarked(exercise, "power"));
  Message heavy{Message::Weight::Warning, tr("Too heavy a cut"), lines.join(QLatin1Char(' ')),
                lowersMarks ? tr("It is in the report, and lowers the marks. Undo it, and use a smaller depth or feed.")
                            : tr("It is in the report. Undo it, and use a smaller depth or feed.")};
  heavy.about = &loaded->document;
  heavy.isOver = [loaded, of = m_loadedParts[loaded]] {
    return static_cast<const WorkpieceDocument&>(loaded->document).workpiece().part != of;
  };
  emit message(heavy);
}

// Tells once for each piece that has come off; the piece is shown faintly where it was.
void WorkpieceUi::tellParted() {
  if (!document()) return;
  const auto part = static_cast<const WorkpieceDocument&>(document()->document).workpiece().part;
  const auto before = std::exchange(m_partedPart, part);
  const bool isOther = std::exchange(m_parted, document()) != document();
  if (isOther || part == before || !part) return;
  if (part->profile.pieces().size() < 2) return;
  const std::vector<TurnedSection> pieces = part->section().pieces();
  const std::vector<TurnedSection> parted = part->partedSince(before.get());
  if (parted.empty() || (before && before->section().pieces().size() >= pieces.size())) return;
  const TurnedSection& piece = parted.front();
  const double kept = part->volumeOf(pieces.front());
  const QLocale locale;
  const QString length = locale.toString(piece.box().sizes().y(), 'f', 2);
  const bool isAtEnd = piece.box().min().y() == pieces.back().box().min().y();
  Message off{Message::Weight::Info, tr("Parted off"),
              isAtEnd ? tr("A piece of %1 mm length has come off at the free end.").arg(length)
                      : tr("A piece of %1 mm length has come off.").arg(length),
              (isAtEnd ? tr("Its volume is %1 mm³; %2 mm³ stay in the chuck. Dimensions and exported drawings and STEP "
                            "files are those of the piece.")
                       : tr("Its volume is %1 mm³; %2 mm³ stay in the chuck. Dimensions and exported drawings and STEP "
                            "files are still those of the piece at the free end, which came off before."))
                  .arg(locale.toString(part->volumeOf(piece), 'f', 0), locale.toString(kept, 'f', 0))};
  off.about = &document()->document;
  off.isOver = isUndone(document()->document);
  emit message(off);
}

// A bar that was wholly in view stays so in another size. Otherwise the camera is left alone.
void WorkpieceUi::followSize() {
  if (!document()) return;
  const StockCylinder& stock = static_cast<const WorkpieceDocument&>(document()->document).workpiece().stock;
  const StockCylinder before = std::exchange(m_size, stock);
  const bool isSame = before.diameter == stock.diameter && before.length == stock.length;
  if (std::exchange(m_sized, document()) != document() || isSame) return;
  Viewport& view = parts().viewport;
  if (isInView(view, before) && !isInView(view, stock)) view.fit();
}

// A field that has become read-only is another one, and the old may be there still.
void WorkpieceUi::explainLocks() {
  if (!document()) return;
  const bool isCut = static_cast<const WorkpieceDocument&>(document()->document).workpiece().part != nullptr;
  const bool isAssigned = static_cast<bool>(document()->document.file().assigned);
  const QString reason = document()->document.history()->canUndo() ? tr("Undo the passes to change the size.")
                                                                   : tr("It was cut already, so its size is fixed.");
  for (const char* field : {"property/diameter", "property/length"}) {
    for (QWidget* row : panel()->findChildren<QWidget*>(QString::fromLatin1(field)))
      row->setToolTip(isAssigned ? tr("The bar is that of the exercise.") : isCut ? reason : QString());
  }
}

Suggestion WorkpieceUi::suggestion() {
  if (!document() || document()->document.history()->count() > 0) return {};
  const bool isCut = static_cast<const WorkpieceDocument&>(document()->document).workpiece().part != nullptr;
  const bool isAssigned = static_cast<bool>(document()->document.file().assigned);
  return {panelIcon(), themeColours(currentTheme()).accent, tr("Stock of %1.").arg(sizeText(document()->document)),
          isAssigned
              ? tr("It is the bar of the exercise. The panel “Lesson” says what to do; “Turn” and “Lathe” cut it.")
          : isCut ? tr("It was cut already, so its size is fixed. “Save as” writes STEP, too.")
                  : tr("Enter another size in its panel, also as “2in” or “50/2”. “Save as” writes STEP, too."),
          panelActions()};
}

std::optional<CompanionFiles::Offer> WorkpieceUi::companionOffer(const QString& path) const {
  if (!isProgramName(path)) return {};
  return Offer{tr("%1 is a program for a lathe").arg(QFileInfo(path).fileName()),
               tr("A program is opened in the program editor of the workpiece that it turns."),
               tr("Open that workpiece first, then the program, or open the program on a new bar."),
               tr("Open on a new bar")};
}

QString WorkpieceUi::companionFilter() const {
  return tr("Programs (%1)").arg(programNameFilter());
}

QString WorkpieceUi::statistics() const {
  return document() ? sizeText(document()->document) : QString();
}

QString WorkpieceUi::openedText(const DocumentTab& opened) const {
  return tr("Opened %1: stock %2").arg(opened.document.name(), sizeText(opened.document));
}

}  // namespace handwheel
