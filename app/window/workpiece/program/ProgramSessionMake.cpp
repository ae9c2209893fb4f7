// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Programs that are written for the user: of passes, and for a target.
#include "controls/program/ProgramEditor.h"
#include "document/workpiece/LatheSetupEdit.h"
#include "document/workpiece/PassesProgram.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/WorkpieceDocument.h"
#include "document/workpiece/target/TargetPosition.h"
#include "machining/TurningFidelity.h"
#include "machining/lathe/LatheJson.h"
#include "machining/lathe/LatheMounting.h"
#include "machining/program/cycles/BoreCuts.h"
#include "machining/program/cycles/CycleProgram.h"
#include "panels/LogModel.h"
#include "panels/MessageBar.h"
#include "text/ErrorWords.h"
#include "tools/workpiece/PassNames.h"
#include "window/documents/DocumentTab.h"
#include "window/fidelity/FidelityChoice.h"
#include "window/workpiece/program/NumbersDialog.h"
#include "window/workpiece/program/ProgramSession.h"
#include "window/workpiece/program/ToolTableDialog.h"

#include <QCoreApplication>
#include <QLocale>

namespace handwheel {

void ProgramSession::askForPasses() {
  if (isRefused()) return;
  auto* dialog = new NumbersDialog(
      tr("Program from passes"),
      tr("The passes that cut this part become a program in the chosen dialect, with their feed per revolution. It is "
         "shown in the editor; undo restores the present text."),
      tr("&Write"),
      {{"passesSpindle", tr("Spindle speed"), tr("r/min"), recordedSpindle(workpiece().workpiece()), 1.0,
        kMostSpindle}},
      m_parts.window);
  dialog->setObjectName(QStringLiteral("passesDialog"));
  connect(dialog, &NumbersDialog::chosen, this,
          [this](const std::vector<double>& numbers) { writePasses(numbers.front()); });
  dialog->open();
}

void ProgramSession::writePasses(double spindle) {
  Job job;
  job.name = tr("Writing the program");
  job.failed = [this](const Error& error) { fail(tr("The passes cannot be written as a program"), error); };
  job.work = [this, spindle, start = workpiece().workpiece(), dialect = m_panel->dialect(),
              failed = job.failed](Progress) -> Job::Finish {
    PassProgram how;
    how.spindle = spindle;
    how.post = start.programPost;
    const Result<PassesProgram> program = passesProgram(start, dialect, how);
    if (!program) return [failed, error = program.error()] { failed(error); };
    return [this, made = *program] {
      offer(made.text, made.tools);
      warnOfLeftOut(made.leftOut);
    };
  };
  m_runs.start(std::move(job));
}

void ProgramSession::warnOfLeftOut(const std::vector<LeftOutPass>& passes) {
  constexpr std::size_t kMostInMessage = 3;
  if (passes.empty()) return;
  QStringList lines;
  for (std::size_t i = 0; i < std::min(passes.size(), kMostInMessage); ++i) {
    const LeftOutPass& pass = passes[i];
    const QString name = passName(pass.tool.get(), TurningSide::Outside, QString::number(pass.number));
    lines << tr("%1: %2").arg(name, QCoreApplication::translate("LathePart", sentenceOf(pass.reason)));
  }
  if (passes.size() > kMostInMessage) lines << tr("The others are named at the head of the program.");
  Message warning{Message::Weight::Warning,
                  tr("%n pass(es) were left out of the program", nullptr, static_cast<int>(passes.size())),
                  lines.join(QLatin1Char(' ')), tr("Do their work by hand, after the program.")};
  warning.about = &m_document.document;
  emit message(warning);
}

void ProgramSession::askForCycles() {
  if (isRefused()) return;
  CycleSettings usual;
  usual.nose = noseOfExercise().value_or(usual.nose);
  const auto& target = workpiece().workpiece().target;
  const double drill = target ? drillFor(target->profile, shippedLatheTools()) : 0.0;
  auto* dialog = new NumbersDialog(
      tr("Rough and finish"),
      tr("Writes a program that makes the target from this part, a bore included, through or blind. It is simulated "
         "first, and refused where it collides or cuts into the target."),
      tr("&Write"),
      {{"cyclesDepth", tr("Depth of cut"), tr("mm"), usual.depth, 0.02, 100.0,
        tr("Depth of a roughing cut, on the radius")},
       {"cyclesAllowance", tr("Allowance"), tr("mm"), usual.allowance, 0.0, 10.0,
        tr("Allowance for the finishing cut")},
       {"cyclesNose", tr("Nose radius"), tr("mm"), usual.nose, TurningPass::kLeastNose, TurningPass::kLargestNose},
       {"cyclesRoughFeed", tr("Feed of roughing"), tr("mm/rev"), usual.roughFeed, 1e-3, 10.0},
       {"cyclesFinishFeed", tr("Feed of finishing"), tr("mm/rev"), usual.finishFeed, 1e-3, 10.0},
       {"cyclesSpeed", tr("Surface speed"), tr("m/min"), usual.speed, 1.0, 5000.0},
       {"cyclesMostSpindle", tr("Largest spindle speed"), tr("r/min"), usual.mostSpindle, 1.0, kMostSpindle},
       {"cyclesDrill", tr("Drill for the bore"), tr("mm"), drill, 0.0, 100.0,
        tr("Diameter. A bore, through or blind, is drilled, roughed and finished with a boring bar; 0 leaves it as it "
           "is.")}},
      m_parts.window);
  dialog->setObjectName(QStringLiteral("cyclesDialog"));
  connect(dialog, &NumbersDialog::chosen, this, &ProgramSession::writeCycles);
  dialog->open();
}

void ProgramSession::writeCycles(const std::vector<double>& numbers) {
  CycleSettings settings;
  double* const fields[] = {&settings.depth,      &settings.allowance, &settings.nose,        &settings.roughFeed,
                            &settings.finishFeed, &settings.speed,     &settings.mostSpindle, &settings.drill};
  std::size_t next = 0;
  for (double* field : fields) *field = numbers[next++];
  settings.post = workpiece().workpiece().programPost;
  const double spacing = m_parts.fidelity.values().of(turnSpacingSetting());
  Job job;
  job.name = tr("Writing and simulating the cycles");
  job.failed = [this](const Error& error) { fail(tr("There are no cycles for this target"), error); };
  job.work = [this, settings, spacing, start = workpiece().workpiece(), dialect = m_panel->dialect(),
              failed = job.failed](Progress progress) -> Job::Finish {
    if (!start.target) return {};
    const TurnedProfile part = partOf(start, spacing).profile;
    const LatheTools tools = shippedLatheTools();
    const CycleTask task{start.target->profile,
                         start.stock,
                         part,
                         start.stock.position,
                         latheOf(start).chuck.grip,
                         tools,
                         programSetupFor(start, tools, dialect, settings.nose).lathe,
                         programAllowance(start)};
    const Result<CycleProgram> program = cycleProgram(task, dialect, settings, progress);
    if (!program) return [failed, error = program.error()] { failed(error); };
    return [this, made = *program, target = start.target, drill = settings.drill] {
      offer(made.text, made.tools);
      warnOfRest(made.rest, target->profile, drill);
    };
  };
  m_runs.start(std::move(job));
}

void ProgramSession::warnOfRest(const CycleRest& rest, const TargetProfile& target, double drill) {
  if (!rest.isConsiderable()) return;
  const QString height = QLocale().toString(rest.height, 'f', 1), z = QLocale().toString(rest.z, 'f', 1);
  Message warning{Message::Weight::Warning, tr("The program leaves material over the target"),
                  rest.isInBore ? tr("In the bore it is up to %1 mm, at Z %2 mm.").arg(height, z)
                                : tr("It is up to %1 mm, at Z %2 mm.").arg(height, z),
                  tr("Cut the rest by hand, or by a program of your own.")};
  if (rest.isInBore && drill == 0.0) {
    const LatheTools tools = shippedLatheTools();
    if (const double fitting = drillFor(target, tools); fitting > 0.0) {
      warning.advice = tr("Choose a drill of %1 mm for the bore.").arg(QLocale().toString(fitting));
    } else if (const std::optional<Error> why = whyNoDrill(target, tools)) {
      const auto argument = [&why](std::size_t i) { return errorArgument(QString::fromStdString(why->arguments[i])); };
      warning.detail += QLatin1Char(' ') + tr("No drill makes it: %1.").arg(argument(2));
      warning.advice = argument(3);
    }
  }
  warning.about = &m_document.document;
  emit message(warning);
}

// The tools that an exercise does not provide are not offered.
void ProgramSession::askForTools() {
  const LatheTools shipped = shippedLatheTools();
  const LatheSetup lathe = latheOf(workpiece().workpiece());
  LatheTools bodies, post;
  for (const auto& tool : shipped)
    if (isAllowed(lathe, tool->id) && !tool->isAbrasive()) bodies.push_back(tool);
  for (const LatheSlot& slot : lathe.stations)
    if (auto tool = toolNamed(bodies, slot.tool)) post.push_back(std::move(tool));
  ProgramTools tools = m_tools;
  for (auto& [number, tool] : tools)
    if (tool.body) tool.body = toolNamed(bodies, tool.body->id);
  auto* dialog = new ToolTableDialog(tools, std::move(bodies), std::move(post), m_panel->dialect(), m_parts.window);
  connect(dialog, &ToolTableDialog::chosen, this, &ProgramSession::storeTools);
  dialog->open();
}

// It has no file yet: that of the text before stays as it is.
void ProgramSession::offer(const std::string& text, ProgramTools tools) {
  ++m_texts;
  m_path.clear();
  m_file = {};
  setText(QString::fromStdString(text), std::move(tools));
  showName();
  run();
}

}  // namespace handwheel
