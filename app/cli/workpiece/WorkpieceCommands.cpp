// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/workpiece/WorkpieceCommands.h"

#include "base/NumberText.h"
#include "cli/Input.h"
#include "cli/Interrupt.h"
#include "cli/Messages.h"
#include "cli/workpiece/ForceCommand.h"
#include "cli/workpiece/PostArguments.h"
#include "cli/workpiece/ProgramCommand.h"
#include "cli/workpiece/TargetCommand.h"
#include "cli/workpiece/ThreadCommand.h"
#include "cli/workpiece/TrainCommand.h"
#include "cli/workpiece/TurnByProgram.h"
#include "cli/workpiece/TurnByRecording.h"
#include "cli/workpiece/TurnByWork.h"
#include "cli/workpiece/TurnRequest.h"
#include "cli/workpiece/TurnStatistics.h"
#include "document/workpiece/FinishReport.h"
#include "document/workpiece/LatheSetupEdit.h"
#include "document/workpiece/TurnedPartEdit.h"
#include "document/workpiece/exercise/AssignedTask.h"
#include "document/workpiece/exercise/ExerciseStock.h"
#include "machining/force/WorkMaterials.h"
#include "text/NoteText.h"

#include <nlohmann/json.hpp>

namespace handwheel {

namespace {

constexpr const char* kTouchesNothing = "The path does not touch the part.";
constexpr const char* kNoWorkOnALathe =
    "This is no work on a lathe: give a workpiece, or what was handed in of an exercise of turning.";

std::size_t passCount(const WorkpieceSnapshot& workpiece) {
  return workpiece.part ? workpiece.part->passes.size() : 0;
}

double volumeOf(const WorkpieceSnapshot& workpiece) {
  return workpiece.part ? workpiece.part->volume() : workpiece.stock.volume();
}

std::string replayReport(const WorkpieceSnapshot& workpiece, bool isSame, bool asJson) {
  const std::size_t passes = passCount(workpiece);
  if (asJson)
    return nlohmann::ordered_json{{"passes", passes}, {"volume_mm3", volumeOf(workpiece)}, {"same", isSame}}.dump(2) +
           "\n";
  return "Passes: " + std::to_string(passes) + ". Volume: " + roundedText(volumeOf(workpiece)) + " mm³.\n" +
         (isSame ? "Replayed, the passes give the same part.\n" : "Replayed, the passes give a different part.\n");
}

std::string report(const WorkpieceSnapshot& workpiece, const TurnStatistics& figures, bool asJson) {
  if (asJson) return statisticsAsJson(figures);
  return "Passes: " + std::to_string(passCount(workpiece)) + ". Volume: " + roundedText(volumeOf(workpiece)) +
         " mm³. " + statisticsAsText(figures);
}

const WorkpieceSnapshot* workpieceIn(const OpenedFile& opened) {
  return dynamic_cast<const WorkpieceSnapshot*>(opened.content.get());
}

// Returns true if the passes cut the same part from the bar, bit for bit.
bool repeats(const WorkpieceSnapshot& workpiece, Progress progress) {
  if (!workpiece.part) return true;
  TurnedProfile profile = TurnedProfile::barOf(workpiece.stock, workpiece.part->profile.size());
  for (std::size_t i = 0; i < workpiece.part->passes.size() && !progress.cancelled(); ++i) {
    cut(profile, workpiece.part->passes[i], static_cast<std::uint32_t>(i), progress);
  }
  return profile == workpiece.part->profile;
}

// The bar that the first word names, or the file; of an exercise the bar that students begin with. exercise: where its
// task is put.
Result<OpenedFile> openInput(const TurnRequest& request, const DocumentKinds& kinds,
                             std::optional<ExerciseStock>& exercise, Progress progress) {
  const DocumentKind& kind = *kinds.withId("workpiece");
  OpenedFile opened = DocumentKinds::blank(kind);
  if (!request.bar) {
    Result<OpenedFile> file = kinds.open(request.input, {}, progress);
    if (file) exercise = exerciseStock(*file->content);
    if (!exercise) return file;
    opened.content = std::make_shared<const WorkpieceSnapshot>(exercise->bar);
    return opened;
  }
  auto workpiece = std::make_shared<WorkpieceSnapshot>();
  workpiece->stock = *request.bar;
  if (request.isMaterialGiven) workpiece->material = request.material.name;
  workpiece->mesh = std::make_shared<const StockMesh>(*request.bar, workpiece->chord);
  opened.content = std::move(workpiece);
  return opened;
}

// The workpiece after the work in a document is done on it again. source: gets that file, with its damage. unreadable:
// a sentence, where there is no such work in it. Errors: those of the file, Cancelled.
Result<WorkpieceSnapshot> turnByDocument(const WorkpieceSnapshot& workpiece, const TurnRequest& request,
                                         const DocumentKinds& kinds, TurnStatistics& figures, DocumentFile& source,
                                         std::string& unreadable, Progress progress) {
  Result<OpenedFile> opened = kinds.open(request.recording, {}, progress.part(0.0, 0.2));
  if (!opened) return opened.error();
  source = std::move(opened->file);
  source.lost.clear();  // it is not written, so nothing is not kept
  if (const auto work = turnedWorkIn(opened->content))
    return turnByWork(workpiece, *work, request, figures, progress.part(0.2, 1.0));
  unreadable = kNoWorkOnALathe;
  return workpiece;
}

int replay(const WorkpieceSnapshot& workpiece, bool asJson) {
  bool isSame = false, isCancelled = false;
  runInterruptible("Turning", [&](CommandJob& job) {
    isSame = repeats(workpiece, job.progress());
    isCancelled = job.progress().cancelled();
  });
  if (isCancelled) return fail(Error{ErrorCode::Cancelled, {}, {}, {}});
  const int code = print(replayReport(workpiece, isSame, asJson));
  return code == kExitDone && !isSame ? kExitSomethingLeft : code;
}

// Returns the reason why a program may not cut the work of an exercise; empty: it may.
std::string refusalOfProgram(const TurnRequest& request, const OpenedFile& file,
                             const std::optional<ExerciseStock>& exercise) {
  if (request.program.empty()) return {};
  const auto task = exercise ? exercise->task : assignedTask(file.file.assigned);
  if (!task || task->areProgramsAllowed) return {};
  return request.input + ": this exercise is to be done by hand. It does not allow programs to cut.";
}

// The speed of a lathe, r/min, unless the words tell one. 0 is none that cuts.
void useSpindle(double speed, const Arguments& arguments, TurnRequest& request) {
  if (speed > 0.0 && !arguments.has("spindle")) request.spindle = speed;
}

// Takes material and speed from an exercise, unless the arguments set them. The chuck is that of the workpiece.
void useMachineOf(const TurningTask& task, const Arguments& arguments, TurnRequest& request) {
  useSpindle(task.lathe.spindleSpeed, arguments, request);
  const WorkMaterials& materials = WorkMaterials::standard();
  const WorkMaterial* const material = materials.find(task.material);
  if (material && !request.isMaterialGiven) request.material = *material;
}

// Takes material and speed from a workpiece, unless the arguments set them, as its replay does.
void useMachineOf(const WorkpieceSnapshot& workpiece, const Arguments& arguments, TurnRequest& request) {
  useSpindle(latheOf(workpiece).spindle.speed, arguments, request);
  if (request.isMaterialGiven || workpiece.material.empty()) return;
  const WorkMaterial* const material = WorkMaterials::standard().named(workpiece.material);
  if (material)
    request.material = *material;
  else
    complain(request.input + ": the material '" + workpiece.material + "' is not known, so forces are those of " +
             request.material.name + ". 'handwheel force --list' names those that are.");
}

}  // namespace

int runTurn(const Arguments& arguments, const DocumentKinds& kinds) {
  TurnRequest request;
  if (const std::string problem = readTurnRequest(arguments, request); !problem.empty())
    return failUsage(problem, "turn");
  std::optional<Result<OpenedFile>> opened;
  std::optional<ExerciseStock> exercise;
  runInterruptible("Reading", [&](CommandJob& job) { opened = openInput(request, kinds, exercise, job.progress()); });
  if (!*opened) return fail(opened->error());
  const OpenedFile& file = opened->value();
  const WorkpieceSnapshot* const given = workpieceIn(file);
  if (!given) return refuse(request.input + " is not a workpiece: only workpieces can be turned.");
  reportLosses(file.file);
  if (request.isReplay) return replay(*given, request.asJson);

  if (const std::string refusal = refusalOfProgram(request, file, exercise); !refusal.empty()) return refuse(refusal);
  if (const std::string refusal = refusalToReplace(request.output, file.file); !refusal.empty()) return refuse(refusal);
  std::vector<std::filesystem::path> inputs{request.program, request.recording, request.tools, request.target};
  if (exercise) inputs.emplace_back(request.input);  // a workpiece would replace the exercise
  if (const std::string refusal = refusalToOverwrite(request.output, inputs); !refusal.empty()) return refuse(refusal);
  if (exercise)
    useMachineOf(*exercise->task, arguments, request);
  else if (!request.bar)
    useMachineOf(*given, arguments, request);
  std::string unreadable;
  std::vector<std::string> remarks;
  TurnStatistics figures;
  bool hasLoads = true;
  DocumentFile recorded;
  std::optional<Result<TargetProfile>> target;
  std::optional<Result<WorkpieceSnapshot>> turned;
  std::optional<Result<WrittenFile>> written;
  runInterruptible("Turning", [&](CommandJob& job) {
    if (!request.target.empty()) target = readTarget(request.target, kinds, job.progress().part(0.0, 0.1));
    if (target && !*target) return;
    const Progress cutting = job.progress().part(0.1, 0.5);
    if (!request.program.empty())
      turned = turnByProgram(*given, request, figures, remarks, cutting);
    else if (isContainerName(request.recording))
      turned = turnByDocument(*given, request, kinds, figures, recorded, unreadable, cutting);
    else
      turned = turnByRecording(*given, request, figures, unreadable, cutting);
    if (!*turned) return;
    hasLoads =
        addLoads(figures, *given, turned->value(), request.material, request.spindle, job.progress().part(0.5, 0.7));
    if (passCount(turned->value()) > passCount(*given))
      written = saveDocument(*file.kind, file.file, turned->value(), request.output, job.progress().part(0.7, 1.0));
  });
  if (target && !*target) return fail(target->error());
  if (!*turned) return fail(turned->error());
  reportLosses(recorded);
  if (!unreadable.empty()) return refuse(request.recording.string() + ": " + unreadable);
  const WorkpieceSnapshot& after = turned->value();
  if (!hasLoads) complain("The forces are not known: there are too many passes to measure them.");
  figures.removed = volumeOf(*given) - volumeOf(after);
  if (after.part) figures.parted = partedOff(given->part.get(), *after.part);
  if (after.part) figures.finish = finishJson(*after.part, after.stock.position);
  const TurnedProfile profile = partOf(after, request.spacing).profile;
  if (target)
    figures.profileError = profileError(target->value(), profile);
  else if (exercise && exercise->task->target)
    figures.profileError = targetError(*exercise, profile);
  for (const std::string& remark : remarks) complain(remark);
  if (!written) {
    complain(kTouchesNothing);
    if (!request.program.empty()) print(report(after, figures, request.asJson));
    return kExitSomethingLeft;
  }
  if (!*written) return fail(written->error());
  for (const Note& note : written->value().notes) complain(noteText(note).toStdString());
  return print(report(after, figures, request.asJson));
}

namespace {

Command turnCommand() {
  CommandSpec spec = {
      "turn",
      "STOCK",
      "Cuts a workpiece on a lathe by a program or a recording. STOCK is a workpiece, an exercise, or a bar such as "
      "cylinder:40x100:\n"
      "diameter and length in mm, its right end at Z 0, gripped at the left. docs/programs.md lists the words of\n"
      "programs. R is a document with work that was made by hand in the window, a workpiece or what was handed in, "
      "whose\n"
      "passes are cut again, turned, ground, bored or threaded; or a recording of a device that the window has "
      "exported,\n"
      "in the coordinates of the document, where each press of the first button is a pass; or a table with the "
      "columns\n"
      "t_s,x_mm,y_mm,z_mm: the centre of the nose, of one pass. Forces follow Kienzle's law. Exit code 0: done; 2: "
      "the path does not touch the part and nothing is "
      "written, "
      "or\n"
      "--replay found a difference; 1: error.",
      {
          {"program", 0, "P.ngc", "The program that the lathe runs"},
          {"recording", 0, "R", "Work by hand (.handwheel), or the recorded path of a tool (.csv)", "path"},
          {"output", 'o', "OUT", "The document to write, .handwheel or an export such as .step or .stl; may be STOCK"},
          {"dialect", 0, "NAME", "Dialect of the program: linuxcnc (default) or fanuc, system A"},
          {"increments", 0, "",
           "A length without a decimal point counts 0.001 mm or 0.0001 inch, as on many a Fanuc; default: mm or "
           "inch"},
          {"block-skip", 0, "N,N", "Block skips of the program that are on, 1 to 9; / is 1. Default: none"},
          {"nose", 0, "MM",
           "Nose radius, 0.05 to 50; default: 0, a point, for a program; what a recording says, else 1", "nose-radius"},
          {"tools", 0, "T.tbl",
           "Table of tools as LinuxCNC has it, in mm: T1 P1 X0 Z0 D0.8 Q2. X (a radius) and Z from the tip to the "
           "post, "
           "D the diameter of the nose, Q the orientation in the numbers of the dialect"},
          {"material", 0, "NAME",
           "Material of the work, for the forces; a new bar gets it. Default: that of the exercise or workpiece, else "
           "medium-carbon-steel"},
          {"spindle", 0, "RPM",
           "Speed of the spindle of a recording, for forces and roughness (default 500, or that of the exercise or "
           "workpiece)"},
          {"method", 0, "NAME",
           "How a recording cuts: trim (default), exactly what the nose sweeps; or poles, by moving the control "
           "points of a smooth curve, which errs by up to their distance, and by millimetres beside walls higher "
           "than "
           "the nose radius"},
          {"resolution", 0, "MM", "Distance of these control points, 0.05 to 10 (default 0.5)"},
          {"target", 0, "FILE", "A drawing (.dxf, .svg) or workpiece to compare with, upper end at upper end"},
          {"spacing", 0, "MM",
           "Sample spacing of the profile, for a bar that was not cut yet; not with a document as R"},
          {"replay", 0, "", "Replay the passes of STOCK on its bar and compare the result, bit for bit"},
          {"json", 0, "", "Report as JSON"},
          {"help", 'h', "", "Show this help"},
      },
      "STOCK (--program P.ngc | --recording R) -o OUT [--dialect NAME] [--post SIDE] [--nose MM] [--material NAME] "
      "[--json]"};
  for (OptionSpec& option : postOptions()) spec.options.push_back(std::move(option));
  return {std::move(spec), runTurn};
}

}  // namespace

std::vector<Command> workpieceCommands() {
  return {turnCommand(), programCommand(), targetCommand(), threadCommand(), trainCommand(), forceCommand()};
}

}  // namespace handwheel
